//! Thin spherical shell.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::number::PI;

/// Thin hollow sphere with its centre at the origin.
///
/// I = 2/3 M r²
///
/// ```
/// use polhode::body::shape::{Shape, SphereShell, Substance};
/// let balloon = SphereShell::new(0.5)?.mass_properties(Substance::Mass(6.0))?;
/// assert!((balloon.inertia().matrix()[0][0] - 1.0).abs() < 1e-15);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereShell {
    radius: f64,
}

impl SphereShell {
    /// Returns a shell with the given radius, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the radius is not positive and finite.
    pub fn new(radius: f64) -> Result<Self, BodyError> {
        representable(Self { radius: positive("the spherical shell's radius", radius)? })
    }
}

impl Shape for SphereShell {
    fn spread(&self) -> Spread {
        let r = self.radius;
        Spread::centered(Extent::Area(self.surface_area()), [r * r / 3.0; 3])
    }

    fn surface_area(&self) -> f64 {
        4.0 * PI * self.radius * self.radius
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Ellipsoid { semi_axes: [self.radius; 3] })
    }
}
