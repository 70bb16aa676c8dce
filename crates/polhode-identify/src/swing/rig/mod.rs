//! Suspensions of a body, and their equations of motion.

mod axis;
mod hung;
mod wires;

pub use axis::Axis;
pub(super) use wires::all_of;
pub use wires::{Wire, Wires};

use nalgebra::DMatrix;

use super::dual::Gradient;
use super::hung_mass::HungMass;
use super::number::Numbers;
use crate::error::IdentifyError;

/// Suspension of a body.
#[derive(Clone, Debug, PartialEq)]
pub enum Rig {
    /// One, two or three wires, strictly massless rods with free joints at both ends: bifilar and
    /// trifilar suspensions, a torsion wire.
    Wires(Wires),
    /// Fixed axis: compound pendulum, knife edge, torsion spindle.
    Axis(Axis),
}

/// Mass properties and weight of the suspended object.
#[derive(Clone, Debug)]
pub(super) struct Load {
    pub(super) mass: HungMass,
    /// Weight minus buoyancy, N.
    pub(super) weight: Gradient,
}

/// Equations F(u, u̇, ü; q) = 0 of an oscillation about equilibrium; u may contain forces as well
/// as positions.
pub(super) trait Oscillator {
    /// Returns the number of equations and of variables u.
    fn width(&self) -> usize;

    /// Returns the constant quantities q.
    fn quantities(&self) -> &[Gradient];

    /// Returns F and its derivatives; those by q only if requested.
    fn equations(&self, u: &[f64], rate: &[f64], acceleration: &[f64], by_quantities: bool) -> Equations;

    /// Returns the angle of the swing, rad, and its derivatives by u.
    fn angle(&self, u: &[f64]) -> (f64, Vec<f64>);

    /// Checks that the motion may have this state.
    ///
    /// # Errors
    /// If a wire is slack.
    fn check(&self, u: &[f64]) -> Result<(), IdentifyError>;

    /// Returns the equilibrium and the small oscillation about it.
    fn rest(&self) -> &Rest;
}

/// Residual F with its derivatives.
#[derive(Clone, Debug)]
pub(super) struct Equations {
    pub(super) value: Vec<f64>,
    pub(super) by_u: DMatrix<f64>,
    pub(super) by_rate: DMatrix<f64>,
    pub(super) by_acceleration: DMatrix<f64>,
    pub(super) by_quantities: DMatrix<f64>,
}

/// Equilibrium u, and the small oscillation u + angle × mode × cos(rate t).
#[derive(Clone, Debug)]
pub(super) struct Rest {
    pub(super) u: Vec<f64>,
    pub(super) mode: Vec<f64>,
    pub(super) rate: f64,
}

impl Rig {
    pub(super) fn oscillator(
        &self,
        numbers: &Numbers,
        load: &Load,
    ) -> Result<Box<dyn Oscillator>, IdentifyError> {
        Ok(match self {
            Self::Wires(wires) => Box::new(hung::Hung::new(wires, numbers, load)?),
            Self::Axis(axis) => Box::new(axis::Held::new(axis, numbers, load)?),
        })
    }

    /// Returns the axis of the swing, in rig axes.
    pub(super) fn axis(&self) -> [f64; 3] {
        match self {
            Self::Wires(_) => [0.0, 0.0, 1.0],
            Self::Axis(axis) => axis.unit(),
        }
    }

    /// Returns the largest amplitude that is supported, rad.
    pub(super) const fn most(&self) -> f64 {
        match self {
            Self::Wires(_) => 1.75,
            Self::Axis(_) => 2.97,
        }
    }

    pub(super) fn check(&self, count: usize) -> Result<(), IdentifyError> {
        match self {
            Self::Wires(wires) => wires.check(count),
            Self::Axis(axis) => axis.check(count),
        }
    }
}
