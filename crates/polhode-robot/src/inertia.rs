//! Reports of the bodies of a model: a link, a group joined by fixed joints, a subtree, or the
//! whole model.

use std::fmt::Write as _;

use polhode::body::{Finding, Severity};
use polhode::math::{Body, Rotation};
use polhode_document::SourceInfo;
use polhode_document::number::number;
use polhode_shape::report::InertiaReport;
use serde_json::{Map, Value, json};

use crate::body::{LinkMass, link_mass};
use crate::line_index::{FilePlace, Places};
use crate::link_error::LinkError;
use crate::lump::{Drive, JointPosition, Lump, Lumping, PositionBy, link_named, lump, lump_valid};
use crate::model::RobotModel;
use crate::remarks::remarks;
use crate::report::format_name;

/// Returns the report of a link, in its own frame.
///
/// # Errors
/// [`LinkError`] if the link is unknown, or has no usable mass properties.
pub fn of_link(model: &RobotModel, name: &str) -> Result<InertiaReport, LinkError> {
    let link = link_named(model, name)?;
    let findings = remarks(model, Some(name))?;
    let Some(link) = model.links.get(link) else { return Err(LinkError::massless(None)) };
    let body = match link_mass(model.format, link) {
        Ok(LinkMass::Body(body)) => body,
        Ok(LinkMass::None) => {
            let message = format!("the link {name:?} has no mass");
            return Err(
                LinkError::new(message, "choose another link, or lump it with other links").at(&link.span)
            );
        }
        Err(error) => return Err(error.of_link(name)),
    };
    // The body frame has the link's axes.
    let properties = body.properties.in_frame::<Body>(Rotation::identity());
    let source = source(model)
        .described(format!("link {name} {}, in the link's frame", of_model(model)))
        .with("link", name)
        .with("frame", "link");
    Ok(InertiaReport { findings, ..InertiaReport::new(rounded(source, body.rounding), properties) })
}

/// Returns one report for each body of joined links.
///
/// `source.joints` lists the given joint values, `source.followers` the values that follow from
/// them, rad or m.
///
/// # Errors
/// [`LinkError`] as for [`lump`] or, if `skips_invalid`, [`lump_valid`]; or if the file states a
/// number twice with different values.
pub fn of_lumps(
    model: &RobotModel,
    lumping: Lumping<'_>,
    positions: &[(String, f64)],
    skips_invalid: bool,
) -> Result<Vec<InertiaReport>, LinkError> {
    let lumps = if skips_invalid { lump_valid } else { lump }(model, lumping, positions)?;
    let mut findings = remarks(model, None)?;
    if let Some(lump) = lumps.first() {
        findings.extend(beyond_limits(model, &lump.positions));
    }
    let report = |lump: Lump| {
        let armatures = lump.drives.iter().filter_map(|drive| armature(model, drive));
        let left_out = lump.left_out.iter().map(|error| left_out(model, error));
        let findings = left_out.chain(findings.iter().cloned()).chain(armatures).collect();
        InertiaReport { findings, ..of_lump(model, lumping, lump) }
    };
    Ok(lumps.into_iter().map(report).collect())
}

/// Reports a link that is left out.
fn left_out(model: &RobotModel, error: &LinkError) -> Finding {
    let place = error.span().map(|span| {
        let FilePlace { file, line, column, .. } = Places::of(model).place(&span);
        format!("{}:{line}:{column}", file.display())
    });
    let message = format!("{error}: it is left out, and its mass is missing in the sum");
    Finding { code: "lump.left_out", severity: Severity::Warning, message, place }
}

/// Reports the inertia that the motor of a joint moves: the body and its own rotor.
fn armature(model: &RobotModel, drive: &Drive) -> Option<Finding> {
    let Drive { joint, span, slides, inertia, armature } = drive;
    let (unit, of) = if *slides { ("kg", "along") } else { ("kg·m²", "about") };
    let message = if armature.is_nan() {
        format!("the armature of joint {joint} is negative or not finite: it is not added")
    } else if *armature > 0.0 {
        let [own, rotor, total] = [*inertia, *armature, inertia + armature].map(|x| number(x, 6));
        format!(
            "joint {joint} moves {own} {unit} {of} its axis, or {total} {unit} including its armature of {rotor} {unit}"
        )
    } else {
        return None;
    };
    let FilePlace { file, line, column, .. } = Places::of(model).place(span);
    let severity = if armature.is_nan() { Severity::Warning } else { Severity::Info };
    let place = Some(format!("{}:{line}:{column}", file.display()));
    Some(Finding { code: "joint.armature", severity, message, place })
}

