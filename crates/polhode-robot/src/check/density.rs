//! Checks that the mass divided by the volume is a density of some material: `density.implausible`.
//!
//! One solid with a plausible density is sufficient. Otherwise the geometry (its unit) or the mass
//! is doubtful. A repair follows if one change makes both density and tensor agree
//! ([`super::explain`]).

use super::body::Body;
use super::dummy::{FRAME, Held};
use super::finding;
use super::material::LEAST;
use super::written::short;
use crate::finding::{Finding, Repair, Severity};
use crate::geometry::VolumeKind;

/// Checks the density. `cause` is the change of the geometry's scale or of the mass that makes
/// density and tensor agree.
pub(super) fn check(
    body: &Body,
    held: Held,
    cause: Option<(String, Option<Repair>)>,
    findings: &mut Vec<Finding>,
) {
    if body.has_plausible_density() {
        return;
    }
    // Closed meshes are preferred: they are more accurate.
    let Some(solid) = body.solids().min_by_key(|s| s.kind != VolumeKind::Closed) else { return };
    let density = body.mass / solid.volume;
    // Shapes that cannot be measured may be nearly all of the body.
    if body.geometry.is_incomplete && density > LEAST {
        return;
    }
    let is_frame = body.mass <= FRAME && (density < LEAST || held != Held::Free);
    let severity = if is_frame { Severity::Note } else { Severity::Suspect };
    let what = if solid.kind == VolumeKind::Closed { "its mesh" } else { "its shapes" };
    let mut message = format!(
        "{} kg in the {} m³ of {what}: density {} kg/m³",
        short(body.mass, 4),
        short(solid.volume, 4),
        short(density, 3)
    );
    let (why, repair) = cause.unwrap_or_default();
    message.push_str(&why);
    let rule =
        "solids have a density of 10 to 25000 kg/m³; too low: is a mesh in mm? too high: is the mass in g?";
    let mut found =
        finding("density.implausible", severity, body.link, body.inertial.mass.span(), message, rule);
    found.numbers = vec![("mass", body.mass), ("volume", solid.volume), ("density", density)];
    found.repair = repair;
    findings.push(found);
}
