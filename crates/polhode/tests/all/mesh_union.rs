//! Unions of overlapping parts, compared with a Boolean kernel and with exact results.

mod cases;

use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::path::Path;

use cases::{Body, Case, Random, brick, cases, mesh, sphere, torus, turned};
use polhode::body::BodyError;
use polhode::body::mesh::{ClosedMesh, MeshUnion, TriangleMesh};
use polhode::body::shape::{Shape, Substance};

fn union(bodies: &[Body]) -> MeshUnion {
    MeshUnion::of(&mesh(bodies)).unwrap()
}

fn refused(bodies: &[Body]) -> BodyError {
    MeshUnion::of(&mesh(bodies)).unwrap_err()
}

/// Returns volume, centre of mass, and the tensor about it at density 1: xx, yy, zz, xy, xz, yz.
fn numbers(shape: &impl Shape) -> [f64; 10] {
    let body = shape.mass_properties(Substance::Density(1.0)).unwrap();
    let ([x, y, z], m) = (body.center_of_mass().to_array(), body.inertia().matrix());
    [body.mass(), x, y, z, m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]]
}

/// Returns the largest relative difference of two results: in units of the volume, of the radius of
/// gyration, of the trace.
fn deviation(a: &[f64; 10], b: &[f64; 10]) -> f64 {
    let trace = b[4] + b[5] + b[6];
    let scale = |k| match k {
        0 => b[0],
        1..=3 => (trace / b[0]).sqrt(),
        _ => trace,
    };
    (0..10).map(|k| (a[k] - b[k]).abs() / scale(k)).fold(0.0, f64::max)
}

fn moved(body: &Body, by: [f64; 3]) -> Body {
    body.clone().moved(|p| [0, 1, 2].map(|k| p[k] + by[k]))
}

#[test]
fn cases_agree_with_a_boolean_kernel() {
    if let Some(folder) = std::env::var_os("POLHODE_WRITE_UNIONS") {
        return write(Path::new(&folder));
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/unions.csv");
    let table = std::fs::read_to_string(path).unwrap();
    let rows: Vec<&str> = table.lines().filter(|line| !line.starts_with('#')).skip(1).collect();
    let cases = cases();
    assert_eq!(rows.len(), cases.len());
    let mut shared = 0;
    for (Case { name, bodies }, row) in cases.iter().zip(rows) {
        let (kernel_name, row) = row.split_once(',').unwrap();
        assert_eq!(kernel_name, name);
        let kernel: Vec<f64> = row.split(',').map(|n| n.parse().unwrap()).collect();
        let union = union(bodies);
        // The measured deviation is 3e-15: both are accurate to rounding.
        let off = deviation(&numbers(&union), &kernel.try_into().unwrap());
        assert!(off < 1e-13, "{name}: {off:e}");
        assert!(union.error() < 2e-15 * union.volume(), "{name}: {:e}", union.error());
        shared += usize::from(union.shared() > 1e-3 * union.volume());
    }
    assert!(shared > 100, "{shared}");
}

/// Writes the cases for `unions.py`: the name, and the points and triangles of each body.
fn write(folder: &Path) {
    for (k, Case { name, bodies }) in cases().iter().enumerate() {
        let mut text = format!("{name}\n");
        for body in bodies {
            writeln!(text, "{} {}", body.points.len(), body.triangles.len()).unwrap();
            body.points.iter().for_each(|[x, y, z]| writeln!(text, "{x:?} {y:?} {z:?}").unwrap());
            body.triangles.iter().for_each(|[a, b, c]| writeln!(text, "{a} {b} {c}").unwrap());
        }
        std::fs::write(folder.join(format!("{k:03}.txt")), text).unwrap();
    }
}

/// Boxes between integer corners, some of them hollow: the enclosed region is a set of cells.
struct Cells {
    bodies: Vec<Body>,
    solid: BTreeSet<[i32; 3]>,
    /// Number of cells in more than one box.
    shared: usize,
    cavities: usize,
}

impl Cells {
    fn new(random: &mut Random) -> Self {
        let mut ranges: Vec<([i32; 3], [i32; 3], i32)> = Vec::new();
        for _ in 0..2 + random.within(0.0, 6.0) as usize {
            let low = [0; 3].map(|_| random.within(0.0, 6.0) as i32);
            let high = low.map(|c| c + 1 + random.within(0.0, 5.0) as i32);
            ranges.push((low, high, 1));
            if random.next() > 0.2 && (0..3).all(|k| high[k] - low[k] > 2) {
                ranges.push((low.map(|c| c + 1), high.map(|c| c - 1), -1));
            }
        }
        let float = |p: [i32; 3]| p.map(f64::from);
        let body = |&(low, high, times): &([i32; 3], [i32; 3], i32)| {
            let body = brick(float(low), float(high));
            if times > 0 { body } else { body.inward() }
        };
        let all = (0..11).flat_map(|x| (0..11).flat_map(move |y| (0..11).map(move |z| [x, y, z])));
        let within = |cell: [i32; 3], low: [i32; 3], high: [i32; 3]| {
            (0..3).all(|k| low[k] <= cell[k] && cell[k] < high[k])
        };
        let times = |cell: [i32; 3]| {
            let around = ranges.iter().filter(|(low, high, _)| within(cell, *low, *high));
            around.map(|range| range.2).sum::<i32>()
        };
        Self {
            bodies: ranges.iter().map(body).collect(),
            cavities: ranges.iter().filter(|range| range.2 < 0).count(),
            solid: all.clone().filter(|&cell| times(cell) > 0).collect(),
            shared: all.filter(|&cell| times(cell) > 1).count(),
        }
    }

    /// Returns the exact numbers, except for the last rounding.
    fn numbers(&self) -> [f64; 10] {
        let volume = self.solid.len() as f64;
        let sum = |of: &dyn Fn([f64; 3]) -> f64| {
            self.solid.iter().map(|cell| of(cell.map(|c| f64::from(c) + 0.5))).sum::<f64>()
        };
        let center = [0, 1, 2].map(|k| sum(&|p| p[k]) / volume);
        let second = |i: usize, j: usize| {
            let own = if i == j { 1.0 / 12.0 } else { 0.0 };
            sum(&|p| (p[i] - center[i]) * (p[j] - center[j]) + own)
        };
        let [xx, yy, zz] = [second(0, 0), second(1, 1), second(2, 2)];
        let [x, y, z] = center;
        [volume, x, y, z, yy + zz, xx + zz, xx + yy, -second(0, 1), -second(0, 2), -second(1, 2)]
    }

    /// Returns the number of faces between solid and empty cells.
    fn area(&self) -> usize {
        let sides = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].into_iter().flat_map(|d: [i32; 3]| [d, d.map(|c| -c)]);
        let beside = |cell: &[i32; 3], d: [i32; 3]| [0, 1, 2].map(|k| cell[k] + d[k]);
        let open =
            |cell: &[i32; 3]| sides.clone().filter(|&d| !self.solid.contains(&beside(cell, d))).count();
        self.solid.iter().map(open).sum()
    }
}

