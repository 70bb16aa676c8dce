//! `<equality>` constraints of joints: one joint's value as a polynomial of another's.
//!
//! y − y₀ = Σ a_k (x − x₀)^k for `polycoef`, with y of `joint1`, x of `joint2` and their `ref` y₀
//! and x₀. Angles are in radians, independently of the compiler setting. MuJoCo enforces this
//! softly by a force; here it holds exactly.
//!
//! Copies and attached models have their own constraints, with the names of their joints.
//!
//! Source: mujoco.readthedocs.io, XML Reference, equality/joint.

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use crate::coordinate::NO_NUMBER;
use crate::model::{Follows, Joint, Name};
use crate::read::xml::{Element, is_true};

use super::context::Context;

/// Default coefficients: y − y₀ = x − x₀.
const POLYNOMIAL: [f64; 5] = [0.0, 1.0, 0.0, 0.0, 0.0];

/// Origin of joints: a model, a copy, or an attached model, nested in another origin.
#[derive(Debug)]
pub(super) struct Origin {
    /// Index of the model's context.
    pub(super) context: usize,
    /// Prefix and suffix of the names.
    pub(super) prefix: Rc<str>,
    pub(super) suffix: Rc<str>,
    /// Index of the enclosing origin; `None` for the main model.
    pub(super) within: Option<usize>,
}

/// First constraint on the joints of one name; `is_only` is true if it is the only one.
struct Constraint<'a> {
    element: Element<'a>,
    is_only: bool,
}

/// Couples joints by the constraints; `of_joints` gives the origin of each joint.
///
/// The constraint of a copy holds if both joints are copied together, as in MuJoCo.
pub(super) fn couple(
    contexts: &[Context<'_>],
    origins: &[Origin],
    of_joints: &[usize],
    joints: &mut [Joint],
) {
    let constraints: Vec<HashMap<&str, Constraint<'_>>> = contexts.iter().map(constraints).collect();
    if constraints.iter().all(HashMap::is_empty) {
        return;
    }
    let numbers: HashMap<String, usize> =
        joints.iter().enumerate().map(|(k, joint)| (joint.name.text.clone(), k)).collect();
    let names: HashSet<(usize, String)> = joints
        .iter()
        .zip(of_joints)
        .flat_map(|(joint, &origin)| {
            chain(origins, origin).filter_map(|origin| Some((origin.context, origin.own(&joint.name.text)?)))
        })
        .map(|(context, own)| (context, own.to_owned()))
        .collect();
    for (k, &origin) in of_joints.iter().enumerate() {
        let mut found: Vec<(Follows, usize)> = Vec::new();
        let Some(joint) = joints.get(k) else { continue };
        for origin in chain(origins, origin) {
            let of_context = constraints.get(origin.context);
            let own = origin.own(&joint.name.text);
            let Some(constraint) = own.and_then(|own| of_context?.get(own)) else { continue };
            let element = constraint.element;
            let leader = element.attribute("joint2").map(|written| written.name()).map(|own| {
                let text = format!("{}{}{}", origin.prefix, own.text, origin.suffix);
                (own.text.clone(), Name { text, ..own })
            });
            let number = leader.as_ref().and_then(|(_, leader)| numbers.get(&leader.text));
            if let (Some((own, _)), None) = (&leader, number)
                && names.contains(&(origin.context, own.clone()))
            {
                continue; // the leader is elsewhere: the two are not copied together
            }
            let leader = leader.map(|(_, leader)| leader);
            let reference = number.and_then(|&leader| joints.get(leader));
            let reference = reference.map_or(0.0, |leader| leader.coordinate.at_rest);
            let coefficients = match constraint.is_only {
                true => coefficients(element, leader.is_some(), joint.coordinate.at_rest),
                false => Err(TWICE.to_owned()),
            };
            let start = element.span().start;
            // One constraint may be reached through two origins that do not change names.
            if found.iter().all(|(_, other)| *other != start) {
                found.push((Follows { span: element.span(), leader, reference, coefficients }, start));
            }
        }
        let is_twice = found.len() > 1;
        let Some(((follows, _), joint)) = found.into_iter().next().zip(joints.get_mut(k)) else { continue };
        let coefficients = if is_twice { Err(TWICE.to_owned()) } else { follows.coefficients };
        joint.coordinate.follows = Some(Follows { coefficients, ..follows });
    }
}

const TWICE: &str = "another constraint also defines its position";

/// Returns an origin and its enclosing origins.
pub(super) fn chain(origins: &[Origin], first: usize) -> impl Iterator<Item = &Origin> {
    std::iter::successors(origins.get(first), |origin| origins.get(origin.within?))
}

impl Origin {
    /// Returns a joint's name without prefix and suffix; `None` if they do not match.
    pub(super) fn own<'n>(&self, name: &'n str) -> Option<&'n str> {
        name.strip_prefix(&*self.prefix)?.strip_suffix(&*self.suffix)
    }
}

/// Returns the active constraints of a model, by the name of the dependent joint.
fn constraints<'a>(context: &Context<'a>) -> HashMap<&'a str, Constraint<'a>> {
    let is_on = |element: &Element<'a>| {
        let written = element.word("active").or_else(|| active_by_class(context.root, element.word("class")));
        written.is_none_or(is_true)
    };
    let mut constraints = HashMap::new();
    for element in context.root.named("equality").flat_map(|all| all.named("joint")).filter(is_on) {
        let Some(joint) = element.word("joint1") else { continue };
        let several = |one: &mut Constraint<'_>| one.is_only = false;
        constraints.entry(joint).and_modify(several).or_insert(Constraint { element, is_only: true });
    }
    constraints
}

/// Returns the attribute `active` of a class or an enclosing class. The outermost class applies to
/// elements without a class.
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
