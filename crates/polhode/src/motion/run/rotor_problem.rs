//! Initial value problem of a free or pivoted rotor, solved by the best available method.

use super::ending::{Ending, MethodReason};
use super::march::March;
use super::solution::{Solution, Steps};
use super::trajectory::Trajectory;
use super::turning::Turning;
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
use crate::motion::solve::limits::{MOST_EVENTS, MOST_STEPS};
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::bound::PATIENCE;
use crate::motion::solve::propagate::stepper::{Rule, Stepper};
use crate::motion::solve::start::{require_ascending, require_few_pulses, require_finite};

/// Initial value problem of a rotor under torques, with events to detect and the method.
#[derive(Clone, Copy, Debug)]
pub(super) struct RotorProblem<'a> {
    pub(super) rotor: &'a Rotor,
    /// History of the mass properties, if they change. `rotor` then has the mass properties at the
    /// start.
    pub(super) history: Option<&'a MassHistory>,
    pub(super) torques: &'a [TorqueModel],
    /// Indices, from 0, of the torques that are switched off until an event switches them on.
    pub(super) switched_off: &'a [usize],
    pub(super) start: State,
    pub(super) events: &'a [Event],
    /// Side of each event's value on which a continued motion starts. Empty otherwise; the start
    /// then determines it.
    pub(super) event_sides: &'a [EventSide],
    /// Times of the samples, s: ascending, none before the start.
    pub(super) times: &'a [f64],
    pub(super) method: Method,
    /// Bound on the error of each integration step, attitude in rad and ω relative. Closed forms
    /// and splitting ignore it.
    pub(super) tolerance: f64,
}

/// Appends the states at each of the times. After the error of a step, the states before it remain.
pub(super) fn sample(
    mut stepper: Stepper<'_>,
    times: &[f64],
    states: &mut Vec<State>,
) -> Result<(), MotionError> {
    let end = times.last().copied().unwrap_or(stepper.time());
    for &time in times {
        while stepper.time() < time {
            stepper.step(end)?;
            stepper.require_bounded(end)?;
        }
        let there = if time == stepper.time() { stepper.now() } else { stepper.at(time) };
        states.push(there.state);
    }
    Ok(())
}

impl<'a> RotorProblem<'a> {
    /// Computes the motion. `progress` receives the time after each step; if it returns `false`,
    /// the computation stops.
    ///
    /// # Errors
    /// The errors of [`Simulation::run_watched`](crate::motion::Simulation::run_watched).
    pub(super) fn run(&self, progress: &mut dyn FnMut(f64) -> bool) -> Result<Trajectory, MotionError> {
        self.require_possible()?;
        match self.choose()? {
            (Way::Closed(motion), reason) => self.exact(motion, reason),
            (Way::Steps(rule), reason) => self.integrate(rule, reason, progress),
        }
    }

    /// Checks the inputs, except for the method.
    ///
    /// # Errors
    /// The first error in the inputs.
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

    /// Appends the states at each of the times. After an error, the states before it remain.
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
        let stepper =
            Stepper::new(rule, (rotor, self.history), torques, switched_off, start, tolerance, false)?;
        sample(stepper, times, states)
    }

    /// Checks that the problem is supported if the mass properties change.
    ///
    /// # Errors
    /// [`MotionError::MassHistory`] for what is not supported with changing mass properties.
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
            return why("cannot be combined with wheels: the mass properties without the wheels are unknown");
        }
        if matches!(method, Method::Splitting { .. }) {
            return why("cannot be combined with splitting, which needs constant mass properties");
        }
        if events.iter().any(Event::needs_inertia) {
            return why(
                "cannot be combined with an event that measures energy, angular momentum or a function of the body",
            );
        }
        if torques.iter().any(TorqueModel::needs_constant_mass) {
            return why("cannot be combined with an energy sink or with gravity on single mass points");
        }
        Ok(())
    }

    /// Returns the pivot, if there is one.
    fn pivot(&self) -> Option<Position<Body>> {
        self.rotor.is_pivoted().then(|| self.rotor.point())
    }

    /// Returns the last of the times, s.
    fn end(&self) -> f64 {
        self.times.last().copied().unwrap_or(self.start.time)
    }

    /// Returns the first torque without a power series, and the reason.
    pub(super) fn rough_torque(&self) -> Option<(usize, &'static str)> {
        let body = self.history.map(|history| (history.body(self.start.time, self.pivot()), history));
        let roughness = |torque: &TorqueModel| {
            let of_changing =
                || body.as_ref().and_then(|(body, history)| body.roughness(torque, history.ball()));
            torque.model().roughness().or_else(of_changing)
        };
        self.torques.iter().enumerate().find_map(|(k, torque)| Some((k, roughness(torque)?)))
    }

    /// Returns the requested method, or the best one.
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

    /// Returns the closed form of the motion.
    ///
    /// # Errors
    /// [`MotionError::NoClosedForm`], or the error that makes the motion undetermined.
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
        let turning = Turning::new(stepper, self.events);
        let start = turning.first(self.start)?;
        let mut march = March::new(turning, self.detector(), self.times);
        let ending = march.run(start, None, progress)?;
        let stepper = march.system.stepper();
        let statistics = stepper.statistics();
        let steps = Steps { tolerance: self.tolerance, statistics };
        let solution = match rule {
            Rule::Taylor => Solution::Taylor(steps),
            Rule::Dop853 => Solution::Dop853(steps),
            Rule::Splitting { order, step } => Solution::Splitting { order, step, statistics },
        };
        let sides = march.detector().sides();
        Ok(Trajectory::assembled(start, march.samples, solution)
            .because(reason)
            .with_events(march.crossings, ending)
            .leaving_events(sides))
    }

    /// Creates the event detector.
    pub(super) fn detector(&self) -> EventDetector<'a> {
        EventDetector::new(self.rotor, self.torques, (self.events, self.event_sides), &self.start)
    }

    /// Computes the samples of a closed form, which has no steps. Events are located in stretches
    /// of time.
    fn exact(&self, motion: ClosedForm, reason: MethodReason) -> Result<Trajectory, MotionError> {
        /// Rotation in a stretch, rad. Each stretch counts as this number of steps.
        const STRETCH: u64 = 16;
        const MOST_LOOKS: u64 = MOST_STEPS / STRETCH;
        let end = self.end();
        // Only an event that stops the motion can bring the end nearer.
        let stops = self.events.iter().any(|event| event.action() == EventAction::Stop);
        let mut watch = self.detector();
        // For a body released at rest, the time scale follows from the torque.
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

/// Selected way to compute the motion.
enum Way {
    Closed(ClosedForm),
    Steps(Rule),
}
