//! Places of the defects and properties that a mesh diagnosis counts.

use super::TriangleMesh;
use super::component::ComponentRole;
use super::diagnosis::{
    Analysis, EdgePlace, MeshDiagnosis, PairPlace, TrianglePlace, again, at_edge, at_pair, at_triangle,
    degenerate, unbalanced,
};
use super::sought::Sought;
use super::threads::Threads;
use super::weld::NONE;

/// Places of what a [`MeshDiagnosis`] counts: the first places of each kind, in the order of the
/// mesh.
///
/// ```
/// use polhode::body::mesh::{MeshDiagnosis, TriangleMesh};
/// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
/// let torn = TriangleMesh::of_triangles(&[[o, y, x], [o, x, z], [o, z, y]])?;
/// let (diagnosis, places) = MeshDiagnosis::with_places(&torn, 100);
/// assert_eq!((diagnosis.boundary.count, places.boundary.len()), (3, 3));
/// assert_eq!(places.boundary[0].ends, [y, x]);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeshPlaces {
    /// Edges of one triangle.
    pub boundary: Vec<EdgePlace>,
    /// Edges that their two triangles traverse in the same direction.
    pub inconsistent: Vec<EdgePlace>,
    /// Edges of more than two triangles.
    pub non_manifold: Vec<EdgePlace>,
    /// Edges of more than two triangles that are not traversed equally often in both directions.
    pub unbalanced: Vec<EdgePlace>,
    /// Triangles with two equal corners.
    pub degenerate: Vec<TrianglePlace>,
    /// Triangles oriented against a clear majority of their component.
    pub flipped: Vec<TrianglePlace>,
    /// Triangles of outward-oriented components inside a solid.
    pub inner_solids: Vec<TrianglePlace>,
    /// Triangles of inward-oriented components inside no solid.
    pub inverted: Vec<TrianglePlace>,
    /// Pairs of identical triangles with the same orientation.
    pub duplicates: Vec<PairPlace>,
    /// Pairs of identical triangles with opposite orientation.
    pub back_to_back: Vec<PairPlace>,
    /// Pairs of triangles of different surfaces that intersect or show overlapping bodies; at most
    /// 10,001.
    pub overlaps: Vec<PairPlace>,
    /// Pairs of triangles of one surface that intersect or show an overlap; at most 10,001.
    pub self_overlaps: Vec<PairPlace>,
    /// Pairs of faces that touch back to back without being the same triangle; at most 10,001.
    pub contacts: Vec<PairPlace>,
}

impl MeshDiagnosis {
    /// Diagnoses the mesh and returns the first places of each kind, at most `most` of each.
    pub fn with_places(mesh: &TriangleMesh, most: usize) -> (Self, MeshPlaces) {
        let analysis =
            Analysis::of(mesh, Sought::All, Threads::for_triangles(mesh.triangles.len()), &|| true);
        let places = MeshPlaces::of(&analysis, most);
        (analysis.diagnosis, places)
    }
}