#[test]
fn bricks_with_faces_edges_and_corners_in_common_are_their_cells() {
    let mut random = Random(7);
    let (mut shared, mut hollow) = (0, 0);
    for round in 0..80 {
        let cells = Cells::new(&mut random);
        let union = match MeshUnion::of(&mesh(&cells.bodies)) {
            Ok(union) => union,
            Err(error) => panic!("{round}: {error}"),
        };
        let off = deviation(&numbers(&union), &cells.numbers());
        assert!(off < 1e-14, "{round}: {off:e}");
        let area = union.surface_area() / cells.area() as f64;
        assert!((area - 1.0).abs() < 1e-14, "{round}: {area}");
        assert!((union.shared() - cells.shared as f64).abs() < 1e-12, "{round}");
        shared += usize::from(cells.shared > 0);
        hollow += usize::from(cells.cavities > 0);
        // The same, rotated: nothing is coplanar or collinear any more, except for rounding.
        let turn = turned(&mut random);
        let turned: Vec<_> = cells.bodies.iter().map(|body| body.clone().moved(&turn)).collect();
        let turned = MeshUnion::of(&mesh(&turned)).unwrap();
        assert!((turned.volume() / union.volume() - 1.0).abs() < 1e-13, "{round}");
    }
    assert!(shared > 50 && hollow > 20, "{shared} {hollow}");
}

/// Returns a prism over a pentagram: its inner pentagon has winding number two.
fn star(height: f64) -> Body {
    let corner = |k: u32, z: f64| [(0.8 * PI * f64::from(k)).cos(), (0.8 * PI * f64::from(k)).sin(), z];
    let mut points: Vec<_> = (0..5).map(|k| corner(k, 0.0)).collect();
    points.extend((0..5).map(|k| corner(k, height)));
    points.extend([[0.0, 0.0, 0.0], [0.0, 0.0, height]]);
    let sides = (0..5).flat_map(|k| {
        let (a, b) = (k, (k + 1) % 5);
        [[a, b, b + 5], [a, b + 5, a + 5], [10, b, a], [11, a + 5, b + 5]]
    });
    Body { points, triangles: sides.collect() }
}

