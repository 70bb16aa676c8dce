//! Radius of gyration longer than the link: `gyration.too_large`, or `inertia.unit` if a wrong unit
//! explains it.
//!
//! k = √(i3/m) cannot exceed the distance from the centre of mass to the farthest point of the
//! body; a solid body has about half of that. If k exceeds the reach of all drawn shapes, the
//! tensor puts mass where there is nothing.

use super::body::Body;
use super::dummy::Held;
use super::finding;
use super::placeholder::{is_round, is_typed};
use super::unit::nearest;
use super::written::short;
use crate::finding::{Finding, Severity};
use crate::moments::trace;

/// Factor on the reach for parts that are not drawn: cables, screws, a cover.
const UNDRAWN: f64 = 1.1;

/// Upper bounds on mass and moment of padded links. For numerical stability, files give light links
/// larger moments, equal and of one digit. A gram with 1e-6 kg·m² has k = 3 cm. Such padding is
/// known, so it is a note.
const PADDED_MASS: f64 = 0.1;
const PADDED_MOMENT: f64 = 1e-3;

/// Upper bound on the ratio of padded moments to those of the geometry: a factor of ten in length.
const PADDED_FACTOR: f64 = 100.0;

/// Returns true if the round moments of a light link are padding, `factor` times the geometry's.
pub(super) fn is_padded(body: &Body, held: Held, factor: f64) -> bool {
    let i3 = body.moments.values[2];
    let is_small = body.mass <= PADDED_MASS && i3 <= PADDED_MOMENT && factor <= PADDED_FACTOR;
    held == Held::Dummy || is_small && is_round(body)
}

/// Assumptions for a link without geometry: a density of at least 10 kg/m³ (foam), and a length of
/// at most ten edges of the cube of that volume. A length of one metre is always accepted.
const SPARSEST: f64 = 10.0;
const LONGEST: f64 = 10.0;

pub(super) fn check(body: &Body, held: Held, findings: &mut Vec<Finding>) {
    let k = body.gyration();
    let i3 = body.moments.values[2];
    let implied = body.solids().map(|s| trace(&body.implied(s, body.mass)) / 3.0).reduce(f64::max);
    // Expected size of the moments, and the factor within which it is known.
    let (bound, seen, size, sure) = match body.reach() {
        Some(reach) => {
            // Estimate without volumes: a solid ball in bounds of that reach, ⅖ m r² with r² =
            // reach² / 3.
            let ball = 0.4 * body.mass * reach * reach / 3.0;
            let seen = format!("its geometry reaches {} m", short(reach, 4));
            (UNDRAWN * reach, seen, implied.unwrap_or(ball), 3.0)
        }
        None => {
            let bound = f64::max(1.0, LONGEST * (body.mass / SPARSEST).cbrt());
            // A cube of water.
            let edge = (body.mass / 1000.0).cbrt();
            let seen = format!("a body of this mass is rarely {} m long", short(bound, 2));
            (bound, seen, body.mass * edge * edge / 6.0, 30.0)
        }
    };
    if !(k > bound) {
        return;
    }
    let [moment, mass, radius] = [i3, body.mass, k].map(|x| short(x, 4));
    // A round number was typed; CAD programs do not produce it.
    let typed = is_typed(body);
    let unit = nearest(trace(&body.written) / 3.0 / size, sure).filter(|_| !typed && held != Held::Dummy);
    let padded = is_padded(body, held, trace(&body.written) / 3.0 / size);
    let digits = if implied.is_some() { 3 } else { 1 };
    let size = short(size, digits);
    let (code, severity) = match unit {
        Some(_) => ("inertia.unit", Severity::Suspect),
        _ => ("gyration.too_large", if padded { Severity::Note } else { Severity::Suspect }),
    };
    let guess = match unit {
        Some(unit) => {
            format!("; expected about {} kg·m²: {} written as kg·m²?", size, unit.name)
        }
        None if typed && !padded => {
            format!("; expected about {} kg·m²: a placeholder?", size)
        }
        None => String::new(),
    };
    let message = format!("{moment} kg·m² for {mass} kg: radius of gyration {radius} m, but {seen}{guess}");
    let rule = "the radius of gyration √(i3/m) is not larger than the body";
    let mut found = finding(code, severity, body.link, body.tensor_place(), message, rule);
    found.numbers = vec![("i3", i3), ("mass", body.mass), ("gyration_radius", k), ("bound", bound)];
    findings.push(found);
}
