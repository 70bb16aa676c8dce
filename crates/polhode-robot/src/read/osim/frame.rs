//! Named frames that are fixed to bodies.

use std::collections::{HashMap, HashSet};

use crate::model::{Name, Pose};
use crate::pose::{about, product};
use crate::read::pose::Reading;
use crate::read::xml::{Element, Written};

/// Maximum length of a chain of frames; longer chains are circular.
const MOST_STEPS: usize = 100;

/// Offset frames of a model, by the last component of their paths. Those of a joint take
/// precedence.
#[derive(Debug, Default)]
pub(super) struct Frames<'a> {
    named: HashMap<&'a str, Element<'a>>,
    /// Names of frames of other kinds, such as station-defined frames.
    others: HashSet<&'a str>,
}

impl<'a> Frames<'a> {
    /// Collects all offset frames of an element.
    pub(super) fn of(root: Element<'a>) -> Self {
        let mut frames = Self::default();
        let mut waiting = vec![root];
        while let Some(element) = waiting.pop() {
            if let Some(name) = element.word("name").filter(|_| element.name().ends_with("Frame")) {
                if element.name() == "PhysicalOffsetFrame" {
                    frames.named.insert(name, element);
                } else {
                    frames.others.insert(name);
                }
            }
            waiting.extend(element.children());
        }
        frames
    }

    /// Returns the body that a frame is fixed to, and the frame's pose in it. Names in `own` take
    /// precedence. `None` for a kind of frame that is not read.
    pub(super) fn placed(&self, own: &Self, named: &Written<'a>) -> Option<(Name, Pose)> {
        let mut pose = Pose::IDENTITY;
        let mut at = named.clone();
        for _ in 0..MOST_STEPS {
            let last = at.value.rsplit('/').next().unwrap_or(at.value);
            let Some(frame) = own.named.get(last).or(self.named.get(last)) else {
                if own.others.contains(last) || self.others.contains(last) {
                    return None;
                }
                return Some((Name { text: last.to_owned(), span: named.span.clone() }, pose));
            };
            let offset = offset(*frame, "translation", "orientation");
            let unreadable = offset.unreadable.iter().chain(&pose.unreadable).cloned().collect();
            pose = Pose { unreadable, span: offset.span.clone(), ..offset.then(&pose) };
            match socket(*frame, "parent") {
                Some(next) => at = next,
                None => break,
            }
        }
        Some((named.name(), pose))
    }
}

/// Returns the connectee of a socket: `socket_NAME`, or a connector of that name before 4.0.
pub(super) fn socket<'a>(element: Element<'a>, name: &str) -> Option<Written<'a>> {
    element.child_text(&format!("socket_{name}")).or_else(|| {
        let connectors = element.child("connectors")?;
        connectors.children().find(|one| one.word("name") == Some(name))?.child_text("connectee_name")
    })
}

/// Returns the pose from the elements for translation and orientation.
pub(super) fn offset(element: Element<'_>, translation: &str, orientation: &str) -> Pose {
    let mut reading = Reading::default();
    let position = reading.numbers(element.child_text(translation).as_ref(), [0.0; 3]);
    let [x, y, z] = reading.numbers(element.child_text(orientation).as_ref(), [0.0; 3]);
    reading.pose(position, product(product(about(0, x), about(1, y)), about(2, z)))
}
