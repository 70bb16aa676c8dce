//! Sphere.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::number::PI;

/// A solid sphere with its centre at the origin.
///
/// I = 2/5 M r²
///
/// ```
/// use polhode::body::shape::{Shape, Sphere, Substance};
/// let ball = Sphere::new(0.5)?.mass_properties(Substance::Mass(4.0))?;
/// assert!((ball.inertia().matrix()[0][0] - 0.4).abs() < 1e-16);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    pub(in crate::body) radius: f64,
}

impl Sphere {
    /// A sphere of the given radius, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the radius is not positive and finite.
    pub fn new(radius: f64) -> Result<Self, BodyError> {
        representable(Self { radius: positive("the sphere's radius", radius)? })
    }
}

impl Shape for Sphere {
    fn spread(&self) -> Spread {
        let r = self.radius;
        Spread::centered(Extent::Volume(4.0 / 3.0 * PI * r * r * r), [r * r / 5.0; 3])
    }

    fn surface_area(&self) -> f64 {
        4.0 * PI * self.radius * self.radius
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Ellipsoid { semi_axes: [self.radius; 3] })
    }
}
