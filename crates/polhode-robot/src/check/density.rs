//! Mass over volume that no material has: `density.implausible`.
//!
//! Foam has 10 kg/m³ or more, osmium 22,590. Closed meshes are drawn after the body, so these bounds are theirs.
//! Primitives and hulls stand for a body more or less well: a box around it is several times its volume, a small
//! cylinder for a motor a part of it; so they are given a factor of five on both sides. One solid within its bounds is enough.

use super::body::Body;
use super::dummy::{FRAME, Held};
use super::finding;
use super::written::short;
use crate::finding::{Finding, Severity};
use crate::geometry::VolumeKind;

const LEAST: f64 = 10.0;
const GREATEST: f64 = 25_000.0;
const CRUDE: f64 = 5.0;

pub(super) fn check(body: &Body, held: Held, findings: &mut Vec<Finding>) {
    let slack = |kind: VolumeKind| if kind == VolumeKind::Closed { 1.0 } else { CRUDE };
    let fits = |kind, density: f64| density >= LEAST / slack(kind) && density <= GREATEST * slack(kind);
    if body.solids().any(|s| fits(s.kind, body.mass / s.volume)) {
        return;
    }
    // Meshes first: they say more.
    let Some(solid) = body.solids().min_by_key(|s| s.kind != VolumeKind::Closed) else { return };
    let density = body.mass / solid.volume;
    let is_frame = body.mass <= FRAME && (density < LEAST || held != Held::Free);
    let severity = if is_frame { Severity::Note } else { Severity::Suspect };
    let what = if solid.kind == VolumeKind::Closed { "its mesh" } else { "its shapes" };
    let message = format!(
        "{} kg in the {} m³ of {what}: {} kg/m³",
        short(body.mass, 4),
        short(solid.volume, 4),
        short(density, 3)
    );
    let rule = "solids have 10 to 25,000 kg/m³; lighter: is a mesh in mm? heavier: is a mass in g?";
    let mut found =
        finding("density.implausible", severity, body.link, body.inertial.mass.span(), message, rule);
    found.numbers = vec![("mass", body.mass), ("volume", solid.volume), ("density", density)];
    findings.push(found);
}
