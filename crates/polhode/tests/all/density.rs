//! Bodies of varying density compared with closed forms and exact rational integrals.

mod voxel_grid;

use polhode::body::density::{
    Cubature, DensityField, FieldError, FieldMassProperties, Parametrised, Solid, mass_properties_of_field,
};
use polhode::body::shape::{Capsule, Cone, Ellipsoid, Tetrahedron, Torus, TriangularPrism};
use polhode::prelude::*;

/// Pseudorandom numbers in [0, 1) (Knuth's MMIX generator).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, n: i64) -> i64 {
        (self.next() * n as f64) as i64
    }
}

/// Exact ∫ρ (1, x, y, z, xx, yy, zz, xy, xz, yz) dV about the origin.
type Moments = [f64; 10];

const POWERS: [[u32; 3]; 10] = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [2, 0, 0],
    [0, 2, 0],
    [0, 0, 2],
    [1, 1, 0],
    [1, 0, 1],
    [0, 1, 1],
];

/// Returns the true errors, in the units of the estimate: mass, centre of mass, inertia relative to
/// half its trace.
fn true_errors(body: &FieldMassProperties, truth: &Moments) -> [f64; 3] {
    let [m, x, y, z, xx, yy, zz, xy, xz, yz] = *truth;
    let c = [x / m, y / m, z / m];
    let second = |value: f64, i: usize, j: usize| value - m * c[i] * c[j];
    let [sx, sy, sz] = [second(xx, 0, 0), second(yy, 1, 1), second(zz, 2, 2)];
    let exact = [
        [sy + sz, -second(xy, 0, 1), -second(xz, 0, 2)],
        [-second(xy, 0, 1), sx + sz, -second(yz, 1, 2)],
        [-second(xz, 0, 2), -second(yz, 1, 2), sx + sy],
    ];
    let got = body.properties.inertia().matrix();
    let worst = (0..9).map(|k| (got[k / 3][k % 3] - exact[k / 3][k % 3]).abs()).fold(0.0, f64::max);
    [
        (body.properties.mass() - m).abs(),
        (body.properties.center_of_mass() - Position::from_array(c)).norm(),
        worst / (sx + sy + sz),
    ]
}

/// Checks that the true error is within the estimate, and the estimate within the tolerance. A
/// closed form evaluated in f64 has rounding of its own.
fn check(name: &str, solid: Solid<'_>, field: &dyn DensityField, tolerance: f64, truth: &Moments) {
    let cubature = Cubature { tolerance, ..Cubature::default() };
    let body = mass_properties_of_field(solid, field, cubature).unwrap_or_else(|e| panic!("{name}: {e}"));
    let FieldError { mass, center_of_mass, inertia } = body.error_estimate;
    let size = (body.properties.inertia().matrix().iter().enumerate().map(|(k, row)| row[k]).sum::<f64>()
        / (2.0 * body.properties.mass()))
    .sqrt();
    let [dm, dc, di] = true_errors(&body, truth);
    // Rounding of the reference.
    let slack = 2e-15;
    let errors = format!("{name}: {dm:e} of {mass:e}, {dc:e} of {center_of_mass:e}, {di:e} of {inertia:e}");
    assert!(dm <= mass + slack * truth[0] && dc <= center_of_mass && di <= inertia, "{errors}");
    let far = body.properties.center_of_mass().norm();
    assert!(mass <= tolerance * body.properties.mass(), "{name}");
    assert!(center_of_mass <= tolerance * size + f64::EPSILON * far && inertia <= tolerance, "{name}");
}

/// Returns a convex wedge, and a block with a step and a notch. Coordinates are multiples of a
/// quarter.
fn solids() -> Vec<ClosedMesh> {
    let quarter = |p: [i64; 3]| p.map(|c| c as f64 / 4.0);
    let wedge = {
        let [a, b, c, d] = [[-3, 1, 2], [5, -2, 1], [1, 6, -2], [2, 3, 7]].map(quarter);
        vec![[a, c, b], [a, b, d], [b, c, d], [c, a, d]]
    };
    // An L shape, extruded along a slanted direction.
    let outline = [[0, 0], [6, 1], [7, 3], [3, 2], [2, 7], [-1, 5]];
    let at = |k: usize, top: bool| {
        let [x, y] = outline[k % 6];
        quarter(if top { [x + 1, y - 2, 5] } else { [x, y, -2] })
    };
    let mut block = Vec::new();
    for k in 0..6 {
        block.push([at(k, false), at(k + 1, false), at(k + 1, true)]);
        block.push([at(k, false), at(k + 1, true), at(k, true)]);
    }
    // The corner at 3 is the only reentrant one: a fan from it covers the outline.
    for k in [4, 5, 6, 7] {
        block.push([at(3, true), at(k, true), at(k + 1, true)]);
        block.push([at(3, false), at(k + 1, false), at(k, false)]);
    }
    [wedge, block].map(|triangles| ClosedMesh::from_triangles(triangles).unwrap()).into()
}

