//! Filling of holes: the result, its error bound, and holes that remain open.

use polhode::body::mesh::{ClosedMesh, Triangle, TriangleMesh};
use polhode::body::shape::{Shape, Substance};

/// Returns a box of three sides with a corner at a generic point, each side of two triangles.
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

/// Returns a star-shaped prism with a lid, whose other end is open: a planar, nonconvex hole.
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
    // Two triangles of different sides that meet at a corner only.
    let mut triangles = cuboid();
    let at = |t: &Triangle| t.contains(&[0.3, -1.7, 0.9]);
    let first = triangles.iter().position(at).unwrap();
    let edges = |a: &Triangle, b: &Triangle| a.iter().filter(|p| b.contains(p)).count();
    let second = (0..12).find(|&k| at(&triangles[k]) && edges(&triangles[k], &triangles[first]) == 1);
    let second = second.unwrap();
    triangles.remove(first.max(second));
    triangles.remove(first.min(second));
    assert_eq!(filled(&triangles, 9.0).open_edges, 6);
    let mesh = TriangleMesh::of_triangles(&cuboid()).unwrap();
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(mesh.filled(wrong).is_err(), "{wrong}");
    }
    assert_eq!(mesh.filled(1.0).unwrap().holes, 0);
}

/// Sheets next to a closed solid: one planar with an interior vertex, one bent, one a single
/// triangle. A bowl is not a sheet.
#[test]
fn the_rim_of_a_sheet_is_no_hole() {
    let [a, b, c, d] = [[5.0, 0.1, 0.2], [5.3, 0.2, 0.1], [5.4, 0.5, 0.3], [4.9, 0.4, 0.5]];
    let plane = |u: f64, v: f64| [7.1 + 0.3 * u - 0.1 * v, 0.2 * u + 0.7 * v, 1.3 - 0.4 * u + 0.2 * v];
    let [e, f, g, m] = [plane(0.0, 0.0), plane(1.0, 0.1), plane(0.3, 0.9), plane(0.4, 0.3)];
    let sheets = [vec![[a, b, c], [a, c, d]], vec![[e, f, m], [f, g, m], [g, e, m]], vec![[a, b, c]]];
    for sheet in sheets {
        let triangles = [cuboid(), sheet.clone()].concat();
        let filled = filled(&triangles, 2.0);
        assert_eq!((filled.holes, filled.triangles, filled.left.sheets), (0, 0, 1), "{sheet:?}");
        assert!(filled.open_edges > 0);
        let mesh = TriangleMesh::of_triangles(&triangles).unwrap();
        assert_eq!(mesh.closing_fill(&|| true), None, "{sheet:?}");
    }
    let bowl = [[e, f, d], [f, g, d], [g, e, d]];
    let filled = filled(&[cuboid().as_slice(), &bowl].concat(), 2.0);
    assert_eq!(
        (filled.holes, filled.open_edges, filled.left),
        (1, 0, polhode::body::mesh::HolesLeft::default())
    );
}

#[test]
fn what_is_left_open_has_its_reason() {
    let mut triangles = cuboid();
    triangles.remove(7);
    let left = |triangles: &[Triangle], size: f64| {
        let left = filled(triangles, size).left;
        [left.many_edged, left.larger, left.sheets, left.loose_edges]
    };
    assert_eq!(left(&triangles, 0.5), [0, 1, 0, 0]);
    assert_eq!(left(&prism(258).0, 40.0), [1, 0, 0, 0]);
    assert_eq!(left(&prism(256).0, 40.0), [0; 4]);
    // two holes that meet at one corner
    let (first, at) = (triangles[0], |t: &Triangle| t.contains(&triangles[0][0]));
    let edges = |t: &Triangle| t.iter().filter(|p| first.contains(p)).count();
    let mut whole = cuboid();
    let second = (0..12).find(|&k| at(&whole[k]) && edges(&whole[k]) == 1).unwrap();
    whole.remove(second);
    whole.remove(0);
    assert_eq!(left(&whole, 9.0), [0, 0, 0, 6]);
    assert_eq!(TriangleMesh::of_triangles(&whole).unwrap().open_edges().len(), 6);
    assert!(TriangleMesh::of_triangles(&cuboid()).unwrap().open_edges().is_empty());
}

