//! Cone and frustum of a cone.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, not_negative, positive};
use crate::body::form::Form;
use crate::math::number::PI;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Position;

/// Solid frustum of a cone, with the centre of its base disk at the origin and its axis along +z;
/// it is a cone if one of its radii is zero.
///
/// About the apex of a cone, I = 3/5 M diag(r²/4 + h², r²/4 + h², r²/2)
///
/// ```
/// use polhode::body::shape::{Cone, Shape, Substance};
/// use polhode::math::Position;
/// let cone = Cone::new(0.5, 0.0, 2.0)?.mass_properties(Substance::Mass(5.0))?;
/// assert!((cone.center_of_mass().z - 0.5).abs() < 1e-15);
/// let about_apex = cone.inertia_about(Position::new(0.0, 0.0, 2.0)).matrix();
/// assert!((about_apex[0][0] - 3.0 * (0.0625 + 4.0)).abs() < 1e-14);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    pub(in crate::body) base_radius: f64,
    pub(in crate::body) top_radius: f64,
    pub(in crate::body) height: f64,
}

impl Cone {
    /// Returns a frustum with the given radii at z = 0 and at z = `height`, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the height is not positive and finite, if a radius is negative
    /// or not finite, or if both are zero.
    pub fn new(base_radius: f64, top_radius: f64, height: f64) -> Result<Self, BodyError> {
        not_negative("the cone's base radius", base_radius)?;
        not_negative("the cone's top radius", top_radius)?;
        positive("the larger radius of the cone", base_radius.max(top_radius))?;
        positive("the cone's height", height)?;
        representable(Self { base_radius, top_radius, height })
    }
}

impl Shape for Cone {
    /// Computes the distribution of mass, with the radii a and b and q = a² + ab + b²:
    ///
    /// V = π/3 h q,  z̄ = h (a² + 2ab + 3b²) / 4q,  ⟨x²⟩ = 3 (a⁴ + a³b + a²b² + ab³ + b⁴) / 20q,
    /// ⟨(z − z̄)²⟩ = 3h² (a⁴ + 4a³b + 10a²b² + 4ab³ + b⁴) / 80q²
    ///
    /// All sums have positive terms, also for a = b.
    fn spread(&self) -> Spread {
        // Lengths relative to the larger radius, so that no power of one radius underflows compared
        // with the other.
        let larger = self.base_radius.max(self.top_radius);
        let (a, b, h) = (self.base_radius / larger, self.top_radius / larger, self.height);
        let (a2, ab, b2) = (a * a, a * b, b * b);
        let q = a2 + ab + b2;
        let xx = 0.15 * (a2 * a2 + b2 * b2 + ab * q) / q * larger * larger;
        let zz = 0.0375 * (a2 * a2 + b2 * b2 + ab * (4.0 * (a2 + b2) + 10.0 * ab)) / (q * q) * h * h;
        Spread {
            extent: Extent::Volume(PI / 3.0 * h * q * larger * larger),
            centroid: Position::new(0.0, 0.0, 0.25 * h * (a2 + 2.0 * ab + 3.0 * b2) / q),
            covariance: Symmetric3::diagonal([xx, xx, zz]),
        }
    }

    fn surface_area(&self) -> f64 {
        let Self { base_radius: a, top_radius: b, height } = *self;
        PI * (a * a + b * b + (a + b) * libm::hypot(height, a - b))
    }

    fn form(&self) -> Option<Form> {
        let Self { base_radius, top_radius, height } = *self;
        Some(Form::Cone { base_radius, top_radius, height })
    }
}
