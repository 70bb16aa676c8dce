//! Mass over volume that no material has: `density.implausible`.
//!
//! Foam has 10 kg/m³ or more, osmium 22,590. Closed meshes are drawn after the body, so these bounds are theirs.
//! Primitives stand for a body more or less well: a box around it is several times its volume, a small cylinder for a
//! motor a part of it; so they are given a factor of five on both sides. One solid within its bounds is enough.

use super::body::Body;
use super::written::short;
use super::{MadeOf, finding};
use crate::finding::{Finding, Severity};

const LEAST: f64 = 10.0;
const GREATEST: f64 = 25_000.0;
const CRUDE: f64 = 5.0;

/// Links of a gram or less are frames that a simulator wanted a mass for.
const FRAME: f64 = 1e-3;

pub(super) fn check(body: &Body, findings: &mut Vec<Finding>) {
    let slack = |made_of: MadeOf| if made_of == MadeOf::Meshes { 1.0 } else { CRUDE };
    let fits =
        |made_of, density: f64| density >= LEAST / slack(made_of) && density <= GREATEST * slack(made_of);
    if body.shapes().any(|s| fits(s.made_of, body.mass / s.volume)) {
        return;
    }
    // Meshes first: they say more.
    let Some(shape) = body.shapes().min_by_key(|s| s.made_of != MadeOf::Meshes) else { return };
    let density = body.mass / shape.volume;
    let light = density < LEAST && body.mass <= FRAME;
    let severity = if light { Severity::Note } else { Severity::Suspect };
    let what = if shape.made_of == MadeOf::Meshes { "its mesh" } else { "its shapes" };
    let message = format!(
        "{} kg in the {} m³ of {what}: {} kg/m³",
        short(body.mass, 4),
        short(shape.volume, 4),
        short(density, 3)
    );
    let rule = "solids have 10 to 25,000 kg/m³; lighter: is a mesh in mm? heavier: is a mass in g?";
    let mut found =
        finding("density.implausible", severity, body.link, body.inertial.mass.span(), message, rule);
    found.numbers = vec![("mass", body.mass), ("volume", shape.volume), ("density", density)];
    findings.push(found);
}
