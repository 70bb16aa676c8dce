//! Every shape compared with its definition by numerical integration, with its own mesh, and with
//! published formulas.

use std::f64::consts::{PI, TAU};
use std::ops::Add;

use polhode::body::BodyError;
use polhode::body::mesh::{ClosedMesh, Triangle};
use polhode::body::shape::{
    BoxShape, BoxShell, Capsule, Cone, ConeShell, Cylinder, CylinderShell, Disk, Ellipsoid, Extent, Plate,
    Rod, Shape, Sphere, SphereShell, Substance, Tetrahedron, Torus, TriangularPlate, TriangularPrism,
};
use polhode::math::{Part, Position};

/// Integrals ∫ dm, ∫ x dm and ∫ (r² 1 − x xᵀ) dm at unit density, the last about [`POINT`].
#[derive(Clone, Copy)]
struct Integrals {
    measure: f64,
    first: [f64; 3],
    inertia: [[f64; 3]; 3],
}

/// Generic point about which moments are taken.
const POINT: [f64; 3] = [0.3, -0.7, 1.1];

/// Range of a parameter that a curve or surface does not have.
const NONE: [f64; 2] = [0.0, 1.0];

impl Integrals {
    /// Integrates over a piece of a shape: a map from a box of parameters to a point and its
    /// volume, area or line element.
    fn over([u, v, w]: [[f64; 2]; 3], map: impl Fn(f64, f64, f64) -> ([f64; 3], f64)) -> Self {
        let mut sum = Self { measure: 0.0, first: [0.0; 3], inertia: [[0.0; 3]; 3] };
        for (u, du) in gauss_legendre(u) {
            for (v, dv) in gauss_legendre(v) {
                for (w, dw) in gauss_legendre(w) {
                    let (x, element) = map(u, v, w);
                    let dm = element * du * dv * dw;
                    let r: [f64; 3] = std::array::from_fn(|k| x[k] - POINT[k]);
                    let r2: f64 = r.iter().map(|c| c * c).sum();
                    sum.measure += dm;
                    for i in 0..3 {
                        sum.first[i] += x[i] * dm;
                        for j in 0..3 {
                            sum.inertia[i][j] += (if i == j { r2 } else { 0.0 } - r[i] * r[j]) * dm;
                        }
                    }
                }
            }
        }
        sum
    }
}

impl Add for Integrals {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self {
            measure: self.measure + b.measure,
            first: std::array::from_fn(|i| self.first[i] + b.first[i]),
            inertia: std::array::from_fn(|i| std::array::from_fn(|j| self.inertia[i][j] + b.inertia[i][j])),
        }
    }
}