/// Computes ∫x^a y^b z^c dV exactly over a polyhedron whose corners are multiples of a quarter. It
/// sums over the signed tetrahedra (0, p, q, r). The monomial is a sum over the choices of a corner
/// for each of its n factors, with ∫λ₁^i λ₂^j λ₃^k dV = 6V i! j! k! / (n + 3)!
fn exact_monomial(mesh: &ClosedMesh, powers: [u32; 3]) -> f64 {
    let n = powers.iter().sum::<u32>();
    let factorial = |n: u32| (1..=i128::from(n)).product::<i128>();
    // A form Σ c_ijk λ₁^i λ₂^j λ₃^k, indexed by i and j; k is the remaining exponent.
    let mut sum = 0_i128;
    for triangle in mesh.triangles() {
        let p = triangle.map(|p| p.map(|c| (c * 4.0) as i128));
        let det = p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1])
            + p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2])
            + p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
        let mut form = vec![((0, 0, 0), 1_i128)];
        for (axis, &power) in powers.iter().enumerate() {
            for _ in 0..power {
                let mut next = std::collections::BTreeMap::new();
                for ((i, j, k), c) in form {
                    *next.entry((i + 1, j, k)).or_insert(0) += c * p[0][axis];
                    *next.entry((i, j + 1, k)).or_insert(0) += c * p[1][axis];
                    *next.entry((i, j, k + 1)).or_insert(0) += c * p[2][axis];
                }
                form = next.into_iter().collect();
            }
        }
        let inner: i128 =
            form.iter().map(|((i, j, k), c)| c * factorial(*i) * factorial(*j) * factorial(*k)).sum();
        sum += det * inner;
    }
    let denominator = factorial(n + 3) * 4_i128.pow(n + 3);
    (sum / denominator) as f64 + (sum % denominator) as f64 / denominator as f64
}

#[test]
fn polynomials_over_meshes_are_exact_to_rounding() {
    let mut random = Random(7);
    for (s, mesh) in solids().iter().enumerate() {
        for trial in 0..8 {
            // A positive constant, and monomials up to degree 6 with exact coefficients in 1/64, or
            // in 1/1024 for the high degrees.
            let mut terms = vec![([0, 0, 0], 900.0)];
            for _ in 0..5 {
                let powers: [u32; 3] = std::array::from_fn(|_| random.below(3) as u32);
                let unit = if powers.iter().sum::<u32>() > 3 { 1024.0 } else { 64.0 };
                terms.push((powers, (random.below(4001) - 2000) as f64 / unit));
            }
            let monomial = |p: [f64; 3], e: [u32; 3]| (0..3).map(|k| p[k].powi(e[k] as i32)).product::<f64>();
            let field = |p: [f64; 3]| terms.iter().map(|&(e, c)| c * monomial(p, e)).sum::<f64>();
            let truth = POWERS.map(|m| {
                let term = |&(e, c): &([u32; 3], f64)| {
                    c * exact_monomial(mesh, std::array::from_fn(|k| e[k] + m[k]))
                };
                terms.iter().map(term).sum::<f64>()
            });
            check(&format!("mesh {s}, polynomial {trial}"), Solid::Mesh(mesh), &field, 1e-12, &truth);
        }
    }
}

/// Computes ∫ e^(k t) t^n dt from a to b for n = 0, 1, 2, by 40 terms of the series, so that a
/// small k loses no accuracy.
fn exponential(k: f64, a: f64, b: f64) -> [f64; 3] {
    [0, 1, 2].map(|n| {
        let mut coefficient = 1.0;
        let mut sum = 0.0;
        for j in 0..60 {
            let p = j + n + 1;
            sum += coefficient * (b.powi(p) - a.powi(p)) / f64::from(p);
            coefficient *= k / f64::from(j + 1);
        }
        sum
    })
}

/// Returns the ten moments of a product of three functions of one coordinate each.
fn product(lines: [[f64; 3]; 3]) -> Moments {
    POWERS.map(|[a, b, c]| lines[0][a as usize] * lines[1][b as usize] * lines[2][c as usize])
}

