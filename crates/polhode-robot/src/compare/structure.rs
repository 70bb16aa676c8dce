//! Differences of joints, and links and groups without a partner.

use polhode_document::number::number;

use super::axis::Axis;
use super::difference::{
    FRAME, JOINT, LINK, NAME, SKIPPED, Sides, ZERO, angle, distance, listed, two_points,
};
use super::frames::{Aligned, Alignment, Joints};
use super::names::last_part;
use super::pairs::{Pair, Pairs};
use super::robot::{Robot, WORLD};
use crate::finding::Finding;
use crate::model::{Joint, JointKind, Span};

/// Upper bound on the names in a note.
const MOST: usize = 12;

/// Returns the differences and notes of the joints above a pair.
pub(super) fn joints(
    sides: &Sides<'_, '_>,
    pairs: &Pairs,
    pair: &Pair,
    alignment: &Alignment,
) -> Vec<Finding> {
    let (a, b) = (sides.a.joint(pair.a), sides.b.joint(pair.b));
    let index = |robot: &Robot<'_>, group: usize| robot.groups.get(group).and_then(|group| group.joint);
    let (in_a, in_b) = (index(sides.a, pair.a), index(sides.b, pair.b));
    let namesake = in_a.and_then(|joint| pairs.namesake(joint));
    if !pair.is_whole && (namesake.is_none() || namesake != in_b) {
        return Vec::new(); // Reported as divided groups.
    }
    let subject = b.or(a).map_or("", |joint| joint.name.text.as_str());
    let spans = || [b, a].map(|joint| joint.map(|joint| joint.name.span.clone()));
    let difference = |message| sides.finding(JOINT, subject, spans(), message);
    let mut found = Vec::new();
    let name = &sides.name_a;
    match &alignment.joints {
        Joints::Same => {}
        Joints::Kind => {
            let [of_a, of_b] = [a, b].map(|joint| joint.map_or("no joint", |joint| kind(joint.kind)));
            found.push(difference(format!("type {of_b}, in {name} {of_a}")));
        }
        Joints::Axis(from, to) => found.push(difference(axis(from, to, name))),
        Joints::Place => {
            let words = |robot: &Robot<'_>, group: usize| match robot.joint(group) {
                Some(joint) => format!("is moved by joint {:?} {}", joint.name.text, hanging(robot, group)),
                None => "is moved by no joint".to_owned(),
            };
            let link = first_link(sides.b, pair.b).or_else(|| first_link(sides.a, pair.a)).unwrap_or("");
            let (of_a, of_b) = (words(sides.a, pair.a), words(sides.b, pair.b));
            found.push(difference(format!("link {link:?} {of_b}, in {name} it {of_a}")));
        }
        Joints::Rest => {
            found.push(difference(format!("its anchor, or its child's pose, differs from {name}")));
        }
    }
    if let (Some(JointKind::Other), Some(JointKind::Other)) =
        (a.map(|joint| joint.kind), b.map(|joint| joint.kind))
    {
        let message = "only its anchor is compared: the joint is neither revolute nor prismatic".to_owned();
        found.push(sides.finding(SKIPPED, subject, spans(), message));
    }
    if alignment.zero != 0.0 {
        let unit = if b.is_some_and(|joint| joint.kind == JointKind::Prismatic) { "m" } else { "rad" };
        let message = format!("its zero differs: 0 in {name} is {} {unit} here", number(alignment.zero, 6));
        let note = sides.finding(ZERO, subject, spans(), message);
        found.push(Finding { numbers: vec![("offset", alignment.zero)], ..note });
    }
    if let (Some(of_a), Some(of_b)) = (a, b)
        && namesake != in_b
        && is_renamed(sides, of_a, of_b)
    {
        let is_crossed = namesake.is_some() || in_b.is_some_and(|joint| pairs.is_namesake(joint));
        let (code, message) = if is_crossed {
            (JOINT, format!("it moves the links that joint {:?} moves in {name}", of_a.name.text))
        } else {
            (NAME, format!("called {:?} in {name}", of_a.name.text))
        };
        if !(is_crossed && matches!(alignment.joints, Joints::Place)) {
            found.push(sides.finding(code, subject, spans(), message));
        }
    }
    found.extend(base(sides, pair));
    found
}

