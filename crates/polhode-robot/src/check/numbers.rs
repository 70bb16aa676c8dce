//! Numbers that are not there, are none, or are not finite: `number.missing`, `number.malformed`, `number.not_finite`.

use super::body::slots;
use super::finding;
use super::tree::Tree;
use super::written::complaint;
use crate::finding::{Finding, Repair, Severity};
use crate::model::{Link, ModelFormat, Number, RobotModel, Slot, Tensor};

pub(super) fn check(model: &RobotModel, link: &Link, tree: &Tree, k: usize, findings: &mut Vec<Finding>) {
    let Some(inertial) = &link.inertial else { return };
    slot(model, link, &inertial.mass, "mass", findings);
    if let Some(slots) = slots(&inertial.tensor) {
        for (name, s) in super::body::NAMES.iter().zip(slots) {
            slot(model, link, s, name, findings);
        }
    }
    for unreadable in &inertial.pose.unreadable {
        number(link, unreadable, "the inertial's place or attitude", findings);
    }
    // A frame without mass needs no tensor, and what is not given SDF takes from its defaults.
    let weighs = inertial.mass.finite().is_some_and(|m| m != 0.0);
    if let (Tensor::Missing(span), true) = (&inertial.tensor, weighs) {
        let moves = tree.moves(k) || model.format == ModelFormat::Urdf;
        let (severity, rule) = match model.format {
            ModelFormat::Sdf => {
                (Severity::Suspect, "what is left out is the identity in SDF: 1 kg·m² about each axis")
            }
            _ if moves => (Severity::Impossible, "a link with mass needs its tensor"),
            _ => (Severity::Note, "a link that moves needs its tensor"),
        };
        let message =
            format!("no inertia tensor beside a mass of {} kg", inertial.mass.finite().unwrap_or(0.0));
        findings.push(finding("inertia.missing", severity, link, span.clone(), message, rule));
    }
}

fn slot(model: &RobotModel, link: &Link, slot: &Slot, what: &str, findings: &mut Vec<Finding>) {
    match slot {
        Slot::Given(given) => number(link, given, what, findings),
        Slot::Missing { span, name } => {
            // SDF has defaults: 1 kg, 1 kg·m² about each axis, products zero.
            let (severity, rule) = match (model.format, what) {
                (ModelFormat::Sdf, "ixy" | "ixz" | "iyz") => return,
                (ModelFormat::Sdf, _) => (Severity::Suspect, "what is left out is 1 in SDF"),
                _ => (Severity::Impossible, "all numbers of an inertial must be given"),
            };
            let message = format!("{name} is missing");
            let code = if what == "mass" { "mass.missing" } else { "number.missing" };
            findings.push(finding(code, severity, link, span.clone(), message, rule));
        }
    }
}

fn number(link: &Link, number: &Number, what: &str, findings: &mut Vec<Finding>) {
    let text = &number.text;
    let (code, message, repaired) = match number.value {
        Some(value) if value.is_finite() => return,
        Some(value) => {
            let why = if value.is_nan() { "not a number" } else { "beyond what a number can hold" };
            ("number.not_finite", format!("{what} = {text:?} is {why}"), None)
        }
        None => {
            let (why, meant) = complaint(text);
            ("number.malformed", format!("{what} = {text:?} {why}"), meant)
        }
    };
    let rule = "numbers are finite decimals with a point, without units";
    let mut found = finding(code, Severity::Impossible, link, number.span.clone(), message, rule);
    found.repair = repaired.map(|meant| Repair {
        description: format!("{what} {text} → {meant}"),
        edits: vec![(number.span.clone(), meant)],
    });
    findings.push(found);
}
