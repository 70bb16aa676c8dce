//! Checks links whose mass SDFormat computes from their collisions (`auto="true"`):
//! `density.implausible`.
//!
//! The tensor follows from the geometry, so only a stated density or mass can be wrong.

use super::material::is_plausible;
use super::written::short;
use super::{LinkGeometry, finding};
use crate::finding::{Finding, Severity};
use crate::model::{Link, ModelFormat};

pub(super) fn check(format: ModelFormat, link: &Link, geometry: &LinkGeometry, findings: &mut Vec<Finding>) {
    let (ModelFormat::Sdf, Some(Ok(computed))) = (format, &link.computed) else { return };
    let densities = || geometry.volumes.iter().map(|volume| (volume.kind, computed.mass / volume.volume));
    if densities().any(|(kind, density)| is_plausible(kind, density)) {
        return;
    }
    let Some((_, density)) = densities().next_back() else { return };
    let message =
        format!("computed mass {} kg, density {} kg/m³", short(computed.mass, 4), short(density, 3));
    let rule = "solids have a density of 10 to 25000 kg/m³; densities are in kg/m³, masses in kg, sizes in m";
    let span = link.name.span.clone();
    let mut found = finding("density.implausible", Severity::Suspect, link, span, message, rule);
    found.numbers = vec![("mass", computed.mass), ("density", density)];
    findings.push(found);
}
