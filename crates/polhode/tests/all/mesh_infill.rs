//! Infill of printed solids, compared with closed forms and a count of points.

use polhode::body::BodyError;
use polhode::body::mesh::{
    ClosedMesh, MassBound, MeshInfill, PrintShell, Triangle, TriangleMesh, UncertainPart,
};
use polhode::body::shape::{Shape, Substance};

/// Rotation of the unit quaternion (2, 1, −3, 4)/√30.
const ROWS: [[f64; 3]; 3] = [[-20.0, -22.0, -4.0], [10.0, -4.0, -28.0], [20.0, -20.0, 10.0]];
const ORIGIN: [f64; 3] = [3.1, -2.3, 0.7];

/// Rotates by a generic rotation and moves away from the origin.
fn placed(p: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| ORIGIN[i] + (0..3).map(|k| ROWS[i][k] * p[k] / 30.0).sum::<f64>())
}

/// Returns a vector of the body frame in space.
fn turned(v: [f64; 3]) -> [f64; 3] {
    let p = placed(v);
    std::array::from_fn(|k| p[k] - ORIGIN[k])
}

/// Returns a prism on a polygon, in an oblique pose.
fn prism(polygon: &[[f64; 2]], height: f64) -> ClosedMesh {
    prism_at(polygon, height, placed)
}

/// Returns a prism on a polygon, triangulated from its first corner.
fn prism_at(polygon: &[[f64; 2]], height: f64, place: impl Fn([f64; 3]) -> [f64; 3]) -> ClosedMesh {
    let n = polygon.len();
    let at = |k: usize, z: f64| place([polygon[k % n][0], polygon[k % n][1], z]);
    let mut triangles: Vec<Triangle> = Vec::new();
    for k in 0..n {
        let [a, b, c, d] = [at(k, 0.0), at(k + 1, 0.0), at(k + 1, height), at(k, height)];
        triangles.extend([[a, b, c], [a, c, d]]);
        if k > 0 && k + 1 < n {
            triangles.extend([
                [at(0, height), at(k, height), at(k + 1, height)],
                [at(0, 0.0), at(k + 1, 0.0), at(k, 0.0)],
            ]);
        }
    }
    ClosedMesh::of(&TriangleMesh::of_triangles(&triangles).unwrap()).unwrap()
}

const fn only_walls(walls: f64) -> PrintShell {
    PrintShell { walls, top: 0.0, bottom: 0.0 }
}

fn infill(solid: &ClosedMesh, walls: f64) -> MeshInfill {
    solid.infill(&only_walls(walls), 1e-3, &|| true).unwrap()
}

/// Asserts that the body with an infill of a quarter of the density is the solid without three
/// quarters of `core`, within the bounds.
fn require_core(solid: &ClosedMesh, shell: PrintShell, core: &ClosedMesh) {
    let found = solid.infill(&shell, 1e-3, &|| true).unwrap();
    let off = (found.volume - core.volume()).abs();
    assert!(off <= found.bound.measure, "{off:e} {:e}", found.bound.measure);
    assert!(found.bound.measure <= 1e-3 * found.volume);
    let density = 1240.0;
    let (body, bound) = found.mass_properties(solid, Substance::Density(density), 0.25).unwrap();
    let part = UncertainPart { properties: body, bound, has_mass: false };
    let bound = MassBound::of(&body, &[part]).unwrap();
    let [whole, less] = [(solid, density), (core, 0.75 * density)]
        .map(|(mesh, d)| mesh.mass_properties(Substance::Density(d)).unwrap());
    let mass = whole.mass() - less.mass();
    assert!((body.mass() - mass).abs() <= bound.mass);
    let [p, q] = [&whole, &less].map(|body| body.center_of_mass().to_array());
    let center: [f64; 3] = std::array::from_fn(|k| (whole.mass() * p[k] - less.mass() * q[k]) / mass);
    let found_center = body.center_of_mass().to_array();
    (0..3).for_each(|k| assert!((found_center[k] - center[k]).abs() <= bound.center_of_mass[k] + 1e-15));
    let about = polhode::math::Position::from_array(center);
    let [i, j] = [&whole, &less].map(|body| body.inertia_about(about).matrix());
    let found = body.inertia().matrix();
    for k in 0..9 {
        let (a, b) = (k / 3, k % 3);
        let off = (found[a][b] - (i[a][b] - j[a][b])).abs();
        assert!(off <= bound.inertia[a][b] + 1e-12 * found[0][0], "{off:e} {:e}", bound.inertia[a][b]);
    }
}