/// Returns a box as a mesh, with its corner at `low`.
fn box_mesh(low: [f64; 3], high: [f64; 3]) -> ClosedMesh {
    let corner =
        |k: usize| std::array::from_fn(|axis| if k >> axis & 1 == 0 { low[axis] } else { high[axis] });
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces
        .iter()
        .flat_map(|&[a, b, c, d]| [[corner(a), corner(b), corner(c)], [corner(a), corner(c), corner(d)]])
        .collect();
    ClosedMesh::from_triangles(triangles).unwrap()
}

const LOW: [f64; 3] = [-0.7, 0.3, -1.1];
const HIGH: [f64; 3] = [0.5, 1.9, 0.4];

#[test]
fn exponentials_over_a_box() {
    let mesh = box_mesh(LOW, HIGH);
    for k in [[0.3, -0.2, 0.7], [1.9, 0.4, -2.3], [-3.1, 2.2, 1.4], [0.0, 5.0, -4.0]] {
        let field = |p: [f64; 3]| 12.5 * (k[0] * p[0] + k[1] * p[1] + k[2] * p[2]).exp();
        let truth = product(std::array::from_fn(|a| exponential(k[a], LOW[a], HIGH[a]))).map(|m| 12.5 * m);
        check(&format!("exp {k:?}"), Solid::Mesh(&mesh), &field, 1e-11, &truth);
    }
    // The box shape is centred at the origin.
    let size: [f64; 3] = std::array::from_fn(|a| HIGH[a] - LOW[a]);
    let shape = BoxShape::new(size).unwrap();
    for k in [[0.3, -0.2, 0.7], [1.9, 0.4, -2.3], [-8.1, 2.2, 11.4]] {
        let field = |p: [f64; 3]| 3.5 * (k[0] * p[0] + k[1] * p[1] + k[2] * p[2]).exp();
        let truth = product(std::array::from_fn(|a| exponential(k[a], -0.5 * size[a], 0.5 * size[a])))
            .map(|m| 3.5 * m);
        check(&format!("shape exp {k:?}"), Solid::Shape(&shape), &field, 1e-12, &truth);
    }
}

/// The same box with its faces divided into 10 × 10 squares: too many triangles for the fine rule.
fn tiled_box(low: [f64; 3], high: [f64; 3]) -> ClosedMesh {
    const N: usize = 10;
    let at = |axis: usize, i: usize| low[axis] + (high[axis] - low[axis]) * i as f64 / N as f64;
    let mut triangles = Vec::new();
    for axis in 0..3 {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        for (side, i, j) in (0..2 * N * N).map(|k| (k % 2, k / 2 % N, k / 2 / N)) {
            let corner = |i: usize, j: usize| {
                let mut p = [0.0; 3];
                p[axis] = at(axis, side * N);
                p[next] = at(next, i);
                p[last] = at(last, j);
                p
            };
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            triangles.extend(if side == 1 { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] });
        }
    }
    ClosedMesh::from_triangles(triangles).unwrap()
}

#[test]
fn meshes_of_many_triangles_take_fewer_samples_each() {
    let mesh = tiled_box(LOW, HIGH);
    assert!(mesh.surface().triangles().len() == 1200 && !mesh.inverted());
    let k = [1.9, 0.4, -2.3];
    let field = |p: [f64; 3]| 12.5 * (k[0] * p[0] + k[1] * p[1] + k[2] * p[2]).exp();
    let truth = product(std::array::from_fn(|a| exponential(k[a], LOW[a], HIGH[a]))).map(|m| 12.5 * m);
    check("tiled", Solid::Mesh(&mesh), &field, 1e-9, &truth);
    let cubature = Cubature { tolerance: 1e-6, ..Cubature::default() };
    let body = mass_properties_of_field(Solid::Mesh(&mesh), &field, cubature).unwrap();
    assert!((1200 * 735..2 * 1200 * 735).contains(&body.evaluations), "{}", body.evaluations);
}

/// Returns the moments of a ball from its radial integrals ∫ρ(r) r^n dr.
fn radial(m0: f64, m2: f64) -> Moments {
    let pi = std::f64::consts::PI;
    let second = 4.0 * pi / 3.0 * m2;
    [4.0 * pi * m0, 0.0, 0.0, 0.0, second, second, second, 0.0, 0.0, 0.0]
}

