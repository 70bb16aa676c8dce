//! Pointing: the angle between a direction of the body and a direction fixed in space or given by
//! the orbit or the magnetic field.

use core::f64::consts::PI;

use super::orbit::Orbit;
use super::require;
use super::state::State;
use super::torque::MagneticField;
use crate::math::frame::{Body, Space};
use crate::math::vector::{Direction, Vector};
use crate::motion::error::MotionError;

/// Direction of space, which may change with time.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reference {
    /// Direction fixed in space.
    Space(Direction<Space>),
    /// Direction to the centre of the orbit: −r.
    Nadir(Orbit),
    /// Direction of the velocity of the centre of mass: v.
    Velocity(Orbit),
    /// Normal of the orbit: r × v.
    OrbitNormal(Orbit),
    /// Magnetic field B.
    Field(MagneticField),
}

/// A direction of the body, and the reference direction from which its angle is measured.
///
/// ```
/// use polhode::math::{AngularVelocity, Direction, Rotation};
/// use polhode::motion::{MU_EARTH, Orbit, Pointing, Reference, State};
/// let (radial, motion) = (Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 0.6, 0.8));
/// let orbit = Orbit::circular(MU_EARTH, 6.778e6, radial, motion)?;
/// let camera = Pointing::new("camera", Direction::new(0.0, 0.0, 1.0), Reference::Nadir(orbit.clone()))?;
/// // Turned with the orbit, the z axis stays at the nadir.
/// let attitude = |time: f64| orbit.local_axes(time) * Rotation::identity();
/// let at = |time: f64| State { time, attitude: attitude(time), omega: AngularVelocity::ZERO };
/// assert!(camera.angle(&at(1234.5)) < 1e-15);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Pointing {
    name: String,
    body: Direction<Body>,
    reference: Reference,
    limit: Option<f64>,
}

impl Reference {
    /// Returns the direction at a time (s); not of unit length.
    pub fn direction(&self, time: f64) -> Direction<Space> {
        match self {
            Self::Space(direction) => *direction,
            Self::Nadir(orbit) => -orbit.position(time).as_quantity(),
            Self::Velocity(orbit) => orbit.velocity(time).as_quantity(),
            Self::OrbitNormal(orbit) => orbit.angular_velocity(time).as_quantity(),
            Self::Field(field) => field.at(time),
        }
    }

    /// Returns the orbit on which the direction depends.
    pub(crate) const fn orbit(&self) -> Option<&Orbit> {
        match self {
            Self::Nadir(orbit) | Self::Velocity(orbit) | Self::OrbitNormal(orbit) => Some(orbit),
            Self::Field(MagneticField::Dipole { orbit, .. }) => Some(orbit),
            Self::Space(_) | Self::Field(MagneticField::Uniform(_)) => None,
        }
    }

    /// Returns the name used in scenario files and summaries.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Space(_) => "a fixed direction",
            Self::Nadir(_) => "nadir",
            Self::Velocity(_) => "velocity",
            Self::OrbitNormal(_) => "orbit_normal",
            Self::Field(_) => "field",
        }
    }

    /// Normalises a fixed direction to unit length.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the vector is zero or not finite.
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
    /// Creates a named pointing, the angle between `body` and `reference`.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if one of the vectors is zero or not
    /// finite.
    pub fn new(
        name: impl Into<String>,
        body: Direction<Body>,
        reference: impl Into<Reference>,
    ) -> Result<Self, MotionError> {
        let reference = reference.into().normalised()?;
        Ok(Self { name: name.into(), body: unit(body)?, reference, limit: None })
    }

    /// Sets the largest angle that is allowed, rad.
    ///
    /// # Errors
    /// [`MotionError::ParameterOutOfRange`] unless it is between 0 and π.
    pub fn with_limit(self, limit: f64) -> Result<Self, MotionError> {
        let holds = 0.0 < limit && limit < PI;
        require::that("the limit of a pointing angle", limit, holds, "between 0 and π rad")?;
        Ok(Self { limit: Some(limit), ..self })
    }

    /// Returns the name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the direction of the body, a unit vector.
    pub const fn body(&self) -> Direction<Body> {
        self.body
    }

    /// Returns the reference direction.
    pub const fn reference(&self) -> &Reference {
        &self.reference
    }

    /// Returns the largest angle that is allowed, rad; `None` without a limit.
    pub const fn limit(&self) -> Option<f64> {
        self.limit
    }

    /// Returns the angle in a state, 0 … π rad.
    pub fn angle(&self, state: &State) -> f64 {
        self.body.angle_to(state.attitude.inverse() * self.reference.direction(state.time))
    }
}

fn unit<Q, F>(v: Vector<Q, F>) -> Result<Direction<F>, MotionError> {
    require::direction("the length of a direction", v)
}
