//! `<attach>`: a body of another model, or all that stands in its world.

use crate::read::xml::Element;

use super::equality::Origin;
use super::{Branch, Reader};

impl<'a> Reader<'_, 'a, '_> {
    /// What is attached, on the branch where it is.
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
        let why = match (found, element.word("body")) {
            (None, _) => "its model is not among the assets, or could not be read",
            _ if element.word("frame").is_some() => "frames are not attached here",
            (Some(_), None) if model.is_none() => "it names no body",
            (Some((context, root)), None) => {
                for world in root.named("worldbody") {
                    let class = world.word("childclass");
                    let attached = Branch {
                        element: world,
                        context,
                        class,
                        prefix: prefix.as_str().into(),
                        origin,
                        ..branch.clone()
                    };
                    branches.push(attached);
                }
                return;
            }
            (Some((context, root)), Some(name)) => match body(root, name) {
                Some((element, class)) => {
                    branches.push(Branch {
                        element,
                        context,
                        class,
                        prefix: prefix.into(),
                        origin,
                        ..branch.clone()
                    });
                    return;
                }
                None => "its model has no such body",
            },
        };
        self.incomplete = Some("<attach> is not read".to_owned());
        let subject = self.name_of(branch.link).to_owned();
        let message = format!("<attach> is not read, and what it makes is not checked: {why}");
        self.note("read.left_out", &subject, element.span(), message);
    }
}

/// The body of that name below the root of a model, and the class around it.
fn body<'a>(root: Element<'a>, name: &str) -> Option<(Element<'a>, Option<&'a str>)> {
    let mut waiting: Vec<_> =
        root.named("worldbody").map(|world| (world, world.word("childclass"))).collect();
    while let Some((element, class)) = waiting.pop() {
        for child in element.children() {
            match child.name() {
                "body" if child.word("name") == Some(name) => return Some((child, class)),
                "body" | "frame" => waiting.push((child, child.word("childclass").or(class))),
                _ => {}
            }
        }
    }
    None
}
