//! The motion of a body on the ground: an initial value problem.

use super::ground::Ground;
use super::law::ContactLaw;
use super::start::ContactStart;
use super::surface::BodySurface;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::{Body, Space};
use crate::math::vector::Acceleration;
use crate::motion::model::event::Event;
use crate::motion::solve::propagate::noise::StepNoise;

/// What touches what, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The surface of the body.
    pub surface: BodySurface,
    /// What it touches.
    pub ground: Ground,
    /// What holds it there.
    pub law: ContactLaw,
    /// g, m/s²
    pub gravity: Acceleration<Space>,
}

impl Contact {
    /// On level ground, rolling, under standard gravity.
    pub const fn rolling(surface: BodySurface) -> Self {
        let gravity = Acceleration::new(0.0, 0.0, -9.80665);
        Self { surface, ground: Ground::LEVEL, law: ContactLaw::ROLLING, gravity }
    }
}

/// An initial value problem: a body on the ground.
///
/// ```
/// use polhode::motion::contact::{BodySurface, Contact, ContactSimulation, ContactStart, SurfaceShape};
/// use polhode::prelude::*;
/// // A homogeneous ball, which rolls as it would without a ground that holds it: with constant velocity a ω.
/// let ball = MassProperties::new(2.0, Position::ZERO, InertiaTensor::diagonal([0.008; 3])?)?;
/// let surface = BodySurface::new(SurfaceShape::Sphere { radius: 0.1 }, Position::ZERO, Rotation::identity())?;
/// let omega = AngularVelocity::new(0.0, 3.0, 0.0);
/// let start = ContactStart::rolling(State { time: 0.0, attitude: Attitude::identity(), omega });
/// let motion = ContactSimulation::new(&ball, &Contact::rolling(surface), start, &[2.0]).run()?;
/// let end = &motion.samples()[0];
/// assert!((end.contact.x - 0.6).abs() < 1e-14 && (end.normal_force - 2.0 * 9.80665).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct ContactSimulation<'a> {
    pub(super) body: &'a MassProperties<Body>,
    pub(super) contact: &'a Contact,
    pub(super) start: ContactStart,
    pub(super) times: &'a [f64],
    pub(super) events: &'a [Event],
    pub(super) tolerance: f64,
    pub(super) noise: Option<StepNoise>,
}

impl<'a> ContactSimulation<'a> {
    /// The loosest bound on the error of a step: what a contact does next depends on signs, and looser steps would hardly be longer.
    pub const LOOSEST: f64 = 1e-12;

    /// From `start`, to be sampled at `times` (ascending, s, none before the start).
    pub const fn new(
        body: &'a MassProperties<Body>,
        contact: &'a Contact,
        start: ContactStart,
        times: &'a [f64],
    ) -> Self {
        Self { body, contact, start, times, events: &[], tolerance: 1e-15, noise: None }
    }

    /// With a bound on the error of each step, relative to the sizes of the variables: 1e-15 unless it is said, and [`ContactSimulation::LOOSEST`] if it is looser
    /// than that.
    #[must_use]
    pub const fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// With events to detect; they may stop the motion, and switch nothing.
    #[must_use]
    pub const fn events(self, events: &'a [Event]) -> Self {
        Self { events, ..self }
    }

    pub(in crate::motion) const fn with_noise(self, noise: Option<StepNoise>) -> Self {
        Self { noise, ..self }
    }

    pub(in crate::motion) const fn body(&self) -> &MassProperties<Body> {
        self.body
    }

    pub(in crate::motion) const fn contact(&self) -> &Contact {
        self.contact
    }

    pub(in crate::motion) const fn start(&self) -> ContactStart {
        self.start
    }

    /// The bound on the error of each step.
    pub(in crate::motion) const fn bound(&self) -> f64 {
        self.tolerance.min(Self::LOOSEST)
    }
}
