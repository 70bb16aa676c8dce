//! Meshes against exact rational arithmetic, and every way in which triangles are not a solid.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

use std::collections::HashMap;

use polhode::{BodyError, ClosedMesh, Shape, Substance, Triangle};

type Point = [i64; 3];

/// A polyhedron with integer corners.
type Solid = Vec<[Point; 3]>;

/// Exact sums over the tetrahedra from the origin to each triangle, d = a · (b × c), s = a + b + c:
/// 6V = Σ d,  24V c = Σ d s,  120V ⟨x xᵀ⟩ = Σ d (a aᵀ + b bᵀ + c cᵀ + s sᵀ).
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

    /// ⟨x_i x_j⟩ − c_i c_j = (4 S_ij Σd − 5 F_i F_j) / 80 (Σd)²
    fn covariance(&self, i: usize, j: usize) -> (i128, i128) {
        (4 * self.second[i][j] * self.d - 5 * self.first[i] * self.first[j], 80 * self.d * self.d)
    }

    /// The tensor at unit mass, as numerators over one denominator.
    fn inertia(&self, i: usize, j: usize) -> (i128, i128) {
        let trace: i128 = (0..3).map(|k| self.covariance(k, k).0).sum();
        let (c, denominator) = self.covariance(i, j);
        (if i == j { trace - c } else { -c }, denominator)
    }
}

/// got − n/d, to a few parts in 10²⁰ of the quotient where that is some hundreds or more.
fn error(got: f64, (n, d): (i128, i128)) -> f64 {
    let (whole, rest) = (n.div_euclid(d), n.rem_euclid(d));
    (got - whole as f64) - rest as f64 / d as f64
}

/// Each coordinate becomes `unit` (x + offset), which must be exact.
fn triangles(solid: &Solid, unit: f64, offset: Point) -> Vec<Triangle> {
    let coordinate = |x: i64| {
        let value = x as f64;
        assert_eq!(value as i64, x);
        unit * value
    };
    let point = |p: Point| [0, 1, 2].map(|k| coordinate(p[k] + offset[k]));
    solid.iter().map(|t| t.map(point)).collect()
}

/// The largest error of the unit-mass central tensor, in parts of half its trace.
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
    for i in 0..3 {
        for j in 0..3 {
            worst = worst.max(error(got[i][j] / (unit * unit), exact.inertia(i, j)).abs());
        }
    }
    worst * unit * unit / half_trace
}

/// Corners lie within ±SIZE: large enough to be generic, small enough for `i128`.
const SIZE: i64 = 4096;

/// Numbers in [0, 1) that look random (Knuth's MMIX generator).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// An octahedron with each face divided into four, `level` times, on the unit sphere.
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

/// A lump: the sphere with random distances from the middle, stretched and sheared, rounded to integers.
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
    let mut worst = [0.0_f64; 4];
    for k in 0..400 {
        let level = k % 4;
        let e = inertia_error(&lump(level, &mut random), 1.0, [0; 3]);
        worst[level as usize] = worst[level as usize].max(e);
    }
    eprintln!("WORST {worst:?}");
}

#[test]
fn a_place_far_away_or_another_unit_costs_nothing() {
    let mut random = Random(2);
    let (mut far, mut unit) = ([0.0_f64; 4], 0.0_f64);
    for level in [0, 1, 2, 3].repeat(25) {
        let solid = lump(level, &mut random);
        for (k, sizes) in [1, 1_000, 1_000_000, 1_000_000_000].into_iter().enumerate() {
            let offset = [2 * SIZE * sizes, -3 * SIZE * sizes, SIZE * sizes + 1];
            far[k] = far[k].max(inertia_error(&solid, 1.0, offset));
        }
        for power in [-42, -12, 18] {
            // bodies of some 1e-9, 1 and 1e9 m
            unit = unit.max(inertia_error(&solid, 2.0_f64.powi(power), [0; 3]));
        }
    }
    eprintln!("WORST far {far:?} unit {unit:e}");
}
