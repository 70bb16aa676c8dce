//! What steps from one time to the next, whichever method it is.

use std::rc::Rc;

use super::piece::Piece;
use super::runge_kutta::RungeKutta;
use super::splitting::{Splitting, SplittingOrder};
use super::taylor::Taylor;
use crate::math::frame::Space;
use crate::math::vector::AngularMomentum;
use crate::motion::error::MotionError;
use crate::motion::rotor::Rotor;
use crate::motion::state::State;
use crate::motion::torque::TorqueModel;

/// The tightest tolerance that rounding leaves room for.
pub const TIGHTEST_TOLERANCE: f64 = 1e-15;
/// The loosest tolerance that still means a solution.
pub const LOOSEST_TOLERANCE: f64 = 1e-2;

/// |ω| beyond which a motion that runs away is not believed, relative to what is usual.
const BELIEVED: f64 = 1e3;

/// |ω| beyond which every motion runs away, relative to what is usual.
const ABSURD: f64 = 1e9;

/// What a run cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StepStatistics {
    /// Steps kept.
    pub accepted: u64,
    /// Steps whose error was too large.
    pub rejected: u64,
    /// Evaluations of the equations of motion for the steps, by DOP853, whose samples between steps cost eleven more; coefficients of
    /// all unknowns, by Taylor's method.
    pub evaluations: u64,
}

/// A state with the work and the angular impulse that torque has given the body since the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Balanced {
    pub(crate) state: State,
    /// ∫ N · ω dt, J.
    pub(crate) work: f64,
    /// ∫ N dt in space axes, N·m·s.
    pub(crate) impulse: AngularMomentum<Space>,
}

/// The integrators.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rule {
    Taylor,
    Dop853,
    Splitting { order: SplittingOrder, step: f64 },
}

/// The motion of one body, step by step.
#[derive(Debug)]
pub(crate) struct Stepper<'a> {
    rotor: &'a Rotor,
    torques: &'a [TorqueModel],
    /// Which of them are switched on.
    switched_on: Vec<bool>,
    /// The first time at which something begins or ends by itself.
    until: f64,
    /// What |ω| is compared with, rad/s: see [`Stepper::require_bounded`].
    usual_rate: f64,
    /// When it began, s.
    begun: f64,
    /// The end of the last step at which |ω| was not yet absurd.
    believed: Balanced,
    /// For how many steps the end has been too far away.
    far: u64,
    tolerance: f64,
    /// True if a spring or wire is among the torques: its twist is watched.
    is_sprung: bool,
    rule: Rule,
    steps: Steps<'a>,
}

