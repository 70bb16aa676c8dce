//! Holes, filled: what comes of it, what it may be off, what stays open.

use polhode::body::mesh::{ClosedMesh, Triangle, TriangleMesh};

/// A box of three sides with a corner at a generic point, each side of two triangles.
fn cuboid() -> Vec<Triangle> {
    let at =
        |x: u8, y: u8, z: u8| [0.3 + 2.1 * f64::from(x), -1.7 + 3.3 * f64::from(y), 0.9 + 0.7 * f64::from(z)];
    let sides = [
        [at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)],
        [at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)],
        [at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)],
        [at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)],
        [at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)],
        [at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)],
    ];
    sides.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()
}

/// A star-shaped prism with a lid, whose other end is open: a plane hole that is not convex.
fn prism(corners: usize) -> (Vec<Triangle>, f64) {
    let corner = |k: usize, z: f64| {
        let (k, turn) = (k % corners, std::f64::consts::TAU / corners as f64);
        let r = if k % 2 == 0 { 1.0 } else { 0.45 + 0.03 * k as f64 };
        [0.2 + r * (turn * k as f64).cos(), -0.6 + r * (turn * k as f64).sin(), z]
    };
    let (low, high) = (0.35, 1.6);
    let middle = [0.2, -0.6, high];
    let mut triangles = Vec::new();
    let mut area = 0.0;
    for k in 0..corners {
        let [a, b, c, d] = [corner(k, low), corner(k + 1, low), corner(k + 1, high), corner(k, high)];
        triangles.extend([[a, b, c], [a, c, d], [middle, d, c]]);
        area += 0.5 * ((a[0] - 0.2) * (b[1] + 0.6) - (a[1] + 0.6) * (b[0] - 0.2));
    }
    (triangles, area * (high - low))
}

fn filled(triangles: &[Triangle], size: f64) -> polhode::body::mesh::FilledMesh {
    TriangleMesh::of_triangles(triangles).unwrap().filled(size).unwrap()
}

fn solid(triangles: &[Triangle], size: f64) -> ClosedMesh {
    ClosedMesh::of(&filled(triangles, size).mesh).unwrap()
}

#[test]
fn a_cuboid_without_a_triangle_has_its_mass_properties_exactly() {
    let whole = ClosedMesh::from_triangles(cuboid()).unwrap();
    for missing in 0..12 {
        let mut triangles = cuboid();
        let last = triangles.remove(missing);
        triangles.rotate_left(missing);
        let filled = filled(&triangles, 5.0);
        assert_eq!((filled.holes, filled.triangles, filled.edges_before, filled.open_edges), (1, 1, 3, 0));
        let closed = ClosedMesh::of(&filled.mesh).unwrap();
        triangles.push(last);
        assert_eq!(closed.volume(), ClosedMesh::from_triangles(triangles).unwrap().volume());
        assert!((closed.volume() - whole.volume()).abs() < 1e-14 * whole.volume());
        assert!(closed.findings().is_empty(), "{:?}", closed.findings());
    }
}

#[test]
fn a_plane_hole_of_any_shape_is_filled_in_its_plane() {
    for corners in [6, 10, 14] {
        let (triangles, volume) = prism(corners);
        let closed = solid(&triangles, 2.5);
        assert!((closed.volume() - volume).abs() < 1e-13 * volume, "{corners}: {} {volume}", closed.volume());
        assert_eq!(closed.surface().triangles().len(), 3 * corners + corners - 2);
        assert!(closed.findings().is_empty(), "{corners}: {:?}", closed.findings());
    }
}

#[test]
fn what_is_larger_or_meets_another_hole_stays_open() {
    let mut triangles = cuboid();
    triangles.remove(7);
    let small = filled(&triangles, 0.5);
    assert_eq!((small.holes, small.triangles, small.open_edges, small.volume_bound), (0, 0, 3, 0.0));
    // Two triangles that meet in a corner only, of different sides.
    let mut triangles = cuboid();
    let at = |t: &Triangle| t.contains(&[0.3, -1.7, 0.9]);
    let first = triangles.iter().position(at).unwrap();
    let edges = |a: &Triangle, b: &Triangle| a.iter().filter(|p| b.contains(p)).count();
    let second = (0..12).find(|&k| at(&triangles[k]) && edges(&triangles[k], &triangles[first]) == 1);
    if let Some(second) = second {
        triangles.remove(first.max(second));
        triangles.remove(first.min(second));
        assert_eq!(filled(&triangles, 9.0).open_edges, 6);
    }
    let mesh = TriangleMesh::of_triangles(&cuboid()).unwrap();
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(mesh.filled(wrong).is_err(), "{wrong}");
    }
    assert_eq!(mesh.filled(1.0).unwrap().holes, 0);
}

#[test]
fn the_bound_holds_for_a_bulge_in_the_ball_about_the_hole() {
    // A tetrahedron's base, which had a pyramid on it: its tip lies in the ball about the base.
    let [a, b, c] = [[0.1, 0.2, 0.3], [2.2, 0.1, 0.4], [0.9, 1.9, 0.2]];
    let (top, tip) = ([1.0, 0.8, 3.1], [1.1, 0.9, -1.0]);
    let open = [[a, b, top], [b, c, top], [c, a, top]];
    let whole =
        ClosedMesh::from_triangles([open.as_slice(), &[[b, a, tip], [c, b, tip], [a, c, tip]]].concat());
    let filled = filled(&open, 2.6);
    let closed = ClosedMesh::of(&filled.mesh).unwrap();
    let off = whole.unwrap().volume() - closed.volume();
    assert!(off > 0.05 * filled.volume_bound && off < filled.volume_bound, "{off} {}", filled.volume_bound);
    assert!(filled.largest_radius < filled.largest && filled.largest_radius > 0.5 * filled.largest);
}

#[test]
fn the_order_of_the_triangles_does_not_matter() {
    let (triangles, _) = prism(10);
    let fill = |triangles: &[Triangle]| {
        let mesh = filled(triangles, 2.5).mesh;
        let mut added: Vec<_> = mesh.corners().skip(triangles.len()).collect();
        added.iter_mut().for_each(|t| t.sort_by(|p, q| p.partial_cmp(q).unwrap()));
        added.sort_by(|s, t| s.partial_cmp(t).unwrap());
        added
    };
    let first = fill(&triangles);
    for turn in [1, 4, 13, 22] {
        let mut other = triangles.clone();
        other.rotate_left(turn);
        other.swap(0, 7);
        other.iter_mut().for_each(|t| t.rotate_left(turn % 3));
        assert_eq!(fill(&other), first, "{turn}");
    }
}