#[test]
fn the_infill_of_a_box_is_a_smaller_box() {
    let rectangle = |x: f64, y: f64, by: f64| [[by, by], [x - by, by], [x - by, y - by], [by, y - by]];
    let solid = prism(&rectangle(2.1, 1.3, 0.0), 0.9);
    for walls in [0.03, 0.2, 0.4] {
        let height = 0.9 - 2.0 * walls;
        let core = prism(&rectangle(2.1, 1.3, walls), height);
        // The smaller prism stands on z = 0: moves it up by the walls.
        let up = turned([0.0, 0.0, walls]);
        let moved = core.triangles().map(|t| t.map(|p| std::array::from_fn(|k| p[k] + up[k]))).collect();
        require_core(&solid, only_walls(walls), &ClosedMesh::from_triangles(moved).unwrap());
    }
}

#[test]
fn the_infill_of_a_cylinder_is_a_smaller_prism() {
    let polygon = |apothem: f64| -> Vec<[f64; 2]> {
        let (n, turn) = (48, std::f64::consts::TAU / 48.0);
        let r = apothem / (0.5 * turn).cos();
        (0..n)
            .map(|k| [0.4 + r * (turn * f64::from(k)).cos(), -0.2 + r * (turn * f64::from(k)).sin()])
            .collect()
    };
    let solid = prism(&polygon(0.8), 1.7);
    for walls in [0.05, 0.31] {
        let core = prism(&polygon(0.8 - walls), 1.7 - 2.0 * walls);
        let up = turned([0.0, 0.0, walls]);
        let moved = core.triangles().map(|t| t.map(|p| std::array::from_fn(|k| p[k] + up[k]))).collect();
        require_core(&solid, only_walls(walls), &ClosedMesh::from_triangles(moved).unwrap());
    }
}

/// The walls round the inner corner of an L with a cylinder.
#[test]
fn the_infill_of_an_angle_has_its_area_and_its_points() {
    let [a, b, c, d, height, walls] = [2.0, 1.7, 0.9, 0.7, 1.1, 0.2];
    // From the reflex corner, so that the triangles of the ends do not overlap.
    let solid = prism(&[[c, d], [c, b], [0.0, b], [0.0, 0.0], [a, 0.0], [a, d]], height);
    let found = infill(&solid, walls);
    let corner = walls * walls * (1.0 - std::f64::consts::FRAC_PI_4);
    let area = (a - 2.0 * walls) * (b - 2.0 * walls) - (a - c) * (b - d) + corner;
    let volume = area * (height - 2.0 * walls);
    let off = (found.volume - volume).abs();
    assert!(off <= found.bound.measure && found.bound.measure < 1e-3 * volume, "{off:e} {:?}", found.bound);

    // Midpoints of a grid in the body frame.
    let (n, mut count, mut sum, mut squares) = (120, 0.0, [0.0; 3], [0.0; 3]);
    for k in 0..n * n * n {
        let part = |i: usize, size: f64| (i as f64 + 0.5) / n as f64 * size;
        let [x, y, z] = [part(k % n, a), part(k / n % n, b), part(k / n / n, height)];
        let notch = [(c - x).max(0.0), (d - y).max(0.0)];
        let is_infill = x.min(a - x).min(y).min(b - y).min(z).min(height - z) > walls
            && (notch[0] * notch[0] + notch[1] * notch[1]).sqrt() > walls;
        if is_infill {
            count += 1.0;
            let p = placed([x, y, z]);
            (0..3).for_each(|k| sum[k] += p[k]);
            (0..3).for_each(|k| squares[k] += p[k] * p[k]);
        }
    }
    let cell = a * b * height / (n * n * n) as f64;
    assert!((count * cell / volume - 1.0).abs() < 0.01);
    let solid_only = solid.mass_properties(Substance::Density(1.0)).unwrap();
    let (hollow, _) = found.mass_properties(&solid, Substance::Density(1.0), 0.0).unwrap();
    // The infill is the solid without the hollow body.
    let mass = solid_only.mass() - hollow.mass();
    let [p, q] = [&solid_only, &hollow].map(|body| body.center_of_mass().to_array());
    for k in 0..3 {
        let center = (solid_only.mass() * p[k] - hollow.mass() * q[k]) / mass;
        assert!((center - sum[k] / count).abs() < 3e-3, "{center} {}", sum[k] / count);
    }
    let origin = polhode::math::Position::ZERO;
    let [i, j] = [&solid_only, &hollow].map(|body| body.inertia_about(origin).matrix());
    let trace: f64 = (0..3).map(|k| i[k][k] - j[k][k]).sum::<f64>() / 2.0;
    let counted: f64 = squares.iter().sum::<f64>() / count * mass;
    assert!((trace / counted - 1.0).abs() < 3e-3, "{trace} {counted}");
}

