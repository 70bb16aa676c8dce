//! Meshes compared with exact rational arithmetic, and all ways in which triangles are not a closed
//! solid.

use std::collections::HashMap;

use polhode::body::BodyError;
use polhode::body::mesh::{ClosedMesh, Triangle, TriangleMesh};
use polhode::body::shape::{Shape, Substance};

type Point = [i64; 3];

/// Polyhedron with integer corners.
type Solid = Vec<[Point; 3]>;

/// Exact sums over the tetrahedra from the origin to each triangle, with d = a · (b × c) and s = a
/// + b + c: 6V = Σ d,  24V c = Σ d s,  120V ⟨x xᵀ⟩ = Σ d (a aᵀ + b bᵀ + c cᵀ + s sᵀ).
struct Exact {
    d: i128,
    first: [i128; 3],
    second: [[i128; 3]; 3],
}

impl Exact {
    fn of(solid: &Solid) -> Self {
        let mut sum = Self { d: 0, first: [0; 3], second: [[0; 3]; 3] };
        for triangle in solid {
            let [a, b, c] = triangle.map(|p| p.map(i128::from));
            let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
            let d = a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1);
            let s: [i128; 3] = std::array::from_fn(|k| a[k] + b[k] + c[k]);
            sum.d += d;
            for i in 0..3 {
                sum.first[i] += d * s[i];
                for j in 0..3 {
                    sum.second[i][j] += d * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
                }
            }
        }
        sum
    }

    /// Returns `⟨x_i x_j⟩ − c_i c_j = (4 S_ij Σd − 5 F_i F_j) / 80 (Σd)²`.
    fn covariance(&self, i: usize, j: usize) -> (i128, i128) {
        (4 * self.second[i][j] * self.d - 5 * self.first[i] * self.first[j], 80 * self.d * self.d)
    }

    /// Returns an element of the tensor at unit mass, as numerator and denominator.
    fn inertia(&self, i: usize, j: usize) -> (i128, i128) {
        let trace: i128 = (0..3).map(|k| self.covariance(k, k).0).sum();
        let (c, denominator) = self.covariance(i, j);
        (if i == j { trace - c } else { -c }, denominator)
    }
}

/// Returns got − n/d, to a few parts in 10²⁰ of the quotient if it is several hundred or more.
fn error(got: f64, (n, d): (i128, i128)) -> f64 {
    let (whole, rest) = (n.div_euclid(d), n.rem_euclid(d));
    (got - whole as f64) - rest as f64 / d as f64
}

/// Maps each coordinate to `unit` (x + offset), which must be exact.
fn triangles(solid: &Solid, unit: f64, offset: Point) -> Vec<Triangle> {
    let coordinate = |x: i64| {
        let value = x as f64;
        assert_eq!(value as i64, x);
        unit * value
    };
    let point = |p: Point| [0, 1, 2].map(|k| coordinate(p[k] + offset[k]));
    solid.iter().map(|t| t.map(point)).collect()
}

/// Returns the largest error of the central tensor at unit mass, relative to half its trace.
fn inertia_error(solid: &Solid, unit: f64, offset: Point) -> f64 {
    let exact = Exact::of(solid);
    let mesh = ClosedMesh::from_triangles(triangles(solid, unit, offset)).unwrap();
    assert!(!mesh.inverted());
    let volume = mesh.volume() / (unit * unit * unit);
    assert!((volume * 6.0 / exact.d as f64 - 1.0).abs() < 2e-15);
    let body = mesh.mass_properties(Substance::Mass(1.0)).unwrap();
    let far = offset.map(|x| x.abs() as f64).into_iter().fold(SIZE as f64, f64::max);
    for (k, got) in body.center_of_mass().to_array().into_iter().enumerate() {
        let got = got / unit - offset[k] as f64;
        assert!(error(got, (exact.first[k], 4 * exact.d)).abs() < 4e-16 * far);
    }
    let got = body.inertia().matrix();
    let half_trace = 0.5 * (0..3).map(|k| got[k][k]).sum::<f64>();
    let mut worst = 0.0_f64;
    for (i, j) in ELEMENTS {
        worst = worst.max(error(got[i][j] / (unit * unit), exact.inertia(i, j)).abs());
    }
    worst * unit * unit / half_trace
}

