//! Simulations: from a start to a trajectory, by the best method there is.

use super::ending::{Ending, MethodReason};
use super::integration::{Integration, MOST_EVENTS, look_ahead};
use super::solution::Solution;
use super::trajectory::Trajectory;
use crate::math::frame::Body;
use crate::math::vector::Position;
use crate::motion::error::MotionError;
use crate::motion::model::event::{Crossing, Event, EventAction};
use crate::motion::model::event_detection::{EventDetector, EventSide, Found, Watched};
use crate::motion::model::mass_history::MassHistory;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::solve::closed_form::ClosedForm;
use crate::motion::solve::limits::MOST_STEPS;
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::bound::PATIENCE;
use crate::motion::solve::propagate::stepper::{Rule, Stepper};
use crate::motion::solve::solver::Solver;
use crate::motion::solve::start::{require_ascending, require_few_pulses, require_finite};

/// An initial value problem: a body, the torques on it, the events to detect, and the method.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::{Ending, EventAction, Measure, Sense};
/// // Spun up from rest by N along z until it turns at 3 rad/s: t = I ω / N.
/// let body = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 2.5])?)?;
/// let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 0.5)));
/// let rate = Measure::OmegaBody(Direction::new(0.0, 0.0, 1.0));
/// let fast = Event::new("fast enough", rate, 3.0, Sense::Rising, EventAction::Stop)?;
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
/// let (rotor, torques, events) = (Rotor::free(&body), [torque], [fast]);
/// let motion = Simulation::new(&rotor, &torques, start, &[0.0, 100.0]).events(&events).run()?;
/// let Ending::Stopped { time, .. } = *motion.ending() else { return Err("it does not stop".into()) };
/// assert!((time - 2.5 * 3.0 / 0.5).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Simulation<'a> {
    /// The body and the point that it turns about.
    pub rotor: &'a Rotor,
    /// Its mass properties over time, if they change: those of `rotor` are its mass properties at the start then.
    pub history: Option<&'a MassHistory>,
    /// What turns it.
    pub torques: &'a [TorqueModel],
    /// Which of the torques, from 0, are switched off until an event switches them on.
    pub switched_off: &'a [usize],
    /// Where it starts.
    pub start: State,
    /// The events to detect.
    pub events: &'a [Event],
    /// On which side of each event's value the start is, of a motion that goes on; empty otherwise, when the start says it.
    pub event_sides: &'a [EventSide],
    /// When to sample it, s: ascending, none before the start.
    pub times: &'a [f64],
    /// How to compute it.
    pub method: Method,
    /// Bound on the error of each integration step, attitude in rad and ω relative; closed forms and splitting ignore it.
    pub tolerance: f64,
}

impl<'a> Simulation<'a> {
    /// A body under torques, all of which act, from a start to times: by the best method at a tolerance of 1e-13, without events.
    pub const fn new(rotor: &'a Rotor, torques: &'a [TorqueModel], start: State, times: &'a [f64]) -> Self {
        let (switched_off, events, event_sides, method, tolerance) = (&[], &[], &[], Method::Auto, 1e-13);
        Self {
            rotor,
            history: None,
            torques,
            switched_off,
            start,
            events,
            event_sides,
            times,
            method,
            tolerance,
        }
    }

    /// Of a body whose mass properties are these over time.
    #[must_use]
    pub const fn changing(self, history: Option<&'a MassHistory>) -> Self {
        Self { history, ..self }
    }

    /// Detects these events.
    #[must_use]
    pub const fn events(self, events: &'a [Event]) -> Self {
        Self { events, ..self }
    }

    /// Leaves these torques, from 0, switched off until an event switches them on.
    #[must_use]
    pub const fn switched_off(self, switched_off: &'a [usize]) -> Self {
        Self { switched_off, ..self }
    }

    /// By this method.
    #[must_use]
    pub const fn method(self, method: Method) -> Self {
        Self { method, ..self }
    }

    /// With this bound on the error of each step.
    #[must_use]
    pub const fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// The motion at each of the times, as [`Simulation::run_watched`] has it.
    ///
    /// # Errors
    /// As [`Simulation::run_watched`].
    pub fn run(&self) -> Result<Trajectory, MotionError> {
        self.run_watched(&mut |_| true)
    }