#[test]
fn thick_walls_and_a_full_infill_are_the_solid() {
    let solid = prism(&[[0.0, 0.0], [2.0, 0.0], [1.7, 1.1]], 0.6);
    let whole = solid.mass_properties(Substance::Mass(3.2)).unwrap();
    for walls in [0.31, 5.0] {
        let none = infill(&solid, walls);
        assert_eq!((none.volume, none.bound.measure), (0.0, 0.0));
        assert_eq!(none.mass_properties(&solid, Substance::Mass(3.2), 0.15).unwrap().0, whole);
    }
    let some = infill(&solid, 0.1);
    assert!(some.volume > 0.1);
    assert_eq!(some.mass_properties(&solid, Substance::Mass(3.2), 1.0).unwrap().0, whole);
    let (hollow, _) = some.mass_properties(&solid, Substance::Mass(3.2), 0.0).unwrap();
    assert!(
        (hollow.mass() - 3.2).abs() < 1e-15
            && hollow.inertia().matrix()[0][0] > 1.05 * whole.inertia().matrix()[0][0]
    );
}

#[test]
fn what_is_no_wall_or_share_is_refused() {
    let solid = prism(&[[0.0, 0.0], [2.0, 0.0], [1.7, 1.1]], 0.6);
    for (walls, tolerance) in [(0.0, 1e-3), (-0.1, 1e-3), (f64::NAN, 1e-3), (0.1, 0.0), (1e-6, 1e-3)] {
        let error = solid.infill(&only_walls(walls), tolerance, &|| true).unwrap_err();
        assert!(matches!(error, BodyError::Parameter { .. }), "{error}");
    }
    for thickness in [-0.1, f64::NAN, f64::INFINITY] {
        for shell in [
            PrintShell { top: thickness, ..only_walls(0.1) },
            PrintShell { bottom: thickness, ..only_walls(0.1) },
        ] {
            let error = solid.infill(&shell, 1e-3, &|| true).unwrap_err();
            assert!(error.to_string().contains("layers"), "{error}");
        }
    }
    let some = infill(&solid, 0.1);
    for fraction in [-0.1, 1.1, f64::NAN] {
        assert!(some.mass_properties(&solid, Substance::Density(1.0), fraction).is_err());
    }
}

