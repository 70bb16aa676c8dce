//! Coordinates of joints, and `CoordinateCouplerConstraint`: y = s f(x) between two coordinates.
//!
//! A coordinate without a given value is at zero, not at its `default_value`. Only linear functions
//! f are read: `LinearFunction` (slope and constant) and `Constant`.

use std::collections::HashMap;

use crate::coordinate::{NO_NUMBER, limits};
use crate::model::{Coordinate, Follows, Joint, Name};
use crate::read::xml::{Element, is_true};

/// Returns the coordinates of a joint.
fn coordinates<'a>(joint: Element<'a>) -> impl Iterator<Item = Element<'a>> {
    let own = joint.child("coordinates").or_else(|| joint.child("CoordinateSet")?.child("objects"));
    own.into_iter().flat_map(|own| own.named("Coordinate"))
}

/// Returns the coordinate of a joint that has exactly one.
pub(super) fn of(joint: Element<'_>) -> Coordinate {
    let mut all = coordinates(joint);
    let (Some(coordinate), None) = (all.next(), all.next()) else { return Coordinate::default() };
    let clamped = coordinate.child_text("clamped").is_some_and(|clamped| is_true(clamped.value));
    let range = coordinate.child_text("range").filter(|_| clamped).and_then(|range| range.array());
    Coordinate {
        name: coordinate.attribute("name").map(|name| name.name()),
        limits: range.and_then(|[lower, upper]| limits(Some(lower), Some(upper))),
        ..Coordinate::default()
    }
}

/// Couples joints by the constraints of a model.
pub(super) fn couple<'a>(
    model: Element<'a>,
    constraints: impl Iterator<Item = Element<'a>>,
    joints: &mut [Joint],
) {
    let owners = owners(model, joints);
    let says = |element: Element<'_>, name: &str| element.child_text(name).map(|text| is_true(text.value));
    for element in constraints.filter(|element| element.name() == "CoordinateCouplerConstraint") {
        let is_off = says(element, "isEnforced") == Some(false) || says(element, "isDisabled") == Some(true);
        let follower = element.child_text("dependent_coordinate_name").filter(|_| !is_off);
        let Some(followers) = follower.and_then(|name| owners.get(name.value)) else { continue };
        let leaders = element.child_text("independent_coordinate_names");
        let mut words = leaders.iter().flat_map(|names| names.value.split_ascii_whitespace());
        let (leader, more) = (words.next(), words.next());
        let leading = leader.and_then(|leader| owners.get(leader));
        let is_double = followers.len() > 1 || leading.is_some_and(|leading| leading.len() > 1);
        // The coupling stores the names of joints, not of coordinates.
        let leader = leaders.as_ref().zip(leader).map(|(names, leader)| {
            let text = leading.and_then(|owners| joints.get(*owners.first()?)).map(|joint| &joint.name.text);
            Name { text: text.map_or_else(|| leader.to_owned(), String::clone), span: names.span.clone() }
        });
        for &follower in followers {
            let Some(joint) = joints.get_mut(follower) else { continue };
            let coefficients = match (&joint.coordinate.follows, more) {
                _ if is_double => Err("two joints have a coordinate of the same name".to_owned()),
                (Some(_), _) => Err("another constraint also defines its position".to_owned()),
                (None, Some(_)) => Err("it is a function of several coordinates".to_owned()),
                (None, None) => coefficients(element),
            };
            let leader = leader.clone().filter(|_| !is_double);
            joint.coordinate.follows =
                Some(Follows { span: element.span(), leader, reference: 0.0, coefficients });
        }
    }
}

/// Returns the joints that have a coordinate of each name, including joints with several
/// coordinates. A name is valid if it has one owner.
fn owners<'a>(model: Element<'a>, joints: &[Joint]) -> HashMap<&'a str, Vec<usize>> {
    let numbers: HashMap<usize, usize> =
        joints.iter().enumerate().map(|(k, joint)| (joint.span.start, k)).collect();
    let mut owners: HashMap<_, Vec<usize>> = HashMap::new();
    let mut waiting = vec![model];
    while let Some(element) = waiting.pop() {
        if let Some(&k) = numbers.get(&element.span().start) {
            for name in coordinates(element).filter_map(|own| own.word("name")) {
                owners.entry(name).or_default().push(k);
            }
        }
        waiting.extend(element.children());
    }
    owners
}

/// Returns s f as polynomial coefficients.
fn coefficients(constraint: Element<'_>) -> Result<Vec<f64>, String> {
    let function = constraint.child("coupled_coordinates_function").and_then(|own| own.children().next());
    let Some(function) = function else { return Err("it has no function".to_owned()) };
    let coefficients = match function.name() {
        "LinearFunction" => function
            .child_text("coefficients")
            .and_then(|text| text.array())
            .map(|[slope, constant]| vec![constant, slope]),
        "Constant" => function.child_text("value").and_then(|text| text.array()).map(|[value]| vec![value]),
        other => return Err(format!("{other} is not read; only LinearFunction is")),
    };
    let scale = match constraint.child_text("scale_factor") {
        Some(written) => written.number().value,
        None => Some(1.0),
    };
    let all =
        coefficients.zip(scale).map(|(all, scale)| all.into_iter().map(|c| scale * c).collect::<Vec<_>>());
    all.filter(|all| all.iter().all(|c| c.is_finite())).ok_or_else(|| NO_NUMBER.to_owned())
}
