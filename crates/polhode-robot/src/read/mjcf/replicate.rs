//! `<replicate>`: what stands in it several times, each copy moved and turned on from the one before.

use std::rc::Rc;

use polhode_source::{ContentError, ContentErrorKind};

use super::equality::Origin;
use super::{Branch, Reader};
use crate::model::Pose;
use crate::read::xml::Element;

/// Elements of a tree with all its copies. A file of a hundred bytes could ask for more than any memory holds.
const MOST_ELEMENTS: usize = 300_000;

/// Bytes of all names with what copies and attached models add to them.
const MOST_NAME_BYTES: usize = 1 << 26;

impl<'a> Reader<'_, 'a, '_> {
    /// The copies of what stands in an element. Copy k is turned by k times `euler`, and stands where k steps of `offset` lead,
    /// each along the axes of the copy before.
    pub(super) fn replicate(
        &mut self,
        branch: &Branch<'a>,
        branches: &mut Vec<Branch<'a>>,
    ) -> Result<(), ContentError> {
        let element = branch.element;
        let count = element.word("count").and_then(|count| count.parse::<usize>().ok());
        let three = |name: &str| element.attribute(name).map_or(Some([0.0; 3]), |written| written.array());
        let (Some(count), Some(offset), Some(turn)) = (count, three("offset"), three("euler")) else {
            let subject = self.name_of(branch.link).to_owned();
            let message = "<replicate> without a count, or with an offset or euler that is not three numbers"
                .to_owned();
            self.incomplete = Some("<replicate> is not read".to_owned());
            self.note("read.left_out", &subject, element.span(), message);
            return Ok(());
        };
        let Some(context) = self.contexts.get(branch.context) else { return Ok(()) };
        let class = element.word("childclass").or(branch.class);
        let separator = element.word("sep").unwrap_or("");
        let digits = count.to_string().len();
        // an inertial in it is the copy's, which is no body
        let inner: Vec<_> = element.children().filter(|child| child.name() != "inertial").collect();
        self.elements = self.elements.saturating_add(count.saturating_mul(inner.len().max(1)));
        self.require_few(element)?;
        let mut position = [0.0; 3];
        for k in 0..count {
            let rotation = context.settings.euler(turn.map(|angle| k as f64 * angle));
            let copy = Pose::new(position, rotation.unwrap_or(Pose::IDENTITY.rotation));
            position = copy.placed(offset);
            let frame = branch.frame.then(&copy);
            let suffix: Rc<str> = format!("{separator}{k:0digits$}{}", branch.suffix).into();
            self.name_bytes += suffix.len();
            self.require_few(element)?;
            let origin = self.origins.len();
            self.origins.push(Origin {
                context: branch.context,
                prefix: branch.prefix.clone(),
                suffix: suffix.clone(),
                within: Some(branch.origin),
            });
            let copied = Branch { frame, class, suffix, origin, ..branch.clone() };
            branches.extend(inner.iter().map(|&element| Branch { element, ..copied.clone() }));
        }
        Ok(())
    }

    /// Refuses what grows beyond any model.
    pub(super) fn require_few(&self, element: Element<'a>) -> Result<(), ContentError> {
        let what = if self.elements > MOST_ELEMENTS {
            format!("a model of more than {MOST_ELEMENTS} elements with its copies")
        } else if self.name_bytes > MOST_NAME_BYTES {
            "names that grow longer together than any model's".to_owned()
        } else {
            return Ok(());
        };
        Err(ContentErrorKind::unsupported(what).at(element.span()))
    }
}
