//! `<replicate>`: repeated copies of its content, each moved and rotated relative to the previous
//! one.

use std::rc::Rc;

use polhode_source::{ContentError, ContentErrorKind};

use super::equality::Origin;
use super::{Branch, Reader};
use crate::model::Pose;
use crate::read::xml::Element;

/// Maximum number of elements with all copies. Without a limit, a file of a hundred bytes could
/// exhaust the memory.
const MOST_ELEMENTS: usize = 300_000;

/// Maximum total bytes of names, with prefixes and suffixes of copies and attached models.
const MOST_NAME_BYTES: usize = 1 << 26;

impl<'a> Reader<'_, 'a, '_> {
    /// Adds the copies of the content. Copy k is rotated by k times `euler`. Its position results
    /// from k steps of `offset`, each along the axes of the previous copy.
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
        // An inertial in it would belong to the copy, which is not a body.
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

    /// Returns an error if the model grows beyond the limits.
    pub(super) fn require_few(&self, element: Element<'a>) -> Result<(), ContentError> {
        let what = if self.elements > MOST_ELEMENTS {
            format!("a model with more than {MOST_ELEMENTS} elements, copies included")
        } else if self.name_bytes > MOST_NAME_BYTES {
            "names that are too long in total".to_owned()
        } else {
            return Ok(());
        };
        Err(ContentErrorKind::unsupported(what).at(element.span()))
    }
}