/// Rows and columns of the elements of a symmetric matrix.
const ELEMENTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Corners are within ±SIZE: large enough to be generic, small enough for `i128`.
const SIZE: i64 = 4096;

/// Pseudorandom numbers in [0, 1) (Knuth's MMIX generator).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Returns an octahedron on the unit sphere, with each face divided into four `level` times.
fn sphere(level: u32) -> Vec<[[f64; 3]; 3]> {
    let mut faces = Vec::new();
    for k in 0..8 {
        let sign = |bit: u32| if k & bit == 0 { 1.0 } else { -1.0 };
        let (x, y, z) = ([sign(1), 0.0, 0.0], [0.0, sign(2), 0.0], [0.0, 0.0, sign(4)]);
        faces.push(if sign(1) * sign(2) * sign(4) > 0.0 { [x, y, z] } else { [x, z, y] });
    }
    let middle = |a: [f64; 3], b: [f64; 3]| {
        let m: [f64; 3] = std::array::from_fn(|k| a[k] + b[k]);
        let norm = m.iter().map(|c| c * c).sum::<f64>().sqrt();
        m.map(|c| c / norm)
    };
    for _division in 0..level {
        let divide = |&[a, b, c]: &[[f64; 3]; 3]| {
            let (p, q, r) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, p, r], [p, b, q], [r, q, c], [p, q, r]]
        };
        faces = faces.iter().flat_map(divide).collect();
    }
    faces
}

/// Returns the sphere with random distances from the centre, stretched and sheared, rounded to
/// integers.
fn lump(level: u32, random: &mut Random) -> Solid {
    let roughness = random.next();
    let stretch: [f64; 3] = std::array::from_fn(|_| 0.05 + 0.6 * random.next());
    let shear = 0.3 * random.next();
    let mut known: HashMap<[u64; 3], Point> = HashMap::new();
    let mut corner = |p: [f64; 3]| {
        *known.entry(p.map(f64::to_bits)).or_insert_with(|| {
            let r = SIZE as f64 * (1.0 - 0.5 * roughness * random.next());
            let [x, y, z] = [0, 1, 2].map(|k| r * stretch[k] * p[k]);
            [x + shear * y, y, z - shear * x].map(|c| c.round() as i64)
        })
    };
    sphere(level).into_iter().map(|t| t.map(&mut corner)).collect()
}

#[test]
fn random_solids_have_their_exact_tensor() {
    let mut random = Random(1);
    for level in [0, 1, 2, 3].repeat(100) {
        let e = inertia_error(&lump(level, &mut random), 1.0, [0; 3]);
        assert!(e < 4e-16, "level {level}: {e:e}");
    }
}

#[test]
fn a_place_far_away_or_another_unit_costs_nothing() {
    let mut random = Random(2);
    for level in [0, 1, 2, 3].repeat(25) {
        let solid = lump(level, &mut random);
        for sizes in [1, 1_000, 1_000_000, 1_000_000_000] {
            let e = inertia_error(&solid, 1.0, [2 * SIZE * sizes, -3 * SIZE * sizes, SIZE * sizes + 1]);
            assert!(e < 4e-16, "{sizes} sizes away: {e:e}");
        }
        for power in [-42, -12, 18] {
            let e = inertia_error(&solid, 2.0_f64.powi(power), [0; 3]); // about 1e-9, 1 and 1e9 m
            assert!(e < 4e-16, "unit 2^{power}: {e:e}");
        }
    }
}