    /// The motion at each of the times, as far as it goes: [`Trajectory::ending`] says where and why it ended. An event that stops it,
    /// and a computation that cannot go on, end it with a sample of their own. `progress` is told the time (s) after each step;
    /// `false` ends the work.
    ///
    /// # Errors
    /// [`MotionError`] for what is wrong before the motion begins: times out of order, a start or a torque that is not finite, an
    /// event that cannot be measured, no closed form for [`Method::Exact`], a torque without a power series for
    /// [`Method::Taylor`], a body that cannot spin. [`MotionError::Stopped`] if `progress` said so.
    pub fn run_watched(&self, progress: &mut dyn FnMut(f64) -> bool) -> Result<Trajectory, MotionError> {
        self.require_possible()?;
        match self.choose()? {
            (Way::Closed(motion), reason) => self.exact(motion, reason),
            (Way::Steps(rule), reason) => self.integrate(rule, reason, progress),
        }
    }

    /// # Errors
    /// What is wrong before the motion begins, but for the method.
    pub(super) fn require_possible(&self) -> Result<(), MotionError> {
        let Self { rotor, torques, switched_off, start, events, times, .. } = *self;
        require_ascending(start.time, times)?;
        require_finite(rotor, torques, switched_off, &start)?;
        events.iter().try_for_each(|event| event.require_possible(rotor, torques, events, &start))?;
        self.require_changing()?;
        let stays_off = |k: &usize| {
            let wakes = EventAction::Switch { torque: *k, on: true };
            switched_off.contains(k) && !events.iter().any(|event| event.action() == wakes)
        };
        require_few_pulses(rotor, torques, &stays_off, [start.time, self.end()])
    }