fn of_lump(model: &RobotModel, lumping: Lumping<'_>, lump: Lump) -> InertiaReport {
    let Lump { frame, links, massless, left_out, positions, held, drives, rounding, properties } = lump;
    let of_model = of_model(model);
    let frame_words = match &frame {
        Some(link) => format!("in the frame of {link}"),
        None => "in the model's frame".to_owned(),
    };
    let count = links.len();
    let many = if count == 1 { "1 link".to_owned() } else { format!("{count} links") };
    let pose = position_words(&positions, &held);
    let words = match lumping {
        Lumping::Fixed => format!("{many} {of_model}, fixed together, {frame_words}"),
        Lumping::All if left_out.is_empty() => format!("all {many} {of_model}{pose}, {frame_words}"),
        Lumping::All => format!("{many} {of_model}, {} left out{pose}, {frame_words}", left_out.len()),
        Lumping::Subtree(link) => {
            format!("{link} and its descendants, {many} {of_model}{pose}, {frame_words}")
        }
    };
    let values = |by: fn(&PositionBy) -> bool| -> Map<String, Value> {
        let those = positions.iter().filter(|position| by(&position.by));
        those.map(|position| (position.joint.clone(), position.value.into())).collect()
    };
    let followers = values(|by| matches!(by, PositionBy::Leader(_)));
    let source = source(model)
        .described(words)
        .with("link", frame.clone())
        .with("frame", if frame.is_some() { "link" } else { "model" })
        .with("links", links)
        .with("massless", massless)
        .with("joints", values(|by| *by == PositionBy::Given));
    let source = if followers.is_empty() { source } else { source.with("followers", followers) };
    let armatures: Vec<Value> = drives
        .iter()
        .filter(|drive| drive.armature > 0.0)
        .map(|Drive { joint, slides, inertia, armature, .. }| {
            let total = inertia + armature;
            json!({ "joint": joint, "slides": slides, "inertia": inertia, "armature": armature, "total": total })
        })
        .collect();
    let source = if armatures.is_empty() { source } else { source.with("armatures", armatures) };
    InertiaReport::new(rounded(source, rounding), properties)
}

/// Returns the joint values in words: `, elbow = 0.523599 rad and other joints at zero`
pub(crate) fn position_words(positions: &[JointPosition], held: &[String]) -> String {
    let mut text = String::new();
    for position in positions.iter().filter(|position| position.by != PositionBy::Rest) {
        let follows = match &position.by {
            PositionBy::Leader(Some(leader)) => format!(" (follows {leader})"),
            _ => String::new(),
        };
        let _ = write!(text, ", {}{follows}", in_words(position));
    }
    let at_rest = || positions.iter().filter(|position| position.by == PositionBy::Rest);
    let place = if at_rest().all(|position| position.value == 0.0) { "zero" } else { "rest" };
    let words = match (text.is_empty(), at_rest().next().is_some()) {
        (true, false) if !held.is_empty() => String::new(),
        (true, _) => format!(", joints at {place}"),
        (false, true) => format!("{text} and other joints at {place}"),
        (false, false) => text,
    };
    words + &held_words(held)
}

/// Returns the held joints in words: `, root as in the file (takes no value)`
fn held_words(held: &[String]) -> String {
    match held {
        [] => String::new(),
        [one] => format!(", {one} as in the file (takes no value)"),
        [one, two] => format!(", {one} and {two} as in the file (take no value)"),
        _ => format!(", {} joints as in the file (take no value)", held.len()),
    }
}

/// Returns a joint value in words: `elbow = 0.523599 rad`
fn in_words(position: &JointPosition) -> String {
    format!("{} = {} {}", position.joint, number(position.value, 6), unit(position))
}

const fn unit(position: &JointPosition) -> &'static str {
    if position.slides { "m" } else { "rad" }
}

/// Reports joints outside their limits. The finding is a warning if the value was given or follows
/// from another joint.
pub(crate) fn beyond_limits(model: &RobotModel, positions: &[JointPosition]) -> Vec<Finding> {
    let places = Places::of(model);
    let outside = positions.iter().filter(|position| position.is_outside());
    let finding = |position: &JointPosition| {
        let [lower, upper] = position.limits?;
        let joint = model.joints.iter().find(|joint| joint.name.text == position.joint)?;
        let FilePlace { file, line, column, .. } = places.place(&joint.span);
        let severity = if position.by == PositionBy::Rest { Severity::Info } else { Severity::Warning };
        let unit = unit(position);
        let limits = match (lower.is_finite(), upper.is_finite()) {
            (true, true) => format!("from {} to {} {unit}", number(lower, 6), number(upper, 6)),
            (true, false) => format!("at least {} {unit}", number(lower, 6)),
            _ => format!("at most {} {unit}", number(upper, 6)),
        };
        Some(Finding {
            code: "position.limits",
            severity,
            message: format!("the joint {} is outside its limits, {limits}", in_words(position)),
            place: Some(format!("{}:{line}:{column}", file.display())),
        })
    };
    outside.filter_map(finding).collect()
}

/// Adds the rounding correction of the tensor to the source description.
fn rounded(source: SourceInfo, rounding: f64) -> SourceInfo {
    if rounding == 0.0 {
        return source;
    }
    let words = format!(
        "{}; tensor changed by {rounding:.1e} kg·m², within its printed digits, to satisfy the triangle inequality",
        source.description
    );
    source.described(words).with("rounding", rounding)
}

/// Returns the source description of a model.
pub(crate) fn source(model: &RobotModel) -> SourceInfo {
    let format = format_name(model.format).to_ascii_lowercase();
    SourceInfo::new(model.path.display().to_string(), format)
}

/// Returns the model's name after "of": `of arm`
pub(crate) fn of_model(model: &RobotModel) -> String {
    model.name.as_ref().map_or_else(|| "of the model".to_owned(), |name| format!("of {name}"))
}
