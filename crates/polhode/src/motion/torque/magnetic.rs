//! A magnet in a field.

use crate::math::frame::{Body, Space};
use crate::math::rotation::Attitude;
use crate::math::vector::{Direction, Torque};
use crate::motion::orbit::Orbit;
use crate::motion::state::State;

/// A magnetic moment fixed in the body: N = m × B.
#[derive(Clone, Debug, PartialEq)]
pub struct Magnetic {
    /// m, A·m².
    pub moment: Direction<Body>,
    /// B.
    pub field: MagneticField,
}

/// A magnetic field in space.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MagneticField {
    /// The same everywhere and always, T.
    Uniform(Direction<Space>),
    /// A dipole's, at the centre of an orbit that the body is on.
    Dipole {
        /// The dipole's moment, A·m².
        dipole: Direction<Space>,
        /// Where the body is.
        orbit: Orbit,
    },
}

impl Magnetic {
    /// N in body axes.
    pub fn torque(&self, _state: &State) -> Torque<Body> {
        Torque::ZERO
    }

    /// U = −m · B, J; `None` where the field changes along an orbit.
    pub fn potential(&self, _attitude: Attitude) -> Option<f64> {
        None
    }

    /// The largest that it can be, N·m.
    pub(crate) fn scale(&self) -> f64 {
        0.0
    }
}