/// Rotates about the vertical axis and moves away from the origin.
fn upright([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = 0.7_f64.sin_cos();
    [cos * x - sin * y - 1.3, sin * x + cos * y + 0.4, z + 2.1]
}

/// Places a profile (x, z) whose prism extends along −y.
fn standing([x, z, along]: [f64; 3]) -> [f64; 3] {
    upright([x, -along, z])
}

#[test]
fn solid_layers_of_a_box_reduce_the_height_of_its_infill() {
    let rectangle = |by: f64| [[by, by], [2.1 - by, by], [2.1 - by, 1.3 - by], [by, 1.3 - by]];
    let solid = prism_at(&rectangle(0.0), 0.9, upright);
    for (walls, top, bottom) in [(0.05, 0.2, 0.11), (0.05, 0.0, 0.3), (0.1, 0.04, 0.0_f64)] {
        let [below, above] = [f64::max(walls, bottom), f64::max(walls, top)];
        let core = prism_at(&rectangle(walls), 0.9 - below - above, |[x, y, z]| upright([x, y, z + below]));
        require_core(&solid, PrintShell { walls, top, bottom }, &core);
    }
}

/// The vertical thickness t of layers under a roof with the slope s is t/√(1 + s²) across.
#[test]
fn solid_layers_under_a_sloping_roof_are_vertical() {
    let (a, b, length) = (1.9, 1.1, 1.4);
    let solid = prism_at(&[[0.0, 0.0], [a, 0.0], [0.0, b]], length, standing);
    for (walls, top, bottom) in [(0.06, 0.21, 0.13), (0.06, 0.065, 0.01)] {
        let slope: f64 = b / a;
        let down = f64::max(top, walls * (1.0 + slope * slope).sqrt());
        let floor = f64::max(walls, bottom);
        let profile =
            [[walls, floor], [(b - down - floor) / slope, floor], [walls, b - down - slope * walls]];
        let core = prism_at(&profile, length - 2.0 * walls, |[x, z, along]| standing([x, z, along + walls]));
        require_core(&solid, PrintShell { walls, top, bottom }, &core);
    }
}

/// The infill of a convex solid has all x with n · x < d − max(w, t n_z, −b n_z) for each face.
#[test]
fn solid_layers_under_a_dome_of_many_triangles() {
    let (around, rings) = (40, 20);
    let point = |k: usize, j: usize| {
        let turn = std::f64::consts::TAU * (k % around) as f64 / around as f64;
        let (sin, cos) = (std::f64::consts::PI * (j as f64 / rings as f64 - 0.5)).sin_cos();
        let cos = if j.is_multiple_of(rings) { 0.0 } else { cos };
        [1.1 * cos * turn.cos(), 0.8 * cos * turn.sin(), 0.9 * sin]
    };
    let mut triangles: Vec<Triangle> = Vec::new();
    for (j, k) in (0..rings).flat_map(|j| (0..around).map(move |k| (j, k))) {
        let [a, b, c, d] = [point(k, j), point(k + 1, j), point(k + 1, j + 1), point(k, j + 1)];
        triangles.extend(if j > 0 { Some([a, b, c]) } else { None });
        triangles.extend(if j + 1 < rings { Some([a, c, d]) } else { None });
    }
    let shell = PrintShell { walls: 0.04, top: 0.15, bottom: 0.08 };
    let solid = ClosedMesh::of(&TriangleMesh::of_triangles(&triangles).unwrap()).unwrap();
    let found = solid.infill(&shell, 1e-3, &|| true).unwrap();
    let faces: Vec<([f64; 3], f64)> = triangles
        .iter()
        .map(|[a, b, c]| {
            let [u, v]: [[f64; 3]; 2] = [b, c].map(|p| std::array::from_fn(|k| p[k] - a[k]));
            let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            let size = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
            let n = n.map(|x| x / size);
            let shift = shell.walls.max(shell.top * n[2]).max(-shell.bottom * n[2]);
            (n, n[0] * a[0] + n[1] * a[1] + n[2] * a[2] - shift)
        })
        .collect();
    // The height of the infill on a grid of vertical lines.
    let count = 500;
    let volume: f64 = (0..count * count)
        .map(|k| {
            let [x, y] = [(k % count, 1.1), (k / count, 0.8)]
                .map(|(k, size)| size * (2.0 * (k as f64 + 0.5) / count as f64 - 1.0));
            let (mut low, mut high) = (-1.0_f64, 1.0_f64);
            for (n, d) in &faces {
                let z = (d - n[0] * x - n[1] * y) / n[2];
                if n[2] > 0.0 { high = high.min(z) } else { low = low.max(z) }
            }
            (high - low).max(0.0)
        })
        .sum::<f64>()
        * (2.2 * 1.6 / (count * count) as f64);
    let off = (found.volume - volume).abs();
    assert!(off <= found.bound.measure + 2e-5 * volume, "{off:e} {:e}", found.bound.measure);
    assert!(found.bound.measure <= 1e-3 * volume);
}

/// A profile with an overhang, whose lower side has layers of its own, and with a ledge.
#[test]
fn solid_layers_over_an_overhang_and_under_a_ledge() {
    let [c, d, a, height, ledge, length] = [0.8, 0.7, 1.7, 1.6, 1.1, 1.2];
    // From a point that sees all others: over the overhang, left of the ledge.
    let profile =
        [[c, d], [a, d], [a, ledge], [0.9, ledge], [0.9, height], [0.0, height], [0.0, 0.0], [c, 0.0]];
    let solid = prism_at(&profile, length, standing);
    let PrintShell { walls, top, bottom } = PrintShell { walls: 0.05, top: 0.13, bottom: 0.17 };
    let found = solid.infill(&PrintShell { walls, top, bottom }, 1e-3, &|| true).unwrap();
    let count = 200_000;
    let area: f64 = (0..count)
        .map(|k| a * (f64::from(k) + 0.5) / f64::from(count))
        .filter(|x| *x > walls && *x < a - walls)
        .map(|x| {
            // The wall round an edge at a horizontal distance.
            let around = |distance: f64| (walls * walls - distance * distance).max(0.0).sqrt();
            let low = match x {
                x if x >= c => d + bottom,
                x if x > c - walls => d + around(c - x),
                _ => bottom,
            };
            let high = match x {
                x if x >= 0.9 => ledge - top,
                x if x > 0.9 - walls => ledge - around(0.9 - x),
                _ => height - top,
            };
            (high - low).max(0.0)
        })
        .sum::<f64>()
        * (a / f64::from(count));
    let volume = area * (length - 2.0 * walls);
    let off = (found.volume - volume).abs();
    assert!(off <= found.bound.measure + 1e-5 * volume, "{off:e} {:e}", found.bound.measure);
    assert!(found.bound.measure <= 1e-3 * volume);
}
