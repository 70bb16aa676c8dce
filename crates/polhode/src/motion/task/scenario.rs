//! A scenario: one body, one motion.

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

/// One body and one motion, as a scenario file describes them: what exists can be computed.
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
///     .under([TorqueModel::Gravity(UniformGravity::STANDARD)])?
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
    /// A free body at rest, its axes along those of space.
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

    /// What it is about.
    #[must_use]
    pub fn titled(self, title: impl Into<String>) -> Self {
        Self { title: Some(title.into()), ..self }
    }

    /// The parts that the body was made of.
    #[must_use]
    pub fn made_of(self, parts: Vec<BodyPart>) -> Self {
        Self { parts, ..self }
    }

    /// When to sample the motion, and how to compute it.
    #[must_use]
    pub fn sampled(self, run: Run) -> Self {
        Self { run: Some(run), ..self }
    }

    /// Without a run.
    #[must_use]
    pub fn not_sampled(self) -> Self {
        Self { run: None, ..self }
    }

    /// With what was noticed on the way.
    #[must_use]
    pub fn noting(mut self, findings: impl IntoIterator<Item = Finding>) -> Self {
        self.findings.extend(findings);
        self
    }

    /// With a point of the body held fixed in space.
    ///
    /// # Errors
    /// As [`Rotor::with_wheels`], of wheels that are there already; [`MotionError::Exclusive`] of a body on a shaft, or one that moves.
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

    /// With wheels that spin inside.
    ///
    /// # Errors
    /// As [`Rotor::with_wheels`]; [`MotionError::Exclusive`] of a pendulum, a prescribed motion and a shaft.
    pub fn with_wheels(self, wheels: &[Wheel]) -> Result<Self, MotionError> {
        self.require_compatible("wheel", !wheels.is_empty())?;
        let carrier = match self.pivot {
            None => Rotor::free(&self.body),
            Some(pivot) => Rotor::pivoted(&self.body, pivot),
        };
        Ok(Self { rotor: carrier.with_wheels(wheels)?, ..self })
    }

    /// With what its wheels are called, in their order.
    #[must_use]
    pub fn naming_wheels(self, names: Vec<Option<String>>) -> Self {
        Self { wheel_names: names, ..self }
    }

    /// With mass properties that change with time; those at the start become the body's. It is to know already where it starts and where it is held.
    ///
    /// ```
    /// use polhode::body::InertiaTensor;
    /// use polhode::motion::{MassHistory, MassRow, Method, Outflow, Run};
    /// use polhode::prelude::*;
    /// // A ball of 1 kg drops half of itself at 2 s and keeps its ω; the same torque makes it faster twice as fast from then on.
    /// let ball = |mass: f64| MassProperties::new(mass, Position::ZERO, InertiaTensor::diagonal([0.4 * mass; 3])?);
    /// let row = |time, body| MassRow { time, body, rates: None };
    /// let rows = [row(0.0, ball(1.0)?), row(2.0, ball(1.0)?), row(2.0, ball(0.5)?)];
    /// let history = MassHistory::new(&rows, Outflow::None)?;
    /// let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 0.2)));
    /// let run = Run { times: vec![2.0, 4.0], method: Method::Auto, tolerance: 1e-13 };
    /// let scenario = Scenario::new(ball(1.0)?).under([torque])?.changing(history)?.sampled(run);
    /// let motion = scenario.simulate().ok_or("it has a run")??;
    /// let rates = motion.samples().iter().map(|sample| sample.state.omega.z);
    /// assert!(rates.zip([1.0, 3.0]).all(|(rate, want)| (rate - want).abs() < 1e-13));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of a body with wheels, a pendulum, a prescribed motion and a shaft; as [`MassHistory::at`].
    pub fn changing(self, history: MassHistory) -> Result<Self, MotionError> {
        self.require_compatible("mass_history", true)?;
        let (body, _) = history.at(self.start.time)?;
        let rotor = history.rotor(self.start.time, self.pivot)?;
        Ok(Self { body, rotor, history: Some(history), ..self })
    }

    /// On the ground. It is to know already where it starts.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of a body that is held at a pivot, and of all that a body on the ground does not have; as
    /// [`Simulation::run`].
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

    /// Hung in gimbals, whose axes say where it starts.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of a body that is held at a pivot or moves, and of all that a rotor in gimbals does not have; as
    /// [`Simulation::run`].
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

    /// From this attitude and ω; of a prescribed motion they are its own.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for numbers that are not finite; [`MotionError::Exclusive`] of a rotor in gimbals.
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

    /// With a velocity of the centre of mass.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of a body that is held at a pivot or by bearings.
    pub fn moving(self, velocity: Velocity<Space>) -> Result<Self, MotionError> {
        if self.rotor.is_pivoted() {
            return Err(exclusive("pivot", "velocity", "a point of the body is held: it only turns"));
        }
        if self.orbit.is_some() {
            return Err(exclusive("orbit", "velocity", "the orbit says how the centre of mass moves"));
        }
        Ok(Self { velocity, ..self })
    }

    /// On an orbit about a point mass. Torques that depend on the place have an orbit of their own, which is to be the same.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of a body that is held by bearings, or has a velocity.
    pub fn in_orbit(self, orbit: Orbit) -> Result<Self, MotionError> {
        self.require_compatible("orbit", true)?;
        if self.velocity != Velocity::ZERO {
            return Err(exclusive("orbit", "velocity", "the orbit says how the centre of mass moves"));
        }
        Ok(Self { orbit: Some(orbit), ..self })
    }

    /// With angles that are of interest.
    #[must_use]
    pub fn pointing(self, pointings: Vec<Pointing>) -> Self {
        Self { pointings, ..self }
    }

    /// Under torques.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of a prescribed motion and a shaft.
    pub fn under<T: Into<ActingTorque>>(
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

    /// With events to detect.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of a prescribed motion and a shaft.
    pub fn watching(self, events: Vec<Event>) -> Result<Self, MotionError> {
        self.require_compatible("event", !events.is_empty())?;
        Ok(self.changed(|task| (task.events, task.event_sides) = (events, Vec::new())))
    }

    /// Hung from an axis, under the gravity that acts on it.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of a body with wheels, a prescribed motion and a shaft; as [`Pendulum::hung`](crate::motion::Pendulum::hung).
    pub fn suspended_from(self, hanging: Suspension) -> Result<Self, MotionError> {
        self.require_compatible("pendulum", true)?;
        let hung = self.changed(|task| task.hanging = Some(hanging));
        hung.pendulum().transpose()?;
        Ok(hung)
    }

    /// With a motion that is given instead of computed; it starts where that does.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of a body under torques or with wheels, events, a pendulum and a shaft.
    pub fn prescribed_as(self, motion: Prescribed) -> Result<Self, MotionError> {
        self.require_compatible("prescribed", true)?;
        let start = starting_as(&motion, self.start);
        Ok(Self { task: Task::Inverse(motion), start, ..self })
    }

    /// On a shaft, which turns from the start's attitude.
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] of all else that moves or holds a body; as [`Prescribed::fixed_axis`].
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

    /// # Errors
    /// [`MotionError::Exclusive`] where a part that comes excludes one that is there.
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

    /// What it is about.
    pub fn title(&self) -> Option<&str> {
        self.title.as_deref()
    }

    /// The parts of the body.
    pub fn parts(&self) -> &[BodyPart] {
        &self.parts
    }

    /// All parts together.
    pub const fn body(&self) -> &MassProperties<Body> {
        &self.body
    }

    /// The body, the point that it turns about, its centre of mass or the pivot, and its wheels.
    pub const fn rotor(&self) -> &Rotor {
        &self.rotor
    }

    /// The point of the body that is held fixed; `None` for a free body.
    pub const fn pivot(&self) -> Option<Position<Body>> {
        self.pivot
    }

    /// Attitude and ω at the start.
    pub const fn start(&self) -> State {
        self.start
    }

    /// Velocity of the centre of mass; of the pivot, which does not move, it is zero.
    pub const fn velocity(&self) -> Velocity<Space> {
        self.velocity
    }

    /// The orbit of the centre of mass, if it is on one.
    pub const fn orbit(&self) -> Option<&Orbit> {
        self.orbit.as_ref()
    }

    /// The angles that are of interest.
    pub fn pointings(&self) -> &[Pointing] {
        &self.pointings
    }

    /// What is asked of the body.
    pub const fn task(&self) -> &Task {
        &self.task
    }

    fn forward(&self) -> Option<&Forward> {
        match &self.task {
            Task::Forward(forward) => Some(forward),
            _ => None,
        }
    }

    /// What turns it.
    pub fn torques(&self) -> &[TorqueModel] {
        self.forward().map_or(&[], |forward| &forward.torques)
    }

    /// The names of the torques, of those that have one.
    pub fn torque_names(&self) -> &[Option<String>] {
        self.forward().map_or(&[], |forward| &forward.names)
    }

    /// Which of the torques, from 0, act only once an event has switched them on.
    pub fn switched_off(&self) -> &[usize] {
        self.forward().map_or(&[], |forward| &forward.switched_off)
    }

    /// On which side of each event's value it starts, where another motion goes on; else empty.
    pub(super) fn event_sides(&self) -> &[EventSide] {
        self.forward().map_or(&[], |forward| &forward.event_sides)
    }

    /// The events to detect.
    pub fn events(&self) -> &[Event] {
        self.forward().map_or(&[], |forward| &forward.events)
    }

    /// What spins inside it.
    pub fn wheels(&self) -> &[Wheel] {
        self.rotor.wheels()
    }

    /// Its mass properties over time, if they change.
    pub const fn history(&self) -> Option<&MassHistory> {
        self.history.as_ref()
    }

    /// The support of the body while it moves.
    pub fn mechanism(&self) -> Mechanism<'_> {
        match (&self.contact, &self.gimbals) {
            (Some(ground), _) => Mechanism::Ground(ground),
            (None, Some(gimbals)) => Mechanism::Gimbals(gimbals),
            (None, None) => Mechanism::Rotor,
        }
    }

    /// How it is on the ground, if it is.
    pub fn ground(&self) -> Option<&GroundContact> {
        self.contact.as_deref()
    }

    /// True if nothing but its inertia, which stays as it is, decides its motion.
    pub fn is_free(&self) -> bool {
        let alone = self.torques().is_empty() && self.wheels().is_empty();
        let is_held = self.contact.is_some() || self.gimbals.is_some();
        alone && self.prescribed().is_none() && self.history.is_none() && !is_held
    }

    /// The name of a wheel, from 0, if it has one.
    pub fn wheel_name(&self, wheel: usize) -> Option<&str> {
        self.wheel_names.get(wheel)?.as_deref()
    }

    /// A motion that is given instead of computed, that of a shaft too.
    pub const fn prescribed(&self) -> Option<&Prescribed> {
        match &self.task {
            Task::Forward(_) => None,
            Task::Inverse(motion) | Task::Shaft(_, motion) => Some(motion),
        }
    }

    /// The axis from which it hangs.
    pub fn suspension(&self) -> Option<Suspension> {
        self.forward()?.hanging
    }

    /// The bearings on which it turns; the prescribed motion is their shaft's.
    pub fn shaft(&self) -> Option<&MountedShaft> {
        match &self.task {
            Task::Shaft(mounted, _) => Some(mounted),
            _ => None,
        }
    }

    /// For how long and how to compute.
    pub const fn run(&self) -> Option<&Run> {
        self.run.as_ref()
    }

    /// What was noticed on the way.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// All particles of the body.
    pub fn particles(&self) -> Vec<Particle<Body>> {
        self.parts.iter().flat_map(|part| part.particles.iter().copied()).collect()
    }

    /// True if particles are all that the body is made of.
    pub fn is_all_particles(&self) -> bool {
        self.parts.iter().all(|part| !part.particles.is_empty())
    }
}

const HUNG: &str = "the body is held at the crossing of the gimbals' axes alone";

const fn exclusive(a: &'static str, b: &'static str, why: &'static str) -> MotionError {
    MotionError::Exclusive { parts: [a, b], why }
}

/// The first state of a prescribed motion; the start that is given where it has none.
fn starting_as(motion: &Prescribed, start: State) -> State {
    let first = motion.span().map_or(0.0, |[first, _]| first.max(0.0));
    motion.at(first).map_or(start, |(state, _)| state)
}