    /// The states at each of the times and nothing else: no events, no samples, no evidence of the error. What an inner loop wants.
    ///
    /// # Errors
    /// As [`Simulation::run`]; and what ends a run early is an error here.
    ///
    /// ```
    /// use polhode::prelude::*;
    /// let inertia = InertiaTensor::diagonal([1.0, 1.1, 0.5])?;
    /// let top = Rotor::pivoted(&MassProperties::new(1.0, Position::new(0.0, 0.0, 0.1), inertia)?, Position::ZERO);
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.0, 9.0) };
    /// let gravity = [TorqueModel::Gravity(UniformGravity::STANDARD)];
    /// let simulation = Simulation::new(&top, &gravity, start, &[0.5, 1.0]);
    /// let (states, run) = (simulation.states()?, simulation.run()?);
    /// assert!(states[1].attitude.angle_to(run.samples()[1].state.attitude) < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn states(&self) -> Result<Vec<State>, MotionError> {
        let mut states = Vec::with_capacity(self.times.len());
        self.fill(&mut states)?;
        Ok(states)
    }

    /// As [`Simulation::states`], after the states that are there already: after an error those before it are left.
    pub(super) fn fill(&self, states: &mut Vec<State>) -> Result<(), MotionError> {
        let Self { rotor, torques, start, times, switched_off, tolerance, .. } = *self;
        require_ascending(start.time, times)?;
        require_finite(rotor, torques, switched_off, &start)?;
        require_few_pulses(rotor, torques, &|k| switched_off.contains(k), [start.time, self.end()])?;
        self.require_changing()?;
        let rule = match self.choose()? {
            (Way::Closed(motion), _) => {
                motion.require(times)?;
                states.extend(motion.at_times(times));
                return Ok(());
            }
            (Way::Steps(rule), _) => rule,
        };
        let mut stepper =
            Stepper::new(rule, (rotor, self.history), torques, switched_off, start, tolerance, false)?;
        let end = times.last().copied().unwrap_or(start.time);
        for &time in times {
            while stepper.time() < time {
                stepper.step(end)?;
                look_ahead(&mut stepper, end)?;
            }
            let there = if time == stepper.time() { stepper.now() } else { stepper.at(time) };
            states.push(there.state);
        }
        Ok(())
    }

    /// # Errors
    /// What is not known of bodies whose mass properties change, if they do.
    fn require_changing(&self) -> Result<(), MotionError> {
        let Self { rotor, history, torques, events, start, method, .. } = *self;
        let Some(history) = history else { return Ok(()) };
        let why = |why| Err(MotionError::MassHistory { time: start.time, why });
        let own = history.rotor(start.time, self.pivot())?;
        let differs = |a: f64, b: f64| !((a - b).abs() <= 1e-9 * b.abs());
        let (given, known) = (rotor.inertia().symmetric(), own.inertia().symmetric());
        if differs(rotor.mass(), own.mass()) || (*given - *known).max_abs() > 1e-9 * known.max_abs() {
            return why("is not that of the body at the start");
        }
        if !rotor.wheels().is_empty() {
            return why("cannot go with wheels: what is left of the body beside them is not known");
        }
        if matches!(method, Method::Splitting { .. }) {
            return why("cannot go with splitting, which needs a body that stays as it is");
        }
        if events.iter().any(Event::needs_inertia) {
            return why(
                "cannot go with an event that measures energy, angular momentum or a function of the body",
            );
        }
        if torques.iter().any(TorqueModel::needs_constant_mass) {
            return why("cannot go with an energy sink or with gravity on single mass points");
        }
        Ok(())
    }

    /// The point that is held.
    fn pivot(&self) -> Option<Position<Body>> {
        self.rotor.is_pivoted().then(|| self.rotor.point())
    }

    /// The last of the times, s.
    fn end(&self) -> f64 {
        self.times.last().copied().unwrap_or(self.start.time)
    }

    /// The first torque without a power series, and why it has none.
    pub(super) fn rough_torque(&self) -> Option<(usize, &'static str)> {
        let body = self.history.map(|history| (history.body(self.start.time, self.pivot()), history));
        let roughness = |torque: &TorqueModel| {
            let of_changing =
                || body.as_ref().and_then(|(body, history)| body.roughness(torque, history.ball()));
            torque.model().roughness().or_else(of_changing)
        };
        self.torques.iter().enumerate().find_map(|(k, torque)| Some((k, roughness(torque)?)))
    }

    /// The requested method, or the best.
    fn choose(&self) -> Result<(Way, MethodReason), MotionError> {
        let rough = self.rough_torque();
        let steps = |rule| Ok((Way::Steps(rule), MethodReason::Asked));
        match self.method {
            Method::Exact => Ok((Way::Closed(self.closed_form()?), MethodReason::Asked)),
            Method::Taylor => match rough {
                Some((torque, why)) => Err(MotionError::NotSmooth { torque, why }),
                None => steps(Rule::Taylor),
            },
            Method::Dop853 => steps(Rule::Dop853),
            Method::Splitting { order, step } => steps(Rule::Splitting { order, step }),
            Method::Auto => match (self.closed_form(), rough) {
                (Ok(motion), _) => {
                    let title = motion.title();
                    Ok((Way::Closed(motion), MethodReason::ClosedForm { title }))
                }
                (Err(MotionError::NoClosedForm { why: no_closed_form }), Some((torque, why))) => {
                    Ok((Way::Steps(Rule::Dop853), MethodReason::Rough { no_closed_form, torque, why }))
                }
                (Err(MotionError::NoClosedForm { why: no_closed_form }), None) => {
                    Ok((Way::Steps(Rule::Taylor), MethodReason::Smooth { no_closed_form }))
                }
                (Err(why), _) => Err(why),
            },
        }
    }

    /// # Errors
    /// [`MotionError::NoClosedForm`], or what makes the motion undetermined.
    fn closed_form(&self) -> Result<ClosedForm, MotionError> {
        if self.history.is_some() {
            return Err(MotionError::NoClosedForm { why: "the mass properties change with time" });
        }
        if self.switched_off.is_empty() && !self.events.iter().any(Event::switches) {
            return ClosedForm::of(self.rotor, self.torques, self.start);
        }
        Err(MotionError::NoClosedForm { why: "torques are switched on and off" })
    }

    fn integrate(
        &self,
        rule: Rule,
        reason: MethodReason,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Trajectory, MotionError> {
        let stepper = Stepper::new(
            rule,
            (self.rotor, self.history),
            self.torques,
            self.switched_off,
            self.start,
            self.tolerance,
            true,
        )?;
        let mut integration = Integration::new(stepper, self.watched_events(), self.start, self.times);
        let (start, ending) = integration.run(self.start, progress)?;
        let stepper = integration.stepper();
        let solver = match stepper.rule() {
            Rule::Taylor => Solver::Taylor,
            Rule::Dop853 => Solver::Dop853,
            Rule::Splitting { order, step } => Solver::Splitting { order, step },
        };
        let (tolerance, statistics) = (stepper.tolerance(), stepper.statistics());
        let solution = Solution::Integrated { solver, tolerance, statistics };
        let sides = integration.event_sides();
        Ok(Trajectory::assembled(start, integration.samples, solution)
            .because(reason)
            .with_events(integration.crossings, ending)
            .leaving_events(sides))
    }

    /// The events, and on which side of each value the start is, if that is known.
    pub(super) const fn watched_events(&self) -> (&'a [Event], &'a [EventSide]) {
        (self.events, self.event_sides)
    }

    /// The closed form, which has no steps: it is looked at turn by turn.
    fn exact(&self, motion: ClosedForm, reason: MethodReason) -> Result<Trajectory, MotionError> {
        /// The turn of a stretch, rad: it counts as so many steps.
        const STRETCH: u64 = 16;
        const MOST_LOOKS: u64 = MOST_STEPS / STRETCH;
        let end = self.end();
        // Only an event that stops the motion can make the end come nearer.
        let stops = self.events.iter().any(|event| event.action() == EventAction::Stop);
        let mut watch = EventDetector::new(self.rotor, self.torques, self.watched_events(), &self.start);
        // A body let go at rest is measured by how fast the torque makes it.
        let torque: f64 = self.torques.iter().map(|torque| torque.scale(self.rotor, &self.start)).sum();
        let [_, moment, _] = self.rotor.principal().moments();
        let torque_rate = (torque / moment).sqrt();
        let (mut time, mut looks, mut far) = (self.start.time, 0, 0);
        let (mut crossings, mut ending) = (Vec::new(), Ending::Complete);
        while !self.events.is_empty() && time < end && ending == Ending::Complete {
            let step = STRETCH as f64 / (motion.at(time).omega.norm() + torque_rate);
            let next = if time + step < end { time + step } else { end };
            looks += 1;
            let is_far = !stops && looks as f64 + (end - time) / step > MOST_LOOKS as f64;
            far = if is_far { far + 1 } else { 0 };
            if !(next > time) {
                ending = Ending::Failed { time, cause: MotionError::StepTooSmall { time, step } };
            } else if looks == MOST_LOOKS || far > PATIENCE {
                let step = step / STRETCH as f64;
                let cause = MotionError::TooManySteps { time, step, most: MOST_STEPS };
                ending = Ending::Failed { time, cause };
            } else {
                let look = watch.look([time, next], &Watched { state: &|t| motion.at(t), rates: &|_| None });
                let mut found = match look {
                    Ok(found) => found,
                    Err(cause) => {
                        ending = Ending::Failed { time, cause };
                        break;
                    }
                };
                let is_stop = |found: &Found| {
                    self.events.get(found.event).is_some_and(|event| event.action() == EventAction::Stop)
                };
                if let Some(k) = found.iter().position(is_stop)
                    && let Some(&Found { event, time, .. }) = found.get(k)
                {
                    let due = watch.due(found.get(k..).unwrap_or_default(), &|t| motion.at(t));
                    watch.cut(&motion.at(time), &due);
                    found.truncate(k);
                    found.extend(due.iter().map(|due| Found { time, ..*due }));
                    ending = Ending::Stopped { event, time };
                }
                for Found { event, time, rising, .. } in found {
                    if crossings.len() == MOST_EVENTS {
                        let cause = MotionError::TooManyEvents { time, most: MOST_EVENTS };
                        ending = Ending::Failed { time, cause };
                        break;
                    }
                    let name = self.events.get(event).map_or("", Event::name).to_owned();
                    crossings.push(Crossing { event, name, state: motion.at(time), rising });
                }
                time = next;
            }
        }
        let times = match ending {
            Ending::Complete => self.times.to_vec(),
            Ending::Stopped { time, .. } | Ending::Contact { time, .. } | Ending::Failed { time, .. } => {
                let before = self.times.iter().copied().filter(|t| *t < time);
                before.chain([time]).collect()
            }
        };
        Ok(Trajectory::of_closed_form(motion, self.rotor, self.torques, &times)?
            .because(reason)
            .with_events(crossings, ending)
            .leaving_events(watch.sides()))
    }
}

/// How to go about it.
enum Way {
    Closed(ClosedForm),
    Steps(Rule),
}

impl Trajectory {
    /// The motion from `start` at each of `times` (ascending, s, none before the start).
    ///
    /// `tolerance` bounds the error of each integration step, attitude in rad and ω relative; closed forms and splitting ignore it. A computation
    /// that cannot go on ends early: [`Trajectory::ending`]. [`Simulation`] is the same with events.
    ///
    /// # Errors
    /// As [`Simulation::run`].
    ///
    /// # Example
    /// ```
    /// use polhode::prelude::*;
    /// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
    /// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.5, 0.9) };
    /// let motion = Trajectory::compute(&body, &[], start, &[0.0, 10.0], Method::Auto, 1e-13)?;
    /// // 50-digit reference: fixtures/free_asymmetric.toml
    /// assert!((motion.samples()[1].state.omega.x - -0.428_074_674_276_547_2).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn compute(
        rotor: &Rotor,
        torques: &[TorqueModel],
        start: State,
        times: &[f64],
        method: Method,
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        Simulation::new(rotor, torques, start, times).method(method).tolerance(tolerance).run()
    }
}