#[test]
fn a_cavity_is_subtracted() {
    let mut random = Random(3);
    for level in [1, 2, 3].repeat(30) {
        let outer = lump(level, &mut random);
        let part = 0.1 + 0.89 * random.next();
        let smaller = |p: Point| p.map(|c| (part * c as f64).round() as i64);
        let cavity = outer.iter().map(|t| t.map(smaller)).map(|[a, b, c]| [a, c, b]);
        let e = inertia_error(&outer.iter().copied().chain(cavity).collect(), 1.0, [0; 3]);
        assert!(e < 6e-16, "a cavity of {part}: {e:e}");
    }
}

#[test]
fn thin_walls_keep_their_digits() {
    let mut random = Random(7);
    for thin in [16, 256, 1024].repeat(20) {
        let scaled = |by: i64| move |p: Point| p.map(|c| by * (c / 100));
        let core = lump(0, &mut random);
        let wall = core.iter().map(|t| t.map(scaled(thin)));
        let cavity = core.iter().map(|t| t.map(scaled(thin - 1))).map(|[a, b, c]| [a, c, b]);
        let solid = wall.chain(cavity).collect();
        let e = inertia_error(&solid, 1.0, [0; 3]);
        assert!(e < 4e-16, "a wall of a {thin}th: {e:e}");
    }
}

#[test]
fn many_triangles_cost_no_digits_and_threads_no_bits() {
    // waves, so that neighbours do not cross after rounding
    let wavy = |p: [f64; 3]| {
        let [x, y, z] = p;
        let r =
            SIZE as f64 * (1.0 + 0.2 * (5.0 * x).sin() * (3.0 * y + 1.0).cos() + 0.1 * (4.0 * z).sin()) / 1.4;
        [r * x + 0.2 * r * y, 0.7 * r * y, 0.5 * r * z - 0.1 * r * x].map(|c| c.round() as i64)
    };
    let solid: Solid = sphere(8).iter().map(|t| t.map(wavy)).collect(); // 524,288 triangles
    let e = inertia_error(&solid, 1.0, [0; 3]);
    assert!(e < 4e-16, "{e:e}");
    let mesh = TriangleMesh::of_triangles(&triangles(&solid, 0.001, [70, -800, 9])).unwrap();
    let [one, two, eight] = [1, 2, 8].map(|threads| ClosedMesh::with_threads(&mesh, threads).unwrap());
    assert_eq!((one.spread(), one.surface_area()), (two.spread(), two.surface_area()));
    assert_eq!((one.spread(), one.surface_area()), (eight.spread(), eight.surface_area()));
    assert_eq!(one.diagnosis(), eight.diagnosis());
}

#[test]
fn needles_and_flakes_keep_the_digits_of_every_element() {
    let mut random = Random(4);
    for squeeze in [[1, 1, 32], [1, 32, 32], [1, 8, 64], [32, 1, 32]].repeat(25) {
        let squeezed = |p: Point| [0, 1, 2].map(|k| p[k] / squeeze[k]);
        let solid = lump(2, &mut random).iter().map(|t| t.map(squeezed)).collect();
        let exact = Exact::of(&solid);
        let mesh = ClosedMesh::from_triangles(triangles(&solid, 1.0, [0; 3])).unwrap();
        let got = mesh.mass_properties(Substance::Mass(1.0)).unwrap().inertia().matrix();
        for (i, j) in ELEMENTS {
            let e = error(got[i][j], exact.inertia(i, j)) / (got[i][i] * got[j][j]).sqrt();
            assert!(e.abs() < 4e-16, "{squeeze:?} element {i}{j}: {e:e}");
        }
    }
}

