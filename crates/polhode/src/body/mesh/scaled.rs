//! Conversion of a diagnosis to another unit of length.

use super::component::MeshComponent;
use super::diagnosis::{EdgePlace, Faults, MeshDiagnosis, PairPlace, TrianglePlace};

impl MeshDiagnosis {
    /// Returns the diagnosis of the mesh with every coordinate multiplied by a positive `factor`.
    pub(super) fn scaled(self, factor: f64) -> Self {
        let point = |p: [f64; 3]| p.map(|c| c * factor);
        let edge = |at: EdgePlace| EdgePlace { ends: at.ends.map(point), ..at };
        let triangle = |at: TrianglePlace| TrianglePlace { corners: at.corners.map(point), ..at };
        let pair = |at: PairPlace| PairPlace { point: point(at.point), ..at };
        let component = |part: MeshComponent| MeshComponent {
            volume: part.volume * factor * factor * factor,
            area: part.area * factor * factor,
            bounds: part.bounds.map(point),
            ..part
        };
        Self {
            boundary: self.boundary.map(edge),
            inconsistent: self.inconsistent.map(edge),
            non_manifold: self.non_manifold.map(edge),
            unbalanced: self.unbalanced.map(edge),
            degenerate: self.degenerate.map(triangle),
            collinear: self.collinear.map(triangle),
            duplicates: self.duplicates.map(pair),
            back_to_back: self.back_to_back.map(pair),
            overlaps: self.overlaps.map(pair),
            self_overlaps: self.self_overlaps.map(pair),
            contacts: self.contacts.map(pair),
            components: self.components.into_iter().map(component).collect(),
            ..self
        }
    }
}

impl<P> Faults<P> {
    fn map(self, place: impl Fn(P) -> P) -> Self {
        Self { count: self.count, first: self.first.map(place) }
    }
}
