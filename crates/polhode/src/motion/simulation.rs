//! Simulations: from a start to a trajectory, by the best method there is.

use super::course::{Course, MOST_STEPS};
use super::ending::{Ending, MethodReason};
use super::error::MotionError;
use super::event::{Crossing, Event, EventAction};
use super::free::FreeMotion;
use super::propagate::stepper::{Rule, Stepper};
use super::rotor::Rotor;
use super::solution::Solution;
use super::state::State;
use super::torque::TorqueModel;
use super::trajectory::{Method, Trajectory, require_ascending};
use super::watch::Watch;

/// A body, what turns it, what to look out for, and how to compute it.
///
/// ```
/// use polhode::*;
/// // Spun up from rest by N along z until it turns at 3 rad/s: t = I ω / N.
/// let body = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 2.5])?)?;
/// let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 0.5)));
/// let rate = Measure::OmegaBody(Direction::new(0.0, 0.0, 1.0));
/// let fast = Event::new("fast enough", rate, 3.0, Sense::Rising, EventAction::Stop)?;
/// let motion = Simulation {
///     rotor: &Rotor::free(&body),
///     torques: &[torque],
///     switched_off: &[],
///     start: State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO },
///     events: &[fast],
///     times: &[0.0, 100.0],
///     method: Method::Auto,
///     tolerance: 1e-13,
/// }
/// .run(&mut |_| {})?;
/// let Ending::Stopped { time, .. } = *motion.ending() else { return Err("it does not stop".into()) };
/// assert!((time - 2.5 * 3.0 / 0.5).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Simulation<'a> {
    /// The body and the point that it turns about.
    pub rotor: &'a Rotor,
    /// What turns it.
    pub torques: &'a [TorqueModel],
    /// Which of the torques, from 0, are switched off until an event switches them on.
    pub switched_off: &'a [usize],
    /// Where it starts.
    pub start: State,
    /// What to look out for.
    pub events: &'a [Event],
    /// When to sample it, s: ascending, none before the start.
    pub times: &'a [f64],
    /// How to compute it.
    pub method: Method,
    /// Bound on the error of each integration step, attitude in rad and ω relative; closed forms and splitting ignore it.
    pub tolerance: f64,
}