#[test]
fn a_surface_that_goes_through_itself_counts_once() {
    let (outer, inner) = (1.0, (0.4 * PI).cos() / (0.2 * PI).cos());
    let once = 5.0 * outer * inner * (0.2 * PI).sin() * 0.7;
    let twice = 2.5 * inner * inner * (0.4 * PI).sin() * 0.7;
    let mut random = Random(3);
    let turn = turned(&mut random);
    for star in [star(0.7), star(0.7).moved(turn)] {
        let counted = ClosedMesh::of(&mesh(std::slice::from_ref(&star))).unwrap();
        assert!((counted.volume() / (once + twice) - 1.0).abs() < 1e-14);
        let union = union(&[star]);
        assert!((union.volume() / once - 1.0).abs() < 1e-14, "{}", union.volume());
        assert!(
            (union.shared() / twice - 1.0).abs() < 1e-13 && union.parts() == 1 && union.solid().is_none()
        );
    }
}

#[test]
fn two_bodies_enclose_what_each_does_but_for_what_they_share() {
    let mut random = Random(11);
    for round in 0..12 {
        let by = random.point([0.9, 1e-3, 1e-6, 1e-9, 1e-12, 3e-16][round % 6]);
        let turn = turned(&mut random);
        let first = if round < 6 { sphere(2) } else { torus(24, 12, 0.4) }.moved(turn);
        let second = moved(&first, by);
        let each = ClosedMesh::of(&mesh(std::slice::from_ref(&first))).unwrap().volume();
        let union = union(&[first, second]);
        assert!((union.volume() + union.shared() - 2.0 * each).abs() < 1e-14 * each, "{round}");
        assert!(union.error() < 1e-14 * each, "{round}: {:e}", union.error());
        assert!(
            union.volume() < (1.0 + 1e-15) * 2.0 * each && union.volume() > (1.0 - 1e-15) * each,
            "{round}"
        );
    }
}

#[test]
fn what_is_sound_is_as_it_is() {
    let bodies = [sphere(2), moved(&torus(20, 9, 0.3), [1.0, 2.5, 0.1]), brick([3.0; 3], [4.0, 4.5, 3.2])];
    let solid = ClosedMesh::of(&mesh(&bodies)).unwrap();
    let united = union(&bodies);
    assert_eq!(united.spread(), solid.spread());
    assert_eq!((united.shared(), united.error(), united.parts()), (0.0, 0.0, 3));
    assert!(united.solid().is_some());
    let (scaled, united) = (solid.scaled(0.3).unwrap(), united.scaled(0.3).unwrap());
    assert_eq!((united.spread(), united.surface_area()), (scaled.spread(), scaled.surface_area()));
}

#[test]
fn a_body_that_is_small_beside_its_distance_counts_as_what_it_is() {
    let large = brick([0.0; 3], [1.0, 1.5, 0.5]);
    for (size, away) in [(1e-6, 1e6), (1e-6, 1e3), (1e-4, 1e4), (0.3, 1e7)] {
        let small = brick([away; 3], [away + size, away + size, away + size]);
        // Effect of rounded coordinates.
        let edge = (away + size) - away;
        let bodies = [large.clone(), small];
        let (solid, united) = (ClosedMesh::of(&mesh(&bodies)).unwrap(), union(&bodies));
        let volume = 0.75 + edge.powi(3);
        let center = (0.75 * 0.75 + edge.powi(3) * (away + 0.5 * edge)) / volume;
        for spread in [solid.spread(), united.spread()] {
            assert!((spread.extent().measure() / volume - 1.0).abs() < 1e-15, "{size} {away}");
            let off = (spread.centroid().to_array()[1] - center).abs();
            assert!(off <= 4e-16 * center.max(1.0), "{size} {away}: {off:e}");
        }
    }
}

#[test]
fn another_unit_is_the_same_union() {
    let bodies = [sphere(1), moved(&torus(12, 7, 0.3), [0.4, 0.3, 0.1])];
    let (union, scaled) = (union(&bodies), union(&bodies).scaled(1e-3).unwrap());
    let other = MeshUnion::of(&mesh(&bodies).scaled(1e-3)).unwrap();
    assert!(deviation(&numbers(&scaled), &numbers(&other)) < 1e-14);
    assert!((scaled.shared() / other.shared() - 1.0).abs() < 1e-13);
    assert!((scaled.error() * 1e9 / union.error() - 1.0).abs() < 1e-12);
    assert!(union.scaled(0.0).is_err());
}