/// Returns a box with integer corners, counter-clockwise as seen from outside.
fn cuboid([x0, y0, z0]: Point, [x1, y1, z1]: Point) -> Solid {
    let quads = [
        [[x0, y0, z0], [x0, y1, z0], [x1, y1, z0], [x1, y0, z0]],
        [[x0, y0, z1], [x1, y0, z1], [x1, y1, z1], [x0, y1, z1]],
        [[x0, y0, z0], [x1, y0, z0], [x1, y0, z1], [x0, y0, z1]],
        [[x1, y0, z0], [x1, y1, z0], [x1, y1, z1], [x1, y0, z1]],
        [[x1, y1, z0], [x0, y1, z0], [x0, y1, z1], [x1, y1, z1]],
        [[x0, y1, z0], [x0, y0, z0], [x0, y0, z1], [x0, y1, z1]],
    ];
    quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()
}

/// Returns a box of 24 m³ at a generic position.
fn brick() -> Vec<Triangle> {
    triangles(&cuboid([0; 3], [2, 3, 4]), 1.0, [5, -7, 11])
}

fn refusal(triangles: Vec<Triangle>) -> BodyError {
    ClosedMesh::from_triangles(triangles).unwrap_err()
}

#[test]
fn a_missing_triangle_or_top_is_an_open_mesh() {
    let mut punctured = brick();
    punctured.remove(6);
    let error = refusal(punctured);
    assert!(matches!(error, BodyError::OpenMesh { edges: 3, triangle: 2, .. }), "{error:?}");
    assert!(error.to_string().contains("3 edges in 1 loop belong to one triangle only"), "{error}");

    let mut topless = brick();
    topless.drain(2..4);
    let BodyError::OpenMesh { edges: 4, example: [a, b], .. } = refusal(topless) else { panic!() };
    assert_eq!([a[2], b[2]], [15.0; 2]); // the rim, at z = 11 + 4

    // a corner that only nearly coincides is a different corner
    let mut torn = brick();
    torn[4][0][0] += 1e-12;
    assert!(matches!(refusal(torn), BodyError::OpenMesh { .. }));
}

#[test]
fn turned_triangles_are_turned_back_if_they_are_few() {
    let codes = |mesh: &ClosedMesh| mesh.findings().iter().map(|f| f.code).collect::<Vec<_>>();
    let sound = ClosedMesh::from_triangles(brick()).unwrap();
    assert_eq!(codes(&sound), [""; 0]);
    for k in 0..12 {
        let mut turned = brick();
        turned[k].swap(0, 1);
        turned[(k + 5) % 12].swap(1, 2);
        let mesh = ClosedMesh::from_triangles(turned.clone()).unwrap();
        assert_eq!(codes(&mesh), ["mesh.flipped"]);
        assert_eq!(mesh.findings()[0].place, Some(format!("triangle {}", k.min((k + 5) % 12) + 1)));
        assert_eq!((mesh.volume(), mesh.diagnosis().components[0].flipped), (24.0, 2));
        let inside_out = turned.iter().map(|&[a, b, c]| [a, c, b]).collect();
        let mesh = ClosedMesh::from_triangles(inside_out).unwrap();
        assert_eq!(codes(&mesh), ["mesh.inverted", "mesh.flipped"]);
        assert_eq!(mesh.volume(), 24.0);
    }
    // with equal numbers of both orientations, the majority is undetermined
    let mut half = brick();
    half[..6].iter_mut().for_each(|t| t.swap(0, 1));
    let error = refusal(half);
    assert!(matches!(error, BodyError::InconsistentWinding { .. }), "{error:?}");
}

#[test]
fn an_inside_out_mesh_is_turned() {
    let solid = lump(2, &mut Random(5));
    let outward = triangles(&solid, 1.0, [0; 3]);
    let inward = outward.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let outward = ClosedMesh::from_triangles(outward).unwrap();
    let turned = ClosedMesh::from_triangles(inward).unwrap();
    assert!(turned.inverted() && !outward.inverted());
    assert!(turned.triangles().eq(outward.triangles()));
    assert_eq!(turned.volume(), outward.volume());
    let [a, b] =
        [&turned, &outward].map(|mesh| *mesh.mass_properties(Substance::Mass(1.0)).unwrap().inertia());
    let (a, b, scale) = (a.matrix(), b.matrix(), b.matrix()[1][1]);
    assert!(a.as_flattened().iter().zip(b.as_flattened()).all(|(a, b)| (a - b).abs() < 4e-16 * scale));
    assert_eq!(turned.surface_area(), outward.surface_area());
}

