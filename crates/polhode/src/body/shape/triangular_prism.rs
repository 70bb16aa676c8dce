//! Right triangular prism.

use super::triangle::Triangle;
use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Position;

/// Solid right prism: a triangle with given corners in the xy plane, extended from −l/2 to l/2
/// along z.
///
/// ⟨x xᵀ⟩ = 1/12 Σ (p_k − p̄)(p_k − p̄)ᵀ in the plane,  ⟨z²⟩ = l²/12
///
/// ```
/// use polhode::body::shape::{Shape, Substance, TriangularPrism};
/// let wedge = TriangularPrism::new([[0.0, 0.0], [0.3, 0.0], [0.0, 0.6]], 1.2)?;
/// let wedge = wedge.mass_properties(Substance::Density(1000.0))?;
/// assert!((wedge.mass() - 108.0).abs() < 1e-12);
/// // I_xx = M (b²/18 + l²/12)
/// assert!((wedge.inertia().matrix()[0][0] - 108.0 * (0.02 + 0.12)).abs() < 1e-13);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangularPrism {
    pub(in crate::body) triangle: Triangle,
    pub(in crate::body) length: f64,
}

impl TriangularPrism {
    /// Returns the prism with the given corners (x, y), in either orientation, and the length along
    /// z, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if a coordinate is not finite, if the corners are collinear, or if
    /// the length is not positive and finite.
    pub fn new(vertices: [[f64; 2]; 3], length: f64) -> Result<Self, BodyError> {
        let triangle =
            Triangle::new(vertices, "the triangular prism's vertex", "the triangular prism's area")?;
        representable(Self { triangle, length: positive("the triangular prism's length", length)? })
    }
}

impl Shape for TriangularPrism {
    fn spread(&self) -> Spread {
        let ([x, y], across) = self.triangle.moments();
        Spread {
            extent: Extent::Volume(self.triangle.area() * self.length),
            centroid: Position::new(x, y, 0.0),
            covariance: across + Symmetric3::diagonal([0.0, 0.0, self.length * self.length / 12.0]),
        }
    }

    /// Returns A = 2 A_triangle + l (sum of the edges).
    fn surface_area(&self) -> f64 {
        2.0 * self.triangle.area() + self.triangle.perimeter() * self.length
    }

    fn form(&self) -> Option<Form> {
        Some(Form::TriangularPrism { vertices: self.triangle.vertices, length: self.length })
    }
}
