//! Solids of which only the moments are known.

use super::error::{BodyError, finite, positive};
use super::inertia::InertiaTensor;
use super::shape::{Extent, Shape, Spread};
use crate::math::frame::Part;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Position;

/// Solid of uniform density, known by its volume, area, centroid and second moments, for example
/// from a mesh reader that stores no triangles.
///
/// ```
/// use polhode::body::MeasuredSolid;
/// use polhode::body::shape::{Shape, Substance};
/// use polhode::math::Position;
/// // A brick of 2 m × 3 m × 1 m: ⟨x²⟩ = a²/12.
/// let covariance = [4.0 / 12.0, 9.0 / 12.0, 1.0 / 12.0, 0.0, 0.0, 0.0];
/// let brick = MeasuredSolid::from_moments(6.0, 22.0, Position::new(5.0, 0.0, -1.0), covariance)?;
/// let body = brick.mass_properties(Substance::Density(0.5))?;
/// assert_eq!(body.mass(), 3.0);
/// assert!((body.inertia().matrix()[0][0] - 3.0 * 10.0 / 12.0).abs() < 1e-15);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredSolid {
    spread: Spread,
    area: f64,
}

impl MeasuredSolid {
    /// Returns a solid from its volume, m³, surface area, m², centroid, m, and second moments about
    /// the centroid per unit volume, ⟨x xᵀ⟩ = ∫ x xᵀ dV / V, m²: xx, yy, zz, xy, xz, yz, products
    /// with the sign of the integral.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if a number is not finite, or if the volume or the area is not
    /// positive; [`BodyError::NegativeMoment`] or [`BodyError::TriangleInequality`] if no solid has
    /// these second moments.
    pub fn from_moments(
        volume: f64,
        area: f64,
        centroid: Position<Part>,
        second_moments: [f64; 6],
    ) -> Result<Self, BodyError> {
        let [xx, yy, zz, xy, xz, yz] = second_moments;
        positive("the volume", volume)?;
        positive("the area", area)?;
        finite("the centroid", centroid.to_array())?;
        finite("the second moments", [xx, yy, zz])?;
        finite("the second moments", [xy, xz, yz])?;
        let covariance = Symmetric3 { xx, yy, zz, xy, xz, yz };
        InertiaTensor::<Part>::from_symmetric(covariance.inertia_of_second_moments())?;
        let spread = Spread { extent: Extent::Volume(volume), centroid, covariance }.representable()?;
        Ok(Self { spread, area })
    }
}

impl Shape for MeasuredSolid {
    fn spread(&self) -> Spread {
        self.spread
    }

    fn surface_area(&self) -> f64 {
        self.area
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CENTROID: Position<Part> = Position::new(0.25, -3.0, 7.5);

    #[test]
    fn what_no_solid_has_is_refused() {
        let good = [0.5, 0.25, 2.0, 0.125, -0.25, 0.0625];
        assert!(MeasuredSolid::from_moments(3.5, 7.0, CENTROID, good).is_ok());
        for (volume, area) in [(0.0, 7.0), (-1.0, 7.0), (f64::NAN, 7.0), (3.5, 0.0), (3.5, f64::INFINITY)] {
            assert!(matches!(
                MeasuredSolid::from_moments(volume, area, CENTROID, good),
                Err(BodyError::Parameter { .. })
            ));
        }
        for bad in [
            [f64::NAN, 0.25, 2.0, 0.125, -0.25, 0.0625],
            [0.5, 0.25, 2.0, 0.125, f64::INFINITY, 0.0625],
            [0.5, 0.25, 2.0, 0.75, -0.25, 0.0625], // |⟨xy⟩|² > ⟨x²⟩ ⟨y²⟩
            [-0.5, 0.25, 2.0, 0.125, -0.25, 0.0625],
        ] {
            assert!(MeasuredSolid::from_moments(3.5, 7.0, CENTROID, bad).is_err(), "{bad:?}");
        }
    }
}