#[test]
fn radial_densities_of_a_ball() {
    let r: f64 = 1.3;
    let ball = Sphere::new(r).unwrap();
    let distance = |p: [f64; 3]| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    // ρ = r^n: ∫r^(n+2) dr and ∫r^(n+4) dr
    for n in 0..7 {
        let field = |p: [f64; 3]| 40.0 * distance(p).powi(n);
        let truth = radial(40.0 * r.powi(n + 3) / f64::from(n + 3), 40.0 * r.powi(n + 5) / f64::from(n + 5));
        check(&format!("r^{n}"), Solid::Shape(&ball), &field, 1e-12, &truth);
    }
    // 1 − (r/R)²/2, and e^(−2r): ∫r² e^(−2r) = 2/8 − e^(−2R)(R²/2 + R/2 + 1/4), and so on
    let field = |p: [f64; 3]| 7.0 * (1.0 - 0.5 * (distance(p) / r).powi(2));
    let truth = radial(7.0 * r.powi(3) * (1.0 / 3.0 - 0.1), 7.0 * r.powi(5) * (0.2 - 1.0 / 14.0));
    check("parabola", Solid::Shape(&ball), &field, 1e-12, &truth);
    let moment = |n: i32| series(n, r);
    let field = |p: [f64; 3]| (-2.0 * distance(p)).exp();
    check("e^-2r", Solid::Shape(&ball), &field, 1e-12, &radial(moment(2), moment(4)));
}

/// Computes ∫ r^n e^(−2r) dr from 0 to b, by its series.
fn series(n: i32, b: f64) -> f64 {
    let mut coefficient = 1.0;
    let mut sum = 0.0;
    for j in 0..60 {
        sum += coefficient * b.powi(j + n + 1) / f64::from(j + n + 1);
        coefficient *= -2.0 / f64::from(j + 1);
    }
    sum
}

#[test]
fn a_gaussian_far_inside_a_body_has_its_textbook_moments() {
    // Truncated at 9 σ, below the rounding. Generic axes and centre.
    let (center, sigma) = ([0.2, -0.1, 0.3], [0.11, 0.17, 0.14]);
    let field =
        |p: [f64; 3]| (0..3).map(|k| -0.5 * ((p[k] - center[k]) / sigma[k]).powi(2)).sum::<f64>().exp();
    let lines = std::array::from_fn(|k| {
        let mass = (2.0 * std::f64::consts::PI).sqrt() * sigma[k];
        [mass, mass * center[k], mass * (sigma[k] * sigma[k] + center[k] * center[k])]
    });
    let truth = product(lines);
    check("box", Solid::Shape(&BoxShape::new([4.0; 3]).unwrap()), &field, 1e-9, &truth);
    check("ball", Solid::Shape(&Sphere::new(2.1).unwrap()), &field, 1e-9, &truth);
    let ellipsoid = Ellipsoid::new([1.9, 2.3, 2.6]).unwrap();
    check("ellipsoid", Solid::Shape(&ellipsoid), &field, 1e-9, &truth);
    check("cylinder", Solid::Shape(&Cylinder::new(2.2, 3.9).unwrap()), &field, 1e-9, &truth);
    check("capsule", Solid::Shape(&Capsule::new(2.0, 1.5).unwrap()), &field, 1e-9, &truth);
    check("mesh", Solid::Mesh(&box_mesh([-1.8, -2.0, -1.7], [1.9, 1.8, 2.2])), &field, 1e-6, &truth);
}

