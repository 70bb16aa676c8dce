//! Scenarios: one body and one motion.

use super::asked::{ActingTorque, Forward, GroundContact, Mechanism, Suspension, Task};
use super::mounted_shaft::MountedShaft;
use super::run::Run;
use crate::body::assembly::BodyPart;
use crate::body::finding::Finding;
use crate::body::mass_properties::MassProperties;
use crate::body::particles::Particle;
use crate::math::frame::{Body, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularVelocity, Position, Velocity};
use crate::motion::contact::ContactStart;
use crate::motion::error::MotionError;
use crate::motion::gimbal::Gimbals;
use crate::motion::inverse::prescribed::Prescribed;
use crate::motion::model::event::Event;
use crate::motion::model::event_detection::EventSide;
use crate::motion::model::mass_history::MassHistory;
use crate::motion::model::orbit::Orbit;
use crate::motion::model::pointing::Pointing;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::model::wheel::Wheel;
use crate::motion::run::channels::CONTACT;
use crate::motion::run::simulation::Simulation;

/// One body and one motion, as in a scenario file. Every value of this type is consistent and can
/// be computed.
///
/// ```
/// use polhode::motion::Run;
/// use polhode::prelude::*;
/// let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// let body = MassProperties::new(2.0, Position::new(0.0, 0.1, 0.5), inertia)?;
/// let omega = AngularVelocity::new(0.3, -0.2, 4.0);
/// let scenario = Scenario::new(body)
///     .held_at(Position::ZERO)?
///     .starting(State { time: 0.0, attitude: Attitude::identity(), omega })?
///     .with_torques([TorqueModel::Gravity(UniformGravity::STANDARD)])?
///     .sampled(Run::evenly(2.0, 201, Method::Auto, 1e-13));
/// let motion = scenario.simulate().ok_or("it has a run")??;
/// assert_eq!(motion.samples().len(), 201);
/// // It moves under gravity, and so cannot be led through a motion that is given.
/// let led = polhode::motion::Prescribed::euler_rates([0.0, 1.1, 0.3], [0.5, 0.0, 30.0])?;
/// assert!(scenario.prescribed_as(led).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    title: Option<String>,
    parts: Vec<BodyPart>,
    body: MassProperties<Body>,
    pivot: Option<Position<Body>>,
    rotor: Rotor,
    start: State,
    velocity: Velocity<Space>,
    orbit: Option<Orbit>,
    pointings: Vec<Pointing>,
    wheel_names: Vec<Option<String>>,
    history: Option<MassHistory>,
    contact: Option<Box<GroundContact>>,
    gimbals: Option<Box<Gimbals>>,
    task: Task,
    run: Option<Run>,
    findings: Vec<Finding>,
}

impl Scenario {
    /// Creates a scenario with a free body at rest, body axes along space axes.
    pub fn new(body: MassProperties<Body>) -> Self {
        Self {
            title: None,
            parts: Vec::new(),
            body,
            pivot: None,
            rotor: Rotor::free(&body),
            start: State { time: 0.0, attitude: Rotation::identity(), omega: AngularVelocity::ZERO },
            velocity: Velocity::ZERO,
            orbit: None,
            pointings: Vec::new(),
            wheel_names: Vec::new(),
            history: None,
            contact: None,
            gimbals: None,
            task: Task::Forward(Forward::default()),
            run: None,
            findings: Vec::new(),
        }
    }

    /// Sets the title.
    #[must_use]
    pub fn titled(self, title: impl Into<String>) -> Self {
        Self { title: Some(title.into()), ..self }
    }

    /// Sets the parts of which the body was assembled.
    #[must_use]
    pub fn made_of(self, parts: Vec<BodyPart>) -> Self {
        Self { parts, ..self }
    }

    /// Sets the sample times and the method.
    #[must_use]
    pub fn sampled(self, run: Run) -> Self {
        Self { run: Some(run), ..self }
    }

    /// Removes the run.
    #[must_use]
    pub fn not_sampled(self) -> Self {
        Self { run: None, ..self }
    }

    /// Adds findings of the checks of the input.
    #[must_use]
    pub fn noting(mut self, findings: impl IntoIterator<Item = Finding>) -> Self {
        self.findings.extend(findings);
        self
    }

