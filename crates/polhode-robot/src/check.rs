//! Checks of a model's inertias: errors, their causes and their repairs.
//!
//! Each link is checked twice. First: can any body have these numbers? This needs only the numbers
//! and their digits ([`Severity::Impossible`]). Second: can *this* body have them? This needs the
//! link's geometry ([`Severity::Suspect`]): its extent, its volume, and its tensor at uniform
//! density.
//!
//! A low false-alarm rate is as important as a high detection rate. Therefore:
//!
//! - A number is only as accurate as its digits. A tensor is impossible only if no tensor that
//!   rounds to the written one is possible (`check/possible.rs`).
//! - A tensor within a factor of three of its geometry's is not a finding, because bodies are not
//!   uniform (`check/ratio.rs`). It becomes one if undoing a known error gives the geometry's
//!   tensor in every element (`check/explain.rs`). Six numbers do not agree by chance.
//! - A fix is offered if exactly one explanation fits all evidence of the link: the six numbers,
//!   the mass, the geometry and the density. Without geometry there is at most a suggestion. A
//!   counterpart with different numbers withdraws it (`check/twin.rs`).
//! - If programs disagree on the up axis of a mesh (glTF, COLLADA with y up), either orientation is
//!   accepted. Nothing that depends on axes is reported or repaired.
//!
//! Each rule is in its own file, which explains its thresholds.

mod alike;
mod armature;
mod body;
mod center;
mod center_slip;
mod computed;
mod conjugate;
mod density;
mod dummy;
mod edit;
mod explain;
mod explanation;
mod factor;
mod formula;
mod gyration;
mod link_geometry;
mod mass;
mod material;
mod nearest;
mod numbers;
pub(crate) mod order;
mod origin;
mod pair;
mod placeholder;
mod possible;
mod power;
mod print;
mod ratio;
mod refused;
mod sign;
mod tree;
mod tree_order;
mod twin;
pub(crate) mod unit;
mod written;

use crate::finding::{Finding, Repair, Severity};
use crate::model::{Link, RobotModel, Span};
use crate::program::Program;
use body::Body;
use dummy::Held;
use explain::Cause;
use possible::Verdict;
use print::Print;
use tree::Tree;

pub use link_geometry::{LinkGeometry, Rescaled};

/// Returns all findings of a model, in file order. `geometry[k]` belongs to `model.links[k]`; links
/// without an entry are not checked.
///
/// The time is linear in the numbers of links and joints, and nothing recurses.
///
/// ```
/// use polhode_robot::check::{LinkGeometry, check};
/// use polhode_robot::geometry::Shapes;
/// use polhode_robot::read::{ReadOptions, read_text};
///
/// let text = r#"<robot><link name="hull"><inertial><mass value="1.5"/>
///     <inertia ixx="0.0347563" iyy="0.0458929" izz="0.0977" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>"#;
/// let model = read_text(text, "iris.urdf".as_ref(), &ReadOptions::default())?;
/// let shapes = Shapes::default();
/// let geometry: Vec<_> = model.links.iter().map(|link| LinkGeometry::of(link, &shapes)).collect();
/// let findings = check(&model, &geometry);
/// assert_eq!(findings[0].code, "inertia.triangle");
/// assert_eq!(findings[0].message, "i1 + i2 = 0.0806492 < i3 = 0.0977 kg·m² (by 0.0170508)");
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
pub fn check(model: &RobotModel, geometry: &[LinkGeometry]) -> Vec<Finding> {
    check_for(model, geometry, &[])
}

