//! Simulations: trajectories from a start, by the best available method.

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

/// Initial value problem: a free or pivoted rotor under torques, a body on the ground, or a rotor
/// in gimbals. It includes the events to detect, and the method.
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

/// System that moves, and its start.
#[derive(Clone, Copy, Debug)]
enum Subject<'a> {
    Rotor { rotor: &'a Rotor, torques: &'a [TorqueModel], start: State },
    Ground { body: &'a MassProperties<Body>, contact: &'a Contact, start: ContactStart },
    Gimbals { body: &'a MassProperties<Body>, gimbals: &'a Gimbals, start: f64 },
}

/// Simulation in the form of the problem of its system.
#[derive(Clone, Copy, Debug)]
pub(super) enum Problem<'a> {
    Rotor(RotorProblem<'a>),
    Ground(ContactProblem<'a>),
    Gimbals(GimbalProblem<'a>),
}

impl<'a> Simulation<'a> {
    /// Creates the problem of a rotor under torques, from a start to times (s, ascending, none
    /// before the start).
    ///
    /// Defaults: [`Method::Auto`], a tolerance of 1e-13, no events, and all torques switched on.
    pub const fn new(rotor: &'a Rotor, torques: &'a [TorqueModel], start: State, times: &'a [f64]) -> Self {
        Self::of(Subject::Rotor { rotor, torques, start }, times, 1e-13)
    }

    /// Creates the problem of a body on the ground, from a start to times (s, ascending, none
    /// before the start).
    ///
    /// The method is collocation or Taylor series. The default tolerance is 1e-15. A tolerance
    /// looser than 1e-12 counts as 1e-12, because the next phase of a contact depends on signs. No
    /// events by default.
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

    /// Creates the problem of a rotor in two gimbals, from the time `start`, s, to times (s,
    /// ascending, none before the start). The axes of `gimbals` state their initial angles and
    /// rates.
    ///
    /// The method is Taylor series. Defaults: a tolerance of 1e-15, no events.
    ///
    /// # Accuracy
    /// Motions of some seconds agree to 1e-13 with `fixtures/gimbals.py`, an independent
    /// formulation in 36 digits.
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
    /// let gimbals = gimbals.with_base(Base::on_earth(latitude)?);
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

    /// Sets the history of the mass properties. The mass properties of the rotor must be those at
    /// the start.
    #[must_use]
    pub const fn changing(self, history: Option<&'a MassHistory>) -> Self {
        Self { history, ..self }
    }

    /// Sets the events to detect. On the ground and in gimbals they may stop the motion, but not
    /// switch torques.
    #[must_use]
    pub const fn events(self, events: &'a [Event]) -> Self {
        Self { events, ..self }
    }

    /// Sets the sides of the events' values on which the motion starts, to continue another motion.
    #[must_use]
    pub const fn event_sides(self, event_sides: &'a [EventSide]) -> Self {
        Self { event_sides, ..self }
    }

    /// Sets the torques, by index from 0, that are switched off until an event switches them on.
    #[must_use]
    pub const fn switched_off(self, switched_off: &'a [usize]) -> Self {
        Self { switched_off, ..self }
    }

    /// Sets the method. On the ground and in gimbals only [`Method::Auto`] and [`Method::Taylor`]
    /// are possible.
    #[must_use]
    pub const fn method(self, method: Method) -> Self {
        Self { method, ..self }
    }

    /// Sets the bound on the error of each step. For a rotor: attitude in rad, ω relative.
    /// Otherwise: relative to the sizes of the variables. Closed forms and splitting ignore it.
    #[must_use]
    pub const fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// Computes the motion at each of the times. See [`Simulation::run_watched`].
    ///
    /// # Errors
    /// The errors of [`Simulation::run_watched`], except [`MotionError::Stopped`].
    pub fn run(&self) -> Result<Trajectory, MotionError> {
        self.run_watched(&mut |_| true)
    }

    /// Computes the motion at each of the times, as far as possible. `progress` receives the time
    /// (s) after each step; if it returns `false`, the computation stops.
    ///
    /// Three things end a motion early: an event that stops it, a change of the contact after which
    /// it is not known, and an error of the computation. The ending is then a sample, and
    /// [`Trajectory::ending`] states time and cause.
    ///
    /// # Errors
    /// Errors in the inputs, before the motion begins:
    ///
    /// - times out of order; a start or a torque that is not finite; an event that cannot be
    ///   measured; a body that cannot spin;
    /// - no closed form for [`Method::Exact`], or a torque without a power series for
    ///   [`Method::Taylor`];
    /// - a start that violates the contact; [`MotionError::Painleve`] and
    ///   [`MotionError::Undecided`] if the beginning of a motion on the ground is not determined;
    /// - gimbals that lock at the start;
    /// - [`MotionError::Exclusive`] for options that the system does not support.
    ///
    /// During the run: [`MotionError::Stopped`] if `progress` returned `false`.
    pub fn run_watched(&self, progress: &mut dyn FnMut(f64) -> bool) -> Result<Trajectory, MotionError> {
        match self.problem()? {
            Problem::Rotor(problem) => problem.run(progress),
            Problem::Ground(problem) => on_ground::run(&problem, progress),
            Problem::Gimbals(problem) => in_gimbals::run(&problem, progress),
        }
    }

    /// Computes the states at each of the times and nothing else: no events, no samples, no error
    /// estimate. Intended for inner loops.
    ///
    /// # Errors
    /// The errors of [`Simulation::run`]. A cause that ends a run early is an error here.
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

    /// Appends the states of [`Simulation::states`]. After an error, the states before it remain.
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

    /// Returns the start time, s.
    pub(super) const fn begins(&self) -> f64 {
        match &self.subject {
            Subject::Rotor { start, .. } => start.time,
            Subject::Ground { start, .. } => start.state.time,
            Subject::Gimbals { start, .. } => *start,
        }
    }

    /// Returns the last of the times, s.
    pub(super) fn ends(&self) -> f64 {
        self.times.last().copied().unwrap_or_else(|| self.begins())
    }

    /// Returns the problem of the system.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for options that the system does not support.
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

    /// Checks that only options for a body on the ground or in gimbals are set.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for an option that only rotors support.
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

/// Reasons why options of rotors are not available on the ground or in gimbals.
struct Held {
    /// Section of a scenario that describes the ground contact or the gimbals.
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
    /// Computes the motion from `start` at each of `times` (ascending, s, none before the start).
    ///
    /// `tolerance` bounds the error of each integration step, attitude in rad and ω relative.
    /// Closed forms and splitting ignore it. A computation that fails ends early; see
    /// [`Trajectory::ending`]. [`Simulation`] offers the same with events.
    ///
    /// # Errors
    /// The errors of [`Simulation::run`].
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