    /// Holds a point of the body fixed in space.
    ///
    /// # Errors
    /// The errors of [`Rotor::with_wheels`] for wheels that were added before.
    /// [`MotionError::Exclusive`] for a body on a shaft, or one with a velocity.
    pub fn held_at(self, pivot: Position<Body>) -> Result<Self, MotionError> {
        if self.velocity != Velocity::ZERO {
            return Err(exclusive("pivot", "velocity", "a point of the body is held: it only turns"));
        }
        if self.gimbals.is_some() {
            return Err(exclusive("gimbals", "pivot", HUNG));
        }
        if matches!(self.task, Task::Shaft(..)) {
            return Err(exclusive("shaft", "pivot", "the bearings hold the body"));
        }
        let rotor = Rotor::pivoted(&self.body, pivot).with_wheels(self.rotor.wheels())?;
        Ok(Self { pivot: Some(pivot), rotor, ..self })
    }

    /// Adds momentum wheels.
    ///
    /// # Errors
    /// The errors of [`Rotor::with_wheels`]. [`MotionError::Exclusive`] for a pendulum, a
    /// prescribed motion or a shaft.
    pub fn with_wheels(self, wheels: &[Wheel]) -> Result<Self, MotionError> {
        self.require_compatible("wheel", !wheels.is_empty())?;
        let carrier = match self.pivot {
            None => Rotor::free(&self.body),
            Some(pivot) => Rotor::pivoted(&self.body, pivot),
        };
        Ok(Self { rotor: carrier.with_wheels(wheels)?, ..self })
    }

    /// Sets the names of the wheels, in their order.
    #[must_use]
    pub fn naming_wheels(self, names: Vec<Option<String>>) -> Self {
        Self { wheel_names: names, ..self }
    }

    /// Sets mass properties that change with time; those at the start become the body's. The start
    /// and the pivot must be set before.
    ///
    /// ```
    /// use polhode::body::InertiaTensor;
    /// use polhode::motion::{MassHistory, MassRow, Method, Outflow, Run};
    /// use polhode::prelude::*;
    /// // A ball of 1 kg drops half of its mass at 2 s and keeps its ω; from then on the same torque
    /// // makes it faster twice as fast.
    /// let ball = |mass: f64| MassProperties::new(mass, Position::ZERO, InertiaTensor::diagonal([0.4 * mass; 3])?);
    /// let row = |time, body| MassRow { time, body, rates: None };
    /// let rows = [row(0.0, ball(1.0)?), row(2.0, ball(1.0)?), row(2.0, ball(0.5)?)];
    /// let history = MassHistory::new(&rows, Outflow::None)?;
    /// let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 0.2)));
    /// let run = Run { times: vec![2.0, 4.0], method: Method::Auto, tolerance: 1e-13 };
    /// let scenario = Scenario::new(ball(1.0)?).with_torques([torque])?.changing(history)?.sampled(run);
    /// let motion = scenario.simulate().ok_or("it has a run")??;
    /// let rates = motion.samples().iter().map(|sample| sample.state.omega.z);
    /// assert!(rates.zip([1.0, 3.0]).all(|(rate, want)| (rate - want).abs() < 1e-13));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for a body with wheels, a pendulum, a prescribed motion or a
    /// shaft. The errors of [`MassHistory::at`].
    pub fn changing(self, history: MassHistory) -> Result<Self, MotionError> {
        self.require_compatible("mass_history", true)?;
        let (body, _) = history.at(self.start.time)?;
        let rotor = history.rotor(self.start.time, self.pivot)?;
        Ok(Self { body, rotor, history: Some(history), ..self })
    }

    /// Puts the body on the ground. The start must be set before.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for a body held at a pivot, and for every part that a body on the
    /// ground cannot have. The errors of [`Simulation::run`].
    pub fn on_ground(self, ground: GroundContact) -> Result<Self, MotionError> {
        self.require_compatible("contact", true)?;
        if self.pivot.is_some() {
            return Err(exclusive("contact", "pivot", "the body is held at its point of contact alone"));
        }
        let start = ContactStart { state: self.start, at: ground.at, velocity: ground.velocity };
        let motion =
            Simulation::on_ground(&self.body, &ground.contact, start, &[]).events(self.events()).run()?;
        let velocity = motion.channel(CONTACT).map_or(self.velocity, |at| at.start().velocity);
        Ok(Self { velocity, contact: Some(Box::new(ground)), ..self })
    }

