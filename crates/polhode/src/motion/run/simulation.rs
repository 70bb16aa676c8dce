//! Simulations: from a start to a trajectory, by the best method there is.

use super::ending::Ending;
use super::rotor_problem::RotorProblem;
use super::trajectory::Trajectory;
use super::{in_gimbals, on_ground};
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::motion::contact::problem::ContactProblem;
use crate::motion::contact::{Contact, ContactStart};
use crate::motion::error::MotionError;
use crate::motion::gimbal::Gimbals;
use crate::motion::gimbal::problem::GimbalProblem;
use crate::motion::model::event::{Event, Measure};
use crate::motion::model::event_detection::EventSide;
use crate::motion::model::mass_history::MassHistory;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::solve::method::Method;

/// An initial value problem: a free or pivoted rotor under torques, a body on the ground or a rotor in
/// gimbals, the events to detect, and the method.
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
    subject: Subject<'a>,
    history: Option<&'a MassHistory>,
    switched_off: &'a [usize],
    events: &'a [Event],
    event_sides: &'a [EventSide],
    times: &'a [f64],
    method: Method,
    tolerance: f64,
}

/// The system that moves, and its start.
#[derive(Clone, Copy, Debug)]
enum Subject<'a> {
    Rotor { rotor: &'a Rotor, torques: &'a [TorqueModel], start: State },
    Ground { body: &'a MassProperties<Body>, contact: &'a Contact, start: ContactStart },
    Gimbals { body: &'a MassProperties<Body>, gimbals: &'a Gimbals, start: f64 },
}

