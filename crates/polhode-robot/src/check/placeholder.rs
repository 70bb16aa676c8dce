//! A tensor that stands in for one: `inertia.placeholder`.
//!
//! The identity is what templates have. It is right for nothing but a metre of cube of 6 kg, so it is a finding where
//! the geometry contradicts, and a note where none can. Other round tensors are common and often meant (1e-3 is what
//! ROS teaches for links of a hand's size): they are one where three links or more that differ share one.

use std::collections::{HashMap, HashSet};

use super::body::Body;
use super::finding;
use super::written::short;
use crate::finding::{Finding, Severity};
use crate::moments::trace;

/// Round moments this large are felt; below, they are padding.
const FELT: f64 = 0.01;

/// Links differ if their masses or their reaches do by this factor.
const DIFFER: f64 = 1.5;

/// A placeholder this near to what the geometry implies serves.
const NEAR: f64 = 5.0;

const RULE: &str = "a tensor follows from the mass and the shape of its own link";

/// True if the moments are equal, of one digit, and the products zero.
pub(super) fn is_round(body: &Body) -> bool {
    let [xx, yy, zz, xy, xz, yz] = body.written;
    let one_digit = |text: &str| {
        let digits = text.trim_start_matches('+').split(['e', 'E']).next().unwrap_or("").replace('.', "");
        digits.trim_matches('0').len() == 1
    };
    let typed = body.numbers().filter(|(k, _)| *k < 3).all(|(_, n)| one_digit(&n.text));
    xx == yy && yy == zz && [xy, xz, yz] == [0.0; 3] && typed
}

/// The identity.
pub(super) fn check(body: &Body, findings: &mut Vec<Finding>) {
    if body.written != [1.0, 1.0, 1.0, 0.0, 0.0, 0.0] {
        return;
    }
    let implied: Vec<f64> = body.solids().map(|s| trace(&body.implied(s)) / 3.0).collect();
    let far = |i: f64| !(1.0 / NEAR..=NEAR).contains(&i);
    let [mass, k] = [body.mass, body.gyration()].map(|x| short(x, 4));
    let (severity, why) = match (implied.iter().copied().reduce(f64::max), body.reach()) {
        (Some(_), _) if !implied.iter().all(|i| far(*i)) => return,
        (Some(i), _) => (Severity::Suspect, format!("its geometry implies some {} kg·m²", short(i, 2))),
        (None, Some(reach)) if body.gyration() > reach => {
            (Severity::Suspect, format!("gyration radius {k} m, its geometry reaches {} m", short(reach, 4)))
        }
        _ => (Severity::Note, format!("gyration radius {k} m")),
    };
    let message = format!("1 kg·m² about each axis on {mass} kg: {why}");
    let mut found = finding("inertia.placeholder", severity, body.link, body.tensor_place(), message, RULE);
    found.numbers = vec![("moment", 1.0), ("mass", body.mass), ("gyration_radius", body.gyration())];
    findings.push(found);
}

/// One round tensor on links that differ.
pub(super) fn repeated(bodies: &[Option<Body>], findings: &mut Vec<Finding>) {
    let told: HashSet<String> =
        findings.iter().filter(|f| f.severity >= Severity::Suspect).map(|f| f.subject.clone()).collect();
    let mut groups: HashMap<u64, Vec<&Body>> = HashMap::new();
    let mut order = Vec::new();
    for body in bodies.iter().flatten() {
        if body.mass > 0.0 && body.written[0] > 0.0 && is_round(body) && !told.contains(&body.link.name.text)
        {
            let group = groups.entry(body.written[0].to_bits()).or_default();
            if group.is_empty() {
                order.push(body.written[0].to_bits());
            }
            group.push(body);
        }
    }
    for group in order.iter().filter_map(|key| groups.get(key)) {
        let differ = |values: &mut dyn Iterator<Item = f64>| {
            let (low, high) = values.fold((f64::INFINITY, 0.0), |(l, h), x| (f64::min(l, x), f64::max(h, x)));
            high > DIFFER * low
        };
        let masses = differ(&mut group.iter().map(|b| b.mass));
        let reaches = differ(&mut group.iter().filter_map(|b| b.reach()));
        let Some(first) = group.first().filter(|_| group.len() >= 3 && (masses || reaches)) else { continue };
        let moment = first.written[0];
        let severity = if moment >= FELT { Severity::Suspect } else { Severity::Note };
        let names: Vec<&str> = group.iter().take(4).map(|b| b.link.name.text.as_str()).collect();
        let more = if group.len() > 4 { ", …" } else { "" };
        let message = format!(
            "{} kg·m² about each axis on {} links that differ: {}{more}",
            short(moment, 4),
            group.len(),
            names.join(", ")
        );
        let mut found =
            finding("inertia.placeholder", severity, first.link, first.tensor_place(), message, RULE);
        found.numbers = vec![("moment", moment), ("links", group.len() as f64)];
        findings.push(found);
    }
}