    /// Suspends the body in gimbals. Their axes determine the start.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for a body that is held at a pivot or has a velocity, and for
    /// every part that a rotor in gimbals cannot have. The errors of [`Simulation::run`].
    pub fn in_gimbals(self, gimbals: Gimbals) -> Result<Self, MotionError> {
        self.require_compatible("gimbals", true)?;
        if self.pivot.is_some() && self.gimbals.is_none() {
            return Err(exclusive("gimbals", "pivot", HUNG));
        }
        if self.velocity != Velocity::ZERO {
            return Err(exclusive("gimbals", "velocity", "the crossing of the axes does not move"));
        }
        let motion = Simulation::in_gimbals(&self.body, &gimbals, self.start.time, &[]).run()?;
        let (start, point) = (motion.start().state, gimbals.crossing());
        let rotor = Rotor::pivoted(&self.body, point);
        Ok(Self { start, rotor, pivot: Some(point), gimbals: Some(Box::new(gimbals)), ..self })
    }

    /// Sets the start: time, attitude and ω. A prescribed motion has its own start.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if a number is not finite.
    /// [`MotionError::Exclusive`] for a rotor in gimbals.
    pub fn starting(self, start: State) -> Result<Self, MotionError> {
        if self.gimbals.is_some() {
            return Err(exclusive("gimbals", "start", "the angles of the axes say how the rotor starts"));
        }
        for (what, value) in [
            ("the start's time", start.time),
            ("the start's attitude", start.attitude.quaternion().iter().sum()),
            ("the start's angular velocity", start.omega.norm()),
        ] {
            require::finite(what, value)?;
        }
        Ok(Self { start, ..self })
    }

    /// Sets the velocity of the centre of mass, m/s.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for a body that is held at a pivot or by bearings.
    pub fn moving(self, velocity: Velocity<Space>) -> Result<Self, MotionError> {
        if self.rotor.is_pivoted() {
            return Err(exclusive("pivot", "velocity", "a point of the body is held: it only turns"));
        }
        if self.orbit.is_some() {
            return Err(exclusive("orbit", "velocity", "the orbit says how the centre of mass moves"));
        }
        Ok(Self { velocity, ..self })
    }

    /// Sets the orbit of the centre of mass. Torques that depend on the position have their own
    /// orbit, which should be the same.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for a body that is held by bearings or has a velocity.
    pub fn in_orbit(self, orbit: Orbit) -> Result<Self, MotionError> {
        self.require_compatible("orbit", true)?;
        if self.velocity != Velocity::ZERO {
            return Err(exclusive("orbit", "velocity", "the orbit says how the centre of mass moves"));
        }
        Ok(Self { orbit: Some(orbit), ..self })
    }

    /// Sets the pointing angles to report.
    #[must_use]
    pub fn pointing(self, pointings: Vec<Pointing>) -> Self {
        Self { pointings, ..self }
    }

    /// Sets the torques.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for a prescribed motion or a shaft.
    pub fn with_torques<T: Into<ActingTorque>>(
        self,
        torques: impl IntoIterator<Item = T>,
    ) -> Result<Self, MotionError> {
        let torques: Vec<ActingTorque> = torques.into_iter().map(Into::into).collect();
        self.require_compatible("torque", !torques.is_empty())?;
        Ok(self.changed(|task| {
            task.switched_off = (0..torques.len()).filter(|&k| !torques[k].is_on).collect();
            (task.torques, task.names) =
                torques.into_iter().map(|torque| (torque.model, torque.name)).unzip();
        }))
    }

    /// Sets the events to detect.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for a prescribed motion or a shaft.
    pub fn watching(self, events: Vec<Event>) -> Result<Self, MotionError> {
        self.require_compatible("event", !events.is_empty())?;
        Ok(self.changed(|task| (task.events, task.event_sides) = (events, Vec::new())))
    }