#[test]
fn the_bound_holds_for_a_bulge_in_the_ball_about_the_hole() {
    // The base of a tetrahedron whose missing tip lies in the ball about the base.
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

/// The rim of the hole is oblique to the axes, so that the ball about the centre of its box extends
/// beyond the rim by more than its radius.
#[test]
fn the_bound_of_centre_and_tensor_holds_however_the_hole_was_closed() {
    let at = |[x, y, z]: [f64; 3]| [0.7 + x, -1.3 + 1.1 * y, 2.9 + 0.9 * z];
    let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(at);
    let [d, e, f] = [[-2.5, -3.5, -3.5], [-3.5, -2.5, -3.5], [-3.5, -3.5, -2.5]].map(at);
    let rim = [a, b, c];
    let open = [[d, f, e], [a, d, e], [a, e, b], [b, e, f], [b, f, c], [c, f, d], [c, d, a]];
    let filled = filled(&open, 2.0);
    let own = ClosedMesh::of(&filled.mesh).unwrap();
    let of = |mesh: &ClosedMesh| mesh.mass_properties(Substance::Density(1.0)).unwrap();
    let (center, tensor) = (of(&own).center_of_mass().to_array(), of(&own).inertia().matrix());
    let largest = of(&own).principal().moments()[2];
    let effect = own.effect(filled.volume_bound, 2.0 * filled.largest_radius);
    let apart = |p: [f64; 3], q: [f64; 3]| (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt();
    let middle = [0, 1, 2].map(|k| {
        let sides = rim.map(|p| p[k]);
        0.5 * (sides.iter().fold(f64::INFINITY, |m, x| m.min(*x))
            + sides.iter().fold(f64::NEG_INFINITY, |m, x| m.max(*x)))
    });
    let corners = own.surface().coordinates().iter().map(|p| apart(*p, center));
    let farthest_corner = corners.fold(0.0, f64::max);
    let (mut farthest, mut most_center, mut most_tensor) = (0.0_f64, 0.0_f64, 0.0_f64);
    let mut tried = 0;
    // domes and dents between the rim and points of the ball: each triangle of the fill is raised
    // to a point, its three sides to others
    for k in 0..400 {
        let part = |j: u32| (f64::from(k * j) * 0.618_034).fract();
        let (turn, z, r) = (std::f64::consts::TAU * part(1), 2.0 * part(3) - 1.0, part(7).cbrt());
        let across = (1.0 - z * z).sqrt();
        let way = [across * turn.cos(), across * turn.sin(), z];
        let tip: [f64; 3] = std::array::from_fn(|i| middle[i] + 0.999 * r * filled.largest_radius * way[i]);
        farthest = farthest.max(apart(tip, center));
        let closed = [open.as_slice(), &[[a, b, tip], [b, c, tip], [c, a, tip]]].concat();
        let Ok(other) = ClosedMesh::from_triangles(closed) else { continue };
        tried += 1;
        let other = of(&other);
        assert!((other.mass() - own.volume()).abs() <= filled.volume_bound);
        most_center = most_center.max(apart(other.center_of_mass().to_array(), center));
        for (p, q) in other.inertia().matrix().as_flattened().iter().zip(tensor.as_flattened()) {
            most_tensor = most_tensor.max((p - q).abs() / largest);
        }
    }
    assert!(tried > 100, "{tried}");
    let outward = [0, 1, 2].map(|k| (middle[k] - center[k]) / apart(middle, center));
    let tip = std::array::from_fn(|k| middle[k] + filled.largest_radius * outward[k]);
    farthest = farthest.max(apart(tip, center));
    assert!(farthest > farthest_corner + filled.largest_radius, "no point would have told r from 2 r");
    assert!(farthest <= farthest_corner + 2.0 * filled.largest_radius);
    assert!(most_center <= effect.center && most_center > 0.01 * effect.center, "{most_center} {effect:?}");
    assert!(
        most_tensor <= effect.inertia && most_tensor > 0.005 * effect.inertia,
        "{most_tensor} {effect:?}"
    );
}

/// Returns the cuboid with each triangle divided into 4ⁿ.
fn fine(cuts: usize) -> Vec<Triangle> {
    (0..cuts).fold(cuboid(), |triangles, _| {
        let middle = |p: [f64; 3], q: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| 0.5 * (p[k] + q[k])) };
        let cut = |[a, b, c]: Triangle| {
            let (d, e, f) = (middle(b, c), middle(c, a), middle(a, b));
            [[a, f, e], [b, d, f], [c, e, d], [d, e, f]]
        };
        triangles.into_iter().flat_map(cut).collect()
    })
}

#[test]
fn an_open_mesh_says_at_which_size_its_holes_are_filled() {
    let whole = fine(5);
    let mut triangles = whole.clone();
    // one triangle of a long side, and two adjacent ones of a short side
    triangles.remove(2_900);
    triangles.drain(302..304);
    let mesh = TriangleMesh::of_triangles(&triangles).unwrap();
    let fill = mesh.closing_fill(&|| true).unwrap();
    assert_eq!((fill.holes, fill.triangles), (2, 3));
    assert!(fill.largest < fill.size && fill.size <= 0.1, "{fill:?}");
    let size = mesh.diagonal();
    assert_eq!(mesh.filled(fill.size * size).unwrap().open_edges, 0);
    assert!(mesh.filled(fill.largest * (1.0 - 1e-9) * size).unwrap().open_edges > 0);
    let closed = ClosedMesh::of(&mesh.filled(fill.size * size).unwrap().mesh).unwrap();
    assert!(
        (closed.volume() / ClosedMesh::from_triangles(whole.clone()).unwrap().volume() - 1.0).abs() < 1e-13
    );
    assert_eq!(mesh.closing_fill(&|| false), None);
    // closed already; a hole that is large compared with the mesh
    assert_eq!(TriangleMesh::of_triangles(&whole).unwrap().closing_fill(&|| true), None);
    assert_eq!(TriangleMesh::of_triangles(&cuboid()[1..]).unwrap().closing_fill(&|| true), None);
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
