//! Volume and moments of MuJoCo's primitives, solid or as shells, with MuJoCo's formulas.
//!
//! Source: MuJoCo 3.x, the functions `GetVolume` and `SetInertia` of its geoms. Its shell of an
//! ellipsoid is approximate; the same approximation is used here.

use std::f64::consts::PI;

/// Volume or surface area of a primitive, and its moments about its centre for a mass of 1.
pub(super) struct Measure {
    /// Volume, m³; area of a shell, m².
    pub(super) amount: f64,
    /// Moments about its axes for a mass of 1 kg, m².
    pub(super) moments: [f64; 3],
}

/// Measures a primitive by its type and MuJoCo's sizes: radius and half length, half edges, or
/// semi-axes. `None` for types without volume.
pub(super) fn of(kind: &str, size: [f64; 3], shell: bool) -> Option<Measure> {
    let [a, b, c] = size;
    let round = |across: f64, along: f64| [across, across, along];
    let (amount, moments) = match (kind, shell) {
        ("sphere", false) => (4.0 * PI * a * a * a / 3.0, [0.4 * a * a; 3]),
        ("sphere", true) => (4.0 * PI * a * a, [2.0 * a * a / 3.0; 3]),
        ("cylinder", false) => (2.0 * PI * a * a * b, round((3.0 * a * a + 4.0 * b * b) / 12.0, 0.5 * a * a)),
        ("cylinder", true) => {
            let disc = a / (2.0 * a + 4.0 * b); // fraction of the mass in each disc
            let wall = 1.0 - 2.0 * disc;
            let across = wall * (6.0 * a * a + 4.0 * b * b) / 12.0 + 2.0 * disc * (0.25 * a * a + b * b);
            (2.0 * PI * a * (a + 2.0 * b), round(across, (wall + disc) * a * a))
        }
        ("capsule", false) => {
            let (h, balls) = (2.0 * b, 4.0 * a / (4.0 * a + 6.0 * b));
            let wall = 1.0 - balls;
            let across =
                wall * (3.0 * a * a + h * h) / 12.0 + balls * (0.4 * a * a + h * (3.0 * a + 2.0 * h) / 8.0);
            (PI * a * a * (h + 4.0 * a / 3.0), round(across, 0.5 * wall * a * a + 0.4 * balls * a * a))
        }
        ("capsule", true) => {
            let (h, balls) = (2.0 * b, a / (a + b));
            let wall = 1.0 - balls;
            let across = wall * (6.0 * a * a + h * h) / 12.0 + balls * (2.0 * a * a / 3.0 + b * (b + a));
            (4.0 * PI * a * (a + b), round(across, wall * a * a + 2.0 * balls * a * a / 3.0))
        }
        ("ellipsoid", false) => (
            4.0 * PI * a * b * c / 3.0,
            [(b * b + c * c) / 5.0, (a * a + c * c) / 5.0, (a * a + b * b) / 5.0],
        ),
        ("ellipsoid", true) => {
            const P: f64 = 1.6075; // Thomsen's formula for the area
            let powers = libm::pow(a * b, P) + libm::pow(b * c, P) + libm::pow(c * a, P);
            (4.0 * PI * libm::pow(powers / 3.0, 1.0 / P), ellipsoid_shell(size))
        }
        ("box" | "hfield", false) => {
            (8.0 * a * b * c, [(b * b + c * c) / 3.0, (a * a + c * c) / 3.0, (a * a + b * b) / 3.0])
        }
        ("box" | "hfield", true) => {
            let area = a * b + b * c + c * a;
            let [z, x, y] = [a * b, b * c, c * a].map(|side| side / area); // of the mass, both sides
            let moments = [
                z * (c * c + b * b / 3.0) + y * (b * b + c * c / 3.0) + x * (b * b + c * c) / 3.0,
                z * (c * c + a * a / 3.0) + x * (a * a + c * c / 3.0) + y * (a * a + c * c) / 3.0,
                x * (a * a + b * b / 3.0) + y * (b * b + a * a / 3.0) + z * (a * a + b * b) / 3.0,
            ];
            (8.0 * area, moments)
        }
        _ => return None,
    };
    Some(Measure { amount, moments })
}

/// Returns the moments of a shell: an ellipsoid minus one with semi-axes 1 µm shorter.
fn ellipsoid_shell(inner: [f64; 3]) -> [f64; 3] {
    let outer = inner.map(|axis| axis + 1e-6);
    let volume = |[a, b, c]: [f64; 3]| 4.0 * PI * a * b * c / 3.0;
    let moments = |axes: [f64; 3]| {
        let [a, b, c] = axes.map(|axis| axis * axis);
        [b + c, a + c, a + b].map(|sum| volume(axes) * sum / 5.0)
    };
    let (large, small) = (moments(outer), moments(inner));
    [0, 1, 2].map(|k| (large[k] - small[k]) / (volume(outer) - volume(inner)))
}
