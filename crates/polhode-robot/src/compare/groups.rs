//! Differences of the links of two groups: link by link if both have the same links with mass, and
//! otherwise as sums.

use polhode_document::number::number;
use polhode_source::Failure;

use super::difference::{FRAME, LINK, MASS, Sides, listed};
use super::frames::{Aligned, Alignment};
use super::link::Compared;
use super::mass::Mass;
use super::pairs::Pair;
use super::robot::{Member, Robot};
use super::sums::{Both, agree, own, subtrees};
use crate::body::link_mass;
use crate::finding::Finding;
use crate::line_index::FilePlace;
use crate::link_error::LinkError;
use crate::model::Pose;

/// Upper bound on the links of equal mass that are compared with one link.
const MOST: usize = 16;

/// Returns the differences of all pairs.
///
/// # Errors
/// [`Failure`] that names a link whose mass cannot be part of a sum.
pub(super) fn differences(
    sides: &Sides<'_, '_>,
    aligned: &Aligned<'_, '_>,
    alignments: &[Alignment],
) -> Result<Vec<Finding>, Failure> {
    let sums = subtrees(aligned, alignments);
    let strangers = Strangers::of(sides.a);
    let mut found = Vec::new();
    for (pair, alignment) in aligned.pairs.list.iter().zip(alignments) {
        let shared: Vec<(&Member, &Member)> = pair.members(sides.a, sides.b).collect();
        if pair.is_whole && !pair.has_same_masses(sides.a, sides.b) {
            found.extend(as_sum(sides, aligned.tolerance, pair, alignment)?);
            continue;
        }
        let mut remark: Option<String> = None;
        for (a, b) in shared {
            let (Some(of_a), Some(of_b)) = (a.mass, b.mass) else {
                found.extend(one_sided(sides, a, b));
                continue;
            };
            // Pose of the first model's link in the second model's link.
            let frame = b.pose.inverse().then(&alignment.pose.then(&a.pose));
            let frame = if aligned.is_near(&frame, &Pose::IDENTITY) { Pose::IDENTITY } else { frame };
            let moved = of_a.placed(&frame);
            if moved.agrees(&of_b, aligned.tolerance) == [true; 3] {
                continue;
            }
            require_readable(sides.b, b, [&moved, &of_b])?;
            if let Some(other) = strangers.find(&of_b, a.link, aligned.tolerance) {
                found.push(stranger(sides, a, b, other));
                continue;
            }
            let remark = remark.get_or_insert_with(|| remark_of(aligned, pair, alignment, &sums));
            let compared = Compared {
                subject: sides.b.name(b.link),
                others: Vec::new(),
                links: [sides.b.link(b), sides.a.link(a)],
                a: moved,
                b: of_b,
                remark,
            };
            found.extend(compared.differences(sides, aligned.tolerance));
        }
    }
    Ok(found)
}

/// Mass properties of the first model's links in their own frames, ascending by mass.
struct Strangers(Vec<(Mass, usize)>);

impl Strangers {
    fn of(robot: &Robot<'_>) -> Self {
        let members = robot.groups.iter().flat_map(|group| &group.members);
        let mut masses: Vec<_> = members.filter_map(|member| Some((member.mass?, member.link))).collect();
        masses.sort_by(|(a, _), (b, _)| a.mass.total_cmp(&b.mass));
        Self(masses)
    }

    /// Returns the only link other than its partner whose numbers a link of the second model has.
    fn find(&self, mass: &Mass, partner: usize, tolerance: f64) -> Option<usize> {
        let least = mass.mass - 2.0 * tolerance * mass.mass.abs();
        let start = self.0.partition_point(|(other, _)| other.mass < least);
        let near = self.0.iter().skip(start).take(MOST);
        let mut same = near.filter(|(other, _)| other.agrees(mass, tolerance) == [true; 3]);
        let (_, link) = same.next().filter(|(_, link)| *link != partner)?;
        same.next().is_none().then_some(*link)
    }
}

/// Returns the difference of a link that has the numbers of another one.
fn stranger(sides: &Sides<'_, '_>, a: &Member, b: &Member, other: usize) -> Finding {
    let spans = [sides.b.link(b), sides.a.link(a)].map(|link| link.map(|link| link.name.span.clone()));
    let message =
        format!("mass, centre and tensor are those of {:?} in {}", sides.a.name(other), sides.name_a);
    let found = sides.finding(LINK, sides.b.name(b.link), spans, message);
    Finding { others: vec![sides.a.name(other).to_owned()], ..found }
}

/// Returns the difference of a link that has mass in one model only.
fn one_sided(sides: &Sides<'_, '_>, a: &Member, b: &Member) -> Option<Finding> {
    let words = |mass: Option<Mass>| match mass {
        None => "no mass".to_owned(),
        Some(mass) if mass.mass.is_finite() => format!("mass {} kg", number(mass.mass, 6)),
        Some(_) => "a mass that cannot be read".to_owned(),
    };
    if a.mass.is_none() && b.mass.is_none() {
        return None;
    }
    let spans = [sides.b.link(b), sides.a.link(a)].map(|link| link.map(|link| link.name.span.clone()));
    let message = format!("{}, in {} {}", words(b.mass), sides.name_a, words(a.mass));
    let numbers = [("a", a.mass), ("b", b.mass)].map(|(name, mass)| (name, mass.map_or(0.0, |m| m.mass)));
    let found = sides.finding(MASS, sides.b.name(b.link), spans, message);
    Some(Finding { numbers: numbers.to_vec(), ..found })
}

