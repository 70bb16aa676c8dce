//! `<attach>`: inserts a body or frame of this or another model, or the whole world of another
//! model.

use crate::read::xml::Element;

use super::equality::Origin;
use super::{Branch, Reader};

impl<'a> Reader<'_, 'a, '_> {
    /// Attaches the content to the branch of the `<attach>` element.
    pub(super) fn attach(&mut self, branch: &Branch<'a>, branches: &mut Vec<Branch<'a>>) {
        let element = branch.element;
        let model = element.word("model");
        let context = match model {
            Some(name) => self.contexts.get(branch.context).and_then(|own| own.models.get(name).copied()),
            None => Some(branch.context),
        };
        let prefix = format!("{}{}", branch.prefix, element.word("prefix").unwrap_or(""));
        self.name_bytes += prefix.len();
        let origin = self.origins.len();
        if let Some(context) = context {
            self.origins.push(Origin {
                context,
                prefix: prefix.as_str().into(),
                suffix: branch.suffix.clone(),
                within: Some(branch.origin),
            });
        }
        let found = context.and_then(|context| Some((context, self.contexts.get(context)?.root)));
        let (kind, name) = match (element.word("body"), element.word("frame")) {
            (Some(_), Some(_)) => return self.not_made(branch, "it names both a body and a frame"),
            (Some(name), None) => ("body", Some(name)),
            (None, name) => ("frame", name),
        };
        let Some((context, root)) = found else {
            return self.not_made(branch, "its model is not in <asset>, or could not be read");
        };
        let attached = |element, class| Branch {
            element,
            context,
            class,
            prefix: prefix.as_str().into(),
            origin,
            ..branch.clone()
        };
        let Some(name) = name else {
            if model.is_none() {
                return self.not_made(branch, "it names no body");
            }
            branches.extend(root.named("worldbody").map(|world| attached(world, world.word("childclass"))));
            return;
        };
        let Some((found, class)) = below(root, kind, name) else {
            return self.not_made(branch, &format!("its model has no such {kind}"));
        };
        // MuJoCo copies only what precedes the element.
        let is_later = found.tree() == element.tree() && found.span().start > element.span().start;
        if model.is_none() && (is_later || holds(found, element)) {
            return self.not_made(branch, &format!("its {kind} has to be complete before the <attach>"));
        }
        branches.push(attached(found, class));
    }
}

/// Returns the body or frame with this name below the root of a model, and the class that applies
/// to it.
fn below<'a>(root: Element<'a>, kind: &str, name: &str) -> Option<(Element<'a>, Option<&'a str>)> {
    let mut waiting: Vec<_> =
        root.named("worldbody").map(|world| (world, world.word("childclass"))).collect();
    while let Some((element, class)) = waiting.pop() {
        for child in element.children() {
            match child.name() {
                own if own == kind && child.word("name") == Some(name) => return Some((child, class)),
                "body" | "frame" => waiting.push((child, child.word("childclass").or(class))),
                _ => {}
            }
        }
    }
    None
}

/// Returns true if an element contains another.
fn holds(outer: Element<'_>, inner: Element<'_>) -> bool {
    let mut waiting = vec![outer];
    while let Some(element) = waiting.pop() {
        if element.tree() == inner.tree() && element.span() == inner.span() {
            return true;
        }
        waiting.extend(element.children());
    }
    false
}
