//! Check that the numbers of a list have units either all or not at all. `["0 mm", "0 mm", "150"]`
//! is refused, because 150 m is hardly meant.

use std::sync::Arc;

use super::source::Source;
use super::tree::{Entries, Kind, Node};
use crate::text::cut;
use crate::unit::{bare_beside_units, measured, unit_of};
use crate::{FormatError, FormatErrorKind};

/// Keys of one table with values of the same kind: of a distribution, or of a span of time.
const TOGETHER: [&str; 6] = ["from", "to", "mode", "mean", "sd", "median"];

/// Key of lists whose numbers have different dimensions; their reader requires units.
const APART: &str = "correlated";

/// Refuses the first list or matrix in which some numbers have units and other nonzero numbers have
/// none.
pub fn check(source: Source<'_>, entries: &Entries) -> Result<(), FormatError> {
    let together: Vec<&Node> =
        TOGETHER.iter().filter_map(|key| entries.get(*key)).map(|entry| &*entry.node).collect();
    let key_of = |node: &Node| {
        let named = TOGETHER.iter().find(|key| entries.get(**key).is_some_and(|e| e.node.span == node.span));
        named.copied().unwrap_or_default()
    };
    alike(source, key_of, &together)?;
    for (key, entry) in entries {
        match &entry.node.kind {
            Kind::Table(_) if key.as_ref() == APART => {}
            Kind::Table(inner) => check(source, inner)?,
            Kind::List(elements) => list(source, key, elements)?,
            _ => {}
        }
    }
    Ok(())
}

fn list(source: Source<'_>, key: &str, elements: &[Arc<Node>]) -> Result<(), FormatError> {
    let rows = elements.iter().map(|element| match &element.kind {
        Kind::List(row) => row.as_slice(),
        _ => std::slice::from_ref(element),
    });
    let scalars: Vec<&Node> = rows.flatten().map(AsRef::as_ref).collect();
    alike(source, |_| key, &scalars)?;
    for element in elements {
        if let Kind::Table(inner) = &element.kind {
            check(source, inner)?;
        }
    }
    Ok(())
}

/// Refuses the first number without a unit in a list that has numbers with units.
fn alike<'a>(
    source: Source<'_>,
    key_of: impl Fn(&Node) -> &'a str,
    nodes: &[&Node],
) -> Result<(), FormatError> {
    let texts = nodes.iter().filter_map(|node| text(node));
    let Some((bare, with)) = bare_beside_units(texts) else { return Ok(()) };
    let Some(node) = nodes.iter().find(|node| text(node) == Some(bare)) else { return Ok(()) };
    let rule = format!("given with its unit, like the other element \"{}\"", cut(with));
    let value = cut(source.text.get(node.span.clone()).unwrap_or(bare));
    let error =
        source.error(node.span.clone(), FormatErrorKind::Value { key: key_of(node).to_owned(), value, rule });
    let unit = unit_of(with);
    let si = measured(with).map(|(_, dimension)| dimension.unit().0).unwrap_or_default();
    let bare = bare.trim();
    Err(error.with_hint(match unit == si || si.is_empty() {
        true => format!("write \"{bare} {unit}\""),
        false => format!("write \"{bare} {unit}\", or \"{bare} {si}\""),
    }))
}

/// Returns a number as it is written, with its unit if it has one.
fn text(node: &Node) -> Option<&str> {
    match &node.kind {
        Kind::Text(text) | Kind::Float(text) | Kind::Whole { digits: text, radix: 10 } => Some(text),
        _ => None,
    }
}
