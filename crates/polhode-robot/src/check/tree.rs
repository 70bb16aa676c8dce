//! Structure of the links and joints: `tree.cycle`, `tree.no_root`, `tree.two_roots`,
//! `tree.two_parents`, `tree.unknown_link`, `tree.shared_name`, `tree.duplicate_link`,
//! `tree.duplicate_joint`, `tree.empty`.
//!
//! The time is linear in the number of joints, and nothing recurses. The formats have different
//! rules: a URDF is one tree; SDF may have free links and closed loops; MJCF is nested and
//! therefore always a tree.

use std::collections::{HashMap, HashSet};

use super::tree_order::sorted;
use crate::finding::{Finding, Severity};
use crate::model::{JointKind, Link, ModelFormat, Name, RobotModel};

/// Links in topological order, with their parents and children.
#[derive(Debug)]
pub(super) struct Tree {
    /// Parents of each link: the joints to them, and their indices; `None` for the world or an
    /// unknown link.
    holders: Vec<Vec<(usize, Option<usize>)>>,
    /// Children of each link, and true if the joint is fixed.
    hanging: Vec<Vec<(usize, bool)>>,
    /// Cycles of links: each link is the parent of the next, and the last is the parent of the
    /// first.
    cycles: Vec<Vec<usize>>,
    moves: Vec<bool>,
    moves_itself: Vec<bool>,
    mass_below: Vec<bool>,
    welded_mass: Vec<bool>,
    /// Group of each link: the first link of those joined by fixed joints, down the tree.
    group: Vec<usize>,
    /// True if a link of the group has mass, indexed by the first link of the group.
    group_mass: Vec<bool>,
    is_weighed: bool,
    is_bounded: bool,
}

impl Tree {
    pub(super) fn of(model: &RobotModel) -> Self {
        let names = index(&model.links);
        let count = model.links.len();
        let mut holders = vec![Vec::new(); count];
        let mut hanging = vec![Vec::new(); count];
        let mut moves_itself = vec![false; count];
        for (j, joint) in model.joints.iter().enumerate() {
            let Some(&child) = names.get(joint.child.text.as_str()) else { continue };
            let parent = joint.parent.as_ref().and_then(|p| names.get(p.text.as_str())).copied();
            let fixed = joint.kind == JointKind::Fixed;
            holders[child].push((j, parent));
            moves_itself[child] |= !fixed;
            if let Some(parent) = parent {
                hanging[parent].push((child, fixed));
            }
        }
        let (order, cycles) = sorted(&holders, &hanging);

        let mut moves = moves_itself.clone();
        for &k in &order {
            // A link of SDF or USD without a parent is free.
            moves[k] |= closes_loops(model.format) && holders[k].is_empty();
            moves[k] &= !model.links[k].is_static;
            if moves[k] {
                for &(child, _) in &hanging[k] {
                    moves[child] = true;
                }
            }
        }
        let mut mass: Vec<bool> = model.links.iter().map(|link| has_mass(model.format, link)).collect();
        // Bodies that are not read have mass, and may be fixed to the link.
        for link in model.unread_bodies.iter().filter_map(|unread| names.get(unread.link.as_deref()?)) {
            mass[*link] = true;
        }
        let mut mass_below = mass.clone();
        let mut welded_mass = mass_below.clone();
        for &k in order.iter().rev() {
            mass_below[k] |= hanging[k].iter().any(|(child, _)| mass_below[*child]);
            welded_mass[k] |= hanging[k].iter().any(|(child, fixed)| *fixed && welded_mass[*child]);
        }
        let mut group: Vec<usize> = (0..count).collect();
        let mut group_mass = vec![false; count];
        for &k in &order {
            for &(child, _) in hanging[k].iter().filter(|(child, fixed)| *fixed && !moves_itself[*child]) {
                group[child] = group[k];
            }
            group_mass[group[k]] |= mass[k];
        }
        let is_weighed = model.links.iter().any(|link| link.inertial.is_some());
        let is_bounded = model.texts().any(|text| text.contains("boundmass"));
        Self {
            holders,
            hanging,
            cycles,
            moves,
            moves_itself,
            mass_below,
            welded_mass,
            group,
            group_mass,
            is_weighed,
            is_bounded,
        }
    }

