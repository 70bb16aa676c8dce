//! Convex hulls compared with their definition, in integer arithmetic.

use std::collections::HashSet;

use polhode::body::BodyError;
use polhode::body::mesh::{ClosedMesh, ConvexHull};

/// Pseudorandom numbers (Knuth's MMIX generator).
struct Random(u64);

impl Random {
    /// Returns an integer in 0 … n − 1.
    fn below(&mut self, n: u64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % n) as i64
    }
}

/// Returns (b − a) × (c − a) · (p − a), exactly.
fn side([a, b, c]: [[i64; 3]; 3], p: [i64; 3]) -> i128 {
    let from = |q: [i64; 3]| [0, 1, 2].map(|k| i128::from(q[k] - a[k]));
    let ([x, y, z], [u, v, w], [p, q, r]) = (from(b), from(c), from(p));
    (y * w - z * v) * p + (z * u - x * w) * q + (x * v - y * u) * r
}

/// Checks the hull of the points: it is closed, its corners are points, no point is outside, and no
/// corner lies between others.
fn check(points: &[[i64; 3]]) -> Result<(usize, usize), BodyError> {
    let given: Vec<[f64; 3]> = points.iter().map(|p| p.map(|c| c as f64)).collect();
    let hull = ConvexHull::of(&given)?;
    let faces: Vec<[[i64; 3]; 3]> = hull.corners().map(|t| t.map(|p| p.map(|c| c as i64))).collect();
    let known: HashSet<_> = points.iter().copied().collect();
    let mut corners = HashSet::new();
    for &face in &faces {
        corners.extend(face);
        assert!(points.iter().all(|&p| side(face, p) <= 0), "{face:?}");
    }
    assert!(corners.is_subset(&known));
    assert_eq!(corners.len(), hull.coordinates().len());
    // Euler: F = 2 V − 4
    assert_eq!(faces.len(), 2 * corners.len() - 4);
    // At a true corner at least three planes meet: the normals of its faces are not coplanar.
    for &corner in &corners {
        let normals: Vec<[i64; 3]> = faces
            .iter()
            .filter(|face| face.contains(&corner))
            .map(|&[a, b, c]| {
                let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
                [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            })
            .collect();
        let n = &normals;
        let spans =
            (0..n.len()).any(|i| (0..i).any(|j| (0..j).any(|k| side([[0; 3], n[i], n[j]], n[k]) != 0)));
        assert!(spans, "{corner:?} lies on a face or an edge");
    }
    let solid = ClosedMesh::of(&hull).unwrap();
    assert!(solid.findings().is_empty(), "{:?}", solid.findings());
    Ok((corners.len(), faces.len()))
}

#[test]
fn hulls_of_few_points_are_what_defines_them() {
    let mut random = Random(1);
    // on coarse grids most points lie on common planes and lines, and many coincide
    for (count, grid) in [(5, 2), (8, 3), (20, 3), (30, 5), (50, 20), (40, 1000)].repeat(60) {
        let points: Vec<[i64; 3]> =
            (0..count).map(|_| [0; 3].map(|_: i64| random.below(grid) - grid as i64 / 2)).collect();
        match check(&points) {
            Ok(_) => {}
            Err(BodyError::FlatPoints { .. }) => {
                // truly all in one plane
                let flat = points.iter().all(|&p| {
                    points.iter().all(|&q| points.iter().all(|&r| side([points[0], q, r], p) == 0))
                });
                assert!(flat, "{points:?}");
            }
            Err(error) => panic!("{error}"),
        }
    }
}

#[test]
fn points_on_faces_and_edges_are_no_corners() {
    let grid: Vec<[i64; 3]> = (0..7)
        .flat_map(|i| (0..7).flat_map(move |j| (0..7).map(move |k| [3 * i, 2 * j + i, k - 2 * j])))
        .collect();
    assert_eq!(check(&grid).unwrap(), (8, 12));
    let backwards: Vec<_> = grid.iter().rev().chain(&grid).copied().collect();
    assert_eq!(check(&backwards).unwrap(), (8, 12));
}

#[test]
fn a_hundred_thousand_points_on_a_sphere_are_nearly_all_corners() {
    let n = 100_000;
    let points: Vec<[f64; 3]> = (0..n)
        .map(|k| {
            let z = 1.0 - (2.0 * f64::from(k) + 1.0) / f64::from(n);
            let (r, angle) = ((1.0 - z * z).sqrt(), f64::from(k) * 2.399_963_229_728_653);
            [r * angle.cos(), r * angle.sin(), z]
        })
        .collect();
    let hull = ConvexHull::of(&points).unwrap();
    assert_eq!((hull.coordinates().len(), hull.triangles().len()), (100_000, 199_996));
    let solid = ClosedMesh::of(&hull).unwrap();
    let sphere = 4.0 / 3.0 * std::f64::consts::PI;
    assert!(solid.volume() < sphere && solid.volume() > sphere * (1.0 - 1e-4));
}

#[test]
fn what_has_no_hull_is_refused() {
    assert_eq!(ConvexHull::of(&[]).unwrap_err(), BodyError::Empty { what: "points" });
    assert!(matches!(ConvexHull::of(&[[0.0, f64::NAN, 1.0]]), Err(BodyError::Parameter { .. })));
    let flat = |points: &[[f64; 3]]| matches!(ConvexHull::of(points), Err(BodyError::FlatPoints { .. }));
    assert!(flat(&[[1.0, 2.0, 3.0]]) && flat(&[[1.0, 2.0, 3.0]; 9]));
    let grid: Vec<[f64; 3]> = (0..100).map(|k| [f64::from(k % 10), f64::from(k / 10), 0.0]).collect();
    let slanted: Vec<[f64; 3]> = grid.iter().map(|&[x, y, _]| [x, y, x + 2.0 * y]).collect();
    assert!(flat(&grid) && flat(&slanted));
    let message = |points: &[[f64; 3]]| ConvexHull::of(points).unwrap_err().to_string();
    let [a, b, c] = [[0.0; 3], [1.0, 1.0, 2.0], [3.0, 3.0, 6.0]];
    for (points, place) in
        [(&grid[..], "in one plane"), (&[a, b, c], "on one line"), (&[b; 5], "at one place")]
    {
        assert!(message(points).contains(place), "{}", message(points));
    }
    // and any scale is accepted
    for scale in [1e-300, 1e-9, 1e9, 1e300] {
        let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.1; 3]];
        let hull = ConvexHull::of(&corner.map(|p: [f64; 3]| p.map(|c| c * scale))).unwrap();
        assert_eq!(hull.triangles().len(), 4);
    }
}

