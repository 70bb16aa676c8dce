//! Common interface of the integrators.

mod changing;
pub(in crate::motion) mod resumable;

use std::rc::Rc;

use super::balanced::Balanced;
use super::bound::Bound;
use super::half_turn::{Torsions, cosine};
use super::ledger::Ledger;
use super::noise::{Noise, StepNoise};
use super::piece::Piece;
use super::runge_kutta::RungeKutta;
use super::splitting::{Splitting, SplittingOrder};
use super::step_statistics::StepStatistics;
use super::taylor::{Acting, Taylor};
use crate::math::frame::{Body, Principal};
use crate::math::vector::{AngularVelocity, Direction, Torque};
use crate::motion::error::MotionError;
use crate::motion::model::euler::euler;
use crate::motion::model::mass_history::MassHistory;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::model::torque::parameter::ParameterKind;
use crate::motion::solve::limits::require_tolerance;

/// Integrators, with their parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rule {
    Taylor,
    Dop853,
    Splitting { order: SplittingOrder, step: f64 },
}

/// Motion of one body, computed step by step.
#[derive(Debug)]
pub(crate) struct Stepper<'a> {
    rotor: &'a Rotor,
    torques: &'a [TorqueModel],
    /// True for each torque that is switched on.
    switched_on: Vec<bool>,
    /// First time at which something begins or ends by schedule, s.
    until: f64,
    bound: Bound<Balanced>,
    /// Start of the last step, s.
    from: f64,
    /// Acting torsion springs and wires.
    torsions: Torsions,
    /// Time at which a torsion is twisted by half a turn, s; a step cannot begin there.
    half_turn: Option<f64>,
    /// True for a motion that continues beyond half a turn. Perturbed runs do, because they reach
    /// the half turn slightly earlier than the run that they are compared with.
    is_unlimited: bool,
    steps: Steps<'a>,
    /// Noise that a comparison run adds to each step.
    noise: Option<Noise>,
    /// History of the mass properties, if they change.
    history: Option<&'a MassHistory>,
    piece: Rc<Piece<'a>>,
    /// Work and impulse of a body with changing mass properties.
    ledger: Option<Ledger>,
}

