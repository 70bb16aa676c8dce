//! Thin circular disk.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::number::PI;

/// Thin disk in the plane z = 0 with its centre at the origin.
///
/// I = M r² diag(1/4, 1/4, 1/2)
///
/// ```
/// use polhode::body::shape::{Disk, Shape, Substance};
/// let coin = Disk::new(0.5)?.mass_properties(Substance::Mass(8.0))?;
/// assert!((coin.inertia().matrix()[2][2] - 1.0).abs() < 1e-15);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    pub(super) radius: f64,
}

impl Disk {
    /// Returns a disk with the given radius, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the radius is not positive and finite.
    pub fn new(radius: f64) -> Result<Self, BodyError> {
        representable(Self { radius: positive("the disk's radius", radius)? })
    }
}

impl Shape for Disk {
    fn spread(&self) -> Spread {
        let r = self.radius;
        Spread::centered(Extent::Area(self.surface_area()), [r * r / 4.0, r * r / 4.0, 0.0])
    }

    fn surface_area(&self) -> f64 {
        PI * self.radius * self.radius
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Disk { radius: self.radius })
    }
}
