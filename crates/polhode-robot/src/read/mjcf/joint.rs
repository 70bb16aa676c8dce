//! Joints, and bodies without joints.

use polhode_source::ContentError;

use super::compiler::Settings;
use super::defaults::Source;
use super::{Branch, Reader, made_up};
use crate::coordinate::limits;
use crate::model::{Coordinate, Joint, JointKind, Name, Pose, Span};
use crate::read::xml::{Element, is_true};

impl<'a> Reader<'_, 'a, '_> {
    pub(super) fn joint(&mut self, branch: &Branch<'a>) {
        let (Some(index), element) = (branch.link, branch.element) else { return };
        let Some(context) = self.contexts.get(branch.context) else { return };
        let source = context.classes.joint(element, branch.class);
        let kind = match (element.name(), source.word("type")) {
            ("freejoint", _) | (_, Some("free")) => JointKind::Free,
            (_, None | Some("hinge")) => JointKind::Revolute,
            (_, Some("slide")) => JointKind::Prismatic,
            _ => JointKind::Other,
        };
        let three = |name: &str, default| {
            source.written(name).map_or(default, |written| written.array().unwrap_or([f64::NAN; 3]))
        };
        let anchor = branch.frame.placed(three("pos", [0.0; 3]));
        let axis = branch.frame.turned(three("axis", [0.0, 0.0, 1.0]));
        let name = element.attribute("name").map_or_else(
            || made_up(format!("joint {}", self.model.joints.len() + 1), element),
            |name| branch.name(name.name()),
        );
        let unread = source.word("type").filter(|word| kind == JointKind::Other && *word != "ball");
        let unread = unread.map(|word| format!("type {word:?} is not a joint type"));
        let coordinate = Coordinate { unread, ..coordinate(&source, kind, &context.settings) };
        if let Some((_, jointed)) = self.jointed.get_mut(index) {
            *jointed = true;
        }
        self.joint_order.push(self.elements);
        self.joint_origins.push(branch.origin);
        self.hang(index, name, element.span(), kind, (axis, anchor), coordinate);
    }

    /// Adds a joint between a link and its parent.
    fn hang(
        &mut self,
        index: usize,
        name: Name,
        span: Span,
        kind: JointKind,
        (axis, anchor): ([f64; 3], [f64; 3]),
        coordinate: Coordinate,
    ) {
        let parent = self.jointed.get(index).and_then(|(parent, _)| *parent);
        let name_of = |link: usize| self.model.links.get(link).map(|link| link.name.clone());
        let Some(child) = name_of(index) else { return };
        let pose = self.frames_in_parents.get(index).cloned().unwrap_or(Pose::IDENTITY);
        let parent = parent.and_then(name_of);
        self.name_bytes +=
            name.text.len() + child.text.len() + parent.as_ref().map_or(0, |name| name.text.len());
        self.model.joints.push(Joint { name, span, kind, parent, child, pose, axis, anchor, coordinate });
    }

    /// Adds fixed joints for links without a joint, and sorts the joints in file order.
    pub(super) fn fix_the_rest(&mut self, root: Element<'a>) -> Result<(), ContentError> {
        for index in 0..self.jointed.len() {
            if self.jointed.get(index).is_some_and(|(_, jointed)| *jointed) {
                continue;
            }
            let Some(link) = self.model.links.get(index) else { continue };
            let span = link.span.clone();
            let name = Name { text: format!("{} (fixed)", link.name.text), span: span.start..span.start + 1 };
            let axis = ([0.0, 0.0, 1.0], [0.0; 3]);
            self.hang(index, name, span, JointKind::Fixed, axis, Coordinate::default());
            self.require_few(root)?;
            let order = self.link_order.get(index).copied().unwrap_or(usize::MAX);
            self.joint_order.push(order);
            self.joint_origins.push(0);
        }
        let joints = std::mem::take(&mut self.model.joints);
        let origins = self.joint_origins.drain(..);
        let mut ordered: Vec<_> =
            self.joint_order.iter().copied().zip(joints.into_iter().zip(origins)).collect();
        ordered.sort_by_key(|(order, _)| *order);
        (self.model.joints, self.joint_origins) = ordered.into_iter().map(|(_, joint)| joint).unzip();
        for link in &mut self.model.links {
            // Without geoms, nothing can be computed from geometry.
            link.from_geometry &= !link.geometry.is_empty();
        }
        Ok(())
    }
}

/// Returns `ref`, and `range` if it is active. Angles are in the unit of the compiler setting.
fn coordinate(source: &Source<'_, '_>, kind: JointKind, settings: &Settings<'_>) -> Coordinate {
    let unit = |value: f64| if kind == JointKind::Revolute { settings.angle(value) } else { value };
    let range = source.written("range").and_then(|range| range.array());
    let is_limited = match source.word("limited") {
        None | Some("auto") => settings.limits_by_range,
        Some(word) => is_true(word),
    };
    let limits =
        range.filter(|_| is_limited).and_then(|[lower, upper]| limits(Some(unit(lower)), Some(unit(upper))));
    let armature = source.number("armature").unwrap_or(0.0);
    Coordinate { at_rest: source.number("ref").map_or(0.0, unit), limits, armature, ..Coordinate::default() }
}