#[test]
fn a_face_with_thousands_of_corners_is_not_made_anew_for_each() {
    // A parabola of lattice points is a polygon without three collinear corners: under one apex,
    // and under a second copy.
    let base = |z: i64| (-5000..5000).map(move |k: i64| [k, k * k, z].map(|c| c as f64));
    let apex = [3.0, 12_000_000.0, 700.0];
    let pyramid: Vec<_> = base(0).chain([apex]).collect();
    let hull = ConvexHull::of(&pyramid).unwrap();
    assert_eq!((hull.coordinates().len(), hull.triangles().len()), (10_001, 19_998));
    let prism: Vec<_> = base(0).chain(base(900)).collect();
    let hull = ConvexHull::of(&prism).unwrap();
    assert_eq!((hull.coordinates().len(), hull.triangles().len()), (20_000, 39_996));
}

#[test]
fn a_corner_of_twenty_thousand_faces_is_no_work_for_each_pair_of_them() {
    // On the moment curve (t, t², t³) every point is a corner, and its two ends belong to every
    // second face (Gale's evenness condition).
    let n = 20_000;
    let points: Vec<[f64; 3]> = (0..n)
        .map(|k| {
            let t = 2.0 * f64::from(k) / f64::from(n - 1) - 1.0;
            [t, t * t, t * t * t]
        })
        .collect();
    let hull = ConvexHull::of(&points).unwrap();
    assert_eq!((hull.coordinates().len(), hull.triangles().len()), (20_000, 39_996));
    let solid = ClosedMesh::of(&hull).unwrap();
    // The volume for the whole curve is Π B(k, k), k = 1, 2, 3, for 0 ≤ t ≤ 1 (Karlin & Shapley
    // 1953), times 2 · 4 · 8.
    assert!((solid.volume() - 16.0 / 45.0).abs() < 1e-7, "{}", solid.volume());
    assert!(solid.diagnosis().overlaps.is_empty());
}