impl MeshPlaces {
    /// Collects at most `most` places of each kind.
    pub(super) fn of(analysis: &Analysis, most: usize) -> Self {
        let Analysis { welded, patches, edges, meetings, diagnosis, .. } = analysis;
        let at_edges = |halves: &[u32]| halves.iter().take(most).map(|&half| at_edge(welded, half)).collect();
        let at_pairs = |pairs: &[_]| pairs.iter().take(most).map(|pair| at_pair(welded, pair)).collect();
        let triangles_that = |is_meant: &dyn Fn(usize) -> bool| {
            let triangles = (0..welded.corners.len()).filter(|&t| is_meant(t)).take(most);
            triangles.map(|t| at_triangle(welded, t)).collect()
        };
        let has_role = |t: usize, role| match patches.component[t] {
            NONE => false,
            component => diagnosis.components[component as usize].role == role,
        };
        let crowded: Vec<u32> = edges.crowded.iter().take(most).map(|edge| edge[0]).collect();
        Self {
            boundary: at_edges(&edges.boundary),
            inconsistent: at_edges(&edges.inconsistent),
            non_manifold: at_edges(&crowded),
            unbalanced: unbalanced(welded, edges).take(most).collect(),
            degenerate: degenerate(welded).take(most).collect(),
            flipped: triangles_that(&|t| patches.against[t]),
            inner_solids: triangles_that(&|t| has_role(t, ComponentRole::InnerSolid)),
            inverted: triangles_that(&|t| has_role(t, ComponentRole::Inverted)),
            duplicates: again(welded, edges, true).take(most).collect(),
            back_to_back: again(welded, edges, false).take(most).collect(),
            overlaps: at_pairs(&meetings.between.pairs),
            self_overlaps: at_pairs(&meetings.within.pairs),
            contacts: at_pairs(&meetings.contacts.pairs),
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::super::{MeshDiagnosis, Triangle, TriangleMesh};

    /// Returns two tetrahedra that intersect, and one inside the first with the same orientation.
    fn crossed() -> Vec<Triangle> {
        let tetrahedron = |at: [f64; 3], size: f64| {
            let corners = [[0.0; 3], [1.0, 0.1, 0.0], [0.2, 1.1, 0.1], [0.1, 0.3, 0.9]];
            let [o, x, y, z] = corners.map(|c: [f64; 3]| core::array::from_fn(|k| at[k] + size * c[k]));
            [[o, y, x], [o, x, z], [o, z, y], [x, y, z]]
        };
        [tetrahedron([0.0; 3], 4.0), tetrahedron([0.7, 0.9, 0.8], 4.0), tetrahedron([0.3, 0.4, 0.3], 0.1)]
            .concat()
    }

    #[test]
    fn every_place_is_there_and_the_first_is_the_diagnosis_s() {
        let mesh = TriangleMesh::of_triangles(&crossed()).unwrap();
        let (diagnosis, places) = MeshDiagnosis::with_places(&mesh, 1_000);
        assert_eq!(diagnosis, MeshDiagnosis::of(&mesh));
        assert_eq!(places.overlaps.len(), diagnosis.overlaps.count);
        assert_eq!(places.overlaps.first().copied(), diagnosis.overlaps.first);
        assert!(places.overlaps.is_sorted_by_key(|pair| pair.triangles));
        assert!(places.overlaps.len() > 2 && places.boundary.is_empty());
        for pair in &places.overlaps {
            let [t, u] = pair.triangles;
            assert!((1..=4).contains(&t) && (5..=8).contains(&u), "{pair:?}");
        }
        let inner: Vec<_> = places.inner_solids.iter().map(|place| place.triangle).collect();
        assert_eq!(inner, [9, 10, 11, 12]);
        let (_, fewer) = MeshDiagnosis::with_places(&mesh, 2);
        assert_eq!(fewer.overlaps, places.overlaps[..2]);
        assert_eq!(fewer.inner_solids, places.inner_solids[..2]);
    }

    #[test]
    fn edges_and_triangles_are_where_they_were_broken() {
        let mut soup = crossed()[..4].to_vec();
        soup[1].swap(0, 1);
        soup.push([soup[0][0], soup[0][0], soup[0][1]]);
        let (diagnosis, places) =
            MeshDiagnosis::with_places(&TriangleMesh::of_triangles(&soup).unwrap(), 1_000);
        assert_eq!(diagnosis.inconsistent.count, 3);
        let on = |p: &[f64; 3]| soup[1].contains(p);
        assert!(places.inconsistent.iter().flat_map(|edge| &edge.ends).all(on));
        let numbers = |places: &[super::TrianglePlace]| places.iter().map(|p| p.triangle).collect::<Vec<_>>();
        assert_eq!((numbers(&places.flipped), numbers(&places.degenerate)), (vec![2], vec![5]));
        soup.remove(1);
        let (_, places) = MeshDiagnosis::with_places(&TriangleMesh::of_triangles(&soup).unwrap(), 1_000);
        let on = |p: &[f64; 3]| crossed()[1].contains(p);
        assert!(places.boundary.len() == 3 && places.boundary.iter().flat_map(|edge| &edge.ends).all(on));
    }
}