/// Returns 24 nodes and weights on an interval, by Newton's method on P₂₄.
fn gauss_legendre([low, high]: [f64; 2]) -> Vec<(f64, f64)> {
    const POINTS: u32 = 24;
    let node = |k: u32| {
        let mut x = (PI * (f64::from(k) + 0.75) / (f64::from(POINTS) + 0.5)).cos();
        let mut slope = 0.0;
        for _newton in 0..8 {
            let (mut p0, mut p1) = (1.0, x);
            for n in (2..=POINTS).map(f64::from) {
                (p0, p1) = (p1, ((2.0 * n - 1.0) * x * p1 - (n - 1.0) * p0) / n);
            }
            slope = f64::from(POINTS) * (x * p1 - p0) / (x * x - 1.0);
            x -= p1 / slope;
        }
        let half = 0.5 * (high - low);
        (low + half * (1.0 + x), half * 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..POINTS).map(node).collect()
}

/// Checks extent, centroid and the full tensor about a generic point, to 1e-13.
#[track_caller]
fn assert_integrals(shape: &dyn Shape, want: Integrals) {
    let close = |got: f64, want: f64, scale: f64| {
        assert!((got - want).abs() < 1e-13 * scale, "{shape:?}: {got} instead of {want}");
    };
    let spread = shape.spread();
    close(spread.extent().measure(), want.measure, want.measure);
    let (mass, trace) = (2.3, want.inertia[0][0] + want.inertia[1][1] + want.inertia[2][2]);
    let body = shape.mass_properties(Substance::Mass(mass)).unwrap();
    let about = body.inertia_about(Position::from_array(POINT)).matrix();
    for (got, first) in body.center_of_mass().to_array().into_iter().zip(want.first) {
        close(got, first / want.measure, 1.0);
    }
    for (got, want_element) in about.as_flattened().iter().zip(want.inertia.as_flattened()) {
        close(got * want.measure / mass, *want_element, 0.5 * trace);
    }
    match spread.extent() {
        Extent::Area(area) => assert_eq!(shape.surface_area(), area),
        Extent::Length(_) => assert_eq!(shape.surface_area(), 0.0),
        Extent::Volume(_) => {} // compared with its mesh
    }
}

/// Returns the direction (θ, φ).
fn direction(theta: f64, phi: f64) -> [f64; 3] {
    [theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()]
}

#[test]
fn solids_are_the_integrals_of_their_definitions() {
    let [a, b, c] = [0.7, 1.3, 0.4];
    let half = |edge: f64| [-0.5 * edge, 0.5 * edge];
    let cuboid = Integrals::over([a, b, c].map(half), |x, y, z| ([x, y, z], 1.0));
    assert_integrals(&BoxShape::new([a, b, c]).unwrap(), cuboid);

    let ball = |[a, b, c]: [f64; 3], inner: f64| {
        Integrals::over([[inner, 1.0], [0.0, PI], [0.0, TAU]], move |s, theta, phi| {
            let [x, y, z] = direction(theta, phi);
            ([a * s * x, b * s * y, c * s * z], a * b * c * s * s * theta.sin())
        })
    };
    assert_integrals(&Sphere::new(0.85).unwrap(), ball([0.85; 3], 0.0));
    assert_integrals(&Ellipsoid::new([a, b, c]).unwrap(), ball([a, b, c], 0.0));

    let (r, l) = (0.45, 1.7);
    let tube = |inner: f64| {
        Integrals::over([[inner, r], [0.0, TAU], half(l)], |rho, phi, z| {
            ([rho * phi.cos(), rho * phi.sin(), z], rho)
        })
    };
    let cylinder = tube(0.0);
    assert_integrals(&Cylinder::new(r, l).unwrap(), cylinder);
    // Walls from thick to thin, the last within the rounding of this integral.
    for part in [1e-9, 0.013, 0.4, 0.77, 0.999] {
        assert_integrals(&Cylinder::hollow(r, part * r, l).unwrap(), tube(part * r));
        assert_integrals(&Sphere::hollow(0.85, part * 0.85).unwrap(), ball([0.85; 3], part));
    }

    let cap = |side: f64| {
        Integrals::over([[0.0, r], [0.0, 0.5 * PI], [0.0, TAU]], move |rho, theta, phi| {
            let [x, y, z] = direction(theta, phi);
            ([rho * x, rho * y, side * (0.5 * l + rho * z)], rho * rho * theta.sin())
        })
    };
    assert_integrals(&Capsule::new(r, l).unwrap(), cylinder + cap(1.0) + cap(-1.0));

    for (base, top) in [(0.9, 0.35), (0.35, 0.9), (0.9, 0.0), (0.0, 0.9), (0.6, 0.6), (0.6, 0.6 + 1e-9)] {
        let h = 1.3;
        let cone = Integrals::over([[0.0, 1.0], [0.0, TAU], [0.0, h]], |s, phi, z| {
            let r = base + (top - base) * z / h;
            ([r * s * phi.cos(), r * s * phi.sin(), z], r * r * s)
        });
        assert_integrals(&Cone::new(base, top, h).unwrap(), cone);
    }

    for (ring, tube) in [(1.1, 0.4), (0.6, 0.6)] {
        let torus = Integrals::over([[0.0, tube], [0.0, TAU], [0.0, TAU]], |rho, psi, phi| {
            let from_axis = ring + rho * psi.cos();
            ([from_axis * phi.cos(), from_axis * phi.sin(), rho * psi.sin()], rho * from_axis)
        });
        assert_integrals(&Torus::new(ring, tube).unwrap(), torus);
    }

    // x = o + s (p + t (q − p) + t w (r − q)): the Duffy transformation, with the element s² t
    // |det|
    let corners = [[0.2, -0.3, 0.5], [1.1, 0.1, 0.4], [0.0, 0.9, 0.7], [0.3, 0.2, 1.9]];
    let [o, p, q, r] = corners;
    let det = 0.9 * (1.2 * 1.4 - 0.2 * 0.5) - 0.4 * (-0.2 * 1.4 - 0.2 * 0.1) - 0.1 * (-0.2 * 0.5 - 1.2 * 0.1);
    let tetrahedron = Integrals::over([[0.0, 1.0]; 3], |s, t, w| {
        let x = |k: usize| o[k] + s * (p[k] - o[k] + t * (q[k] - p[k]) + t * w * (r[k] - q[k]));
        ([x(0), x(1), x(2)], s * s * t * det)
    });
    assert_integrals(&Tetrahedron::new(corners).unwrap(), tetrahedron);
    assert_integrals(&Tetrahedron::new([p, o, q, r]).unwrap(), tetrahedron); // the other handedness

    let [o, p, q] = TRIANGLE;
    assert_integrals(&TriangularPrism::new([o, p, q], l).unwrap(), triangle(Some(half(l))));
    assert_integrals(&TriangularPrism::new([p, o, q], l).unwrap(), triangle(Some(half(l))));
}

/// Corners of a generic triangle, far from the origin compared with its size.
const TRIANGLE: [[f64; 2]; 3] = [[0.2, -0.3], [1.1, 0.1], [0.4, 0.9]];

/// Integrates [`TRIANGLE`] over an interval of z, or flat at z = 0, by the Duffy transformation,
/// with the element u |det|.
fn triangle(along: Option<[f64; 2]>) -> Integrals {
    let [o, p, q] = TRIANGLE;
    let det = (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
    Integrals::over([[0.0, 1.0], [0.0, 1.0], along.unwrap_or(NONE)], |u, v, z| {
        let [x, y] = [0, 1].map(|k| o[k] + u * (p[k] - o[k] + v * (q[k] - p[k])));
        ([x, y, if along.is_some() { z } else { 0.0 }], u * det)
    })
}

#[test]
fn thin_shapes_are_the_integrals_of_their_definitions() {
    let half = |edge: f64| [-0.5 * edge, 0.5 * edge];
    let (r, l) = (0.45, 1.7);
    assert_integrals(
        &Rod::new(l).unwrap(),
        Integrals::over([half(l), NONE, NONE], |z, _, _| ([0.0, 0.0, z], 1.0)),
    );

    let disk = |z: f64| {
        Integrals::over([[0.0, r], [0.0, TAU], NONE], move |rho, phi, _| {
            ([rho * phi.cos(), rho * phi.sin(), z], rho)
        })
    };
    assert_integrals(&Disk::new(r).unwrap(), disk(0.0));
    let tube =
        Integrals::over([[0.0, TAU], half(l), NONE], |phi, z, _| ([r * phi.cos(), r * phi.sin(), z], r));
    assert_integrals(&CylinderShell::new(r, l, false).unwrap(), tube);
    assert_integrals(&CylinderShell::new(r, l, true).unwrap(), tube + disk(-0.5 * l) + disk(0.5 * l));

    let sphere = Integrals::over([[0.0, PI], [0.0, TAU], NONE], |theta, phi, _| {
        (direction(theta, phi).map(|c| r * c), r * r * theta.sin())
    });
    assert_integrals(&SphereShell::new(r).unwrap(), sphere);

    // Wall of a frustum: dA = ρ (s/h) dφ dz with the slant height s.
    for (base, top) in [(0.9, 0.35), (0.35, 0.9), (0.9, 0.0), (0.0, 0.9), (0.6, 0.6)] {
        let h = 1.3;
        let radius = |z: f64| base + (top - base) * z / h;
        let slant = f64::hypot(h, base - top) / h;
        let wall = Integrals::over([[0.0, TAU], [0.0, h], NONE], |phi, z, _| {
            let r = radius(z);
            ([r * phi.cos(), r * phi.sin(), z], r * slant)
        });
        let end = |r: f64, z: f64| {
            Integrals::over([[0.0, r], [0.0, TAU], NONE], move |rho, phi, _| {
                ([rho * phi.cos(), rho * phi.sin(), z], rho)
            })
        };
        assert_integrals(&ConeShell::new(base, top, h, false).unwrap(), wall);
        assert_integrals(&ConeShell::new(base, top, h, true).unwrap(), wall + end(base, 0.0) + end(top, h));
    }
    assert_integrals(&TriangularPlate::new(TRIANGLE).unwrap(), triangle(None));

    let [a, b, c] = [0.7, 1.3, 0.4];
    let plate = Integrals::over([half(a), half(b), NONE], |x, y, _| ([x, y, 0.0], 1.0));
    assert_integrals(&Plate::new([a, b]).unwrap(), plate);
    let faces = [-0.5, 0.5].map(|side| {
        Integrals::over([half(b), half(c), NONE], move |y, z, _| ([side * a, y, z], 1.0))
            + Integrals::over([half(a), half(c), NONE], move |x, z, _| ([x, side * b, z], 1.0))
            + Integrals::over([half(a), half(b), NONE], move |x, y, _| ([x, y, side * c], 1.0))
    });
    assert_integrals(&BoxShell::new([a, b, c]).unwrap(), faces[0] + faces[1]);
}

/// Returns the surface of revolution of a profile (distance from the axis, z), which ascends on the
/// outside, about z in `n` steps.
fn revolved(profile: &[[f64; 2]], n: u32) -> Vec<Triangle> {
    let point = |[r, z]: [f64; 2], j: u32| {
        let (sin, cos) = (TAU * f64::from(j % n) / f64::from(n)).sin_cos();
        [r * cos, r * sin, z]
    };
    let strip = |lower: [f64; 2], upper: [f64; 2]| {
        (0..n).flat_map(move |j| {
            let [a, b, c, d] = [point(lower, j), point(lower, j + 1), point(upper, j + 1), point(upper, j)];
            [[a, b, c], [a, c, d]]
        })
    };
    profile.windows(2).flat_map(|p| strip(p[0], p[1])).collect()
}

/// Returns `n` steps along a circle about (r, z), between two angles from the outward direction;
/// points on the axis are exact.
fn arc([r, z]: [f64; 2], radius: f64, [from, to]: [f64; 2], n: u32) -> Vec<[f64; 2]> {
    let on_axis = |r: f64| if r.abs() < 1e-15 { 0.0 } else { r };
    let angle = |k: u32| from + (to - from) * f64::from(k) / f64::from(n);
    (0..=n).map(|k| [on_axis(r + radius * angle(k).cos()), z + radius * angle(k).sin()]).collect()
}

/// Returns volume, area, height of the centroid, and the diagonal of the tensor at unit mass.
fn numbers(shape: &dyn Shape) -> [f64; 6] {
    let body = shape.mass_properties(Substance::Mass(1.0)).unwrap();
    let [[xx, ..], [_, yy, _], [.., zz]] = body.inertia().matrix();
    [shape.spread().extent().measure(), shape.surface_area(), body.center_of_mass().z, xx, yy, zz]
}

/// Checks that the error of a mesh falls by four for a refinement by two, and that Richardson
/// extrapolation from two meshes gives the shape.
#[track_caller]
fn assert_meshed(shape: &dyn Shape, triangles: impl Fn(u32) -> Vec<Triangle>) {
    let mesh = |n: u32| {
        let mesh = ClosedMesh::from_triangles(triangles(n)).unwrap();
        assert!(!mesh.inverted());
        numbers(&mesh)
    };
    let (exact, coarse, fine) = (numbers(shape), mesh(96), mesh(192));
    for ((want, coarse), fine) in exact.into_iter().zip(coarse).zip(fine) {
        let extrapolated = (4.0 * fine - coarse) / 3.0;
        assert!((fine - want).abs() < 3e-3, "{shape:?}: {fine} near {want}");
        assert!((extrapolated - want).abs() < 1e-6, "{shape:?}: {extrapolated} instead of {want}");
        if (fine - want).abs() > 1e-12 {
            let fall = (coarse - want) / (fine - want);
            assert!((fall - 4.0).abs() < 3e-3, "{shape:?}: the error falls by {fall} near {want}");
        }
    }
}

#[test]
fn round_solids_are_the_limits_of_their_meshes() {
    let quarter = 0.5 * PI;
    let sphere = |n: u32| revolved(&arc([0.0; 2], 0.8, [-quarter, quarter], n / 2), n);
    assert_meshed(&Sphere::new(0.8).unwrap(), sphere);
    let stretch = |p: [f64; 3]| [p[0] * 0.875, p[1] * 1.625, p[2] * 0.5]; // of the sphere of radius 0.8
    let ellipsoid = |n: u32| sphere(n).into_iter().map(|t| t.map(stretch)).collect();
    assert_meshed(&Ellipsoid::new([0.7, 1.3, 0.4]).unwrap(), ellipsoid);

    let (r, l) = (0.45, 1.7);
    let can = [[0.0, -0.5 * l], [r, -0.5 * l], [r, 0.5 * l], [0.0, 0.5 * l]];
    assert_meshed(&Cylinder::new(r, l).unwrap(), |n| revolved(&can, n));
    let pill = |n: u32| {
        let mut profile = arc([0.0, -0.5 * l], r, [-quarter, 0.0], n / 4);
        profile.extend(arc([0.0, 0.5 * l], r, [0.0, quarter], n / 4));
        revolved(&profile, n)
    };
    assert_meshed(&Capsule::new(r, l).unwrap(), pill);
    for (base, top) in [(0.9, 0.35), (0.35, 0.9), (0.9, 0.0), (0.0, 0.9), (0.6, 0.6)] {
        let profile = [[0.0, 0.0], [base, 0.0], [top, 1.3], [0.0, 1.3]];
        assert_meshed(&Cone::new(base, top, 1.3).unwrap(), |n| revolved(&profile, n));
    }
    let ring = |n: u32| {
        let mut profile = arc([1.1, 0.0], 0.4, [-PI, PI], n);
        profile[n as usize] = profile[0];
        revolved(&profile, n)
    };
    assert_meshed(&Torus::new(1.1, 0.4).unwrap(), ring);
}

#[test]
fn flat_faced_solids_are_their_meshes() {
    let same = |shape: &dyn Shape, triangles: Vec<Triangle>| {
        let mesh = ClosedMesh::from_triangles(triangles).unwrap();
        for (got, want) in numbers(&mesh).into_iter().zip(numbers(shape)) {
            assert!((got - want).abs() < 1e-15, "{shape:?}: {got} instead of {want}");
        }
    };
    let [o, a, b, c] = [[0.2, -0.3, 0.5], [1.1, 0.1, 0.4], [0.0, 0.9, 0.7], [0.3, 0.2, 1.9]];
    same(&Tetrahedron::new([c, a, o, b]).unwrap(), vec![[o, b, a], [o, a, c], [o, c, b], [a, b, c]]);

    let size = [0.7, 1.3, 0.4];
    let corner = |x: f64, y: f64, z: f64| [0.5 * x * size[0], 0.5 * y * size[1], 0.5 * z * size[2]];
    let side = |axis: usize, s: f64| {
        // counter-clockwise seen from +axis, from −axis for s < 0
        let turn = |u: f64, v: f64| {
            let mut p = [0.0; 3];
            (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (s, u, s * v);
            corner(p[0], p[1], p[2])
        };
        let [p, q, r, t] = [turn(-1.0, -1.0), turn(1.0, -1.0), turn(1.0, 1.0), turn(-1.0, 1.0)];
        [[p, q, r], [p, r, t]]
    };
    let faces = (0..3).flat_map(|axis| [side(axis, 1.0), side(axis, -1.0)].concat()).collect();
    same(&BoxShape::new(size).unwrap(), faces);
}

#[test]
fn printed_moments_come_back() {
    let tensor = |shape: &dyn Shape, mass: f64| shape.mass_properties(Substance::Mass(mass)).unwrap();
    let close = |got: f64, want: f64| assert!((got / want - 1.0).abs() < 1e-14, "{got} instead of {want}");

    // Landau & Lifshitz, Mechanics, §32, problem 2(e): a cone about its centre of mass and about
    // its vertex
    let (m, r, h) = (2.3, 0.8, 1.9);
    for (cone, apex) in [(Cone::new(r, 0.0, h).unwrap(), h), (Cone::new(0.0, r, h).unwrap(), 0.0)] {
        let body = tensor(&cone, m);
        close((body.center_of_mass().z - apex).abs(), 0.75 * h);
        let [central, vertex] =
            [body.inertia().matrix(), body.inertia_about(Position::new(0.0, 0.0, apex)).matrix()];
        close(central[0][0], 3.0 / 20.0 * m * (r * r + h * h / 4.0));
        close(vertex[0][0], 3.0 / 5.0 * m * (r * r / 4.0 + h * h));
        close(vertex[2][2], 3.0 / 10.0 * m * r * r);
    }

    // Landau & Lifshitz, §32, problem 2(f): an ellipsoid
    let body = tensor(&Ellipsoid::new([0.7, 1.3, 0.4]).unwrap(), m).inertia().matrix();
    for (k, want) in [1.69 + 0.16, 0.49 + 0.16, 0.49 + 1.69].into_iter().enumerate() {
        close(body[k][k], m / 5.0 * want);
    }

    // Weisstein, MathWorld, "Torus": I_z = M (c² + 3/4 a²), I_x = M (c²/2 + 5/8 a²)
    let body = tensor(&Torus::new(1.1, 0.4).unwrap(), m).inertia().matrix();
    close(body[2][2], m * (1.21 + 0.12));
    close(body[0][0], m * (0.605 + 0.1));

    // Curtis, Orbital Mechanics for Engineering Students, 2nd ed., example 10.2: a thin open
    // cylinder
    let body = tensor(&CylinderShell::new(1.0, 3.0, false).unwrap(), 100.0).inertia().matrix();
    close(body[2][2], 100.0);
    close(body[0][0], 125.0);

    // 5/18 M a² for a hollow cube, by hand from six plates
    let body = tensor(&BoxShell::new([1.3; 3]).unwrap(), m).inertia().matrix();
    close(body[1][1], 5.0 / 18.0 * m * 1.69);
}

#[test]
fn an_ellipsoids_area_is_right_at_any_aspect() {
    let area = |semi_axes| Ellipsoid::new(semi_axes).unwrap().surface_area();
    let close =
        |got: f64, want: f64| assert!((got / want - 1.0).abs() < 2e-15, "{got:e} instead of {want:e}");
    // 4π abc R_G(a⁻², b⁻², c⁻²) with 40 digits (mpmath)
    close(area([1.0, 2.0, 3.0]), 48.882_146_302_582_06);
    close(area([4.7, 1.1, 1.2]), 54.690_124_099_820_31);
    close(area([1e-3, 1.0, 1e3]), 6_283.209_792_943_225);
    close(area([1.0, 1e-6, 1.0]), 6.283_185_307_270_747);
    close(area([0.7, 0.9, 1e8]), 792_655_627.264_573_7);
    // a ball, and spheroids of eccentricity 0.6 and 0.8 by their elementary formulas
    close(area([0.3; 3]), 4.0 * PI * 0.09);
    close(area([1.0, 1.0, 0.8]), TAU * (1.0 + 0.64 / 0.6 * 0.6_f64.atanh()));
    close(area([0.6, 0.6, 1.0]), TAU * 0.36 * (1.0 + 0.8_f64.asin() / (0.6 * 0.8)));
}

#[test]
fn a_substance_fits_the_shape_or_is_refused() {
    let (solid, thin, line) = (Sphere::new(0.5).unwrap(), Disk::new(0.5).unwrap(), Rod::new(0.5).unwrap());
    let mass = |shape: &dyn Shape, substance| shape.mass_properties(substance).map(|body| body.mass());
    assert_eq!(mass(&solid, Substance::Density(3.0)), Ok(0.5 * PI));
    assert_eq!(mass(&thin, Substance::AreaDensity(2.0)), Ok(0.5 * PI));
    assert_eq!(mass(&line, Substance::LineDensity(2.0)), Ok(1.0));
    let all = [Substance::Density(2.0), Substance::AreaDensity(2.0), Substance::LineDensity(2.0)];
    let shapes: [(&dyn Shape, &str); 3] = [(&solid, "kg/m³"), (&thin, "kg/m²"), (&line, "kg/m,")];
    for (k, (shape, unit)) in shapes.into_iter().enumerate() {
        assert_eq!(mass(shape, Substance::Mass(2.5)), Ok(2.5));
        for (n, substance) in all.into_iter().enumerate().filter(|(n, _)| *n != k) {
            let message = mass(shape, substance).unwrap_err().to_string();
            assert!(message.contains(unit), "substance {n}: {message}");
        }
        for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(mass(shape, Substance::Mass(value)).is_err());
        }
    }
    for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(mass(&solid, Substance::Density(value)).is_err());
        assert!(mass(&thin, Substance::AreaDensity(value)).is_err());
        assert!(mass(&line, Substance::LineDensity(value)).is_err());
    }
}

#[test]
fn impossible_sizes_are_refused_by_name() {
    type Maker = Box<dyn Fn(f64) -> Option<BodyError>>;
    fn maker<S>(make: impl Fn(f64) -> Result<S, BodyError> + 'static) -> Maker {
        Box::new(move |x| make(x).err())
    }
    let makers = [
        ("the box's size", maker(|x| BoxShape::new([1.0, x, 1.0]))),
        ("the hollow box's size", maker(|x| BoxShell::new([1.0, 1.0, x]))),
        ("the sphere's radius", maker(Sphere::new)),
        ("the spherical shell's radius", maker(SphereShell::new)),
        ("the ellipsoid's semi-axis", maker(|x| Ellipsoid::new([x, 1.0, 1.0]))),
        ("the cylinder's radius", maker(|x| Cylinder::new(x, 1.0))),
        ("the cylinder's length", maker(|x| Cylinder::new(1.0, x))),
        ("the cylindrical shell's radius", maker(|x| CylinderShell::new(x, 1.0, true))),
        ("the cylindrical shell's length", maker(|x| CylinderShell::new(1.0, x, false))),
        ("the capsule's radius", maker(|x| Capsule::new(x, 1.0))),
        ("the capsule's length", maker(|x| Capsule::new(1.0, x))),
        ("the cone's height", maker(|x| Cone::new(1.0, 0.5, x))),
        ("the torus's ring radius", maker(|x| Torus::new(x, 1.0))),
        ("the torus's tube radius", maker(|x| Torus::new(1.0, x))),
        ("the rod's length", maker(Rod::new)),
        ("the disk's radius", maker(Disk::new)),
        ("the plate's size", maker(|x| Plate::new([1.0, x]))),
        ("the conical shell's height", maker(|x| ConeShell::new(1.0, 0.5, x, true))),
        ("the triangular prism's length", maker(|x| TriangularPrism::new(TRIANGLE, x))),
    ];
    let refused = |name: &str, value: f64, error: Option<BodyError>| match error {
        Some(BodyError::Parameter { what, value: got, .. }) => {
            assert_eq!(what, name);
            assert!(got == value || got.is_nan() && value.is_nan(), "{name}: {got} instead of {value}");
        }
        other => panic!("{name} = {value}: {other:?}"),
    };
    for (name, make) in makers {
        assert_eq!(make(1.0), None, "{name}");
        for value in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            refused(name, value, make(value));
        }
    }
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        refused("the cone's base radius", value, Cone::new(value, 1.0, 1.0).err());
        refused("the cone's top radius", value, Cone::new(1.0, value, 1.0).err());
    }
    refused("the larger radius of the cone", 0.0, Cone::new(0.0, 0.0, 1.0).err());
    refused("the torus's tube radius", 1.5, Torus::new(1.0, 1.5).err());

    let [o, a, b] = [[0.1, 0.2, 0.3], [1.7, 0.1, -0.4], [0.6, 0.9, 0.8]];
    let tetrahedron = |c: [f64; 3]| Tetrahedron::new([o, a, b, c]).err();
    assert_eq!(tetrahedron([0.0, 0.0, 2.0]), None);
    refused("the tetrahedron's vertex", f64::NAN, tetrahedron([0.0, f64::NAN, 0.0]));
    refused("the tetrahedron's vertex", f64::INFINITY, tetrahedron([0.0, f64::INFINITY, 0.0]));
    // on the plane of the others, except for the rounding of its own coordinates
    for (u, v) in [(0.3, 0.4), (-2.7, 0.1), (1.0, 1.0), (1.0, 0.0)] {
        let c = std::array::from_fn(|k| o[k] + u * (a[k] - o[k]) + v * (b[k] - o[k]));
        let error = tetrahedron(c).unwrap();
        assert!(matches!(error, BodyError::Parameter { what: "the tetrahedron's volume", .. }), "{error}");
    }
}

#[test]
fn a_shape_far_from_the_origin_loses_nothing() {
    let corners = [[0.25, -0.5, 0.5], [1.125, 0.125, 0.375], [0.0, 0.875, 0.75], [0.25, 0.25, 2.0]];
    let far = corners.map(|[x, y, z]| [x + 1e9, y - 3e9, z + 2e9]); // still exact
    let [near, far] = [corners, far].map(|corners| Tetrahedron::new(corners).unwrap().spread());
    assert_eq!(near.extent(), far.extent());
    assert!((far.centroid() - near.centroid() - Position::<Part>::new(1e9, -3e9, 2e9)).norm() < 5e-7);
    let moments = |corners| {
        let body = Tetrahedron::new(corners).unwrap().mass_properties(Substance::Mass(1.0)).unwrap();
        body.inertia().matrix()
    };
    assert_eq!(moments(corners), moments(corners.map(|[x, y, z]| [x - 1e9, y, z + 1e9])));
}
