//! Links whose mass SDFormat computes from their collisions (`auto="true"`): `density.implausible`.
//!
//! The tensor is that of the geometry, so only a stated density or mass may be wrong. The bounds are those of `density.rs`, which grants
//! primitives a factor of 5.

use super::written::short;
use super::{LinkGeometry, finding};
use crate::finding::{Finding, Severity};
use crate::geometry::VolumeKind;
use crate::model::{Link, ModelFormat};

/// Least and greatest density of a solid, kg/m³.
const LEAST: f64 = 10.0;
const GREATEST: f64 = 25_000.0;
const CRUDE: f64 = 5.0;

pub(super) fn check(format: ModelFormat, link: &Link, geometry: &LinkGeometry, findings: &mut Vec<Finding>) {
    let (ModelFormat::Sdf, Some(Ok(computed))) = (format, &link.computed) else { return };
    let slack = |kind: VolumeKind| if kind == VolumeKind::Closed { 1.0 } else { CRUDE };
    let densities = || geometry.volumes.iter().map(|volume| (volume.kind, computed.mass / volume.volume));
    let fits = |(kind, density)| density >= LEAST / slack(kind) && density <= GREATEST * slack(kind);
    if densities().any(fits) {
        return;
    }
    let Some((_, density)) = densities().next_back() else { return };
    let message = format!("{} kg, computed, at {} kg/m³", short(computed.mass, 4), short(density, 3));
    let rule = "solids have 10 to 25,000 kg/m³: a density is in kg/m³, a mass in kg, a size in m";
    let span = link.name.span.clone();
    let mut found = finding("density.implausible", Severity::Suspect, link, span, message, rule);
    found.numbers = vec![("mass", computed.mass), ("density", density)];
    findings.push(found);
}