/// Checks a model as [`check`] does. A rejection by one of these programs is an error instead of a
/// note.
pub fn check_for(model: &RobotModel, geometry: &[LinkGeometry], programs: &[Program]) -> Vec<Finding> {
    let tree = Tree::of(model);
    let print = Print::of(model);
    let nothing = LinkGeometry::default();
    let mut findings = tree::check(model, &tree);
    let mut bodies = Vec::with_capacity(model.links.len());
    for (link, geometry) in model.links.iter().zip(geometry) {
        computed::check(model.format, link, geometry, &mut findings);
    }
    for (k, link) in model.links.iter().enumerate() {
        let placed = link.inertial.as_ref().is_none_or(|inertial| inertial.pose.unreadable.is_empty());
        let geometry = geometry.get(k).filter(|_| placed).unwrap_or(&nothing);
        bodies.push(Body::of(model.format, link, geometry, print));
    }
    let held = dummy::held(&tree, &bodies);
    for (k, (link, body)) in model.links.iter().zip(&bodies).enumerate() {
        numbers::check(model, link, &tree, k, &mut findings);
        mass::check(model, &tree, k, &mut findings);
        if let Some(body) = body {
            let mut found = of_body(model, body, held.get(k).copied().unwrap_or(Held::Free));
            leave_one_repair(&mut found);
            findings.append(&mut found);
        } else if let Some(inertial) = &link.inertial {
            findings.extend(possible::of_moments(link, inertial));
        }
    }
    numbers::elsewhere(model, &mut findings);
    armature::check(model, &mut findings);
    refused::check(model, &tree, programs, &mut findings);
    pair::check(model, &tree, &bodies, &mut findings);
    placeholder::repeated(&bodies, &mut findings);
    twin::withdraw(model, &bodies, &mut findings);
    let mut findings = alike::grouped(model, findings);
    for finding in &mut findings {
        finding.numbers.retain(|(_, x)| x.is_finite());
        if !model.is_si || !model.is_editable {
            finding.repair = None; // its numbers are converted from those of the text, or shared
        }
    }
    findings.sort_by_key(|f| f.span.start);
    findings
}

/// Checks the mass, centre and tensor of one body.
fn of_body(model: &RobotModel, body: &Body, held: Held) -> Vec<Finding> {
    let mut findings = Vec::new();
    let verdict = possible::check(body, held != Held::Free, &mut findings);
    if verdict == Verdict::Nothing {
        return findings;
    }
    let weighs = body.mass > 0.0;
    let mut cause = if weighs { explain::cause(model, body) } else { Cause::default() };
    match (verdict, cause.tensor.take()) {
        (Verdict::Impossible, Some(slip)) => beside(&mut findings, slip),
        (Verdict::Impossible, None) => order::check_alone(body, &mut findings),
        (_, slip) => {
            // Only the most certain explanation is reported.
            findings.extend(slip.or(cause.mass.take()));
            // Correcting the mass or the sizes also makes the tensor right.
            let is_explained = cause.density.as_ref().is_some_and(|(_, repair)| repair.is_some());
            let is_open = |findings: &[Finding]| {
                !is_explained && findings.iter().all(|f| f.severity < Severity::Suspect)
            };
            let rules: [fn(&Body, Held, &mut Vec<Finding>); 3] =
                [placeholder::check, gyration::check, ratio::check];
            for rule in rules {
                if is_open(&findings) && !findings.iter().any(|f| f.code == "gyration.too_large") {
                    rule(body, held, &mut findings);
                }
            }
        }
    }
    if weighs {
        density::check(body, held, cause.density, &mut findings);
        center::check(model, body, held, &mut findings);
    }
    findings
}

/// Adds an error that explains an impossible tensor. If it has no rule of its own, it extends the
/// finding.
fn beside(findings: &mut Vec<Finding>, slip: Finding) {
    match findings.last_mut() {
        Some(found) if slip.code == "inertia.geometry" => {
            found.message = format!("{}; {}", found.message, slip.message);
            found.numbers.extend(slip.numbers);
            found.repair = slip.repair;
        }
        _ => findings.push(slip),
    }
}

/// Removes repairs that change the same place: they contradict each other.
fn leave_one_repair(findings: &mut [Finding]) {
    let repaired: Vec<Span> = findings
        .iter()
        .flat_map(|f| f.repair.iter().flat_map(|r| r.edits.iter().map(|(span, _)| span.clone())))
        .collect();
    let twice = |repair: &Repair| {
        repair
            .edits
            .iter()
            .any(|(span, _)| repaired.iter().filter(|s| s.start < span.end && span.start < s.end).count() > 1)
    };
    for finding in findings {
        if finding.repair.as_ref().is_some_and(twice) {
            finding.repair = None;
        }
    }
}

/// Creates a finding about a link.
fn finding(
    code: &'static str,
    severity: Severity,
    link: &Link,
    span: Span,
    message: String,
    rule: &str,
) -> Finding {
    Finding::new(code, severity, &link.name.text, span, message, rule)
}
