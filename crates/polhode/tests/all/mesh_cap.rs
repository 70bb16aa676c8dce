//! Closing of holes by caps: exact for planar holes, otherwise with bounds that contain the truth.

use polhode::body::MassProperties;
use polhode::body::mesh::{
    CappedMesh, ClosedMesh, MassBound, MomentBound, Triangle, TriangleMesh, UncertainPart,
};
use polhode::body::shape::{Shape, Substance};
use polhode::math::Part;

/// Pseudorandom numbers in (0, 1).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() * n as f64) as usize % n
    }
}

/// Rotates by a generic rotation and moves away from the origin.
fn placed(triangles: &[Triangle]) -> Vec<Triangle> {
    // Rotation of the unit quaternion (2, 1, −3, 4)/√30.
    let rows = [[-20.0, -22.0, -4.0], [10.0, -4.0, -28.0], [20.0, -20.0, 10.0]];
    let at = |p: [f64; 3]| {
        let turned: [f64; 3] = std::array::from_fn(|i| (0..3).map(|k| rows[i][k] * p[k] / 30.0).sum());
        [turned[0] + 3.1, turned[1] - 2.3, turned[2] + 0.7]
    };
    triangles.iter().map(|corners| corners.map(at)).collect()
}

/// Returns a bumpy closed ring off the origin.
fn ring(around: usize, along: usize) -> Vec<Triangle> {
    let corner = |i: usize, k: usize| {
        let [u, v] = [(i % around, around), (k % along, along)]
            .map(|(i, n)| std::f64::consts::TAU * i as f64 / n as f64);
        let r = 0.7 + (0.21 + 0.04 * (5.0 * u).cos()) * v.cos() + 0.03 * (3.0 * u).sin();
        [r * u.cos(), 0.9 * r * u.sin(), 0.17 * v.sin() + 0.05 * u.cos()]
    };
    let mut triangles = Vec::new();
    for i in 0..around {
        for k in 0..along {
            let [a, b, c, d] = [corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    placed(&triangles)
}

/// Returns a star-shaped prism with a lid, whose other end is open: a planar, nonconvex hole; and
/// the lid of that end.
fn prism(corners: usize) -> (Vec<Triangle>, Vec<Triangle>) {
    let corner = |k: usize, z: f64| {
        let (k, turn) = (k % corners, std::f64::consts::TAU / corners as f64);
        let r = if k % 2 == 0 { 1.0 } else { 0.45 + 0.03 * k as f64 };
        [0.2 + r * (turn * k as f64).cos(), -0.6 + r * (turn * k as f64).sin(), z]
    };
    let (mut triangles, mut lid) = (Vec::new(), Vec::new());
    for k in 0..corners {
        let [a, b, c, d] = [corner(k, 0.35), corner(k + 1, 0.35), corner(k + 1, 1.6), corner(k, 1.6)];
        triangles.extend([[a, b, c], [a, c, d], [[0.2, -0.6, 1.6], d, c]]);
        lid.push([[0.2, -0.6, 0.35], b, a]);
    }
    (placed(&triangles), placed(&lid))
}

fn capped(triangles: &[Triangle]) -> (CappedMesh, ClosedMesh) {
    let capped = TriangleMesh::of_triangles(triangles).unwrap().capped(&|| true);
    let solid = ClosedMesh::of(&capped.mesh).unwrap();
    (capped, solid)
}

fn solid(triangles: &[Triangle]) -> ClosedMesh {
    ClosedMesh::of(&TriangleMesh::of_triangles(triangles).unwrap()).unwrap()
}

/// Returns the largest ratio of an error to its bound: of volume, centre, tensor and moments, at a
/// known density and at a known mass.
fn worst(capped: &CappedMesh, closed: &ClosedMesh, truth: &ClosedMesh) -> f64 {
    let density = 2.3;
    let mut worst = 0.0_f64;
    let mut compare = |error: f64, bound: f64| {
        // Rounding of the true values.
        worst = worst.max(if error.abs() < 1e-13 { 0.0 } else { error.abs() / bound });
    };
    for has_mass in [false, true] {
        let substance =
            if has_mass { Substance::Mass(density * closed.volume()) } else { Substance::Density(density) };
        let body = |mesh: &ClosedMesh| mesh.mass_properties(substance).unwrap();
        let (found, exact) = (body(closed), body(truth));
        let (volume, bound) = bounds(capped, &found, density, has_mass);
        compare(closed.volume() - truth.volume(), volume);
        compare(found.mass() - exact.mass(), bound.mass);
        let [a, b] = [&found, &exact].map(|body| body.center_of_mass().to_array());
        (0..3).for_each(|k| compare(a[k] - b[k], bound.center_of_mass[k]));
        let [i, j] = [&found, &exact].map(|body| body.inertia().matrix());
        (0..9).for_each(|k| compare(i[k / 3][k % 3] - j[k / 3][k % 3], bound.inertia[k / 3][k % 3]));
        let [p, q] = [&found, &exact].map(|body| body.principal().moments());
        (0..3).for_each(|k| compare(p[k] - q[k], bound.moments));
    }
    worst
}

fn bounds(
    capped: &CappedMesh,
    found: &MassProperties<Part>,
    density: f64,
    has_mass: bool,
) -> (f64, MassBound) {
    let center = found.center_of_mass().to_array();
    let all = capped.holes.iter().map(|hole| hole.bound(center).unwrap());
    let bound = all.fold(MomentBound::default(), |all, bound| all + bound);
    let part = UncertainPart { properties: *found, bound: bound * density, has_mass };
    (bound.measure, MassBound::of(found, &[part]).unwrap())
}

#[test]
fn planar_holes_are_closed_exactly() {
    for corners in [5, 6, 11, 300] {
        let (open, lid) = prism(corners);
        let (capped, closed) = capped(&open);
        assert_eq!((capped.holes.len(), capped.holes[0].loops), (1, 1));
        assert_eq!(capped.holes[0].rim.len(), corners);
        let truth = solid(&[open, lid].concat());
        let [a, b] = [&closed, &truth].map(|mesh| mesh.mass_properties(Substance::Density(2.7)).unwrap());
        assert!((a.mass() - b.mass()).abs() < 1e-12 * b.mass(), "{corners}");
        assert!((a.center_of_mass() - b.center_of_mass()).norm() < 1e-12);
        for (x, y) in a.inertia().matrix().as_flattened().iter().zip(b.inertia().matrix().as_flattened()) {
            assert!((x - y).abs() < 1e-12, "{x} {y}");
        }
        // Rounded corners are not exactly coplanar; the hull of 300 of them has 600 faces.
        let bound = capped.holes[0].bound([0.0; 3]).unwrap();
        assert!(bound.measure < 1e-12 && bound.second[0][0] < 2e-11, "{bound:?}");
    }
}

/// Returns the positions of triangles that form strips without inner vertices, so that the missing
/// surface is in the hull of its rim.
fn strips(triangles: &[Triangle], random: &mut Random) -> Vec<usize> {
    let shares = |t: usize, u: usize| triangles[t].iter().filter(|p| triangles[u].contains(p)).count();
    let mut cut: Vec<usize> = Vec::new();
    for _ in 0..1 + random.below(3) {
        let mut last = random.below(triangles.len());
        if cut.iter().any(|&t| shares(t, last) > 0) {
            continue;
        }
        let mut strip = vec![last];
        for _ in 0..2 + random.below(6) {
            let next: Vec<usize> = (0..triangles.len())
                .filter(|&t| {
                    let touches = |u: &usize| shares(t, *u) > 0;
                    // A new vertex each time: the strip never surrounds one.
                    shares(t, last) == 2
                        && !strip.contains(&t)
                        && !cut.iter().any(touches)
                        && triangles[t].iter().any(|p| !strip.iter().any(|&u| triangles[u].contains(p)))
                })
                .collect();
            if next.is_empty() {
                break;
            }
            last = next[random.below(next.len())];
            strip.push(last);
        }
        cut.extend(strip);
    }
    cut
}

#[test]
fn the_truth_is_within_the_bounds_of_200_random_cuts() {
    let whole = ring(13, 8);
    let truth = solid(&whole);
    let mut random = Random(7);
    let (mut compared, mut largest) = (0, 0.0_f64);
    for _ in 0..200 {
        let cut = strips(&whole, &mut random);
        let open: Vec<Triangle> = (0..whole.len()).filter(|t| !cut.contains(t)).map(|t| whole[t]).collect();
        let capped = TriangleMesh::of_triangles(&open).unwrap().capped(&|| true);
        let closed = ClosedMesh::of(&capped.mesh).unwrap();
        if closed.diagnosis().self_overlaps.is_empty() {
            compared += 1;
            let ratio = worst(&capped, &closed, &truth);
            assert!(ratio <= 1.0, "{ratio} for {cut:?}");
            largest = largest.max(ratio);
        }
    }
    // The bounds are not idle: a bound of a third would fail.
    assert!(compared > 190 && largest > 1.0 / 3.0, "{compared} {largest}");
}

/// A hole around a vertex, closed in truth by triangles to a random point of its hull.
#[test]
fn the_truth_is_within_the_bounds_for_random_surfaces_in_the_hull() {
    let whole = ring(13, 8);
    let mut random = Random(11);
    let (mut compared, mut largest) = (0, 0.0_f64);
    for _ in 0..200 {
        let vertex = whole[random.below(whole.len())][random.below(3)];
        let (around, open): (Vec<Triangle>, Vec<Triangle>) =
            whole.iter().partition(|triangle| triangle.contains(&vertex));
        let (capped, closed) = capped(&open);
        // The most weight at few vertices gives points far from the cap.
        let weights: Vec<f64> = capped.holes[0].rim.iter().map(|_| random.next().powi(8)).collect();
        let sum: f64 = weights.iter().sum();
        let apex = std::array::from_fn(|k| {
            capped.holes[0].rim.iter().zip(&weights).map(|(p, w)| w / sum * p[k]).sum()
        });
        let fan = around.iter().map(|triangle| triangle.map(|p| if p == vertex { apex } else { p }));
        let other: Vec<Triangle> = open.iter().copied().chain(fan).collect();
        let Ok(truth) = ClosedMesh::of(&TriangleMesh::of_triangles(&other).unwrap()) else { continue };
        if truth.diagnosis().self_overlaps.is_empty() && closed.diagnosis().self_overlaps.is_empty() {
            compared += 1;
            let ratio = worst(&capped, &closed, &truth);
            assert!(ratio <= 1.0, "{ratio} at {vertex:?}");
            largest = largest.max(ratio);
        }
    }
    assert!(compared > 100 && largest > 1.0 / 3.0, "{compared} {largest}");
}

#[test]
fn holes_that_share_a_vertex_are_one_hole_with_two_curves() {
    let whole = ring(13, 8);
    let truth = solid(&whole);
    let vertex = whole[40][0];
    let around: Vec<usize> = (0..whole.len()).filter(|&t| whole[t].contains(&vertex)).collect();
    let apart =
        around.iter().find(|&&t| whole[t].iter().filter(|p| whole[around[0]].contains(p)).count() == 1);
    let cut = [around[0], *apart.unwrap()];
    let open: Vec<Triangle> = (0..whole.len()).filter(|t| !cut.contains(t)).map(|t| whole[t]).collect();
    let (capped, closed) = capped(&open);
    let holes: Vec<_> = capped.holes.iter().map(|hole| (hole.loops, hole.rim.len())).collect();
    assert_eq!((holes, capped.triangles), (vec![(2, 5)], 2));
    assert!((closed.volume() - truth.volume()).abs() < 1e-14);
    assert!(worst(&capped, &closed, &truth) <= 1.0);
}

/// A wall inside a body has edges of three triangles; flipped triangles are turned with their caps.
#[test]
fn walls_and_flipped_triangles_are_closed() {
    let whole = ring(13, 8);
    let truth = solid(&whole);
    let mut flipped = whole.clone();
    flipped.remove(17);
    flipped[16].swap(0, 1);
    let (_, closed) = capped(&flipped);
    assert!((closed.volume() - truth.volume()).abs() < 1e-14, "{}", closed.volume());

    let (open, lid) = prism(6);
    let [a, b, c] = [open[0][0], open[6][0], open[12][0]];
    let walled: Vec<Triangle> = [open, lid, vec![[a, b, c]]].concat();
    let mesh = TriangleMesh::of_triangles(&walled).unwrap();
    assert!(ClosedMesh::of(&mesh).is_err());
    let capped = mesh.capped(&|| true);
    assert_eq!((capped.holes.len(), capped.holes[0].rim.len()), (1, 3));
}