#[test]
fn every_shape_has_the_parametrisation_of_its_own_spread() {
    let shapes: [&dyn Parametrised; 14] = [
        &BoxShape::new([0.7, 1.3, 2.1]).unwrap(),
        &Sphere::new(0.9).unwrap(),
        &Ellipsoid::new([0.7, 1.3, 2.1]).unwrap(),
        &Cylinder::new(0.6, 1.7).unwrap(),
        &Cylinder::hollow(0.6, 0.23, 1.7).unwrap(),
        &Cylinder::hollow(0.6, 0.599_999_9, 1.7).unwrap(),
        &Sphere::hollow(0.9, 0.31).unwrap(),
        &Sphere::hollow(0.9, 0.899_999_9).unwrap(),
        &TriangularPrism::new([[0.1, -0.3], [1.3, 0.1], [0.2, 1.7]], 0.8).unwrap(),
        &Capsule::new(0.6, 1.7).unwrap(),
        &Cone::new(0.9, 0.4, 1.3).unwrap(),
        &Cone::new(0.0, 0.4, 1.3).unwrap(),
        &Torus::new(1.1, 0.4).unwrap(),
        &Tetrahedron::new([[0.1, -0.3, 0.2], [1.3, 0.1, -0.4], [0.2, 1.7, 0.3], [-0.3, 0.4, 1.1]]).unwrap(),
    ];
    for shape in shapes {
        let cubature = Cubature { tolerance: 1e-13, ..Cubature::default() };
        let body = mass_properties_of_field(Solid::Shape(shape), &|_: [f64; 3]| 2.5, cubature).unwrap();
        let exact = shape.mass_properties(Substance::Density(2.5)).unwrap();
        assert!((body.properties.mass() / exact.mass() - 1.0).abs() < 4e-15, "{shape:?}");
        assert!((body.properties.center_of_mass() - exact.center_of_mass()).norm() < 1e-14, "{shape:?}");
        let (got, exact) = (body.properties.inertia().matrix(), exact.inertia().matrix());
        let trace = exact[0][0] + exact[1][1] + exact[2][2];
        for k in 0..9 {
            assert!((got[k / 3][k % 3] - exact[k / 3][k % 3]).abs() < 4e-15 * trace, "{shape:?}");
        }
    }
}

#[test]
fn steps_converge_and_the_estimate_covers_them() {
    // 3 kg/m³ below the cut, 8 kg/m³ above: two boxes.
    let two = |cut: f64, low: [f64; 3], high: [f64; 3]| {
        let line = |a: f64, b: f64| [b - a, (b * b - a * a) / 2.0, (b.powi(3) - a.powi(3)) / 3.0];
        let below = product([line(low[0], high[0]), line(low[1], high[1]), line(low[2], cut)]);
        let above = product([line(low[0], high[0]), line(low[1], high[1]), line(cut, high[2])]);
        std::array::from_fn(|k| 3.0 * below[k] + 8.0 * above[k])
    };
    let field = |p: [f64; 3]| if p[2] < 0.13 { 3.0 } else { 8.0 };
    // A shape is divided at the discontinuity.
    let size: [f64; 3] = std::array::from_fn(|a| HIGH[a] - LOW[a]);
    let half = size.map(|s| 0.5 * s);
    let shape = BoxShape::new(size).unwrap();
    check("shape step", Solid::Shape(&shape), &field, 1e-10, &two(0.13, half.map(|h| -h), half));
    for cut in [-0.9, -0.31, 0.0, 0.13, 0.37] {
        let field = move |p: [f64; 3]| if p[2] < cut { 3.0 } else { 8.0 };
        let mesh = box_mesh(LOW, HIGH);
        check(&format!("mesh step {cut}"), Solid::Mesh(&mesh), &field, 1e-2, &two(cut, LOW, HIGH));
    }
}

#[test]
fn a_kink_converges() {
    // ρ = |x|: ∫|x| x^n
    let (a, b) = (LOW[0], HIGH[0]);
    let line = |a: f64, b: f64| [b - a, (b * b - a * a) / 2.0, (b.powi(3) - a.powi(3)) / 3.0];
    let kink = [(a * a + b * b) / 2.0, (b.powi(3) + a.powi(3)) / 3.0, (a.powi(4) + b.powi(4)) / 4.0];
    let truth = product([kink, line(LOW[1], HIGH[1]), line(LOW[2], HIGH[2])]);
    check("kink", Solid::Mesh(&box_mesh(LOW, HIGH)), &|p: [f64; 3]| p[0].abs(), 1e-5, &truth);
}

#[test]
fn a_body_far_away_and_one_of_another_scale_lose_nothing() {
    // Quarters remain exact at 2^20; the field uses coordinates relative to the body.
    let (low, high) = ([-0.75, 0.25, -1.0], [0.5, 2.0, 0.5]);
    let solve = |scale: f64, far: f64, tolerance: f64| {
        let at = |p: [f64; 3]| p.map(|c| (c + far) * scale);
        let field = |p: [f64; 3]| {
            let [x, y, z] = p.map(|c| c / scale - far);
            2.0 + x + 0.5 * y * z
        };
        let cubature = Cubature { tolerance, ..Cubature::default() };
        mass_properties_of_field(Solid::Mesh(&box_mesh(at(low), at(high))), &field, cubature).unwrap()
    };
    let near = solve(1.0, 0.0, 1e-12);
    let tensor = near.properties.inertia().matrix();
    for (scale, far, tolerance, within) in [
        (1e-9, 0.0, 1e-12, 1e-15),
        (1e9, 0.0, 1e-12, 1e-15),
        // The field sees coordinates with a rounding of 2⁻³³ m.
        (1.0, 1_048_576.0, 1e-8, 1e-9),
    ] {
        let other = solve(scale, far, tolerance);
        let got = other.properties.inertia().matrix();
        for k in 0..9 {
            let error = got[k / 3][k % 3] / scale.powi(5) - tensor[k / 3][k % 3];
            assert!(error.abs() < within * tensor[0][0], "{scale} {far}: {error}");
        }
        let place = (other.properties.center_of_mass() / scale).to_array().map(|c| c - far);
        let error = Position::<Part>::from_array(place) - near.properties.center_of_mass();
        assert!(error.norm() < within.max(f64::EPSILON * far), "{error:?}");
    }
}