    pub(super) fn len(&self) -> usize {
        self.holders.len()
    }

    /// Returns the children of a link, and true if the joint is fixed.
    pub(super) fn hanging(&self, k: usize) -> &[(usize, bool)] {
        self.hanging.get(k).map_or(&[], Vec::as_slice)
    }

    /// Returns a link and all links joined to it by fixed joints, down the tree.
    pub(super) fn welded(&self, k: usize) -> Vec<usize> {
        let (mut welded, mut seen) = (vec![k], HashSet::from([k]));
        let mut next = 0;
        while let Some(&link) = welded.get(next) {
            let own = self.hanging(link).iter().filter(|(child, _)| self.group(*child) == self.group(k));
            welded.extend(own.map(|(child, _)| *child).filter(|child| seen.insert(*child)));
            next += 1;
        }
        welded
    }

    /// Returns the first joint to a parent.
    pub(super) fn joint(&self, k: usize) -> Option<usize> {
        self.holders.get(k)?.first().map(|(joint, _)| *joint)
    }

    /// Returns true if joints let the link move, its own or those of its ancestors.
    pub(super) fn moves(&self, k: usize) -> bool {
        self.moves.get(k).copied().unwrap_or(false)
    }

    /// Returns true if a joint of its own lets the link move.
    pub(super) fn moves_itself(&self, k: usize) -> bool {
        self.moves_itself.get(k).copied().unwrap_or(false)
    }

    /// Returns true if the link is fixed to another link or to the world.
    pub(super) fn is_carried(&self, k: usize) -> bool {
        self.holders.get(k).is_some_and(|h| !h.is_empty()) && !self.moves_itself(k)
    }

    /// Returns true if the link has children but no parent.
    pub(super) fn is_base(&self, k: usize) -> bool {
        self.holders.get(k).is_some_and(Vec::is_empty) && self.hanging.get(k).is_some_and(|h| !h.is_empty())
    }

    /// Returns true if the link or one of its descendants has mass.
    pub(super) fn has_mass_below(&self, k: usize) -> bool {
        self.mass_below.get(k).copied().unwrap_or(true)
    }

    /// Returns true if any link has mass.
    pub(super) fn has_mass(&self) -> bool {
        self.mass_below.contains(&true)
    }

    /// Returns true if the link or a descendant fixed to it has mass.
    pub(super) fn has_welded_mass(&self, k: usize) -> bool {
        self.welded_mass.get(k).copied().unwrap_or(true)
    }

    /// Returns the first link of the group joined by fixed joints.
    pub(super) fn group(&self, k: usize) -> usize {
        self.group.get(k).copied().unwrap_or(k)
    }

    /// Returns true if a link of the same fixed group has mass.
    pub(super) fn is_held_by_mass(&self, k: usize) -> bool {
        self.group_mass.get(self.group(k)).copied().unwrap_or(true)
    }

    /// Returns true if the model sets a lower bound on every mass for MuJoCo.
    pub(super) fn is_bounded(&self) -> bool {
        self.is_bounded
    }

    /// Returns true if any link states its mass.
    pub(super) fn is_weighed(&self) -> bool {
        self.is_weighed
    }
}

/// Returns the index of the first link of each name.
fn index(links: &[Link]) -> HashMap<&str, usize> {
    let mut names = HashMap::with_capacity(links.len());
    for (k, link) in links.iter().enumerate() {
        names.entry(link.name.text.as_str()).or_insert(k);
    }
    names
}

/// Returns true if the link has mass, stated or by default. An unreadable mass is reported
/// elsewhere.
fn has_mass(format: ModelFormat, link: &Link) -> bool {
    match &link.inertial {
        Some(inertial) => inertial.mass.finite().is_none_or(|m| m > 0.0),
        None if format == ModelFormat::Mjcf && matches!(link.computed, Some(Err(_))) => true, // unknown
        None if link
            .computed
            .as_ref()
            .is_some_and(|made| made.as_ref().is_ok_and(|made| made.mass > 0.0)) =>
        {
            true
        }
        None if link.from_geometry => !link.geometry.is_empty(),
        None => format == ModelFormat::Sdf,
    }
}