/// Compares the sums of two groups with different links.
fn as_sum(
    sides: &Sides<'_, '_>,
    tolerance: f64,
    pair: &Pair,
    alignment: &Alignment,
) -> Result<Vec<Finding>, Failure> {
    require_positive(sides.a, pair.a)?;
    require_positive(sides.b, pair.b)?;
    let (of_a, of_b) = (with_mass(sides.a, pair.a), with_mass(sides.b, pair.b));
    let subject = of_b.first().or(of_a.first()).copied().unwrap_or("");
    let first = |robot: &Robot<'_>, group: usize| {
        let members = &robot.groups.get(group)?.members;
        let member = members.iter().find(|member| member.mass.is_some()).or(members.first())?;
        Some(robot.link(member)?.name.span.clone())
    };
    let spans = [first(sides.b, pair.b), first(sides.a, pair.a)];
    let which = |links: &[&str]| match links {
        [] => "no link with mass".to_owned(),
        links => listed(links),
    };
    let words = format!("{} here, {} in {}", which(&of_b), which(&of_a), sides.name_a);
    let others = of_b.iter().chain(&of_a).filter(|name| **name != subject).map(|name| (*name).to_owned());
    let mut others: Vec<String> = others.collect();
    others.sort();
    others.dedup();
    match own(pair, alignment, sides.a, sides.b) {
        [Some(a), Some(b)] => {
            let remark = format!(" (sum of {words})");
            let compared = Compared { subject, others, links: [None; 2], a, b, remark: &remark };
            let mut found = compared.differences(sides, tolerance);
            let [span, related] = &spans;
            let place = |found: Finding| {
                let placed =
                    sides.finding(found.code, subject, [span.clone(), related.clone()], found.message);
                Finding { others: found.others, numbers: found.numbers, ..placed }
            };
            if found.is_empty() {
                let message = format!("the sums of the rigid group agree: {words}");
                return Ok(vec![sides.finding(FRAME, subject, spans, message)]);
            }
            found = found.into_iter().map(place).collect();
            Ok(found)
        }
        [a, b] => {
            let words = |sum: Option<Mass>, links: &[&str]| match sum {
                Some(sum) => format!("mass {} kg (sum of {})", number(sum.mass, 6), listed(links)),
                None => "no mass".to_owned(),
            };
            let message = format!("{}, in {} {}", words(b, &of_b), sides.name_a, words(a, &of_a));
            let [a, b] = [a, b].map(|sum| sum.map_or(0.0, |sum| sum.mass));
            let found = sides.finding(MASS, subject, spans, message);
            Ok(vec![Finding { others, numbers: vec![("a", a), ("b", b)], ..found }])
        }
    }
}

/// Refuses a mass that cannot be part of a sum.
fn require_positive(robot: &Robot<'_>, group: usize) -> Result<(), Failure> {
    let members = robot.groups.get(group).into_iter().flat_map(|group| &group.members);
    for member in members {
        let (Some(mass), Some(link)) = (member.mass, robot.link(member)) else { continue };
        require_readable(robot, member, [&mass, &mass])?;
        if !(mass.mass > 0.0) {
            let name = &link.name.text;
            let message = format!(
                "the link {name:?} cannot be summed with the others of its rigid group: its mass is {} kg",
                number(mass.mass, 6)
            );
            let FilePlace { file, line, column, .. } = robot.place(&link.name.span);
            let hint = "`polhode check` reports the error and the fix";
            return Err(Failure::located(message, file, [line, column], hint));
        }
    }
    Ok(())
}

/// Refuses a link of which a quantity cannot be read in both files.
fn require_readable(robot: &Robot<'_>, member: &Member, masses: [&Mass; 2]) -> Result<(), Failure> {
    let [a, b] = masses.map(Mass::readable);
    let (true, Some(link)) = ((0..3).any(|k| !a[k] && !b[k]), robot.link(member)) else { return Ok(()) };
    let name = &link.name.text;
    let error = match link_mass(robot.model.format, link) {
        Err(error) => error,
        Ok(_) => LinkError::of_number("its mass properties cannot be read", &link.span),
    };
    Err(error.of_link(name).in_model(robot.model))
}

/// Returns the links with mass of a group.
fn with_mass<'m>(robot: &Robot<'m>, group: usize) -> Vec<&'m str> {
    let members = robot.groups.get(group).into_iter().flat_map(|group| &group.members);
    members.filter(|member| member.mass.is_some()).map(|member| robot.name(member.link)).collect()
}

/// Returns the smallest sum that agrees although a link differs, in words.
fn remark_of(aligned: &Aligned<'_, '_>, pair: &Pair, alignment: &Alignment, sums: &[Option<Both>]) -> String {
    let Aligned { a, b, pairs, tolerance, .. } = aligned;
    if pair.is_whole && agree(&own(pair, alignment, a, b), *tolerance) {
        return "; the sum of its rigid group agrees: moved between links".to_owned();
    }
    let mut at = pairs.number(pair.a, pair.b);
    while let Some(k) = at {
        let Some(pair) = pairs.list.get(k) else { break };
        if sums.get(k).and_then(Option::as_ref).is_some_and(|sum| agree(sum, *tolerance)) {
            let below = match b.joint(pair.b) {
                Some(joint) => format!("the subtree below joint {:?}", joint.name.text),
                None => "all links".to_owned(),
            };
            return format!("; the sum of {below} agrees: moved between links");
        }
        at = pairs.above(pair, a, b);
    }
    String::new()
}
