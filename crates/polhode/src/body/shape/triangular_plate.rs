//! Thin triangular plate.

use super::triangle::Triangle;
use super::{Extent, Shape, Spread, representable};
use crate::body::error::BodyError;
use crate::body::form::Form;
use crate::math::vector::Position;

/// Thin triangle in the plane z = 0 with given corners.
///
/// ⟨x xᵀ⟩ = 1/12 Σ (p_k − p̄)(p_k − p̄)ᵀ: the sum over its corners, each with a twelfth of the mass
///
/// ```
/// use polhode::body::shape::{Shape, Substance, TriangularPlate};
/// let gusset = TriangularPlate::new([[0.0, 0.0], [0.3, 0.0], [0.0, 0.6]])?;
/// let gusset = gusset.mass_properties(Substance::Mass(2.0))?;
/// assert!((gusset.center_of_mass().y - 0.2).abs() < 1e-16);
/// // a right triangle of legs a and b: I_xx = M b²/18, I_xy = M a b/36
/// assert!((gusset.inertia().matrix()[0][0] - 0.04).abs() < 1e-16);
/// assert!((gusset.inertia().matrix()[0][1] - 0.01).abs() < 1e-16);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangularPlate {
    triangle: Triangle,
}

impl TriangularPlate {
    /// Returns the plate with the given corners (x, y), m; both orientations are allowed.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if a coordinate is not finite, or if the corners are collinear.
    pub fn new(vertices: [[f64; 2]; 3]) -> Result<Self, BodyError> {
        let triangle =
            Triangle::new(vertices, "the triangular plate's vertex", "the triangular plate's area")?;
        representable(Self { triangle })
    }
}

impl Shape for TriangularPlate {
    fn spread(&self) -> Spread {
        let ([x, y], covariance) = self.triangle.moments();
        Spread { extent: Extent::Area(self.triangle.area()), centroid: Position::new(x, y, 0.0), covariance }
    }

    fn surface_area(&self) -> f64 {
        self.triangle.area()
    }

    fn form(&self) -> Option<Form> {
        Some(Form::TriangularPrism { vertices: self.triangle.vertices, length: 0.0 })
    }
}