/// Returns true if two joints have different names that their files state. Generated names do not
/// count.
fn is_renamed(sides: &Sides<'_, '_>, a: &Joint, b: &Joint) -> bool {
    let is_stated = |robot: &Robot<'_>, joint: &Joint| {
        robot.model.texts().any(|text| text.contains(joint.name.text.as_str()))
    };
    last_part(&a.name.text) != last_part(&b.name.text) && is_stated(sides.a, a) && is_stated(sides.b, b)
}

/// Returns the note that a base is free in one model and fixed to the world in the other.
fn base(sides: &Sides<'_, '_>, pair: &Pair) -> Option<Finding> {
    let is_free = |robot: &Robot<'_>, group| robot.joint(group).is_some_and(|j| j.kind == JointKind::Free);
    let words = match (pair.a, pair.b) {
        (WORLD, b) if is_free(sides.b, b) => "free here, fixed to the world",
        (a, WORLD) if is_free(sides.a, a) => "fixed to the world here, free",
        _ => return None,
    };
    let link = first_link(sides.b, pair.b)?;
    let message = format!("the base is {words} in {}", sides.name_a);
    Some(sides.finding(FRAME, link, [link_span(sides.b, pair.b), link_span(sides.a, pair.a)], message))
}

/// Describes two axes that differ.
fn axis(from: &Axis, to: &Axis, name: &str) -> String {
    let (turned, away) = from.apart(to);
    let [of_a, of_b] = two_points(from.direction, to.direction);
    let from_reverse = std::f64::consts::PI - turned;
    if from_reverse < std::f64::consts::FRAC_PI_4 {
        let also =
            if from_reverse > 1e-6 { format!(" and {} apart", angle(from_reverse)) } else { String::new() };
        return format!("axis {of_b}, in {name} {of_a}: reversed{also}");
    }
    let mut words = Vec::new();
    if turned > 1e-12 {
        words.push(format!("axis {of_b}, in {name} {of_a}: {} apart", angle(turned)));
    }
    if away > 0.0 && !to.slides {
        let [of_a, of_b] = two_points(from.point, to.point);
        words.push(format!("axis through {of_b} m, in {name} through {of_a} m: {} apart", distance(away)));
    }
    words.join("; ") + ", in the frame of the group above"
}

const fn kind(kind: JointKind) -> &'static str {
    match kind {
        JointKind::Fixed => "fixed",
        JointKind::Revolute => "revolute",
        JointKind::Prismatic => "prismatic",
        JointKind::Free => "free",
        JointKind::Other => "other than revolute and prismatic",
    }
}

/// Returns the group above in words: `below "base"`
fn hanging(robot: &Robot<'_>, group: usize) -> String {
    let parent = robot.groups.get(group).and_then(|group| group.parent);
    match parent.and_then(|parent| first_link(robot, parent)) {
        Some(link) => format!("below {link:?}"),
        None => "in the world".to_owned(),
    }
}

fn first_link<'m>(robot: &Robot<'m>, group: usize) -> Option<&'m str> {
    let member = robot.groups.get(group)?.members.first()?;
    Some(robot.name(member.link))
}

fn link_span(robot: &Robot<'_>, group: usize) -> Option<Span> {
    let member = robot.groups.get(group)?.members.first()?;
    Some(robot.link(member)?.name.span.clone())
}

