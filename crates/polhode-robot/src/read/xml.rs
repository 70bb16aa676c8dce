//! XML helpers for the readers.

pub(crate) use polhode_source::xml::{Document, Element, Forest, Links, Written, is_true, with_root};

use crate::model::{Number, Slot};

/// Returns an attribute as a number, or as missing.
pub(crate) fn slot(element: Element<'_>, name: &str) -> Slot {
    match element.attribute(name) {
        Some(written) => Slot::Given(written.number()),
        None => Slot::Missing { span: element.span(), name: name.to_owned() },
    }
}

/// Returns the text of a child element as a number, or as missing.
pub(crate) fn child_slot(element: Element<'_>, name: &str) -> Slot {
    match element.child(name) {
        Some(child) => match child.text() {
            Some(written) => Slot::Given(written.number()),
            None => Slot::Given(Number { text: String::new(), span: child.span(), value: None }),
        },
        None => Slot::Missing { span: element.span(), name: name.to_owned() },
    }
}
