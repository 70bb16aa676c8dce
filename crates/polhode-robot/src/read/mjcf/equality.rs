//! `<equality>` of joints: one joint's value as a polynomial of another's.
//!
//! y − y₀ = Σ a_k (x − x₀)^k for `polycoef`, with y of `joint1`, x of `joint2` and their `ref` y₀ and x₀; angles in radians whatever the
//! compiler says. MuJoCo pulls towards this by a force; here it holds.
//!
//! Copies and attached models bring theirs along, with the names of their joints: what names a joint that is not there is another's.
//!
//! Source: mujoco.readthedocs.io, XML Reference, equality/joint.

use std::collections::{HashMap, HashSet};

use crate::coordinate::NO_NUMBER;
use crate::model::{Follows, Joint, Name};
use crate::read::xml::{Element, is_true};

use super::Names;
use super::context::Context;

/// The coefficients that are not given: y − y₀ = x − x₀.
const POLYNOMIAL: [f64; 5] = [0.0, 1.0, 0.0, 0.0, 0.0];

/// Tells joints which others they follow.
pub(super) fn couple(contexts: &[Context<'_>], attached: &[Names], joints: &mut [Joint]) {
    let constraints: Vec<Vec<Element<'_>>> = contexts.iter().map(constraints).collect();
    if constraints.iter().all(Vec::is_empty) {
        return;
    }
    let numbers: HashMap<String, usize> =
        joints.iter().enumerate().map(|(k, joint)| (joint.name.text.clone(), k)).collect();
    let mut done = HashSet::new();
    for (context, prefix, suffix) in attached {
        for &element in constraints.get(*context).into_iter().flatten() {
            let named = |attribute: &str| {
                let written = element.attribute(attribute)?;
                let own = written.name();
                let copied = Name { text: format!("{prefix}{}{suffix}", own.text), ..own };
                Some(copied)
            };
            let Some(follower) = named("joint1") else { continue };
            let leader = named("joint2");
            let Some(&k) = numbers.get(&follower.text) else { continue };
            // a copy may follow what is not copied
            let leader =
                leader.map(|leader| match element.attribute("joint2").map(|written| written.name()) {
                    Some(own) if !numbers.contains_key(&leader.text) => own,
                    _ => leader,
                });
            if !done.insert((follower.text, element.span().start)) {
                continue;
            }
            let reference = leader.as_ref().and_then(|leader| joints.get(*numbers.get(&leader.text)?));
            let reference = reference.map_or(0.0, |leader| leader.coordinate.at_rest);
            let Some(coordinate) = joints.get_mut(k).map(|joint| &mut joint.coordinate) else { continue };
            let coefficients = match coordinate.follows {
                Some(_) => Err("another constraint says where it is, too".to_owned()),
                None => coefficients(element, leader.is_some(), coordinate.at_rest),
            };
            coordinate.follows = Some(Follows { span: element.span(), leader, reference, coefficients });
        }
    }
}

/// The constraints of joints in a model that are on.
fn constraints<'a>(context: &Context<'a>) -> Vec<Element<'a>> {
    let is_on = |element: &Element<'a>| {
        let written = element.word("active").or_else(|| active_by_class(context.root, element.word("class")));
        written.is_none_or(is_true)
    };
    context.root.named("equality").flat_map(|all| all.named("joint")).filter(is_on).collect()
}

/// What a class says of `active`, or one around it; the outermost class is that of what names none.
fn active_by_class<'a>(root: Element<'a>, wanted: Option<&str>) -> Option<&'a str> {
    let mut waiting: Vec<_> = root.named("default").map(|class| (class, true, None)).collect();
    while let Some((class, is_outermost, around)) = waiting.pop() {
        let active = class.child("equality").and_then(|equality| equality.word("active")).or(around);
        if wanted.map_or(is_outermost, |wanted| class.word("class") == Some(wanted)) {
            return active;
        }
        waiting.extend(class.named("default").map(|inner| (inner, false, active)));
    }
    None
}

fn coefficients(element: Element<'_>, has_leader: bool, at_rest: f64) -> Result<Vec<f64>, String> {
    let mut all = POLYNOMIAL;
    if let Some(written) = element.attribute("polycoef") {
        let mut values = written.values();
        for (coefficient, value) in all.iter_mut().zip(&mut values) {
            *coefficient = value;
        }
        if values.next().is_some() {
            return Err("polycoef has more than five numbers".to_owned());
        }
    }
    if !all.iter().all(|coefficient| coefficient.is_finite()) {
        return Err(NO_NUMBER.to_owned());
    }
    let [constant, rest @ ..] = all;
    let mut coefficients = vec![constant + at_rest];
    if has_leader {
        coefficients.extend(rest);
    }
    Ok(coefficients)
}
