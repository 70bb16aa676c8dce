//! Reader of `<inertial>`.

use crate::model::{Inertial, Number, Pose, Slot, Tensor};
use crate::read::xml::{Element, Written, slot};

use super::Reader;
use super::defaults::Source;

/// Returns the inertial of a body, and the frames that enclose it, the outermost first. As in
/// MuJoCo (3.17), an inertial in a frame is placed by the frame.
pub(super) fn of(body: Element<'_>) -> Option<(Element<'_>, Vec<Element<'_>>)> {
    // Each element with the list index of the element that encloses it.
    let mut seen = vec![(body, 0)];
    let mut at = 0;
    while let Some(&(element, _)) = seen.get(at) {
        if let Some(inertial) = element.child("inertial") {
            let mut frames = Vec::new();
            while let Some(&(frame, around)) = seen.get(at).filter(|_| at > 0) {
                frames.push(frame);
                at = around;
            }
            frames.reverse();
            return Some((inertial, frames));
        }
        seen.extend(element.named("frame").map(|frame| (frame, at)));
        at += 1;
    }
    None
}

impl<'a> Reader<'_, 'a, '_> {
    pub(super) fn inertial(
        &mut self,
        (element, frames): (Element<'a>, Vec<Element<'a>>),
        link: &str,
        context: usize,
    ) -> Inertial {
        let tensor = if let Some(full) = element.attribute("fullinertia") {
            // The order of the file is that of `Tensor::Six`.
            Tensor::Six(Box::new(self.slots(&full, ["M11", "M22", "M33", "M12", "M13", "M23"], link)))
        } else if let Some(diagonal) = element.attribute("diaginertia") {
            Tensor::Diagonal(Box::new(self.slots(
                &diagonal,
                ["diaginertia 1", "diaginertia 2", "diaginertia 3"],
                link,
            )))
        } else {
            Tensor::Missing(element.span())
        };
        let mass = slot(element, "mass");
        let pose = self.pose(element, &Source::of(element), context);
        let pose = frames.into_iter().rev().fold(pose, |inner, frame| {
            let outer = self.pose(frame, &Source::of(frame), context);
            let placed = outer.then(&inner);
            let unreadable = outer.unreadable.into_iter().chain(inner.unreadable).collect();
            Pose { unreadable, span: inner.span, ..placed }
        });
        Inertial { span: element.span(), mass, pose, tensor }
    }

    /// Returns the numbers of an attribute. A number that is absent is missing; an extra number is
    /// suspect.
    fn slots<const N: usize>(&mut self, written: &Written<'a>, names: [&str; N], link: &str) -> [Slot; N] {
        let mut numbers = written.numbers();
        let slots = names.map(|name| match numbers.next() {
            Some(number) => Slot::Given(number),
            None => Slot::Missing { span: written.span.clone(), name: name.to_owned() },
        });
        if let Some(Number { span, .. }) = numbers.next() {
            let span = span.start..written.span.end.max(span.end);
            let order = if N == 6 { "; the six are xx yy zz xy xz yz, not rows of a matrix" } else { "" };
            let message = format!("more than {N} numbers: MuJoCo refuses the file{order}");
            self.suspect("read.numbers", link, span, message);
        }
        slots
    }
}