#[test]
fn another_unit_is_that_of_all_coordinates() {
    let mut random = Random(29);
    let solid = lump(2, &mut random);
    let mut soup = triangles(&solid, 1.0, [0; 3]);
    soup.extend(triangles(&cuboid([9000, 9001, 9002], [9050, 9060, 9070]), 1.0, [0; 3]));
    soup[3].swap(0, 1);
    for factor in [1e-3, 0.0254, 1.0, 7.3] {
        let mesh = TriangleMesh::of_triangles(&soup).unwrap();
        let scaled = ClosedMesh::of(&mesh).unwrap().scaled(factor).unwrap();
        let direct = ClosedMesh::of(&mesh.scaled(factor)).unwrap();
        assert_eq!(scaled.surface(), direct.surface());
        let [a, b] = [&scaled, &direct].map(|mesh| mesh.mass_properties(Substance::Density(3.0)).unwrap());
        assert_eq!((a, scaled.volume(), scaled.surface_area()), (b, direct.volume(), direct.surface_area()));
        assert_eq!(scaled.findings(), direct.findings());
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs(); // rounding by scaling of a distant box
        for (a, b) in scaled.diagnosis().components.iter().zip(&direct.diagnosis().components) {
            assert!(near(a.volume, b.volume) && near(a.area, b.area), "{a:?} {b:?}");
            assert!(a.bounds.as_flattened().iter().zip(b.bounds.as_flattened()).all(|(a, b)| near(*a, *b)));
        }
    }
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e200] {
        let mesh = ClosedMesh::from_triangles(soup.clone()).unwrap();
        assert!(matches!(mesh.scaled(factor), Err(BodyError::Parameter { .. })), "{factor}");
    }
}

#[test]
fn a_triangle_given_twice_is_refused() {
    let refused = |triangles: Vec<Triangle>, count: usize, first: usize, second: usize| {
        assert_eq!(refusal(triangles), BodyError::DuplicateTriangle { count, first, second });
    };
    refused([brick(), brick()].concat(), 12, 1, 13); // closed, but with double weight
    let mut one = brick();
    let [a, b, c] = one[3];
    one.insert(8, [b, c, a]); // the same triangle, starting at another corner
    refused(one, 1, 4, 9);

    // a reversed copy is a different case: a wall without thickness, or two bodies that touch
    let wall = [[a, b, c], [a, c, b]];
    let mesh =
        ClosedMesh::from_triangles([brick(), wall.map(|t| t.map(|p| p.map(|x| 0.5 * x))).to_vec()].concat());
    assert_eq!(mesh.unwrap().volume(), 24.0);
    let solid = [cuboid([0; 3], [2, 3, 4]), cuboid([2, 0, 0], [5, 3, 4])].concat();
    let touching = ClosedMesh::from_triangles(triangles(&solid, 1.0, [0; 3])).unwrap();
    let whole = ClosedMesh::from_triangles(triangles(&cuboid([0; 3], [5, 3, 4]), 1.0, [0; 3])).unwrap();
    assert_eq!(touching.volume(), whole.volume());
    let tensor = |mesh: &ClosedMesh| *mesh.mass_properties(Substance::Density(1.0)).unwrap().inertia();
    for (got, want) in
        tensor(&touching).matrix().as_flattened().iter().zip(tensor(&whole).matrix().as_flattened())
    {
        assert!((got - want).abs() < 1e-13);
    }
}

