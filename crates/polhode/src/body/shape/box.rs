//! Rectangular box.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;

/// Solid box with its centre at the origin and its edges along the axes.
///
/// I = M/12 diag(b² + c², a² + c², a² + b²) for edges a, b, c
///
/// ```
/// use polhode::body::shape::{BoxShape, Shape, Substance};
/// let brick = BoxShape::new([0.2, 0.1, 0.06])?.mass_properties(Substance::Density(1800.0))?;
/// assert!((brick.mass() - 2.16).abs() < 1e-15);
/// assert!((brick.inertia().matrix()[2][2] - 2.16 / 12.0 * (0.04 + 0.01)).abs() < 1e-17);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxShape {
    pub(in crate::body) size: [f64; 3],
}

impl BoxShape {
    /// Returns a box with the given edge lengths along x, y and z, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if an edge is not positive and finite.
    pub fn new(size: [f64; 3]) -> Result<Self, BodyError> {
        for edge in size {
            positive("the box's size", edge)?;
        }
        representable(Self { size })
    }
}

impl Shape for BoxShape {
    fn spread(&self) -> Spread {
        let [a, b, c] = self.size;
        // ∫ x² dx / a over ±a/2.
        Spread::centered(Extent::Volume(a * b * c), self.size.map(|edge| edge * edge / 12.0))
    }

    fn surface_area(&self) -> f64 {
        let [a, b, c] = self.size;
        2.0 * (a * b + b * c + c * a)
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Box { size: self.size })
    }
}
