//! The motion of a rotor in its gimbals: an initial value problem.

use super::suspension::Gimbals;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::motion::solve::propagate::noise::StepNoise;

/// An initial value problem: a body as the rotor of two gimbals, whose axes say where they start.
///
/// It is integrated by Taylor series, the rounding of the variables carried along. The evidence is the balance of energy,
/// [`GimbalTrajectory::energy_drift`](super::GimbalTrajectory::energy_drift).
///
/// # Accuracy
/// Motions of some seconds agree with those of `fixtures/gimbals.py`, another formulation in 36 digits, to 1e-13.
///
/// ```
/// use polhode::motion::gimbal::{Axis, Base, GimbalSimulation, Gimbals};
/// use polhode::prelude::*;
/// // A gyrocompass: its axis is kept level, and swings about north, T = 2π √(A/(C ν ω_E cos λ)).
/// let (a, c, spin, latitude) = (0.012, 0.02, 1500.0, 0.9_f64);
/// let rotor = MassProperties::new(3.0, Position::ZERO, InertiaTensor::diagonal([a, a, c])?)?;
/// let period = std::f64::consts::TAU * (a / (c * spin * Base::EARTH_RATE * latitude.cos())).sqrt();
/// // The outer axis up, the inner one east, so that the rotor's, up × east, is north.
/// let axes = [Axis::free(1e-3, 0.0)?, Axis::locked(0.0)?, Axis::driven(0.0, spin)?];
/// let gimbals = Gimbals::new(Direction::new(0.0, 0.0, 1.0), Direction::new(1.0, 0.0, 0.0), axes)?;
/// let gimbals = gimbals.on(Base::on_earth(latitude)?);
/// let motion = GimbalSimulation::new(&rotor, &gimbals, 0.0, &[period]).run()?;
/// let end = &motion.samples()[0];
/// assert!((end.angles[0] - 1e-3).abs() < 1e-9 && motion.energy_drift() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct GimbalSimulation<'a> {
    pub(super) body: &'a MassProperties<Body>,
    pub(super) gimbals: &'a Gimbals,
    pub(super) start: f64,
    pub(super) times: &'a [f64],
    pub(super) tolerance: f64,
    pub(super) noise: Option<StepNoise>,
}

impl<'a> GimbalSimulation<'a> {
    /// From the time `start`, s, to be sampled at `times` (ascending, s, none before the start).
    pub const fn new(
        body: &'a MassProperties<Body>,
        gimbals: &'a Gimbals,
        start: f64,
        times: &'a [f64],
    ) -> Self {
        Self { body, gimbals, start, times, tolerance: 1e-15, noise: None }
    }

    /// With a bound on the error of each step, relative to the sizes of the variables: 1e-15 unless it is said.
    #[must_use]
    pub const fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    pub(in crate::motion) const fn with_noise(self, noise: Option<StepNoise>) -> Self {
        Self { noise, ..self }
    }

    pub(in crate::motion) const fn body(&self) -> &MassProperties<Body> {
        self.body
    }

    pub(in crate::motion) const fn gimbals(&self) -> &Gimbals {
        self.gimbals
    }

    pub(in crate::motion) const fn start(&self) -> f64 {
        self.start
    }

    /// The bound on the error of each step.
    pub(in crate::motion) const fn bound(&self) -> f64 {
        self.tolerance
    }
}