    /// Suspends the body from an axis, under the gravity that acts on it.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for a body with wheels, a prescribed motion or a shaft. The
    /// errors of [`Pendulum::hung`](crate::motion::Pendulum::hung).
    pub fn suspended_from(self, hanging: Suspension) -> Result<Self, MotionError> {
        self.require_compatible("pendulum", true)?;
        let hung = self.changed(|task| task.hanging = Some(hanging));
        hung.pendulum().transpose()?;
        Ok(hung)
    }

    /// Sets a prescribed motion, which also determines the start.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for a body under torques or with wheels, and for events, a
    /// pendulum or a shaft.
    pub fn prescribed_as(self, motion: Prescribed) -> Result<Self, MotionError> {
        self.require_compatible("prescribed", true)?;
        let start = starting_as(&motion, self.start);
        Ok(Self { task: Task::Inverse(motion), start, ..self })
    }

    /// Mounts the body on a shaft, which turns from the attitude of the start.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for any other support or motion of the body. The errors of
    /// [`Prescribed::fixed_axis`].
    pub fn mounted(self, shaft: MountedShaft) -> Result<Self, MotionError> {
        self.require_compatible("shaft", true)?;
        if self.pivot.is_some() {
            return Err(exclusive("shaft", "pivot", "the bearings hold the body"));
        }
        if self.velocity != Velocity::ZERO {
            return Err(exclusive("shaft", "velocity", "the bearings hold the body"));
        }
        let (point, axis) = (shaft.shaft.point(), shaft.shaft.axis());
        let motion = Prescribed::fixed_axis(self.start.attitude, axis, shaft.rate, shaft.acceleration)?;
        let start = starting_as(&motion, self.start);
        let rotor = Rotor::pivoted(&self.body, point);
        Ok(Self { pivot: Some(point), rotor, start, task: Task::Shaft(Box::new(shaft), motion), ..self })
    }

    pub(super) fn changed(mut self, change: impl FnOnce(&mut Forward)) -> Self {
        if let Task::Forward(forward) = &mut self.task {
            change(forward);
        }
        self
    }

    /// Checks that a new part is compatible with the existing ones.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] if it is not.
    fn require_compatible(&self, comes: &'static str, is_any: bool) -> Result<(), MotionError> {
        let is_there = |part: &str| match part {
            "prescribed" => matches!(self.task, Task::Inverse(_)),
            "shaft" => matches!(self.task, Task::Shaft(..)),
            "torque" => !self.torques().is_empty(),
            "event" => !self.events().is_empty(),
            "orbit" => self.orbit.is_some(),
            "pendulum" => self.suspension().is_some(),
            "mass_history" => self.history.is_some(),
            "contact" => self.contact.is_some(),
            "gimbals" => self.gimbals.is_some(),
            _ => !self.wheels().is_empty(),
        };
        let excluded = Self::EXCLUSIVE
            .into_iter()
            .find(|&(a, b, _)| (a == comes && is_there(b)) || (b == comes && is_there(a)));
        match excluded {
            Some((a, b, why)) if is_any => Err(exclusive(a, b, why)),
            _ => Ok(()),
        }
    }

    /// Returns the title.
    pub fn title(&self) -> Option<&str> {
        self.title.as_deref()
    }

    /// Returns the parts of the body.
    pub fn parts(&self) -> &[BodyPart] {
        &self.parts
    }

    /// Returns the mass properties of the whole body.
    pub const fn body(&self) -> &MassProperties<Body> {
        &self.body
    }

    /// Returns the body with its wheels and its reference point: the centre of mass or the pivot.
    pub const fn rotor(&self) -> &Rotor {
        &self.rotor
    }

    /// Returns the point of the body that is fixed in space; `None` for a free body.
    pub const fn pivot(&self) -> Option<Position<Body>> {
        self.pivot
    }

    /// Returns the start: time, attitude and ω.
    pub const fn start(&self) -> State {
        self.start
    }

    /// Returns the velocity of the centre of mass, m/s; zero for a body held at a pivot.
    pub const fn velocity(&self) -> Velocity<Space> {
        self.velocity
    }

    /// Returns the orbit of the centre of mass, if there is one.
    pub const fn orbit(&self) -> Option<&Orbit> {
        self.orbit.as_ref()
    }

    /// Returns the pointing angles to report.
    pub fn pointings(&self) -> &[Pointing] {
        &self.pointings
    }

    /// Returns the task.
    pub const fn task(&self) -> &Task {
        &self.task
    }