#[test]
fn a_mesh_wound_inward_is_turned_and_parts_that_are_are_refused() {
    let bodies = [brick([0.0; 3], [2.0; 3]), brick([1.0, 0.5, 0.25], [3.0, 1.5, 1.25])];
    let inward: Vec<_> = bodies.iter().map(|body| body.clone().inward()).collect();
    let (one, other) = (union(&bodies), union(&inward));
    assert_eq!(numbers(&one), numbers(&other));
    assert!((one.volume() - 9.0).abs() < 1e-14 && (one.shared() - 1.0).abs() < 1e-14);
    assert_eq!(other.findings().iter().map(|f| f.code).collect::<Vec<_>>(), ["mesh.inverted"]);
    // A cavity that extends beyond its solid.
    let error = refused(&[bodies[0].clone(), inward[1].clone()]);
    let BodyError::NegativeUnion { volume, whole } = error else { panic!("{error}") };
    assert!((volume - 1.0).abs() < 1e-14 && (whole - 7.0).abs() < 1e-14);
    // A cavity that another body fills partly.
    let hollow = brick([-1.0; 3], [3.0; 3]).with(&inward[0]);
    let filled = union(&[hollow, brick([1.0, 1.0, -2.0], [1.5, 1.5, 1.0])]);
    assert!((filled.volume() - (64.0 - 8.0 + 0.25 + 0.25)).abs() < 1e-13, "{}", filled.volume());
}

#[test]
fn what_is_not_closed_or_encloses_nothing_is_refused() {
    let bodies = [brick([0.0; 3], [2.0; 3]), brick([1.0, 0.5, 0.25], [3.0, 1.5, 1.25])];
    let mut open = bodies.to_vec();
    open[1].triangles.pop();
    assert!(matches!(refused(&open), BodyError::OpenMesh { edges: 3, .. }));
    let mut twice = bodies.to_vec();
    let first = twice[1].triangles[0];
    twice[1].triangles.push(first);
    assert!(matches!(refused(&twice), BodyError::DuplicateTriangle { .. }));
    let mut turned = bodies.to_vec();
    for k in [0, 3, 5, 6, 8, 10] {
        turned[1].triangles[k].swap(0, 1);
    }
    assert!(matches!(refused(&turned), BodyError::InconsistentWinding { .. }), "{}", refused(&turned));
    // One face reversed.
    let mut flipped = bodies.to_vec();
    flipped[1].triangles[4].swap(0, 1);
    let flipped = union(&flipped);
    assert!((flipped.volume() - 9.0).abs() < 1e-14 && flipped.findings()[0].code == "mesh.flipped");
    let nothing = [bodies[0].clone(), bodies[0].clone().inward()];
    assert!(matches!(refused(&nothing), BodyError::FlatMesh { .. }), "{}", refused(&nothing));
    assert!(MeshUnion::of(&TriangleMesh::default()).is_err());
    let ended = MeshUnion::watched(&mesh(&bodies), &|| false);
    assert!(matches!(ended, Err(BodyError::UnionUndecided { .. } | BodyError::OverlapsUndecided { .. })));
}

/// Arbitrary contacts of corners give a result or an error.
#[test]
fn crumpled_surfaces_are_united_or_refused() {
    let (mut united, mut negative) = (0, 0);
    for seed in 0..60 {
        let mut random = Random(seed);
        let by = random.within(0.0, 1.0);
        let crumpled = |random: &mut Random| {
            let mut body = sphere(1);
            for p in &mut body.points {
                let to = random.point(by);
                *p = [0, 1, 2].map(|k| p[k] + to[k]);
                if seed % 3 == 0 {
                    *p = p.map(|c| (c * 4.0).round() / 4.0); // many coplanar, collinear and coincident points
                }
            }
            body
        };
        let bodies: Vec<_> = (0..1 + seed % 3).map(|_| crumpled(&mut random)).collect();
        match MeshUnion::of(&mesh(&bodies)) {
            Ok(union) => {
                let rounding = union.error() - union.left_out();
                assert!(rounding < 1e-12 * union.volume(), "{seed}: {rounding:e}");
                united += 1;
            }
            Err(BodyError::NegativeUnion { volume, whole }) => {
                assert!(volume > 1e-3 * whole, "{seed}: {volume:e}");
                negative += 1;
            }
            Err(error) => panic!("{seed}: {error}"),
        }
    }
    assert!(united > 5 && negative > 5, "{united} {negative}");
}
