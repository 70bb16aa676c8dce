//! What a volume that may belong to a solid or not means for its mass properties.

use super::ClosedMesh;
use super::close_pairs::distance;
use crate::body::shape::{Shape, Spread};

/// How far the mass properties of a solid may be off: [`ClosedMesh::effect`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct MeshEffect {
    /// Relative, of the volume; of the mass at one density.
    pub volume: f64,
    /// Of the centre of mass, m.
    pub center: f64,
    /// Of each element of the tensor about the centre of mass at one density, relative to its largest moment.
    pub inertia: f64,
}

impl ClosedMesh {
    /// How far the mass properties may be off if so much volume, m³, at most `beyond` m farther out than the
    /// solid's corners, may belong to it or not.
    ///
    /// With V, its part ΔV, the farthest R of it from the centre of mass: Δc ≤ ΔV R/(V − ΔV), ΔI ≤ ΔV R² + (V + ΔV) Δc².
    pub fn effect(&self, volume: f64, beyond: f64) -> MeshEffect {
        MeshEffect::of(&self.spread(), self.surface().coordinates(), volume, beyond)
    }
}

impl MeshEffect {
    /// The same of a solid with these corners.
    pub(super) fn of(spread: &Spread, corners: &[[f64; 3]], volume: f64, beyond: f64) -> Self {
        let centroid = spread.centroid().to_array();
        let from_center = corners.iter().map(|p| distance(*p, centroid));
        let reach = from_center.fold(0.0, f64::max) + beyond;
        let whole = spread.extent().measure();
        let center = if volume < whole { volume * reach / (whole - volume) } else { f64::INFINITY };
        // tr C − λ, with the least eigenvalue λ of the covariance
        let least = spread.covariance.eigen().values.into_iter().fold(f64::INFINITY, f64::min);
        let largest = spread.size_squared() - least;
        let second = volume * reach * reach + (whole + volume) * center * center;
        Self { volume: volume / whole, center, inertia: second / (whole * largest) }
    }
}
