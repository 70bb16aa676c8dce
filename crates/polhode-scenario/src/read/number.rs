//! Numbers of a scenario as written, with their keys.

use std::ops::Range;
use std::sync::Arc;

use polhode_source::toml::tree::{Entries, Kind, Known, Node};
use polhode_source::unit::{Dimension, unit_of};

/// Number of a scenario: its key, its place, and its value.
#[derive(Clone, Debug, PartialEq)]
pub struct WrittenNumber {
    /// Key, such as `body.part[0].size[2]`.
    pub key: String,
    /// Name, shape or model of the innermost enclosing table that has one, such as `"crossbar"`.
    pub owner: Option<String>,
    /// Bytes of the number in the text.
    pub place: Range<usize>,
    /// Value in SI units.
    pub value: f64,
    /// Unit as written; empty for a plain number, which is in SI.
    pub unit: String,
    /// Dimension of the number.
    pub dimension: Dimension,
}

impl WrittenNumber {
    /// Returns the symbols of the SI unit, such as `kg·m²`; empty for a plain number.
    pub fn si(&self) -> String {
        self.dimension.unit().0
    }
}

/// Returns every number of a scenario that was read, in the order of the text.
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
        // Numbers of a plan's `[sweep]` do not belong to the scenario.
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
