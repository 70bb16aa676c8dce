//! Welding of torn meshes: the result, its error bound, and refusals.

use polhode::body::BodyError;
use polhode::body::mesh::{ClosedMesh, Triangle, TriangleMesh, WeldedMesh};
use polhode::body::shape::{Shape, Substance};
use proptest::prelude::*;

/// Pseudorandom numbers in (−1, 1).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn moved(&mut self, p: [f64; 3], by: f64) -> [f64; 3] {
        p.map(|c| c + by * self.next() / 3.0_f64.sqrt())
    }
}

/// Returns a ring of oval cross-section off the origin.
fn ring(around: usize, along: usize) -> Vec<Triangle> {
    let corner = |i: usize, k: usize| {
        let [u, v] = [(i % around, around), (k % along, along)]
            .map(|(i, n)| std::f64::consts::TAU * i as f64 / n as f64);
        let r = 0.7 + 0.21 * v.cos() + 0.03 * (3.0 * u).sin();
        [1.3 + r * u.cos(), -0.8 + 0.9 * r * u.sin(), 0.4 + 0.17 * v.sin() + 0.05 * u.cos()]
    };
    let mut triangles = Vec::new();
    for i in 0..around {
        for k in 0..along {
            let [a, b, c, d] = [corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    triangles
}

/// Returns the mesh with every corner of every triangle moved by up to `by`.
fn torn(triangles: &[Triangle], by: f64, seed: u64) -> TriangleMesh {
    let mut random = Random(seed);
    let torn: Vec<_> = triangles.iter().map(|corners| corners.map(|p| random.moved(p, by))).collect();
    TriangleMesh::of_triangles(&torn).unwrap()
}

/// Returns the triangles by their corners, sorted, each starting at its smallest corner.
fn sorted(mesh: &TriangleMesh) -> Vec<Triangle> {
    let key = |triangle: &Triangle| triangle.map(|p| p.map(|c| (c + 0.0).to_bits()));
    let from_least =
        |[a, b, c]: Triangle| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min_by_key(key).unwrap();
    let mut all: Vec<_> = mesh.corners().map(from_least).collect();
    all.sort_by_key(key);
    all
}

fn refusal(mesh: &TriangleMesh, tolerance: f64) -> BodyError {
    mesh.welded(tolerance).unwrap_err()
}

#[test]
fn a_mesh_whose_triangles_were_all_torn_off_has_its_mass_properties_to_the_bound() {
    let whole = ClosedMesh::from_triangles(ring(24, 14)).unwrap();
    let size = whole.surface().diagonal();
    let torn = torn(&ring(24, 14), 1e-7 * size, 3);
    assert!(matches!(ClosedMesh::of(&torn), Err(BodyError::OpenMesh { edges: 2016, .. })));
    let welded = torn.welded(1e-6 * size).unwrap();
    assert_eq!((welded.joined, welded.points, welded.open_edges, welded.vanished), (6 * 336, 336, 0, 0));
    assert!(welded.largest_distance > 1e-8 * size && welded.largest_distance <= 2e-7 * size);
    assert!(welded.farthest_move > 0.3 * welded.largest_distance);
    let solid = ClosedMesh::of(&welded.mesh).unwrap();
    // The mean of the corners of a vertex also is within the largest displacement.
    let off = (solid.volume() - whole.volume()).abs();
    assert!(off > 0.0 && off <= welded.volume_bound, "{off:e} {:e}", welded.volume_bound);
    assert!(welded.volume_bound < 3e-6 * whole.volume());

    let effect = solid.effect(welded.volume_bound, welded.farthest_move);
    let body = |mesh: &ClosedMesh| mesh.mass_properties(Substance::Density(2.7)).unwrap();
    let (a, b) = (body(&solid), body(&whole));
    assert!((a.center_of_mass() - b.center_of_mass()).norm() <= effect.center);
    let largest = b.principal().moments()[2];
    let (i, j) = (a.inertia().matrix(), b.inertia().matrix());
    let worst = i.iter().flatten().zip(j.iter().flatten()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    assert!(worst > 0.0 && worst <= effect.inertia * largest, "{worst:e} {:e}", effect.inertia * largest);
    assert!(effect.inertia < 2e-5 && effect.center < 1e-5 * size);
}

#[test]
fn the_bound_holds_wherever_in_their_spread_the_vertices_are() {
    let size = TriangleMesh::of_triangles(&ring(9, 7)).unwrap().diagonal();
    let welded = torn(&ring(9, 7), 3e-3 * size, 11).welded(8e-3 * size).unwrap();
    assert_eq!(welded.open_edges, 0);
    let volume = ClosedMesh::of(&welded.mesh).unwrap().volume();
    let middle = welded.mesh.coordinates();
    let mut largest = 0.0_f64;
    for seed in 0..40 {
        let mut random = Random(seed);
        // all outward, all inward, or at random
        let to = |p: &[f64; 3]| match seed {
            0 | 1 => {
                let from = [p[0] - 1.3, p[1] + 0.8, p[2] - 0.4];
                let r = (from[0] * from[0] + from[1] * from[1]).sqrt();
                let on = [0.7 * from[0] / r, 0.7 * from[1] / r, 0.0];
                let out: [f64; 3] = std::array::from_fn(|k| from[k] - on[k]);
                let n = out.iter().map(|c| c * c).sum::<f64>().sqrt();
                let by = if seed == 0 { welded.farthest_move } else { -welded.farthest_move };
                std::array::from_fn(|k| p[k] + by * out[k] / n)
            }
            _ => random.moved(*p, welded.farthest_move),
        };
        let vertices: Vec<[f64; 3]> = middle.iter().map(to).collect();
        let other = TriangleMesh::new(vertices, welded.mesh.triangles().to_vec()).unwrap();
        let off = (ClosedMesh::of(&other).unwrap().volume() - volume).abs();
        assert!(off <= welded.volume_bound, "{seed}: {off:e} {:e}", welded.volume_bound);
        largest = largest.max(off);
    }
    assert!(largest > 0.5 * welded.volume_bound, "{largest:e} {:e}", welded.volume_bound);
}

#[test]
fn nothing_is_welded_unasked_and_what_is_closed_stays_as_it_is() {
    let mesh = TriangleMesh::of_triangles(&ring(9, 7)).unwrap();
    let welded = mesh.welded(0.01 * mesh.diagonal()).unwrap();
    assert_eq!((welded.joined, welded.points, welded.volume_bound.to_bits()), (0, 0, 0));
    assert_eq!(sorted(&welded.mesh), sorted(&mesh));
    assert!(ClosedMesh::of(&torn(&ring(9, 7), 1e-13, 5)).is_err());
}

#[test]
fn a_tolerance_that_would_lose_features_is_refused_with_the_reason() {
    let whole = ring(160, 80);
    let size = TriangleMesh::of_triangles(&whole).unwrap().diagonal();
    let torn = torn(&whole, 1e-6 * size, 8);
    assert_eq!(torn.welded(3e-6 * size).unwrap().open_edges, 0);
    let BodyError::WeldTooWide { tolerance, vertices, distance, example: [a, b] } =
        refusal(&torn, 0.0095 * size)
    else {
        panic!()
    };
    assert!(vertices > 6 && distance > tolerance);
    let apart = a.iter().zip(b).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
    assert!(apart > tolerance && apart <= distance * (1.0 + 1e-12));
    for wrong in [0.0, -1e-6, f64::NAN, 0.02 * size] {
        assert!(matches!(refusal(&torn, wrong), BodyError::Parameter { .. }), "{wrong}");
    }
    assert!(refusal(&torn, 0.02 * size).to_string().contains("a hundredth"));
}

#[test]
fn a_triangle_of_which_two_corners_become_one_is_counted_and_bounds_nothing() {
    let [o, x, y, z] = [[0.1, 0.2, -0.3], [2.3, 0.1, 0.0], [0.2, 3.1, 0.3], [0.1, 0.4, 1.7]];
    let z2 = [0.1, 0.4001, 1.7002];
    // a sliver between z and z2 without neighbours
    let mesh =
        TriangleMesh::of_triangles(&[[o, y, x], [o, x, z], [o, z2, y], [x, y, z], [z, z2, o]]).unwrap();
    let welded = mesh.welded(3e-4).unwrap();
    assert_eq!((welded.joined, welded.points, welded.vanished, welded.open_edges), (2, 1, 1, 0));
    let solid = ClosedMesh::of(&welded.mesh).unwrap();
    assert_eq!((solid.degenerate(), solid.surface().triangles().len()), (1, 4));
}

#[test]
fn an_open_mesh_says_at_which_weld_it_closes() {
    let whole = ring(24, 14);
    let size = TriangleMesh::of_triangles(&whole).unwrap().diagonal();
    let torn = torn(&whole, 1e-6 * size, 21);
    let weld = torn.closing_weld(&|| true).unwrap();
    assert!(weld.least < weld.tolerance && weld.tolerance <= 3e-6, "{weld:?}");
    assert_eq!((weld.joined, weld.points), (6 * 336, 336));
    let closes = |tolerance: f64| {
        torn.welded(tolerance * size).is_ok_and(|welded| ClosedMesh::of(&welded.mesh).is_ok())
    };
    assert!(closes(weld.tolerance) && !closes(weld.least * (1.0 - 1e-9)));
    assert_eq!(torn.closing_weld(&|| false), None);
    // closed already; a hole; torn by more than a thousandth
    assert_eq!(TriangleMesh::of_triangles(&whole).unwrap().closing_weld(&|| true), None);
    assert_eq!(TriangleMesh::of_triangles(&whole[1..]).unwrap().closing_weld(&|| true), None);
    assert_eq!(self::torn(&whole, 5e-3 * size, 4).closing_weld(&|| true), None);
}

/// Two parallel squares, 0.5 mm apart and with opposite orientation, without the walls between
/// them.
#[test]
fn a_weld_that_presses_two_sheets_onto_each_other_closes_nothing_worth_a_mention() {
    let at = |i: usize, k: usize, z: f64| [0.1 + 0.2 * i as f64, -0.3 + 0.2 * k as f64, z];
    let squares = (0..5).flat_map(|i| (0..5).map(move |k| (i, k)));
    let sheets = squares.flat_map(|(i, k)| {
        let corners = |z: f64| [at(i, k, z), at(i + 1, k, z), at(i + 1, k + 1, z), at(i, k + 1, z)];
        let ([a, b, c, d], [e, f, g, h]) = (corners(0.0005), corners(0.0));
        [[a, b, c], [a, c, d], [e, g, f], [e, h, g]]
    });
    let mesh = TriangleMesh::of_triangles(&sheets.collect::<Vec<_>>()).unwrap();
    let welded = mesh.welded(4e-4 * mesh.diagonal()).unwrap();
    assert_eq!((welded.open_edges, welded.joined), (0, 40));
    let solid = ClosedMesh::of(&welded.mesh).unwrap();
    assert!(welded.volume_bound > 0.5 * solid.volume(), "{:e} {:e}", welded.volume_bound, solid.volume());
    assert_eq!(mesh.closing_weld(&|| true), None);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn the_order_of_the_triangles_does_not_matter(seed in any::<u64>(), by in 1e-9..2e-3_f64) {
        let whole = ring(7, 6);
        let mesh = torn(&whole, by, seed);
        let weld = |mesh: &TriangleMesh| mesh.welded(1e-2);
        let mut triangles: Vec<_> = mesh.corners().collect();
        let mut random = Random(seed ^ 0x5bd1);
        for k in (1..triangles.len()).rev() {
            triangles.swap(k, ((0.5 + 0.5 * random.next()) * (k + 1) as f64) as usize);
            triangles[k].rotate_left(k % 3);
        }
        let shuffled = TriangleMesh::of_triangles(&triangles).unwrap();
        let [a, b]: [WeldedMesh; 2] = [weld(&mesh).unwrap(), weld(&shuffled).unwrap()];
        prop_assert_eq!(sorted(&a.mesh), sorted(&b.mesh));
        prop_assert_eq!((a.joined, a.points, a.largest_distance), (b.joined, b.points, b.largest_distance));
        prop_assert_eq!((a.open_edges, a.points), (0, 42));
    }
}

/// Returns a generic solid whose triangles are split at points of one or two of their edges. The
/// points are on the edges, or `off` them. Returns also the number of the points.
fn with_junctions(off: f64) -> (Vec<Triangle>, usize) {
    let mut random = Random(29);
    let (mut triangles, mut points) = (Vec::new(), 0);
    for (k, [a, b, c]) in ring(9, 7).into_iter().enumerate() {
        let between = |t: f64, random: &mut Random| {
            let on: [f64; 3] = std::array::from_fn(|i| a[i] + t * (b[i] - a[i]));
            random.moved(on, off)
        };
        match k % 5 {
            1 => {
                let p = between(0.37, &mut random);
                triangles.extend([[a, p, c], [p, b, c]]);
                points += 1;
            }
            3 => {
                let [p, q] = [between(0.21, &mut random), between(0.68, &mut random)];
                triangles.extend([[a, p, c], [p, q, c], [q, b, c]]);
                points += 2;
            }
            _ => triangles.push([a, b, c]),
        }
    }
    (triangles, points)
}

#[test]
fn t_junctions_are_welded_and_counted() {
    let whole = ClosedMesh::from_triangles(ring(9, 7)).unwrap();
    for (off, tolerance) in [(0.0, 1e-12), (1e-5, 3e-5)] {
        let (triangles, points) = with_junctions(off);
        let open = TriangleMesh::of_triangles(&triangles).unwrap();
        assert!(ClosedMesh::of(&open).is_err());
        let welded = open.welded(tolerance).unwrap();
        assert_eq!((welded.junctions, welded.joined, welded.open_edges), (points, 0, 0));
        assert_eq!(welded.origins.len(), points);
        assert!(welded.largest_offset <= off + 1e-15 && welded.largest_offset >= 0.3 * off);
        let solid = ClosedMesh::of(&welded.mesh).unwrap();
        assert!(solid.diagnosis().self_overlaps.is_empty() || off == 0.0);
        let change = (solid.volume() - whole.volume()).abs();
        assert!(change <= welded.volume_bound + 1e-14, "{change:e} {:e}", welded.volume_bound);
        assert!(off > 0.0 || change < 1e-14);
        assert!(off == 0.0 || change > 1e-3 * welded.volume_bound, "{change:e}");
        assert!(off == 0.0 || open.welded(0.03 * tolerance).unwrap().open_edges > 0);
    }
}

/// A point at a junction of a junction: the split edges are split again.
#[test]
fn splits_are_repeated_until_no_junction_is_left() {
    let [o, x, y, z] = [[0.3, -0.2, 0.1], [2.3, -0.2, 0.1], [0.3, 2.8, 0.1], [0.3, -0.2, 1.1]];
    // One side has the edge from x to y whole, the other in three pieces, and one of these pieces
    // belongs to a triangle that is split along another edge as well.
    let on = |t: f64| [x[0] + t * (y[0] - x[0]), x[1] + t * (y[1] - x[1]), 0.1];
    let [p, q] = [on(0.25), on(0.625)];
    let m = [0.5 * (o[0] + x[0]), -0.2, 0.1];
    let base = [[o, y, q], [o, q, p], [o, p, m], [m, p, x]];
    let others = [[o, x, z], [o, z, y], [x, y, z]];
    let open = TriangleMesh::of_triangles(&[base.as_slice(), &others].concat()).unwrap();
    let welded = open.welded(1e-9).unwrap();
    assert_eq!((welded.junctions, welded.open_edges), (3, 0));
    let volume = ClosedMesh::of(&welded.mesh).unwrap().volume();
    assert!((volume - 1.0).abs() < 1e-15, "{volume}");
}
