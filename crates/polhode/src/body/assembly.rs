//! Assemblies: parts, each with its own place and turn, joined into one body.

use super::error::{BodyError, finite};
use super::form::PlacedForm;
use super::mass_properties::MassProperties;
use super::particles::Particle;
use super::shape::Extent;
use crate::math::frame::{Body, Part};
use crate::math::rotation::Rotation;
use crate::math::vector::Position;

/// One part of an assembly: its mass properties in its own axes, and where those axes stand in the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedPart {
    pub(super) properties: MassProperties<Part>,
    position: Position<Body>,
    pub(super) rotation: Rotation<Body, Part>,
}

impl PlacedPart {
    /// The part with its origin at `position` and its axes turned by `rotation` = R_body_part.
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

    /// The part's mass properties in body axes.
    pub fn in_body(&self) -> MassProperties<Body> {
        self.properties.moved(self.position, self.rotation)
    }
}

/// One part of a body as reports name it: what it is, and its mass properties in body axes.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPart {
    /// What the user calls it.
    pub name: String,
    /// What it is: `box`, `mesh`, `particles`, `tensor`, …
    pub kind: &'static str,
    /// Mass properties, body axes.
    pub properties: MassProperties<Body>,
    /// Volume, area or length, where it has one.
    pub extent: Option<Extent>,
    /// Bounding area of a solid, or area of a shell, m².
    pub surface_area: Option<f64>,
    /// The particles that it is made of, body axes; empty for anything else.
    pub particles: Vec<Particle<Body>>,
    /// What it looks like; `None` for particles, and where only the moments are known.
    pub form: Option<PlacedForm>,
}

/// Mass properties of parts rigidly joined; parts that overlap count twice where they do.
///
/// ```
/// use polhode::body::{PlacedPart, assemble};
/// use polhode::body::shape::{BoxShape, Shape, Substance};
/// use polhode::math::{Position, Rotation};
/// let brick = BoxShape::new([1.0, 1.0, 2.0])?.mass_properties(Substance::Mass(1.0))?;
/// let upright = PlacedPart::new(brick, Position::ZERO, Rotation::identity())?;
/// let quarter = Rotation::about(polhode::math::Direction::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_2)?;
/// let lying = PlacedPart::new(brick, Position::new(0.0, 1.5, 0.0), quarter)?;
/// let body = assemble(&[upright, lying])?;
/// assert!((body.inertia().matrix()[0][0] - 47.0 / 24.0).abs() < 1e-15); // NASA JEOD, mass_01
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`BodyError::Empty`] without parts; [`BodyError::Parameter`] if a sum is not finite.
pub fn assemble(parts: &[PlacedPart]) -> Result<MassProperties<Body>, BodyError> {
    let placed: Vec<_> = parts.iter().map(PlacedPart::in_body).collect();
    MassProperties::combined(&placed)
}