/// A simulation as the problem of its system.
#[derive(Clone, Copy, Debug)]
pub(super) enum Problem<'a> {
    Rotor(RotorProblem<'a>),
    Ground(ContactProblem<'a>),
    Gimbals(GimbalProblem<'a>),
}

impl<'a> Simulation<'a> {
    /// A rotor under torques, all of which act, from a start to times (s, ascending, none before the
    /// start): by the best method at a tolerance of 1e-13, without events.
    pub const fn new(rotor: &'a Rotor, torques: &'a [TorqueModel], start: State, times: &'a [f64]) -> Self {
        Self::of(Subject::Rotor { rotor, torques, start }, times, 1e-13)
    }

    /// A body on the ground, from a start to times (s, ascending, none before the start): by collocation
    /// or Taylor series at a tolerance of 1e-15, without events. A looser tolerance than 1e-12 counts as
    /// 1e-12, as the next phase of a contact depends on signs.
    ///
    /// ```
    /// use polhode::motion::channel;
    /// use polhode::motion::contact::{BodySurface, Contact, ContactStart, SurfaceShape};
    /// use polhode::prelude::*;
    /// // A homogeneous ball, which rolls as it would without a ground that holds it: with constant velocity a ω.
    /// let ball = MassProperties::new(2.0, Position::ZERO, InertiaTensor::diagonal([0.008; 3])?)?;
    /// let surface = BodySurface::new(SurfaceShape::Sphere { radius: 0.1 }, Position::ZERO, Rotation::identity())?;
    /// let omega = AngularVelocity::new(0.0, 3.0, 0.0);
    /// let start = ContactStart::rolling(State { time: 0.0, attitude: Attitude::identity(), omega });
    /// let motion = Simulation::on_ground(&ball, &Contact::rolling(surface), start, &[2.0]).run()?;
    /// let end = motion.channel(channel::CONTACT).and_then(|contact| contact.last()).ok_or("it has a sample")?;
    /// assert!((end.contact.x - 0.6).abs() < 1e-14 && (end.normal_force - 2.0 * 9.80665).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const fn on_ground(
        body: &'a MassProperties<Body>,
        contact: &'a Contact,
        start: ContactStart,
        times: &'a [f64],
    ) -> Self {
        Self::of(Subject::Ground { body, contact, start }, times, 1e-15)
    }

    /// A body as the rotor of two gimbals, whose axes state where they start, from the time `start`, s,
    /// to times (s, ascending, none before the start): by Taylor series at a tolerance of 1e-15, without
    /// events.
    ///
    /// # Accuracy
    /// Motions of some seconds agree with those of `fixtures/gimbals.py`, another formulation in 36 digits, to 1e-13.
    ///
    /// ```
    /// use polhode::motion::channel;
    /// use polhode::motion::gimbal::{Axis, Base, Gimbals};
    /// use polhode::prelude::*;
    /// // A gyrocompass: its axis is kept level, and swings about north, T = 2π √(A/(C ν ω_E cos λ)).
    /// let (a, c, spin, latitude) = (0.012, 0.02, 1500.0, 0.9_f64);
    /// let rotor = MassProperties::new(3.0, Position::ZERO, InertiaTensor::diagonal([a, a, c])?)?;
    /// let period = std::f64::consts::TAU * (a / (c * spin * Base::EARTH_RATE * latitude.cos())).sqrt();
    /// // The outer axis up, the inner one east, so that the rotor's, up × east, is north.
    /// let axes = [Axis::free(1e-3, 0.0)?, Axis::locked(0.0)?, Axis::driven(0.0, spin)?];
    /// let gimbals = Gimbals::new(Direction::new(0.0, 0.0, 1.0), Direction::new(1.0, 0.0, 0.0), axes)?;
    /// let gimbals = gimbals.on(Base::on_earth(latitude)?);
    /// let motion = Simulation::in_gimbals(&rotor, &gimbals, 0.0, &[period]).run()?;
    /// let angles = motion.channel(channel::AXIS_ANGLES).and_then(|angles| angles.last()).ok_or("it has a sample")?;
    /// assert!((angles[0] - 1e-3).abs() < 1e-9 && motion.energy_drift() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const fn in_gimbals(
        body: &'a MassProperties<Body>,
        gimbals: &'a Gimbals,
        start: f64,
        times: &'a [f64],
    ) -> Self {
        Self::of(Subject::Gimbals { body, gimbals, start }, times, 1e-15)
    }

    const fn of(subject: Subject<'a>, times: &'a [f64], tolerance: f64) -> Self {
        let (history, switched_off, events, event_sides, method) = (None, &[], &[], &[], Method::Auto);
        Self { subject, history, switched_off, events, event_sides, times, method, tolerance }
    }

    /// A rotor whose mass properties are these over time: those of the rotor are its mass properties at the start.
    #[must_use]
    pub const fn changing(self, history: Option<&'a MassHistory>) -> Self {
        Self { history, ..self }
    }

    /// Detects these events. On the ground and in gimbals they may stop the motion, and switch nothing.
    #[must_use]
    pub const fn events(self, events: &'a [Event]) -> Self {
        Self { events, ..self }
    }

    /// Starts on these sides of the events' values, where another motion goes on.
    #[must_use]
    pub const fn event_sides(self, event_sides: &'a [EventSide]) -> Self {
        Self { event_sides, ..self }
    }

    /// Leaves these torques, from 0, switched off until an event switches them on.
    #[must_use]
    pub const fn switched_off(self, switched_off: &'a [usize]) -> Self {
        Self { switched_off, ..self }
    }

    /// Requests this method. On the ground and in gimbals it is [`Method::Auto`] or [`Method::Taylor`].
    #[must_use]
    pub const fn method(self, method: Method) -> Self {
        Self { method, ..self }
    }

    /// Bounds the error of each step: of a rotor the attitude in rad and ω relative, elsewhere relative to
    /// the sizes of the variables. Closed forms and splitting ignore it.
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

    /// The motion at each of the times, as far as it goes: [`Trajectory::ending`] states where and why it
    /// ended. An event that stops it, a change of the contact after which it is not known, and a
    /// computation that cannot go on, end it with a sample of their own. `progress` receives the time (s)
    /// after each step; `false` ends the work.
    ///
    /// # Errors
    /// [`MotionError`] for what is wrong before the motion begins: times out of order, a start or a torque that is not finite, an
    /// event that cannot be measured, no closed form for [`Method::Exact`], a torque without a power series for
    /// [`Method::Taylor`], a body that cannot spin; a start that violates the contact, [`MotionError::Painleve`] and
    /// [`MotionError::Undecided`] where it is not known how a motion on the ground begins; gimbals that lock at the start;
    /// [`MotionError::Exclusive`] of what a system does not have. [`MotionError::Stopped`] if `progress` said so.
    pub fn run_watched(&self, progress: &mut dyn FnMut(f64) -> bool) -> Result<Trajectory, MotionError> {
        match self.problem()? {
            Problem::Rotor(problem) => problem.run(progress),
            Problem::Ground(problem) => on_ground::run(&problem, progress),
            Problem::Gimbals(problem) => in_gimbals::run(&problem, progress),
        }
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
        let motion = match self.problem()? {
            Problem::Rotor(problem) => return problem.fill(states),
            Problem::Ground(problem) => {
                on_ground::run(&ContactProblem { events: &[], event_sides: &[], ..problem }, &mut |_| true)?
            }
            Problem::Gimbals(problem) => {
                in_gimbals::run(&GimbalProblem { events: &[], event_sides: &[], ..problem }, &mut |_| true)?
            }
        };
        states.extend(motion.samples().iter().map(|sample| sample.state));
        match motion.ending() {
            Ending::Complete | Ending::Stopped { .. } => Ok(()),
            Ending::Contact { change, time } => {
                Err(MotionError::ContactChanged { what: change.description(), time: *time })
            }
            Ending::Failed { cause, .. } => Err(cause.clone()),
        }
    }

    /// Time of the start, s.
    pub(super) const fn begins(&self) -> f64 {
        match &self.subject {
            Subject::Rotor { start, .. } => start.time,
            Subject::Ground { start, .. } => start.state.time,
            Subject::Gimbals { start, .. } => *start,
        }
    }

    /// Last of the times, s.
    pub(super) fn ends(&self) -> f64 {
        self.times.last().copied().unwrap_or_else(|| self.begins())
    }

    /// The problem of its system.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of what the system does not have.
    pub(super) fn problem(&self) -> Result<Problem<'a>, MotionError> {
        let Self { history, switched_off, events, event_sides, times, method, tolerance, .. } = *self;
        match self.subject {
            Subject::Rotor { rotor, torques, start } => Ok(Problem::Rotor(RotorProblem {
                rotor,
                history,
                torques,
                switched_off,
                start,
                events,
                event_sides,
                times,
                method,
                tolerance,
            })),
            Subject::Ground { body, contact, start } => {
                self.require_held(&ON_GROUND)?;
                let noise = None;
                Ok(Problem::Ground(ContactProblem {
                    body,
                    contact,
                    start,
                    times,
                    events,
                    event_sides,
                    tolerance,
                    noise,
                }))
            }
            Subject::Gimbals { body, gimbals, start } => {
                self.require_held(&IN_GIMBALS)?;
                let noise = None;
                Ok(Problem::Gimbals(GimbalProblem {
                    body,
                    gimbals,
                    start,
                    times,
                    events,
                    event_sides,
                    tolerance,
                    noise,
                }))
            }
        }
    }

    /// # Errors
    /// [`MotionError::Exclusive`] of what rotors alone have.
    fn require_held(&self, held: &Held) -> Result<(), MotionError> {
        let is_method = matches!(self.method, Method::Auto | Method::Taylor);
        let measures = |event: &Event| matches!(event.measure(), Measure::TotalEnergy);
        let rules = [
            ("method", is_method, held.method),
            ("mass_history", self.history.is_none(), "its mass properties stay as they are"),
            ("torque", self.switched_off.is_empty(), held.torque),
            ("event", !self.events.iter().any(Event::switches), held.torque),
            ("event", !self.events.iter().any(measures), held.energy),
        ];
        match rules.into_iter().find(|(_, holds, _)| !holds) {
            Some((part, _, why)) => Err(MotionError::Exclusive { parts: [held.part, part], why }),
            None => Ok(()),
        }
    }
}

/// Reasons why what rotors have does not go with a body that something holds.
struct Held {
    /// The part of a scenario that holds it.
    part: &'static str,
    method: &'static str,
    torque: &'static str,
    energy: &'static str,
}

const ON_GROUND: Held = Held {
    part: "contact",
    method: "a body on the ground is computed by collocation or Taylor series, method \"auto\" or \"taylor\"",
    torque: "no torque but those of the contact acts on a body on the ground",
    energy: "the energy of a body on the ground includes that of its centre of mass",
};

const IN_GIMBALS: Held = Held {
    part: "gimbals",
    method: "a rotor in gimbals is computed by Taylor series, method \"auto\" or \"taylor\"",
    torque: "no torque but those of the axes acts on a rotor in gimbals",
    energy: "the energy of a rotor in gimbals includes that of the gimbals",
};

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
