//! XML as the languages of robots use it.

pub(crate) use polhode_source::xml::{Document, Element, Forest, Links, Written, is_true, with_root};

use crate::model::{Number, Slot};

/// What an element's attribute says as a number, or that it lacks it.
pub(crate) fn slot(element: Element<'_>, name: &str) -> Slot {
    match element.attribute(name) {
        Some(written) => Slot::Given(written.number()),
        None => Slot::Missing { span: element.span(), name: name.to_owned() },
    }
}

/// What an element in the element says as a number, or that it lacks it.
pub(crate) fn child_slot(element: Element<'_>, name: &str) -> Slot {
    match element.child(name) {
        Some(child) => match child.text() {
            Some(written) => Slot::Given(written.number()),
            None => Slot::Given(Number { text: String::new(), span: child.span(), value: None }),
        },
        None => Slot::Missing { span: element.span(), name: name.to_owned() },
    }
}