impl Simulation<'_> {
    /// The motion at each of the times, as far as it goes: [`Trajectory::ending`] says where and why it ended. An event that stops it,
    /// and a computation that cannot go on, end it with a sample of their own. `progress` is told the time (s) after each step.
    ///
    /// # Errors
    /// [`MotionError`] for what is wrong before the motion begins: times out of order, a start or a torque that is not finite, an
    /// event that cannot be measured, no closed form for [`Method::Exact`], a torque without a power series for
    /// [`Method::Taylor`], a body that cannot spin.
    pub fn run(&self, progress: &mut dyn FnMut(f64)) -> Result<Trajectory, MotionError> {
        let Self { rotor, torques, start, events, times, method, .. } = *self;
        require_ascending(start.time, times)?;
        require_finite(rotor, torques, &start)?;
        events.iter().try_for_each(|event| event.require_possible(rotor, torques, events, &start))?;
        let rough = torques.iter().enumerate().find_map(|(k, torque)| Some((k, torque.roughness()?)));
        match (method, self.closed_form(), rough) {
            (Method::Auto, Ok(motion), _) => self.exact(motion, MethodReason::ClosedForm),
            (Method::Exact, Ok(motion), _) => self.exact(motion, MethodReason::Asked),
            (Method::Exact, Err(why), _) => Err(why),
            (Method::Auto, Err(MotionError::NoClosedForm { why: no_closed_form }), Some((torque, why))) => {
                self.integrate(Rule::Dop853, MethodReason::Rough { no_closed_form, torque, why }, progress)
            }
            (Method::Auto, Err(MotionError::NoClosedForm { why: no_closed_form }), None) => {
                self.integrate(Rule::Taylor, MethodReason::Smooth { no_closed_form }, progress)
            }
            (Method::Auto, Err(why), _) => Err(why),
            (Method::Taylor, _, Some((torque, why))) => Err(MotionError::NotSmooth { torque, why }),
            (Method::Taylor, _, None) => self.integrate(Rule::Taylor, MethodReason::Asked, progress),
            (Method::Splitting { order, step }, ..) => {
                self.integrate(Rule::Splitting { order, step }, MethodReason::Asked, progress)
            }
            (Method::Dop853, ..) => self.integrate(Rule::Dop853, MethodReason::Asked, progress),
        }
    }

    /// # Errors
    /// [`MotionError::NoClosedForm`], or what makes the motion undetermined.
    fn closed_form(&self) -> Result<FreeMotion, MotionError> {
        if !self.torques.is_empty() {
            return Err(MotionError::NoClosedForm { why: "a torque acts on the body" });
        }
        FreeMotion::of(self.rotor, self.start)
    }

    fn integrate(
        &self,
        rule: Rule,
        reason: MethodReason,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Trajectory, MotionError> {
        let stepper =
            Stepper::new(rule, self.rotor, self.torques, self.switched_off, self.start, self.tolerance)?;
        let mut course = Course::new(stepper, self.events, self.start, self.times);
        let (start, ending) = course.run(self.start, progress)?;
        let stepper = course.stepper();
        let method = match stepper.rule() {
            Rule::Taylor => Method::Taylor,
            Rule::Dop853 => Method::Dop853,
            Rule::Splitting { order, step } => Method::Splitting { order, step },
        };
        let (tolerance, statistics) = (stepper.tolerance(), stepper.statistics());
        let solution = Solution::Integrated { method, tolerance, statistics };
        Ok(Trajectory::assembled(start, course.samples, solution)
            .because(reason)
            .with_events(course.crossings, ending))
    }

    /// The closed form, which has no steps: it is looked at turn by turn.
    fn exact(&self, motion: FreeMotion, reason: MethodReason) -> Result<Trajectory, MotionError> {
        /// The turn of a stretch, rad.
        const STRETCH: f64 = 16.0;
        let end = self.times.last().copied().unwrap_or(self.start.time);
        let mut watch = Watch::new(self.rotor, self.torques, self.events, &self.start);
        let (mut time, mut looks) = (self.start.time, 0);
        let (mut crossings, mut ending) = (Vec::new(), Ending::Complete);
        while !self.events.is_empty() && time < end && ending == Ending::Complete {
            let step = STRETCH / motion.at(time).omega.norm();
            let next = if time + step < end { time + step } else { end };
            looks += 1;
            if !(next > time) {
                ending = Ending::Failed { time, cause: MotionError::StepTooSmall { time, step } };
            } else if looks == MOST_STEPS / 16 {
                let cause = MotionError::TooManySteps { time, step, most: looks };
                ending = Ending::Failed { time, cause };
            } else {
                for found in watch.look([time, next], &|t| motion.at(t)) {
                    let Some(event) = self.events.get(found.event) else { continue };
                    let (name, state) = (event.name().to_owned(), motion.at(found.time));
                    crossings.push(Crossing { event: found.event, name, state, rising: found.rising });
                    if event.action() == EventAction::Stop {
                        ending = Ending::Stopped { event: found.event, time: found.time };
                        break;
                    }
                }
                time = next;
            }
        }
        let times = match ending {
            Ending::Complete => self.times.to_vec(),
            Ending::Stopped { time, .. } | Ending::Failed { time, .. } => {
                let before = self.times.iter().copied().filter(|t| *t < time);
                before.chain([time]).collect()
            }
        };
        Ok(Trajectory::of_motion(motion, &times)?.because(reason).with_events(crossings, ending))
    }
}

/// A start is input: what is wrong with it is not the computation's fault.
fn require_finite(rotor: &Rotor, torques: &[TorqueModel], start: &State) -> Result<(), MotionError> {
    let (energy, momentum) = (rotor.kinetic_energy(start.omega), rotor.angular_momentum(start.omega).norm());
    for (what, value) in [
        ("the start's time", start.time),
        ("the start's attitude", start.attitude.quaternion().iter().sum()),
        ("the start's angular velocity", start.omega.norm()),
        ("the start's kinetic energy", energy),
        ("the start's angular momentum", momentum),
        ("the torque", torques.iter().map(|torque| torque.scale(rotor, start)).sum()),
    ] {
        if !value.is_finite() {
            return Err(MotionError::Parameter { what, value, rule: "finite" });
        }
    }
    Ok(())
}