#[test]
fn degenerate_triangles_are_left_out() {
    let [a, b] = [brick()[0][0], brick()[0][1]];
    let with = [vec![[a, a, b]], brick(), vec![[a, b, a], [b; 3], [a, a, b], [a, a, b]]].concat();
    let [with, without] = [with, brick()].map(|triangles| ClosedMesh::from_triangles(triangles).unwrap());
    assert_eq!([with.degenerate(), without.degenerate()], [5, 0]);
    assert_eq!([with.vertices(), without.vertices()], [8, 8]);
    assert_eq!(with.surface().triangles().len(), 12);
    assert_eq!(with.spread(), without.spread());
    // three different corners on one line are a seam, not a defect: an edge split on one side only
    let mut split = brick();
    let [p, q, r] = split[0];
    let middle: [f64; 3] = std::array::from_fn(|k| 0.5 * (p[k] + q[k]));
    split[0] = [middle, q, r];
    split.extend([[p, middle, r], [p, q, middle]]);
    assert_eq!(ClosedMesh::from_triangles(split).unwrap().volume(), 24.0);
    // zero has no sign
    let mut zero = triangles(&cuboid([0; 3], [2, 3, 4]), 1.0, [0; 3]);
    zero[0] = zero[0].map(|p| p.map(|c| if c == 0.0 { -0.0 } else { c }));
    assert_eq!(ClosedMesh::from_triangles(zero).unwrap().vertices(), 8);
}

#[test]
fn a_vertex_that_is_not_finite_is_refused_by_triangle() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut broken = brick();
        broken[4][2][1] = value;
        assert!(
            matches!(refusal(broken), BodyError::Vertex { triangle: 5, vertex: [_, y, _] } if !y.is_finite())
        );
    }
}

#[test]
fn what_encloses_nothing_is_refused() {
    assert_eq!(refusal(vec![]), BodyError::Empty { what: "triangles" });
    let [a, b, c] = brick()[0];
    assert_eq!(refusal(vec![[a; 3]; 4]), BodyError::Empty { what: "triangles" });
    assert!(matches!(refusal(vec![[a, b, c], [a, c, b]]), BodyError::FlatMesh { .. }));
    // four corners on a slanted plane, except for the rounding of the last
    let [o, p, q] = [[0.1, 0.2, 0.3], [1.7, 0.1, -0.4], [0.6, 0.9, 0.8]];
    let r: [f64; 3] = std::array::from_fn(|k| o[k] + 0.7 * (p[k] - o[k]) + 0.6 * (q[k] - o[k]));
    assert!(matches!(refusal(vec![[o, q, p], [o, p, r], [o, r, q], [p, q, r]]), BodyError::FlatMesh { .. }));
}

/// Returns a strip `n` long and `m` wide whose end is joined to its beginning with reversed
/// orientation; closed across or not.
fn twisted(n: usize, m: usize, closed: bool) -> Vec<Triangle> {
    let mut random = Random(6);
    let points: Vec<[f64; 3]> = (0..n * (m + 1)).map(|_| std::array::from_fn(|_| random.next())).collect();
    let point = |i: usize, j: usize| {
        let j = if closed { j % m } else { j };
        match (i < n, closed) {
            (true, _) => points[i * (m + 1) + j],
            (false, true) => points[(m - j) % m],
            (false, false) => points[m - j],
        }
    };
    let quad = |i: usize, j: usize| {
        let [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    (0..n).flat_map(|i| (0..m).flat_map(move |j| quad(i, j))).collect()
}

#[test]
fn one_sided_surfaces_are_refused() {
    let moebius = refusal(twisted(12, 3, false));
    assert!(matches!(moebius, BodyError::OpenMesh { edges: 24, .. }), "{moebius:?}");
    let klein = refusal(twisted(12, 5, true));
    assert!(matches!(klein, BodyError::Unorientable { edges: 5, .. }), "{klein:?}");
}