#[derive(Debug)]
enum Steps<'a> {
    Taylor(Box<Taylor<'a>>),
    Dop853(Box<RungeKutta<'a>>),
    Splitting(Box<Splitting<'a>>),
}

impl<'a> Stepper<'a> {
    /// Without evidence Taylor's method leaves out work and impulse, which are zero then.
    ///
    /// # Errors
    /// [`MotionError::Parameter`] if the tolerance is outside 1e-15 … 1e-2, or a given step not positive and finite;
    /// [`MotionError::NotSplittable`]; [`MotionError::NotSpinnable`]; [`MotionError::TorqueWithoutInertia`] if the torque cannot be
    /// balanced.
    pub(crate) fn new(
        rule: Rule,
        rotor: &'a Rotor,
        torques: &'a [TorqueModel],
        switched_off: &[usize],
        start: State,
        tolerance: f64,
        with_evidence: bool,
    ) -> Result<Self, MotionError> {
        let has_tolerance = !matches!(rule, Rule::Splitting { .. });
        if has_tolerance && !(TIGHTEST_TOLERANCE..=LOOSEST_TOLERANCE).contains(&tolerance) {
            let rule = "between 1e-15 and 1e-2";
            return Err(MotionError::Parameter { what: "the tolerance", value: tolerance, rule });
        }
        if !rotor.is_spinnable() {
            return Err(MotionError::NotSpinnable);
        }
        let switched_on: Vec<bool> = (0..torques.len()).map(|k| !switched_off.contains(&k)).collect();
        let piece = Rc::new(Piece::new(rotor, acting(torques, &switched_on), &start));
        piece.require_balanced_sink(&start)?;
        let until = piece.until;
        let usual_rate = start.omega.norm().max(torque_rate(&piece));
        let is_sprung = torques.iter().any(|torque| torque.name() == "torsion");
        let steps = match rule {
            Rule::Taylor => Steps::Taylor(Box::new(Taylor::new(piece, start, tolerance, with_evidence)?)),
            Rule::Dop853 => Steps::Dop853(Box::new(RungeKutta::new(piece, start, tolerance)?)),
            Rule::Splitting { order, step } => {
                Steps::Splitting(Box::new(Splitting::new(piece, torques, start, order, step)?))
            }
        };
        let (begun, believed) =
            (start.time, Balanced { state: start, work: 0.0, impulse: AngularMomentum::ZERO });
        Ok(Self {
            rotor,
            torques,
            switched_on,
            until,
            usual_rate,
            begun,
            believed,
            far: 0,
            tolerance,
            is_sprung,
            rule,
            steps,
        })
    }

    /// Looks again at what acts now.
    ///
    /// # Errors
    /// [`MotionError::TorqueWithoutInertia`] if it cannot be balanced.
    pub(crate) fn change(&mut self) -> Result<(), MotionError> {
        let state = self.now().state;
        let piece = Rc::new(Piece::new(self.rotor, acting(self.torques, &self.switched_on), &state));
        piece.require_balanced_sink(&state)?;
        self.until = piece.until;
        self.usual_rate = self.usual_rate.max(torque_rate(&piece));
        match &mut self.steps {
            Steps::Taylor(taylor) => taylor.change(piece),
            Steps::Dop853(dop853) => dop853.change(piece),
            Steps::Splitting(splitting) => splitting.change(piece),
        }
    }

    /// What is stepped: the body, and what turns it.
    pub(crate) fn subject(&self) -> (&'a Rotor, &'a [TorqueModel]) {
        (self.rotor, self.torques)
    }

    /// The torques that are switched on, with their schedules.
    pub(crate) fn switched_on(&self) -> impl Iterator<Item = &'a TorqueModel> + Clone + use<'a, '_> {
        acting(self.torques, &self.switched_on)
    }

    /// Switches a torque on or off, from the next [`Stepper::change`] on.
    pub(crate) fn switch(&mut self, torque: usize, on: bool) {
        if let Some(switch) = self.switched_on.get_mut(torque) {
            *switch = on;
        }
    }

    /// Goes back to a time within the last step.
    pub(crate) fn cut(&mut self, time: f64) {
        match &mut self.steps {
            Steps::Taylor(taylor) => taylor.cut(time),
            Steps::Dop853(dop853) => dop853.cut(time),
            Steps::Splitting(splitting) => splitting.cut(time),
        }
    }

    /// Refuses to go on with a motion that runs away before it comes to `end`.
    ///
    /// Nothing that is meant turns 10⁹ times faster than |ω| at the start, than every √(N/I) at which something begins to act, I the
    /// least moment, and than one radian in the whole run. From 10³ times that on it is not believed any more, if it ends so.
    ///
    /// # Errors
    /// [`MotionError::RunAway`].
    pub(crate) fn require_bounded(&mut self, end: f64) -> Result<(), MotionError> {
        self.usual_rate = self.usual_rate.max(1.0 / (end - self.begun));
        let now = self.now();
        let rate = now.state.omega.norm();
        if rate <= BELIEVED * self.usual_rate {
            self.believed = now;
        }
        if rate <= ABSURD * self.usual_rate { Ok(()) } else { Err(self.run_away()) }
    }

    /// The end of the last step at which |ω| was not yet absurd: what is left of a motion that runs away.
    pub(crate) const fn believed(&self) -> Balanced {
        self.believed
    }

    /// Why it cannot go on: that it runs away, if |ω| grows to ten times what is believed within less time than it took to come there.
    /// Towards infinity steps shrink to nothing before |ω| is large enough by itself.
    pub(crate) fn explained(&self, cause: MotionError) -> MotionError {
        let State { time, omega, .. } = self.now().state;
        let believed = self.believed.state.time;
        let is_sudden = time - believed < believed - self.begun;
        if is_sudden && omega.norm() > 10.0 * BELIEVED * self.usual_rate { self.run_away() } else { cause }
    }

    /// Counts the steps at which the end was too far away, one after the other.
    pub(crate) const fn has_been_far(&mut self, is_far: bool) -> u64 {
        self.far = if is_far { self.far + 1 } else { 0 };
        self.far
    }

    fn run_away(&self) -> MotionError {
        let State { time, omega, .. } = self.believed.state;
        MotionError::RunAway { time, rate: omega.norm(), most: BELIEVED * self.usual_rate }
    }

    /// `None` for steps of a given length.
    pub(crate) fn tolerance(&self) -> Option<f64> {
        (!matches!(self.rule, Rule::Splitting { .. })).then_some(self.tolerance)
    }

    pub(crate) fn rule(&self) -> Rule {
        self.rule
    }

    /// One step forward, not beyond `until`, nor beyond a time at which a torque begins or ends.
    ///
    /// # Errors
    /// [`MotionError::StepTooSmall`], [`MotionError::NotFinite`] or [`MotionError::TorqueWithoutInertia`]; the stepper
    /// stays at the last good state. [`MotionError::RunAway`] in place of these. [`MotionError::HalfTurn`] after a step that went too far.
    pub(crate) fn step(&mut self, until: f64) -> Result<(), MotionError> {
        if self.time() >= self.until {
            self.change()?;
        }
        let until = until.min(self.until);
        let before = self.is_sprung.then(|| self.now().state);
        let stepped = match &mut self.steps {
            Steps::Taylor(taylor) => taylor.step(until),
            Steps::Dop853(dop853) => dop853.step(until),
            Steps::Splitting(splitting) => splitting.step(until),
        };
        stepped.map_err(|cause| self.explained(cause))?;
        before.map_or(Ok(()), |before| self.require_untwisted(&before))
    }

    /// # Errors
    /// [`MotionError::HalfTurn`] if a spring or wire that acts has been twisted beyond half a turn.
    fn require_untwisted(&self, before: &State) -> Result<(), MotionError> {
        let after = self.now().state.attitude;
        let acting = self.switched_on().filter_map(|torque| torque.acting(before.time));
        let is_beyond = acting.into_iter().any(|torque| match torque {
            TorqueModel::Torsion(torsion) => torsion.passes_half_turn(before.attitude, after),
            _ => false,
        });
        if is_beyond { Err(MotionError::HalfTurn { time: before.time }) } else { Ok(()) }
    }

    pub(crate) fn time(&self) -> f64 {
        match &self.steps {
            Steps::Taylor(taylor) => taylor.time(),
            Steps::Dop853(dop853) => dop853.time(),
            Steps::Splitting(splitting) => splitting.time(),
        }
    }

    /// The step that the tolerance allows next, or the given one, s.
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

    /// The state now.
    pub(crate) fn now(&self) -> Balanced {
        match &self.steps {
            Steps::Taylor(taylor) => taylor.now(),
            Steps::Dop853(dop853) => dop853.now(),
            Steps::Splitting(splitting) => splitting.now(),
        }
    }

    /// The state at a time within the last step: dense output.
    pub(crate) fn at(&self, time: f64) -> Balanced {
        match &self.steps {
            Steps::Taylor(taylor) => taylor.at(time),
            Steps::Dop853(dop853) => dop853.at(time),
            Steps::Splitting(splitting) => splitting.at(time),
        }
    }
}

/// The torques that are switched on.
fn acting<'a, 'b>(
    torques: &'a [TorqueModel],
    switched_on: &'b [bool],
) -> impl Iterator<Item = &'a TorqueModel> + Clone + use<'a, 'b> {
    torques.iter().zip(switched_on).filter(|(_, on)| **on).map(|(torque, _)| torque)
}

/// √(N/I), rad/s, of the least moment that is one.
fn torque_rate(piece: &Piece<'_>) -> f64 {
    let moments = piece.rotor.principal().moments();
    let least = moments.into_iter().find(|i| *i > 0.0).unwrap_or(f64::INFINITY);
    (piece.largest_torque / least).sqrt()
}