/// Returns the differences of groups with several partners: links that are fixed together in one
/// model and move in the other.
pub(super) fn divided(sides: &Sides<'_, '_>, aligned: &Aligned<'_, '_>) -> Vec<Finding> {
    let Aligned { a, b, pairs, .. } = aligned;
    let mut found = Vec::new();
    let names = |robot: &Robot<'_>, groups: &[usize]| -> Vec<String> {
        groups.iter().filter_map(|&group| first_link(robot, group)).map(str::to_owned).collect()
    };
    let moving = |robot: &Robot<'_>, groups: &[usize]| -> Vec<String> {
        let joints = groups.iter().skip(1).filter_map(|&group| robot.joint(group));
        joints.map(|joint| joint.name.text.clone()).collect()
    };
    let mut push = |robot: &Robot<'_>, groups: &[usize], whole: [Option<Span>; 2], one: &str, many: &str| {
        let links = names(robot, groups);
        let words: Vec<&str> = links.iter().map(String::as_str).collect();
        let joints = moving(robot, groups);
        let joints: Vec<&str> = joints.iter().map(String::as_str).collect();
        let by = if joints.is_empty() { String::new() } else { format!(", moved by {}", listed(&joints)) };
        let message =
            format!("{} are one rigid group in {one}, but {} in {many}{by}", listed(&words), groups.len());
        let subject = words.first().copied().unwrap_or("");
        let others = links.iter().skip(1).cloned().collect();
        found.push(Finding { others, ..sides.finding(LINK, subject, whole, message) });
    };
    for k in 0..a.groups.len() {
        let partners: Vec<usize> = pairs.of_a(k).collect();
        if partners.len() > 1 {
            let spans = [partners.get(1).and_then(|&b_group| link_span(b, b_group)), link_span(a, k)];
            push(b, &partners, spans, &sides.name_a, &sides.name_b);
        }
    }
    for (k, partners) in pairs.of_b() {
        if partners.len() > 1 {
            let spans = [link_span(b, k), partners.get(1).and_then(|&a_group| link_span(a, a_group))];
            push(a, &partners, spans, &sides.name_b, &sides.name_a);
        }
    }
    found
}

/// Model that has links without a partner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    A,
    B,
}

/// Returns the differences of groups with mass without a partner, and a note about frames without
/// mass and without a partner.
pub(super) fn alone(sides: &Sides<'_, '_>, aligned: &Aligned<'_, '_>) -> Vec<Finding> {
    let pairs = &aligned.pairs.list;
    let mut found = Vec::new();
    for side in [Side::A, Side::B] {
        let (robot, other) =
            if side == Side::A { (sides.a, &sides.name_b) } else { (sides.b, &sides.name_a) };
        let mut has_pair = vec![false; robot.groups.len()];
        let mut has_partner = vec![false; robot.model.links.len()];
        for pair in pairs {
            let group = if side == Side::A { pair.a } else { pair.b };
            has_pair.get_mut(group).into_iter().for_each(|slot| *slot = true);
            for (one, two) in pair.members(sides.a, sides.b) {
                let member = if side == Side::A { one } else { two };
                has_partner.get_mut(member.link).into_iter().for_each(|slot| *slot = true);
            }
        }
        let spans = |span: Span| if side == Side::A { [None, Some(span)] } else { [Some(span), None] };
        let mut frames: Vec<&str> = Vec::new();
        let mut first: Option<Span> = None;
        for (k, group) in robot.groups.iter().enumerate() {
            let is_alone = has_pair.get(k) == Some(&false);
            for member in &group.members {
                let Some(link) = robot.link(member) else { continue };
                let name = link.name.text.as_str();
                match member.mass {
                    Some(mass) if is_alone => {
                        let mass = number(mass.mass, 6);
                        let message = format!(
                            "{mass} kg without a partner in {other}: neither the link nor the joint above it is there"
                        );
                        found.push(sides.finding(LINK, name, spans(link.name.span.clone()), message));
                    }
                    None if has_partner.get(member.link) == Some(&false) => {
                        first.get_or_insert_with(|| link.name.span.clone());
                        frames.push(name);
                    }
                    _ => {}
                }
            }
            if let Some(joint) =
                robot.joint(k).filter(|_| is_alone && group.members.iter().all(|m| m.mass.is_none()))
            {
                let moved = group.members.first().map_or("", |member| robot.name(member.link));
                let message = format!("no partner in {other}; it moves {moved:?}, which has no mass");
                found.push(sides.finding(FRAME, &joint.name.text, spans(joint.name.span.clone()), message));
            }
        }
        if let Some(span) = first {
            let shown: Vec<&str> = frames.iter().take(MOST).copied().collect();
            let more = frames.len().saturating_sub(shown.len());
            let more = if more > 0 { format!(" and {more} more") } else { String::new() };
            let words = if frames.len() == 1 {
                "frame without mass and without a partner"
            } else {
                "frames without mass and without a partner"
            };
            let message = format!("{words} in {other}: {}{more}", shown.join(", "));
            found.push(sides.finding(FRAME, "", spans(span), message));
        }
    }
    found
}
