//! The numbers of a scenario as they are written, each with its key.

use std::ops::Range;
use std::sync::Arc;

use polhode_source::toml::tree::{Entries, Kind, Known, Node};
use polhode_source::unit::{Dimension, unit_of};

/// A number of a scenario: its key, where and how it is written, and what it is.
#[derive(Clone, Debug, PartialEq)]
pub struct WrittenNumber {
    /// `body.part[0].size[2]`
    pub key: String,
    /// What the innermost table on the way to it that has a name, a shape or a model is called, if there is one: `"crossbar"`.
    pub owner: Option<String>,
    /// Bytes of the text.
    pub place: Range<usize>,
    /// SI.
    pub value: f64,
    /// The unit as it is written; empty of a plain number, which is SI.
    pub unit: String,
    /// What it measures.
    pub dimension: Dimension,
}

impl WrittenNumber {
    /// The symbols of its unit in SI: `kg·m²`; empty of a plain number.
    pub fn si(&self) -> String {
        self.dimension.unit().0
    }
}

/// Every number of a scenario that was read, in the order of the text.
pub(crate) fn numbers(entries: &Entries) -> Vec<WrittenNumber> {
    let mut found = Vec::new();
    inside(entries, "", None, &mut found);
    found.sort_by_key(|number| number.place.start);
    found
}

fn inside(entries: &Entries, way: &str, owner: Option<&str>, found: &mut Vec<WrittenNumber>) {
    let text = |key: &str| match &entries.get(key)?.node.kind {
        Kind::Text(text) => Some(text.as_str()),
        _ => None,
    };
    let owner = ["name", "shape", "model"].into_iter().find_map(text).or(owner);
    for (key, entry) in entries {
        // A plan's own numbers are no numbers of its scenario.
        if way.is_empty() && &**key == "sweep" {
            continue;
        }
        let further = if way.is_empty() { key.to_string() } else { format!("{way}.{key}") };
        at(&entry.node, &further, owner, found);
    }
}

fn at(node: &Arc<Node>, key: &str, owner: Option<&str>, found: &mut Vec<WrittenNumber>) {
    match (&node.kind, node.known.get()) {
        (Kind::Table(entries), _) => inside(entries, key, owner, found),
        (Kind::List(elements), _) => {
            for (k, element) in elements.iter().enumerate() {
                at(element, &format!("{key}[{k}]"), owner, found);
            }
        }
        (kind, Some(&Known::Number(value, dimension))) => {
            let unit = if let Kind::Text(text) = kind { unit_of(text).to_owned() } else { String::new() };
            let (key, owner, place) = (key.to_owned(), owner.map(str::to_owned), node.span.clone());
            found.push(WrittenNumber { key, owner, place, value, unit, dimension });
        }
        _ => {}
    }
}
