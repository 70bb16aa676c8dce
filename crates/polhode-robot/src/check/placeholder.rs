//! Placeholder tensors: `inertia.placeholder`.
//!
//! The identity is a common template value. It is correct only for bodies such as a cube of 1 m and
//! 6 kg. It is a finding if the geometry contradicts it, and a note without geometry.
//!
//! Other round tensors are common and often intended; 1e-3 is the value in ROS tutorials for links
//! of the size of a hand. They are a finding if at least three different links share one, or if
//! links are too small for it. This gives one finding that names all of them.

use std::collections::{HashMap, HashSet};

use super::alike::named;
use super::body::Body;
use super::dummy::Held;
use super::finding;
use super::written::short;
use crate::finding::{Finding, Severity};
use crate::moments::trace;

/// Moment above which a round tensor affects the motion, kg·m². Smaller ones are padding.
const FELT: f64 = 0.01;

/// Factor between masses, or between reaches, from which links count as different.
const DIFFER: f64 = 1.5;

/// Factor between a placeholder and the geometry's moments within which it is acceptable.
const NEAR: f64 = 5.0;

const RULE: &str = "a tensor follows from the mass and the shape of its own link";

/// Returns true if the three moments are equal and of one digit, and the products are zero.
pub(super) fn is_round(body: &Body) -> bool {
    let [xx, yy, zz, ..] = body.written;
    xx == yy && yy == zz && is_typed(body)
}

/// Returns true if the nonzero moments are equal and of one digit, and the products are zero. A
/// program does not compute such values.
pub(super) fn is_typed(body: &Body) -> bool {
    let [xx, yy, zz, xy, xz, yz] = body.written;
    let greatest = xx.max(yy).max(zz);
    let one_digit = |text: &str| {
        let digits = text.trim_start_matches('+').split(['e', 'E']).next().unwrap_or("").replace('.', "");
        digits.trim_matches('0').len() == 1
    };
    let alike = body
        .numbers()
        .filter(|(k, _)| *k < 3)
        .all(|(k, number)| body.written[k] == 0.0 || body.written[k] == greatest && one_digit(&number.text));
    [xy, xz, yz] == [0.0; 3] && alike
}

/// Checks for the identity.
pub(super) fn check(body: &Body, _: Held, findings: &mut Vec<Finding>) {
    if body.written != [1.0, 1.0, 1.0, 0.0, 0.0, 0.0] {
        return;
    }
    let implied: Vec<f64> = body.solids().map(|s| trace(&body.implied(s, body.mass)) / 3.0).collect();
    let far = |i: f64| !(1.0 / NEAR..=NEAR).contains(&i);
    let [mass, k] = [body.mass, body.gyration()].map(|x| short(x, 4));
    let (severity, why) = match (implied.iter().copied().reduce(f64::max), body.reach()) {
        (Some(_), _) if !implied.iter().all(|i| far(*i)) => return,
        (Some(i), _) => (Severity::Suspect, format!("its geometry implies about {} kg·m²", short(i, 2))),
        (None, Some(reach)) if body.gyration() > reach => (
            Severity::Suspect,
            format!("radius of gyration {k} m, but its geometry reaches only {} m", short(reach, 4)),
        ),
        _ => (Severity::Note, format!("radius of gyration {k} m")),
    };
    let message = format!("1 kg·m² about each axis for {mass} kg: {why}");
    let mut found = finding("inertia.placeholder", severity, body.link, body.tensor_place(), message, RULE);
    found.numbers = vec![("moment", 1.0), ("mass", body.mass), ("gyration_radius", body.gyration())];
    findings.push(found);
}

/// Reports a round tensor shared by links that differ, or that cannot all have it. One finding for
/// all replaces the findings about the size of each.
pub(super) fn repeated(bodies: &[Option<Body>], findings: &mut Vec<Finding>) {
    let mut groups: HashMap<u64, Vec<&Body>> = HashMap::new();
    let mut order = Vec::new();
    let told: HashSet<&str> =
        findings.iter().filter(|f| is_other_reason(f)).map(|f| f.subject.as_str()).collect();
    for body in bodies.iter().flatten() {
        let wrong = told.contains(body.link.name.text.as_str());
        if body.mass > 0.0 && body.written[0] > 0.0 && is_round(body) && !wrong {
            let group = groups.entry(body.written[0].to_bits()).or_default();
            if group.is_empty() {
                order.push(body.written[0].to_bits());
            }
            group.push(body);
        }
    }
    for group in order.iter().filter_map(|key| groups.get(key)) {
        if let Some(found) = of_group(group, findings) {
            let names: HashSet<&str> = group.iter().map(|body| body.link.name.text.as_str()).collect();
            findings.retain(|f| !(stands_for(f) && names.contains(f.subject.as_str())));
            findings.push(found);
        }
    }
}

/// Returns true if a finding is about the size of a link's round tensor.
fn stands_for(finding: &Finding) -> bool {
    matches!(finding.code, "gyration.too_large" | "inertia.unit" | "inertia.placeholder" | "inertia.geometry")
}

/// Returns true if a finding reports another error of a tensor.
fn is_other_reason(finding: &Finding) -> bool {
    finding.severity >= Severity::Suspect && finding.code.starts_with("inertia.") && !stands_for(finding)
}

fn of_group(group: &[&Body], findings: &[Finding]) -> Option<Finding> {
    let first = group.first().filter(|_| group.len() >= 3)?;
    let differ = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, 0.0), |(l, h), x| (f64::min(l, x), f64::max(h, x)));
        high > DIFFER * low
    };
    let masses = differ(&mut group.iter().map(|b| b.mass));
    let reaches = differ(&mut group.iter().filter_map(|b| b.reach()));
    let names: Vec<&str> = group.iter().map(|b| b.link.name.text.as_str()).collect();
    let all: HashSet<&str> = names.iter().copied().collect();
    let alone = findings.iter().filter(|f| stands_for(f) && all.contains(f.subject.as_str()));
    let worst = alone.clone().map(|f| f.severity).max();
    let off = alone.filter(|f| f.severity >= Severity::Suspect).count();
    if !masses && !reaches && worst.is_none() {
        return None;
    }
    let moment = first.written[0];
    let felt = if moment >= FELT && (masses || reaches) { Severity::Suspect } else { Severity::Note };
    let severity = worst.unwrap_or(felt).max(felt);
    let that_differ = if masses || reaches { " of different mass or size" } else { "" };
    let too_large = match off {
        0 => String::new(),
        off => format!("; impossible for the mass and size of {off} of them"),
    };
    let message = format!(
        "the same {} kg·m² about each axis on {} links{that_differ}: {}{too_large}",
        short(moment, 4),
        group.len(),
        named(&names)
    );
    let mut found = finding("inertia.placeholder", severity, first.link, first.tensor_place(), message, RULE);
    found.others = names.iter().skip(1).map(|name| (*name).to_owned()).collect();
    found.numbers = vec![("moment", moment), ("links", group.len() as f64)];
    Some(found)
}