    fn forward(&self) -> Option<&Forward> {
        match &self.task {
            Task::Forward(forward) => Some(forward),
            _ => None,
        }
    }

    /// Returns the torques.
    pub fn torques(&self) -> &[TorqueModel] {
        self.forward().map_or(&[], |forward| &forward.torques)
    }

    /// Returns the names of the torques; `None` for a torque without a name.
    pub fn torque_names(&self) -> &[Option<String>] {
        self.forward().map_or(&[], |forward| &forward.names)
    }

    /// Returns the indices, from 0, of the torques that act only after an event has switched them
    /// on.
    pub fn switched_off(&self) -> &[usize] {
        self.forward().map_or(&[], |forward| &forward.switched_off)
    }

    /// Returns the initial side of each event's value if the scenario continues another motion;
    /// otherwise empty.
    pub(super) fn event_sides(&self) -> &[EventSide] {
        self.forward().map_or(&[], |forward| &forward.event_sides)
    }

    /// Returns the events to detect.
    pub fn events(&self) -> &[Event] {
        self.forward().map_or(&[], |forward| &forward.events)
    }

    /// Returns the momentum wheels.
    pub fn wheels(&self) -> &[Wheel] {
        self.rotor.wheels()
    }

    /// Returns the mass history, if the mass properties change.
    pub const fn history(&self) -> Option<&MassHistory> {
        self.history.as_ref()
    }

    /// Returns the support of the body.
    pub fn mechanism(&self) -> Mechanism<'_> {
        match (&self.contact, &self.gimbals) {
            (Some(ground), _) => Mechanism::Ground(ground),
            (None, Some(gimbals)) => Mechanism::Gimbals(gimbals),
            (None, None) => Mechanism::Rotor,
        }
    }

    /// Returns the contact with the ground, if there is one.
    pub fn ground(&self) -> Option<&GroundContact> {
        self.contact.as_deref()
    }

    /// True if the motion is torque-free: no torques, wheels, support or mass history.
    pub fn is_free(&self) -> bool {
        let alone = self.torques().is_empty() && self.wheels().is_empty();
        let is_held = self.contact.is_some() || self.gimbals.is_some();
        alone && self.prescribed().is_none() && self.history.is_none() && !is_held
    }

    /// Returns the name of a wheel, by index from 0, if it has one.
    pub fn wheel_name(&self, wheel: usize) -> Option<&str> {
        self.wheel_names.get(wheel)?.as_deref()
    }

    /// Returns the prescribed motion, including that of a shaft.
    pub const fn prescribed(&self) -> Option<&Prescribed> {
        match &self.task {
            Task::Forward(_) => None,
            Task::Inverse(motion) | Task::Shaft(_, motion) => Some(motion),
        }
    }

    /// Returns the axis of a pendulum, if there is one.
    pub fn suspension(&self) -> Option<Suspension> {
        self.forward()?.hanging
    }

    /// Returns the shaft in its bearings, if there is one. The prescribed motion is then that of
    /// the shaft.
    pub fn shaft(&self) -> Option<&MountedShaft> {
        match &self.task {
            Task::Shaft(mounted, _) => Some(mounted),
            _ => None,
        }
    }

    /// Returns the sample times and the method.
    pub const fn run(&self) -> Option<&Run> {
        self.run.as_ref()
    }

    /// Returns the findings of the checks of the input.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// Returns all particles of the body.
    pub fn particles(&self) -> Vec<Particle<Body>> {
        self.parts.iter().flat_map(|part| part.particles.iter().copied()).collect()
    }

    /// True if the body consists of particles only.
    pub fn is_all_particles(&self) -> bool {
        self.parts.iter().all(|part| !part.particles.is_empty())
    }
}

const HUNG: &str = "the body is held at the crossing of the gimbals' axes alone";

const fn exclusive(a: &'static str, b: &'static str, why: &'static str) -> MotionError {
    MotionError::Exclusive { parts: [a, b], why }
}

/// Returns the first state of a prescribed motion, or `start` if it has none.
fn starting_as(motion: &Prescribed, start: State) -> State {
    let first = motion.span().map_or(0.0, |[first, _]| first.max(0.0));
    motion.at(first).map_or(start, |(state, _)| state)
}
