//! Cylinder.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::number::PI;

/// A solid cylinder with its centre at the origin and its axis along z.
///
/// I = M diag(r²/4 + l²/12, r²/4 + l²/12, r²/2)
///
/// ```
/// use polhode::body::shape::{Cylinder, Shape, Substance};
/// let wheel = Cylinder::new(0.5, 0.1)?.mass_properties(Substance::Mass(8.0))?;
/// assert!((wheel.inertia().matrix()[2][2] - 1.0).abs() < 1e-15);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    pub(in crate::body) radius: f64,
    pub(in crate::body) length: f64,
}

impl Cylinder {
    /// A cylinder of the given radius and length, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if one is not positive and finite.
    pub fn new(radius: f64, length: f64) -> Result<Self, BodyError> {
        representable(Self {
            radius: positive("the cylinder's radius", radius)?,
            length: positive("the cylinder's length", length)?,
        })
    }
}

impl Shape for Cylinder {
    fn spread(&self) -> Spread {
        let Self { radius: r, length: l } = *self;
        Spread::centered(Extent::Volume(PI * r * r * l), [r * r / 4.0, r * r / 4.0, l * l / 12.0])
    }

    fn surface_area(&self) -> f64 {
        2.0 * PI * self.radius * (self.radius + self.length)
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Cylinder { radius: self.radius, length: self.length, open: false })
    }
}