const CLOSED_LOOPS: &str = "SDF and USD allow closed loops; not every engine does";

/// Returns true if the format allows joints between any two links.
fn closes_loops(format: ModelFormat) -> bool {
    matches!(format, ModelFormat::Sdf | ModelFormat::Usd)
}

/// Checks the structure of the model.
pub(super) fn check(model: &RobotModel, tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    let is_urdf = model.format == ModelFormat::Urdf;
    if model.links.is_empty() {
        if is_urdf {
            let message = "no links".to_owned();
            findings.push(Finding::new(
                "tree.empty",
                Severity::Impossible,
                "",
                0..0,
                message,
                "a robot has at least one link",
            ));
        }
        return findings;
    }
    duplicates(model, &mut findings);
    unknown(model, &mut findings);
    for cycle in &tree.cycles {
        if let Some(found) = round(model, tree, cycle) {
            findings.push(found);
        }
    }
    for (k, link) in model.links.iter().enumerate() {
        two_parents(model, tree, k, link, &mut findings);
    }
    if is_urdf {
        roots(model, tree, &mut findings);
    }
    findings
}

fn duplicates(model: &RobotModel, findings: &mut Vec<Finding>) {
    let mut twice = |names: &mut dyn Iterator<Item = &Name>, code, what: &str| {
        let mut seen: HashMap<&str, ()> = HashMap::new();
        for name in names {
            if seen.insert(&name.text, ()).is_some() {
                let message = format!("a second {what} named {:?}", name.text);
                let rule = "names are unique";
                findings.push(Finding::new(
                    code,
                    Severity::Impossible,
                    &name.text,
                    name.span.clone(),
                    message,
                    rule,
                ));
            }
        }
    };
    twice(&mut model.links.iter().map(|l| &l.name), "tree.duplicate_link", "link");
    twice(&mut model.joints.iter().map(|j| &j.name), "tree.duplicate_joint", "joint");
    shared(model, findings);
}

/// Reports a link and a joint with the same name. SDF has one namespace for both; URDF and MJCF
/// have two.
fn shared(model: &RobotModel, findings: &mut Vec<Finding>) {
    let (severity, rule) = match model.format {
        ModelFormat::Sdf => {
            (Severity::Suspect, "names in a model are unique: libsdformat refuses duplicates since SDF 1.7")
        }
        ModelFormat::Urdf => (Severity::Note, "URDF allows a shared name, but SDF does not"),
        ModelFormat::Mjcf | ModelFormat::Usd | ModelFormat::Osim => return,
    };
    let links = index(&model.links);
    for name in model.joints.iter().map(|joint| &joint.name).filter(|name| !name.text.is_empty()) {
        if links.contains_key(name.text.as_str()) {
            let message = format!("a link and a joint are both named {:?}", name.text);
            let span = name.span.clone();
            findings.push(Finding::new("tree.shared_name", severity, &name.text, span, message, rule));
        }
    }
}

fn unknown(model: &RobotModel, findings: &mut Vec<Finding>) {
    let names = index(&model.links);
    // In SDF a joint may refer to a frame or to a link of an included model, in USD to a prim of
    // another layer.
    let is_part = match model.format {
        ModelFormat::Sdf => ["<frame", "<include"].iter().any(|tag| model.text.contains(tag)),
        ModelFormat::Usd => model.notes.iter().any(|note| note.code == "read.include"),
        _ => false,
    };
    for joint in &model.joints {
        for (name, what) in [(joint.parent.as_ref(), "parent"), (Some(&joint.child), "child")] {
            let Some(name) = name.filter(|n| !names.contains_key(n.text.as_str())) else { continue };
            let elsewhere = is_part || model.format == ModelFormat::Sdf && name.text.contains("::");
            let severity = if elsewhere { Severity::Note } else { Severity::Impossible };
            let message =
                format!("joint {:?}: its {what} {:?} is not a link of the model", joint.name.text, name.text);
            let rule = "a joint connects two links";
            findings.push(Finding::new(
                "tree.unknown_link",
                severity,
                &joint.name.text,
                name.span.clone(),
                message,
                rule,
            ));
        }
    }
}

