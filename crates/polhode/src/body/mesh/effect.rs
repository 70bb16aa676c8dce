//! Effect of an uncertain volume on the mass properties of a solid.

use super::ClosedMesh;
use super::close_pairs::distance;
use crate::body::shape::{Shape, Spread};

/// Error bounds of a solid's mass properties: [`ClosedMesh::effect`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct MeshEffect {
    /// Relative error of the volume, which is that of the mass at uniform density.
    pub volume: f64,
    /// Error of the centre of mass, m.
    pub center: f64,
    /// Error of each element of the tensor about the centre of mass at uniform density, relative to
    /// its largest moment.
    pub inertia: f64,
}

impl ClosedMesh {
    /// Returns bounds of the errors of the mass properties if `volume`, m³, may or may not belong
    /// to the solid and lies at most `beyond` m farther out than the solid's corners.
    ///
    /// Let V be the solid's volume, ΔV the uncertain volume, and R its largest distance from the
    /// centre of mass. Then Δc ≤ ΔV R/(V − ΔV), ΔI ≤ ΔV R² + (V + ΔV) Δc².
    pub fn effect(&self, volume: f64, beyond: f64) -> MeshEffect {
        MeshEffect::of(&self.spread(), self.surface().coordinates(), volume, beyond)
    }
}

impl MeshEffect {
    /// Returns the error bounds for a solid with these corners.
    pub(super) fn of(spread: &Spread, corners: &[[f64; 3]], volume: f64, beyond: f64) -> Self {
        let centroid = spread.centroid().to_array();
        let from_center = corners.iter().map(|p| distance(*p, centroid));
        let reach = from_center.fold(0.0, f64::max) + beyond;
        let whole = spread.extent().measure();
        let center = if volume < whole { volume * reach / (whole - volume) } else { f64::INFINITY };
        // Largest moment per unit mass: tr C − λ, with the smallest eigenvalue λ of the covariance
        // C.
        let least = spread.covariance.eigen().values.into_iter().fold(f64::INFINITY, f64::min);
        let largest = spread.size_squared() - least;
        let second = volume * reach * reach + (whole + volume) * center * center;
        Self { volume: volume / whole, center, inertia: second / (whole * largest) }
    }
}