#[test]
fn a_density_that_cannot_be_is_refused_with_its_place() {
    let ball = Sphere::new(1.0).unwrap();
    let solve = |solid: Solid<'_>, field: &dyn DensityField| {
        mass_properties_of_field(solid, field, Cubature { tolerance: 1e-6, max_evaluations: Some(2_000_000) })
    };
    let negative = |p: [f64; 3]| 0.9 - p[0];
    match solve(Solid::Shape(&ball), &negative) {
        Err(BodyError::Density { at, value }) => assert!(at[0] > 0.9 && value == negative(at)),
        other => panic!("{other:?}"),
    }
    match solve(Solid::Shape(&ball), &|p: [f64; 3]| (0.2 - p[1]).sqrt()) {
        Err(BodyError::Density { at, value }) => assert!(at[1] > 0.2 && value.is_nan()),
        other => panic!("{other:?}"),
    }
    assert!(solve(Solid::Shape(&ball), &|p: [f64; 3]| 1.0 / p[2].abs().min(0.0)).is_err());
    let nothing = solve(Solid::Shape(&ball), &|_: [f64; 3]| 0.0);
    assert!(matches!(nothing, Err(BodyError::Parameter { what: "the mass", .. })), "{nothing:?}");
    // ρ may be negative in the notch of the block, outside the body, but not inside.
    let [wedge, block] = &solids()[..] else { panic!() };
    let seen = std::sync::atomic::AtomicBool::new(false);
    let notch = |p: [f64; 3]| {
        let up = (p[2] + 0.5) / 1.75;
        let [x, y] = [p[0] - 1.25 - 0.25 * up, p[1] - 1.25 + 0.5 * up];
        let rho = 4.0 * (x * x + y * y - 0.35);
        seen.fetch_or(rho < 0.0, std::sync::atomic::Ordering::Relaxed);
        rho
    };
    assert!(solve(Solid::Mesh(block), &notch).unwrap().properties.mass() > 1.0);
    assert!(seen.into_inner());
    let error = solve(Solid::Mesh(wedge), &|p: [f64; 3]| p[2] - 0.5).unwrap_err();
    assert!(error.to_string().contains("must be finite and not negative"), "{error}");
}

#[test]
fn a_tolerance_out_of_reach_is_an_error_that_says_how_far_it_came() {
    let mesh = &solids()[0];
    let step = |p: [f64; 3]| if p[0] + 0.3 * p[1] < 0.4 { 3.0 } else { 8.0 };
    let solve = |tolerance, max_evaluations| {
        mass_properties_of_field(
            Solid::Mesh(mesh),
            &step,
            Cubature { tolerance, max_evaluations: Some(max_evaluations) },
        )
    };
    match solve(1e-9, 300_000) {
        Err(BodyError::Cubature { tolerance, reached, evaluations }) => {
            assert!(tolerance == 1e-9 && reached > 1e-9 && reached < 0.1 && evaluations <= 300_000);
        }
        other => panic!("{other:?}"),
    }
    assert!(matches!(solve(1e-2, 10_000), Err(BodyError::Cubature { evaluations: 0, .. })));
    // Accuracy beyond rounding cannot be reached: the computation stops long before the limit.
    let constant = |_: [f64; 3]| 4.5;
    let beyond = mass_properties_of_field(
        Solid::Mesh(mesh),
        &constant,
        Cubature { tolerance: 1e-18, ..Cubature::default() },
    );
    assert!(matches!(beyond, Err(BodyError::Cubature { evaluations: 1..100_000, .. })), "{beyond:?}");
    assert!(matches!(solve(0.0, 1_000_000), Err(BodyError::Parameter { what: "the tolerance", .. })));
}
