//! Hint that overlapping parts can be united.

use polhode::body::BodyError;
use polhode::body::mesh::{MeshFlaws, MeshUnion, TriangleMesh};

/// Suggests the union for a mesh that does not bound a solid, if the union exists; it is computed
/// to find out.
pub(crate) fn hint(
    all: &TriangleMesh,
    flaws: &MeshFlaws,
    goes_on: &(dyn Fn() -> bool + Sync),
) -> Option<&'static str> {
    let may_be = matches!(
        flaws.first,
        BodyError::OverlappingMesh { .. }
            | BodyError::NestedSolid { .. }
            | BodyError::DuplicateTriangle { .. }
            | BodyError::OverlapsUndecided { .. }
    ) && MeshUnion::is_possible(&flaws.diagnosis);
    (may_be && MeshUnion::watched(all, goes_on).is_ok()).then_some(
        "use --union, or union = true in a scenario, so that overlapping regions count once; or unite the solids in the program that created the mesh; \
         or use the convex hull of all parts by --hull",
    )
}