fn round(model: &RobotModel, tree: &Tree, cycle: &[usize]) -> Option<Finding> {
    let last = *cycle.last()?;
    let first = *cycle.first()?;
    let (joint, _) = tree.holders.get(first)?.iter().find(|(_, p)| *p == Some(last))?;
    let joint = model.joints.get(*joint)?;
    let link = model.links.get(first)?;
    // Only the ends of a long cycle are shown.
    let name = |k: &usize| model.links.get(*k).map_or("", |l| l.name.text.as_str());
    let shown: Vec<&str> = if cycle.len() <= 12 {
        cycle.iter().map(name).collect()
    } else {
        cycle
            .iter()
            .take(6)
            .map(name)
            .chain(["…"])
            .chain(cycle.iter().skip(cycle.len() - 5).map(name))
            .collect()
    };
    let message = format!("the joints form a cycle: {} → {}", shown.join(" → "), name(&first));
    let (severity, rule) = match model.format {
        format if closes_loops(format) => (Severity::Note, CLOSED_LOOPS),
        _ => (Severity::Impossible, "the links of a robot form a tree"),
    };
    let mut found = Finding::new("tree.cycle", severity, &link.name.text, joint.span.clone(), message, rule);
    found.numbers = vec![("links", cycle.len() as f64)];
    Some(found)
}

fn two_parents(model: &RobotModel, tree: &Tree, k: usize, link: &Link, findings: &mut Vec<Finding>) {
    let Some([(_, first), rest @ ..]) = tree.holders.get(k).map(Vec::as_slice) else { return };
    // An MJCF body may have several joints to its parent.
    let second = rest.iter().find(|(_, parent)| parent != first || model.format == ModelFormat::Urdf);
    let Some(joint) = second.and_then(|(j, _)| model.joints.get(*j)) else { return };
    let parent = |joint: Option<&usize>| {
        let joint = joint.and_then(|j| model.joints.get(*j));
        joint.and_then(|j| j.parent.as_ref()).map_or("the world", |p| p.text.as_str())
    };
    let first = parent(tree.holders.get(k).and_then(|h| h.first()).map(|(j, _)| j));
    let other = joint.parent.as_ref().map_or("the world", |p| p.text.as_str());
    let (severity, rule) = match model.format {
        format if closes_loops(format) => (Severity::Note, CLOSED_LOOPS),
        _ => (Severity::Impossible, "a link has at most one parent: the links form a tree without loops"),
    };
    let message = format!("{:?} has two parents, {first:?} and {other:?}", link.name.text);
    findings.push(Finding::new(
        "tree.two_parents",
        severity,
        &link.name.text,
        joint.child.span.clone(),
        message,
        rule,
    ));
}

fn roots(model: &RobotModel, tree: &Tree, findings: &mut Vec<Finding>) {
    let roots: Vec<&Link> = model
        .links
        .iter()
        .zip(&tree.holders)
        // Joints without a parent, or with the world as parent.
        .filter(|(_, holders)| {
            holders.iter().all(|(joint, _)| model.joints.get(*joint).is_some_and(|j| j.parent.is_none()))
        })
        .map(|(link, _)| link)
        .collect();
    let rule = "exactly one link, the root, has no parent";
    match roots.as_slice() {
        [] => {
            let message = "no root: every link has a parent".to_owned();
            findings.push(Finding::new("tree.no_root", Severity::Impossible, "", 0..0, message, rule));
        }
        [_] => {}
        [_, second, ..] => {
            let names: Vec<&str> = roots.iter().take(5).map(|l| l.name.text.as_str()).collect();
            let more = if roots.len() > 5 { ", …" } else { "" };
            let message = format!("{} roots: {}{more}", roots.len(), names.join(", "));
            let (subject, span) = (&second.name.text, second.name.span.clone());
            let mut found =
                Finding::new("tree.two_roots", Severity::Impossible, subject, span, message, rule);
            found.numbers = vec![("roots", roots.len() as f64)];
            findings.push(found);
        }
    }
}
