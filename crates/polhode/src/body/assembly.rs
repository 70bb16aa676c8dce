//! Assemblies: rigidly joined parts, each with its own position and orientation.

use super::error::{BodyError, finite};
use super::form::PlacedForm;
use super::mass_properties::MassProperties;
use super::particles::Particle;
use super::shape::Extent;
use crate::math::frame::{Body, Part};
use crate::math::rotation::Rotation;
use crate::math::vector::Position;

/// Part of an assembly: mass properties in the part's own axes, with its position and orientation
/// in the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedPart {
    pub(super) properties: MassProperties<Part>,
    position: Position<Body>,
    pub(super) rotation: Rotation<Body, Part>,
}

impl PlacedPart {
    /// Returns the part with its origin at `position` and its axes rotated by
    /// `rotation` = R_body_part.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the position is not finite.
    pub fn new(
        properties: MassProperties<Part>,
        position: Position<Body>,
        rotation: Rotation<Body, Part>,
    ) -> Result<Self, BodyError> {
        finite("the part's position", position.to_array())?;
        Ok(Self { properties, position, rotation })
    }

    /// Returns the part's mass properties in body axes.
    pub fn in_body(&self) -> MassProperties<Body> {
        self.properties.moved(self.position, self.rotation)
    }
}

/// Part of a body as reports list it: its name, its kind, and its mass properties in body axes.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPart {
    /// Name that the user gave to the part.
    pub name: String,
    /// Kind of part: `box`, `mesh`, `particles`, `tensor`, …
    pub kind: &'static str,
    /// Mass properties of the part, body axes.
    pub properties: MassProperties<Body>,
    /// Volume, area or length of the part; `None` if it has none.
    pub extent: Option<Extent>,
    /// Bounding area of a solid, or area of a shell, m².
    pub surface_area: Option<f64>,
    /// Particles of the part, body axes; empty if the part does not consist of particles.
    pub particles: Vec<Particle<Body>>,
    /// Shape for drawing; `None` for particles, and if only the moments are known.
    pub form: Option<PlacedForm>,
}

/// Computes the mass properties of rigidly joined parts. Regions where parts overlap count twice.
///
/// ```
/// use polhode::body::{PlacedPart, assemble};
/// use polhode::body::shape::{BoxShape, Shape, Substance};
/// use polhode::math::{Position, Rotation};
/// let brick = BoxShape::new([1.0, 1.0, 2.0])?.mass_properties(Substance::Mass(1.0))?;
/// let upright = PlacedPart::new(brick, Position::ZERO, Rotation::identity())?;
/// let quarter = Rotation::from_axis_angle(polhode::math::Direction::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_2)?;
/// let lying = PlacedPart::new(brick, Position::new(0.0, 1.5, 0.0), quarter)?;
/// let body = assemble(&[upright, lying])?;
/// assert!((body.inertia().matrix()[0][0] - 47.0 / 24.0).abs() < 1e-15); // NASA JEOD, mass_01
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`BodyError::Empty`] if `parts` is empty; [`BodyError::Parameter`] if a sum is not finite.
pub fn assemble(parts: &[PlacedPart]) -> Result<MassProperties<Body>, BodyError> {
    let placed: Vec<_> = parts.iter().map(PlacedPart::in_body).collect();
    MassProperties::combined(&placed)
}
