//! Where a direction of the body points: the angle to a direction that is fixed in space, or that the orbit or the field gives.

use super::orbit::Orbit;
use super::require;
use super::state::State;
use super::torque::MagneticField;
use crate::math::frame::{Body, Space};
use crate::math::vector::{Direction, Vector};
use crate::motion::error::MotionError;

/// A direction of space, which may change with time.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reference {
    /// Fixed.
    Space(Direction<Space>),
    /// Towards the centre of the orbit: −r.
    Nadir(Orbit),
    /// The way that the centre of mass moves: v.
    Velocity(Orbit),
    /// r × v
    OrbitNormal(Orbit),
    /// B
    Field(MagneticField),
}

/// A direction of the body, and the one to which its angle is of interest.
///
/// ```
/// use polhode::math::{AngularVelocity, Direction, Rotation};
/// use polhode::motion::{MU_EARTH, Orbit, Pointing, Reference, State};
/// let (radial, motion) = (Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 0.6, 0.8));
/// let orbit = Orbit::circular(MU_EARTH, 6.778e6, radial, motion)?;
/// let camera = Pointing::new("camera", Direction::new(0.0, 0.0, 1.0), Reference::Nadir(orbit.clone()))?;
/// // Turned with the orbit, the z axis stays at the nadir.
/// let at = |time: f64| State { time, attitude: orbit.local_axes(time) * Rotation::identity(), omega: AngularVelocity::ZERO };
/// assert!(camera.angle(&at(1234.5)) < 1e-15);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Pointing {
    name: String,
    body: Direction<Body>,
    reference: Reference,
}

impl Reference {
    /// The direction at a time in s; not of unit length.
    pub fn direction(&self, time: f64) -> Direction<Space> {
        match self {
            Self::Space(direction) => *direction,
            Self::Nadir(orbit) => -orbit.position(time).as_quantity(),
            Self::Velocity(orbit) => orbit.velocity(time).as_quantity(),
            Self::OrbitNormal(orbit) => orbit.angular_velocity(time).as_quantity(),
            Self::Field(field) => field.at(time),
        }
    }

    /// The orbit that it depends on.
    pub(crate) const fn orbit(&self) -> Option<&Orbit> {
        match self {
            Self::Nadir(orbit) | Self::Velocity(orbit) | Self::OrbitNormal(orbit) => Some(orbit),
            Self::Field(MagneticField::Dipole { orbit, .. }) => Some(orbit),
            Self::Space(_) | Self::Field(MagneticField::Uniform(_)) => None,
        }
    }

    /// As scenario files and summaries name it.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Space(_) => "a fixed direction",
            Self::Nadir(_) => "nadir",
            Self::Velocity(_) => "velocity",
            Self::OrbitNormal(_) => "orbit_normal",
            Self::Field(_) => "field",
        }
    }

    /// The same, of unit length where it is fixed.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if it has no direction.
    pub(crate) fn normalised(self) -> Result<Self, MotionError> {
        match self {
            Self::Space(direction) => Ok(Self::Space(unit(direction)?)),
            Self::Field(ref field) => unit(field.at(0.0)).map(|_| self),
            _ => Ok(self),
        }
    }
}

impl From<Direction<Space>> for Reference {
    fn from(direction: Direction<Space>) -> Self {
        Self::Space(direction)
    }
}

impl Pointing {
    /// The angle between `body` and `reference`, by a name.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if one of them has no direction.
    pub fn new(
        name: impl Into<String>,
        body: Direction<Body>,
        reference: impl Into<Reference>,
    ) -> Result<Self, MotionError> {
        Ok(Self { name: name.into(), body: unit(body)?, reference: reference.into().normalised()? })
    }

    /// What it is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The direction of the body, of unit length.
    pub const fn body(&self) -> Direction<Body> {
        self.body
    }

    /// What its angle is measured from.
    pub const fn reference(&self) -> &Reference {
        &self.reference
    }

    /// The angle in a state, 0 … π rad.
    pub fn angle(&self, state: &State) -> f64 {
        self.body.angle_to(state.attitude.inverse() * self.reference.direction(state.time))
    }
}

fn unit<Q, F>(v: Vector<Q, F>) -> Result<Direction<F>, MotionError> {
    require::direction("the length of a direction", v)
}
