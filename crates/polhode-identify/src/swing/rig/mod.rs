//! How a body is hung, and its equations of motion there.

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

/// How a body is hung.
#[derive(Clone, Debug, PartialEq)]
pub enum Rig {
    /// On one, two or three wires, or more exactly on rods without mass that turn freely at both ends: bifilar and trifilar suspensions, a torsion wire.
    Wires(Wires),
    /// About an axis that is held: compound pendulum, knife edge, torsion spindle.
    Axis(Axis),
}

/// What is to be known of a hung body besides its mass and tensor.
#[derive(Clone, Debug)]
pub(super) struct Load {
    pub(super) mass: HungMass,
    /// Its weight less the buoyancy, N.
    pub(super) weight: Gradient,
}

/// Equations F(u, u̇, ü; q) = 0 of a motion that swings about a state of rest; u may hold forces besides places.
pub(super) trait Oscillator {
    /// How many equations there are, and numbers u.
    fn width(&self) -> usize;

    /// The quantities q, which do not change with time.
    fn quantities(&self) -> &[Gradient];

    /// F and its derivatives; those by q if they are wanted.
    fn equations(&self, u: &[f64], rate: &[f64], acceleration: &[f64], by_quantities: bool) -> Equations;

    /// The angle that swings, and its derivatives by u.
    fn angle(&self, u: &[f64]) -> (f64, Vec<f64>);

    /// Whether the motion may have this state.
    ///
    /// # Errors
    /// Where a wire is slack.
    fn check(&self, u: &[f64]) -> Result<(), IdentifyError>;

    /// The state of rest and the small motion about it.
    fn rest(&self) -> &Rest;
}

/// F with its derivatives.
#[derive(Clone, Debug)]
pub(super) struct Equations {
    pub(super) value: Vec<f64>,
    pub(super) by_u: DMatrix<f64>,
    pub(super) by_rate: DMatrix<f64>,
    pub(super) by_acceleration: DMatrix<f64>,
    pub(super) by_quantities: DMatrix<f64>,
}

/// A state of rest, and the small motion u + angle × mode × cos(rate t).
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

    /// The axis of the twist in the rig.
    pub(super) fn axis(&self) -> [f64; 3] {
        match self {
            Self::Wires(_) => [0.0, 0.0, 1.0],
            Self::Axis(axis) => axis.unit(),
        }
    }

    /// The largest amplitude that is computed.
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
