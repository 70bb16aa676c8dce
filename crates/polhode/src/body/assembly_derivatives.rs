//! Derivatives of an assembly's mass properties with respect to its parts and their positions.

use super::assembly::PlacedPart;
use super::derivative::{MassPropertiesDerivative, MassPropertiesGradient};
use super::error::BodyError;
use super::mass_properties::{Center, MassProperties};
use super::shape::Extent;
use crate::math::frame::{Body, Part};
use crate::math::rotation::Rotation;
use crate::math::vector::Position;

/// Mass properties of an assembly, and their derivatives with respect to each of its parts.
///
/// The derivatives are exact except for rounding, about 4e-16 of the largest term. All are along
/// body axes.
///
/// ```
/// use polhode::body::shape::{BoxShape, Shape, Sphere, Substance};
/// use polhode::body::{AssemblyDerivatives, PlacedPart};
/// use polhode::math::{Position, Rotation};
/// let brick = BoxShape::new([0.2, 0.1, 0.06])?;
/// let ball = Sphere::new(0.03)?;
/// let parts = [
///     PlacedPart::new(brick.mass_properties(Substance::Density(1800.0))?, Position::ZERO, Rotation::identity())?,
///     PlacedPart::new(ball.mass_properties(Substance::Mass(0.5))?, Position::new(0.1, 0.02, 0.05), Rotation::identity())?,
/// ];
/// let body = AssemblyDerivatives::of(&parts)?;
/// let [of_brick, of_ball] = &body.parts[..] else { unreachable!() };
/// // A brick that is 1 kg/m³ denser is heavier by its volume …
/// let by_density = of_brick.by_density(brick.spread().extent());
/// assert!((by_density.mass - 0.0012).abs() < 1e-17);
/// // … and a ball that is further along x takes the centre of mass with it, by its share of the mass.
/// let [by_x, ..] = of_ball.by_position();
/// assert!((by_x.center_of_mass.x - 0.5 / body.properties.mass()).abs() < 1e-16);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct AssemblyDerivatives {
    /// Mass properties of the assembly, as [`assemble`](super::assemble) returns them.
    pub properties: MassProperties<Body>,
    /// Derivatives with respect to each part, in the order of the parts.
    pub parts: Vec<PartDerivatives>,
}

/// Derivatives of an assembly's mass properties with respect to one of its parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartDerivatives {
    in_body: MassProperties<Body>,
    /// Vector from the assembly's centre of mass to the part's, m.
    lever: Position<Body>,
    /// Vector from the part's origin to its centre of mass, body axes, m.
    arm: Position<Body>,
    rotation: Rotation<Body, Part>,
    whole: f64,
}

impl AssemblyDerivatives {
    /// Computes the mass properties of rigidly joined parts and their derivatives.
    ///
    /// # Errors
    /// The errors of [`assemble`](super::assemble).
    pub fn of(parts: &[PlacedPart]) -> Result<Self, BodyError> {
        let placed: Vec<_> = parts.iter().map(PlacedPart::in_body).collect();
        let properties = MassProperties::combined(&placed)?;
        let centers: Vec<_> = placed.iter().map(|part| (part.mass(), part.center_of_mass())).collect();
        let Center { mass: whole, reference, rest } =
            Center::of(&centers).ok_or(BodyError::Empty { what: "parts" })?;
        let parts = parts.iter().zip(placed).map(|(part, in_body)| {
            let lever = (in_body.center_of_mass() - reference) - rest;
            let arm = part.rotation * part.properties.center_of_mass();
            PartDerivatives { in_body, lever, arm, rotation: part.rotation, whole }
        });
        Ok(Self { properties, parts: parts.collect() })
    }
}

impl PartDerivatives {
    /// Returns the derivative with respect to the part's mass, per kg, at constant shape and
    /// constant relative distribution of mass.
    pub fn by_mass(&self) -> MassPropertiesDerivative<Body> {
        self.of_whole(&MassPropertiesDerivative::by_mass(&self.in_body))
    }

    /// Returns the derivative with respect to the density of a homogeneous part: per kg/m³ for a
    /// solid, per kg/m² for a thin surface, per kg/m for a rod.
    pub fn by_density(&self, extent: Extent) -> MassPropertiesDerivative<Body> {
        self.of_whole(&MassPropertiesDerivative::by_density(&self.in_body, extent))
    }

    /// Returns the derivatives with respect to the position of the part's origin, per m, for x, y
    /// and z.
    pub fn by_position(&self) -> [MassPropertiesDerivative<Body>; 3] {
        MassPropertiesDerivative::by_translation().map(|change| self.of_whole(&change))
    }

    /// Returns the derivatives with respect to a small rotation vector θ of the part about its own
    /// origin, body axes, per rad: R → exp(θ) R.
    pub fn by_rotation(&self) -> [MassPropertiesDerivative<Body>; 3] {
        MassPropertiesDerivative::by_turn(&self.in_body, self.arm).map(|change| self.of_whole(&change))
    }

    /// Returns the derivative with respect to any parameter, from the derivative of the part's own
    /// mass properties in its own axes.
    pub fn by_part_change(&self, change: &MassPropertiesDerivative<Part>) -> MassPropertiesDerivative<Body> {
        self.of_whole(&change.in_frame(self.rotation))
    }

    /// Returns the gradient of a scalar with respect to the part's own mass properties (in its own
    /// axes), from its gradient with respect to those of the assembly.
    pub fn gradient(&self, of_whole: &MassPropertiesGradient<Body>) -> MassPropertiesGradient<Part> {
        of_whole.pulled_back(|change| self.by_part_change(change))
    }

    fn of_whole(&self, change: &MassPropertiesDerivative<Body>) -> MassPropertiesDerivative<Body> {
        change.of_sum(self.in_body.mass(), self.lever, self.whole)
    }
}
