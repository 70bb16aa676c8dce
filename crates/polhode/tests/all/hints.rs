//! Hints of mesh errors, followed: the changed mesh is accepted. Those of other errors are followed
//! by the tests of the command.

use polhode::body::BodyError;
use polhode::body::mesh::{ClosedMesh, MeshShell, MeshUnion, Triangle, TriangleMesh};
use polhode::body::shape::{Shape, Substance};

/// Tetrahedron with a right angle at `at`, wound outward.
fn tetrahedron(at: [f64; 3], legs: [f64; 3]) -> Vec<Triangle> {
    let corner = |k: usize| std::array::from_fn(|axis| at[axis] + if axis == k { legs[axis] } else { 0.0 });
    let [o, x, y, z] = [at, corner(0), corner(1), corner(2)];
    vec![[o, y, x], [o, x, z], [o, z, y], [x, y, z]]
}

fn turned(triangles: &[Triangle]) -> Vec<Triangle> {
    triangles.iter().map(|&[a, b, c]| [a, c, b]).collect()
}

fn mesh(parts: &[&[Triangle]]) -> TriangleMesh {
    TriangleMesh::of_triangles(&parts.concat()).unwrap()
}

#[track_caller]
fn follow<T, U>(refused: Result<T, BodyError>, hint: &str, changed: Result<U, BodyError>) -> U {
    let error = refused.err().unwrap();
    assert_eq!(error.hint(), Some(hint), "{error}");
    let found = changed.map_err(|again| format!("{error}\n{hint}\n{again}"));
    found.unwrap()
}

#[test]
fn hints_for_meshes_are_followed() {
    let first = tetrahedron([0.2, -0.1, 0.4], [3.0, 2.0, 1.0]);
    let far = tetrahedron([11.0, 1.0, 1.0], [2.0, 1.5, 1.1]);
    let near = tetrahedron([0.5, 0.1, 0.5], [3.0, 2.0, 1.0]);
    let within = tetrahedron([0.3, 0.0, 0.5], [0.3, 0.2, 0.1]);
    let of = |parts: &[&[Triangle]]| ClosedMesh::of(&mesh(parts));
    let solid = follow(
        of(&[&first[1..]]),
        "close the mesh in the tool that made it; vertices that only nearly coincide count as different",
        of(&[&first]),
    );
    assert!((solid.volume() - 1.0).abs() < 1e-12);
    let again = [first[0], turned(&first)[0]];
    follow(of(&[&first, &again]), "remove duplicate faces in the tool that made the mesh", of(&[&first]));
    follow(
        of(&[&turned(&first[..2]), &first[2..]]),
        "make the normals consistent in the tool that made the mesh",
        of(&[&first]),
    );
    let united = follow(
        of(&[&first, &near]),
        "unite the solids in the tool that made the mesh (boolean union)",
        MeshUnion::of(&mesh(&[&first, &near])),
    );
    assert!((united.volume() + united.shared() - 2.0).abs() < 1e-9 && united.shared() > 0.1);
    let hollow = follow(
        of(&[&first, &within]),
        "for a cavity, turn the normals inward; unite a solid within a solid with the outer one",
        of(&[&first, &turned(&within)]),
    );
    assert!((hollow.volume() - (1.0 - 0.001)).abs() < 1e-12);
    follow(of(&[&first, &turned(&far)]), "turn the normals of this part outward", of(&[&first, &far]));
    follow(
        MeshUnion::of(&mesh(&[&first, &turned(&far)])),
        "turn the normals of inward parts outward; a part that intersects itself is inside out in places: fix it in the tool that made the mesh",
        MeshUnion::of(&mesh(&[&first, &far])),
    );
}

#[test]
fn a_one_sided_surface_is_used_as_a_sheet() {
    let at = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.3, 0.8], [2.0, 0.5, 1.7]];
    // The projective plane with six vertices.
    let faces = [
        [0, 1, 4],
        [0, 1, 5],
        [0, 2, 3],
        [0, 2, 5],
        [0, 3, 4],
        [1, 2, 3],
        [1, 2, 4],
        [1, 3, 5],
        [2, 4, 5],
        [3, 4, 5],
    ];
    let plane: Vec<Triangle> = faces.iter().map(|face: &[usize; 3]| face.map(|k| at[k])).collect();
    let sheet = follow(
        ClosedMesh::of(&mesh(&[&plane])).and_then(|solid| solid.mass_properties(Substance::Mass(2.0))),
        "cut it open and close it as the surface of a solid, or use it as a thin sheet",
        MeshShell::new(&mesh(&[&plane]), 1e-3).and_then(|sheet| sheet.mass_properties(Substance::Mass(2.0))),
    );
    assert!(sheet.mass() == 2.0);
}

#[test]
fn a_weld_between_gaps_and_features_closes_a_mesh() {
    // The edge from o to z is divided, and the points of one side lie a gap apart.
    let (n, gap) = (40, 1e-6);
    let [o, x, y, z] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]];
    let point =
        |k: u32, off: f64| [if k.is_multiple_of(n) { 0.0 } else { off }, 0.0, f64::from(k) / f64::from(n)];
    let mut torn = vec![[o, y, x], [x, y, z]];
    torn.extend((0..n).map(|k| [x, point(k + 1, 0.0), point(k, 0.0)]));
    torn.extend((0..n).map(|k| [y, point(k, gap), point(k + 1, gap)]));
    let torn = mesh(&[&torn]);
    let welded = follow(
        torn.welded(0.03),
        "weld with a smaller tolerance: less than the mesh's smallest feature, more than its gaps",
        torn.welded(1e-4),
    );
    assert_eq!(welded.open_edges, 0);
    assert!((ClosedMesh::of(&welded.mesh).unwrap().volume() - 1.0).abs() < 1e-5);
}