#[derive(Debug)]
enum Steps<'a> {
    Taylor(Box<Taylor<'a>>),
    Dop853(Box<RungeKutta<'a>>),
    Splitting(Box<Splitting<'a>>),
}

impl<'a> Stepper<'a> {
    /// Prepares the integration from a state.
    ///
    /// `with_evidence`: compute work and impulse too. If false, Taylor's method omits them, and
    /// they are zero.
    ///
    /// # Errors
    /// - A parameter error ([`MotionError::is_parameter`]) if the tolerance is outside 1e-15 …
    ///   1e-2, or a given step is not positive and finite.
    /// - [`MotionError::NotSplittable`] for splitting with unsuitable torques.
    /// - [`MotionError::NotSpinnable`] for a body without inertia.
    /// - [`MotionError::TorqueWithoutInertia`] if the torque cannot be balanced.
    pub(crate) fn new(
        rule: Rule,
        (rotor, history): (&'a Rotor, Option<&'a MassHistory>),
        torques: &'a [TorqueModel],
        switched_off: &[usize],
        start: State,
        tolerance: f64,
        with_evidence: bool,
    ) -> Result<Self, MotionError> {
        let subject = (rotor, history);
        Self::of((rule, None), subject, torques, switched_off, start, tolerance, with_evidence)
    }

    /// Prepares Taylor's method for torques that are decomposed already, all switched on. The errors
    /// are those of [`Stepper::new`].
    pub(in crate::motion) fn of_acting(
        acting: &Acting,
        rotor: &'a Rotor,
        torques: &'a [TorqueModel],
        start: State,
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        Self::of((Rule::Taylor, Some(acting)), (rotor, None), torques, &[], start, tolerance, false)
    }

    fn of(
        (rule, known): (Rule, Option<&Acting>),
        (rotor, history): (&'a Rotor, Option<&'a MassHistory>),
        torques: &'a [TorqueModel],
        switched_off: &[usize],
        start: State,
        tolerance: f64,
        with_evidence: bool,
    ) -> Result<Self, MotionError> {
        let switched_on: Vec<bool> = (0..torques.len()).map(|k| !switched_off.contains(&k)).collect();
        let torques_on = acting(torques, &switched_on);
        let piece = Rc::new(match history {
            None => {
                if !matches!(rule, Rule::Splitting { .. }) {
                    require_tolerance(tolerance)?;
                }
                Piece::first(rotor, torques_on, &start)?
            }
            Some(history) => {
                require_tolerance(tolerance)?;
                Piece::of_changing(rotor, history, torques_on, &start)
            }
        });
        let ledger = (with_evidence && history.is_some()).then(Ledger::default);
        let with_evidence = with_evidence && history.is_none();
        let until = piece.until;
        let bound = Bound::new(&piece, &start);
        let first = Rc::clone(&piece);
        let steps = match rule {
            Rule::Taylor => {
                Steps::Taylor(Box::new(Taylor::new(first, known, start, tolerance, with_evidence)?))
            }
            Rule::Dop853 => Steps::Dop853(Box::new(RungeKutta::new(first, start, tolerance)?)),
            Rule::Splitting { order, step } => {
                Steps::Splitting(Box::new(Splitting::new(first, torques, start, order, step)?))
            }
        };
        let mut stepper = Self {
            rotor,
            torques,
            switched_on,
            until,
            bound,
            from: start.time,
            torsions: Torsions::default(),
            half_turn: None,
            is_unlimited: false,
            steps,
            noise: None,
            history,
            piece,
            ledger,
        };
        stepper.watch_torsions(&start);
        Ok(stepper)
    }

    /// Lets the motion continue beyond half a turn of torsions, where their torque is not
    /// determined.
    pub(crate) fn beyond_half_turns(mut self) -> Self {
        self.is_unlimited = true;
        self.torsions = Torsions::default();
        self.half_turn = None;
        self
    }

    /// Finds the torsions that act now.
    fn watch_torsions(&mut self, state: &State) {
        if self.is_unlimited {
            return;
        }
        let acting = self.switched_on().filter_map(|torque| torque.acting(state.time));
        self.torsions = Torsions::of(acting, state.attitude);
        self.half_turn = self.torsions.is_half_turn(state.attitude).then_some(state.time);
    }

    /// Returns the same integrator with longer steps, each perturbed at its end. Splitting keeps
    /// its step length.
    pub(crate) fn perturbed(mut self, StepNoise { seed, amplitude, stretch }: StepNoise) -> Self {
        match &mut self.steps {
            Steps::Taylor(taylor) => taylor.stretch(stretch),
            Steps::Dop853(dop853) => dop853.stretch(stretch),
            Steps::Splitting(_) => {}
        }
        Self { noise: (amplitude > 0.0).then(|| Noise::new(seed, amplitude)), ..self }
    }

    /// Updates what acts from now on.
    ///
    /// # Errors
    /// [`MotionError::TorqueWithoutInertia`] if the torque cannot be balanced.
    pub(crate) fn change(&mut self) -> Result<(), MotionError> {
        let mut state = self.now().state;
        if let Some(history) = self.history.filter(|_| self.time() >= self.until) {
            state = self.jump_of_mass(history, state)?;
        }
        let torques = acting(self.torques, &self.switched_on);
        let piece = Rc::new(match self.history {
            None => Piece::new(self.rotor, torques, &state),
            Some(history) => Piece::of_changing(self.rotor, history, torques, &state),
        });
        piece.require_balanced_sink(&state)?;
        self.until = piece.until;
        self.watch_torsions(&state);
        self.bound.act(&piece);
        self.piece = Rc::clone(&piece);
        match &mut self.steps {
            Steps::Taylor(taylor) => taylor.change(piece),
            Steps::Dop853(dop853) => dop853.change(piece),
            Steps::Splitting(splitting) => splitting.change(piece),
        }
    }

    /// Returns the body and the torques on it.
    pub(crate) fn subject(&self) -> (&'a Rotor, &'a [TorqueModel]) {
        (self.rotor, self.torques)
    }

    /// Returns the torques that are switched on, with their schedules.
    pub(crate) fn switched_on(&self) -> impl Iterator<Item = &'a TorqueModel> + Clone + use<'a, '_> {
        acting(self.torques, &self.switched_on)
    }

    /// Returns true if the torque with this index is switched on.
    pub(crate) fn is_on(&self, torque: usize) -> bool {
        self.switched_on.get(torque).is_some_and(|on| *on)
    }

    /// Switches a torque on or off, effective at the next [`Stepper::change`].
    pub(crate) fn switch(&mut self, torque: usize, on: bool) {
        if let Some(switch) = self.switched_on.get_mut(torque) {
            *switch = on;
        }
    }

    /// Returns to a time within the last step.
    pub(crate) fn cut(&mut self, time: f64) {
        self.steps.cut(time);
        self.half_turn = self.half_turn.filter(|half_turn| *half_turn <= time);
        self.account();
    }

    /// Returns an error if the motion diverges before it reaches `end`, or if `end` is too many
    /// steps away; see [`Bound`].
    ///
    /// # Errors
    /// [`MotionError::RunAway`] or [`MotionError::TooManySteps`].
    pub(crate) fn require_bounded(&mut self, end: f64) -> Result<(), MotionError> {
        let (step, allowed, now) = (self.statistics().accepted, self.next_step(), [self.time(), self.rate()]);
        let Self { bound, steps, from, ledger, .. } = self;
        bound.end(end);
        bound.require(step, now[1], || {
            let before = steps.at(*from);
            let rate = before.state.omega.norm();
            (*from, rate, ledger.map_or(before, |ledger| ledger.from(before.state)))
        })?;
        bound.require_few_steps(step, allowed, now, end)
    }

    /// Returns the last plausible state of a diverging motion.
    pub(crate) fn last_plausible(&self) -> Option<Balanced> {
        self.bound.last_plausible()
    }

    /// Returns the reason why the motion cannot continue; see [`Bound`].
    pub(crate) fn explained(&self, cause: MotionError) -> MotionError {
        self.bound.explained(cause, [self.time(), self.rate()])
    }

    /// Takes one step forward. It does not go beyond `until`, a time at which a torque begins or
    /// ends, or half a turn of a torsion.
    ///
    /// # Errors
    /// - [`MotionError::StepTooSmall`], [`MotionError::NotFinite`] or
    ///   [`MotionError::TorqueWithoutInertia`]. The stepper keeps the last good state.
    /// - [`MotionError::RunAway`] instead of these, if the motion diverges.
    /// - [`MotionError::HalfTurn`] if the last step has ended at a half turn.
    pub(crate) fn step(&mut self, until: f64) -> Result<(), MotionError> {
        if self.time() >= self.until {
            self.change()?;
        }
        if self.half_turn.is_some() {
            return Err(MotionError::HalfTurn { time: self.time() });
        }
        let until = until.min(self.until);
        let rate = self.rate();
        self.from = self.time();
        if let Some(ledger) = &mut self.ledger {
            ledger.begin();
        }
        let stepped = match &mut self.steps {
            Steps::Taylor(taylor) => taylor.step(until),
            Steps::Dop853(dop853) => dop853.step(until),
            Steps::Splitting(splitting) => splitting.step(until),
        };
        stepped.map_err(|cause| self.explained(cause))?;
        self.find_half_turn(rate);
        self.account();
        if let Some(noise) = &mut self.noise {
            match &mut self.steps {
                Steps::Taylor(taylor) => taylor.perturb(noise),
                Steps::Dop853(dop853) => dop853.perturb(noise),
                Steps::Splitting(splitting) => splitting.perturb(noise),
            }
        }
        Ok(())
    }

    /// Ends the last step at the first half turn of a torsion in it. `rate`: |ω| at its start.
    fn find_half_turn(&mut self, rate: f64) {
        if self.torsions.is_empty() {
            return;
        }
        let (from, rate) = (self.from, self.rate().max(rate));
        let steps = &self.steps;
        let after = self.torsions.half_turn(self.time() - from, rate, |rest| match steps {
            Steps::Taylor(taylor) => taylor.cosine(rest),
            steps => Box::new(move |after| cosine(rest, steps.at(from + after).state.attitude)),
        });
        if let Some(after) = after {
            self.steps.cut(from + after);
            self.half_turn = Some(from + after);
        }
    }

    pub(crate) fn time(&self) -> f64 {
        match &self.steps {
            Steps::Taylor(taylor) => taylor.time(),
            Steps::Dop853(dop853) => dop853.time(),
            Steps::Splitting(splitting) => splitting.time(),
        }
    }

    /// Returns the next step that the tolerance allows, or the constant step, s.
    pub(crate) fn next_step(&self) -> f64 {
        match &self.steps {
            Steps::Taylor(taylor) => taylor.next_step(),
            Steps::Dop853(dop853) => dop853.next_step(),
            Steps::Splitting(splitting) => splitting.next_step(),
        }
    }

    pub(crate) fn statistics(&self) -> StepStatistics {
        match &self.steps {
            Steps::Taylor(taylor) => taylor.statistics(),
            Steps::Dop853(dop853) => dop853.statistics(),
            Steps::Splitting(splitting) => splitting.statistics(),
        }
    }

    /// Enables derivatives with respect to the start, the inertia and these parameters. Only
    /// Taylor's method has them.
    pub(in crate::motion) fn differentiated(
        mut self,
        parameters: Vec<(&'a TorqueModel, ParameterKind)>,
    ) -> Self {
        if let Steps::Taylor(taylor) = &mut self.steps {
            taylor.differentiate(parameters);
        }
        self
    }

    /// Returns the derivatives at a time within the last step, column by column. Each column
    /// contains θ and ω, body axes. The columns belong to θ(0), ω(0), the inertia and the
    /// parameters.
    pub(in crate::motion) fn derivatives_at(&self, time: f64) -> Vec<[f64; 6]> {
        match &self.steps {
            Steps::Taylor(taylor) => taylor.derivatives_at(time),
            Steps::Dop853(_) | Steps::Splitting(_) => Vec::new(),
        }
    }

    /// Returns Ω and ω̇ at a time within the last step, from what acts in it, body axes.
    pub(in crate::motion) fn rates_at(&self, time: f64) -> [Direction<Body>; 2] {
        match &self.steps {
            Steps::Taylor(taylor) => taylor.rates_at(time),
            Steps::Dop853(_) | Steps::Splitting(_) => [Direction::from_array([f64::NAN; 3]); 2],
        }
    }

    /// Returns Ω and ω̇ in a state from the equations of motion of the last step, body axes; `None`
    /// if the mass properties change.
    pub(crate) fn rates_of(&self, state: &State) -> Option<[Direction<Body>; 2]> {
        let piece = &*self.piece;
        if piece.changing.is_some() {
            return None;
        }
        let (to_body, moments) = (self.rotor.principal().rotation(), self.rotor.principal().moments());
        let omega = to_body.inverse() * state.omega;
        let (h, l) = (piece.wheel_momentum(state.time), piece.angular_momentum(state.time, omega));
        let torque = to_body.inverse() * piece.torque(state, state.attitude);
        // Ω = ω + α L × ω;  I ω̇ = N − ω × I ω + h × ω + α L × (L × ω) − ḣ
        let bending: Torque<Principal> = l.cross(omega);
        let slip: AngularVelocity<Principal> = bending.as_quantity() * piece.sink;
        let inside = h.cross(omega) + l.cross(slip) - piece.motor_torque();
        let acceleration: Direction<Principal> = euler(moments, omega, torque + inside).as_quantity();
        Some([(omega + slip).as_quantity(), acceleration].map(|v| to_body * v))
    }

    /// Adds the effect of a shifted switching time to each column of the present derivatives.
    /// `times`: derivative of this time for each column. `by`: rates of θ and ω, body axes.
    pub(in crate::motion) fn jump(&mut self, times: &[f64], by: [Direction<Body>; 2]) {
        if let Steps::Taylor(taylor) = &mut self.steps {
            taylor.jump(times, by);
        }
    }

    /// Returns the state now, with work and impulse.
    pub(crate) fn now(&self) -> Balanced {
        let now = match &self.steps {
            Steps::Taylor(taylor) => taylor.now(),
            Steps::Dop853(dop853) => dop853.now(),
            Steps::Splitting(splitting) => splitting.now(),
        };
        self.ledger.map_or(now, |ledger| ledger.now(now.state))
    }

    /// Returns the state at a time within the last step (dense output).
    pub(crate) fn at(&self, time: f64) -> Balanced {
        let there = self.steps.at(time);
        self.ledger.map_or(there, |ledger| {
            ledger.at(&self.piece, self.from, there.state, &|time| self.steps.at(time).state)
        })
    }

    /// Returns |ω|, rad/s.
    fn rate(&self) -> f64 {
        match &self.steps {
            Steps::Taylor(taylor) => taylor.rate(),
            Steps::Dop853(dop853) => dop853.now().state.omega.norm(),
            Steps::Splitting(splitting) => splitting.now().state.omega.norm(),
        }
    }
}

impl Steps<'_> {
    fn cut(&mut self, time: f64) {
        match self {
            Self::Taylor(taylor) => taylor.cut(time),
            Self::Dop853(dop853) => dop853.cut(time),
            Self::Splitting(splitting) => splitting.cut(time),
        }
    }

    fn at(&self, time: f64) -> Balanced {
        match self {
            Self::Taylor(taylor) => taylor.at(time),
            Self::Dop853(dop853) => dop853.at(time),
            Self::Splitting(splitting) => splitting.at(time),
        }
    }
}

/// Returns the torques that are switched on.
fn acting<'a, 'b>(
    torques: &'a [TorqueModel],
    switched_on: &'b [bool],
) -> impl Iterator<Item = &'a TorqueModel> + Clone + use<'a, 'b> {
    torques.iter().zip(switched_on).filter(|(_, on)| **on).map(|(torque, _)| torque)
}
