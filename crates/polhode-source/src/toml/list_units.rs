//! Check that the numbers of a list have units either all or not at all. `["0 mm", "0 mm", "150"]`
//! is refused, because 150 m is hardly meant.

use std::sync::Arc;

use super::source::Source;
use super::symbols::words;
use super::tree::{Entries, Kind, Node};
use crate::text::cut;
use crate::unit::{bare, bare_beside_units, measured, unit_of};
use crate::{FormatError, FormatErrorKind};

/// Keys of one table with values of the same kind: of a distribution, or of a span of time.
const TOGETHER: [&str; 6] = ["from", "to", "mode", "mean", "sd", "median"];

/// Key of lists whose numbers have different dimensions; their reader requires units.
const APART: &str = "correlated";

/// Refuses the first list or matrix in which some numbers have units and other nonzero numbers have
/// none. A formula with a symbol has a unit if the symbol has one.
pub fn check(source: Source<'_>, entries: &Entries) -> Result<(), FormatError> {
    check_table(Lists { source, symbols: &symbols(entries) }, entries)
}

/// Text of a document, and its symbols with units.
#[derive(Clone, Copy)]
struct Lists<'a> {
    source: Source<'a>,
    symbols: &'a [&'a str],
}

/// Returns the names of the symbols that have units.
fn symbols(entries: &Entries) -> Vec<&str> {
    let Some(Kind::Table(named)) = entries.get("symbols").map(|entry| &entry.node.kind) else {
        return Vec::new();
    };
    let has_unit = |node: &Node| text(node).is_some_and(|text| !unit_of(text).is_empty());
    named.iter().filter(|(_, entry)| has_unit(&entry.node)).map(|(name, _)| name.as_ref()).collect()
}

fn check_table(lists: Lists<'_>, entries: &Entries) -> Result<(), FormatError> {
    let together: Vec<&Node> =
        TOGETHER.iter().filter_map(|key| entries.get(*key)).map(|entry| &*entry.node).collect();
    let key_of = |node: &Node| {
        let named = TOGETHER.iter().find(|key| entries.get(**key).is_some_and(|e| e.node.span == node.span));
        named.copied().unwrap_or_default()
    };
    alike(lists, key_of, &together)?;
    for (key, entry) in entries {
        match &entry.node.kind {
            Kind::Table(_) if key.as_ref() == APART => {}
            Kind::Table(inner) => check_table(lists, inner)?,
            Kind::List(elements) => list(lists, key, elements)?,
            _ => {}
        }
    }
    Ok(())
}

fn list(lists: Lists<'_>, key: &str, elements: &[Arc<Node>]) -> Result<(), FormatError> {
    let rows = elements.iter().map(|element| match &element.kind {
        Kind::List(row) => row.as_slice(),
        _ => std::slice::from_ref(element),
    });
    let scalars: Vec<&Node> = rows.flatten().map(AsRef::as_ref).collect();
    alike(lists, |_| key, &scalars)?;
    for element in elements {
        if let Kind::Table(inner) = &element.kind {
            check_table(lists, inner)?;
        }
    }
    Ok(())
}

/// Refuses the first number without a unit in a list that has numbers with units, or formulas with
/// units.
fn alike<'a>(
    Lists { source, symbols }: Lists<'_>,
    key_of: impl Fn(&Node) -> &'a str,
    nodes: &[&Node],
) -> Result<(), FormatError> {
    let texts = nodes.iter().filter_map(|node| text(node));
    let is_formula = |text: &&str| {
        measured(text).is_err() && words(&without_sines(text)).any(|word| symbols.contains(&word))
    };
    let beside_formula = || {
        let with = texts.clone().find(is_formula)?;
        let is_nonzero = |text: &&str| bare(text).is_some_and(|value| value != 0.0);
        Some((texts.clone().find(is_nonzero)?, with))
    };
    let Some((without, with)) = bare_beside_units(texts.clone()).or_else(beside_formula) else {
        return Ok(());
    };
    let Some(node) = nodes.iter().find(|node| text(node) == Some(without)) else { return Ok(()) };
    let rule = format!("given with its unit, like the other element \"{}\"", cut(with));
    let value = cut(source.text.get(node.span.clone()).unwrap_or(without));
    let error =
        source.error(node.span.clone(), FormatErrorKind::Value { key: key_of(node).to_owned(), value, rule });
    if is_formula(&with) {
        return Err(error.with_hint("write its unit after the number, both in quotes"));
    }
    let (without, unit) = (without.trim(), unit_of(with));
    let si = measured(with).map(|(_, dimension)| dimension.unit().0).unwrap_or_default();
    Err(error.with_hint(match unit == si || si.is_empty() {
        true => format!("write \"{without} {unit}\""),
        false => format!("write \"{without} {unit}\", or \"{without} {si}\""),
    }))
}

/// Returns a formula without its sines, cosines and tangents, which are plain numbers.
fn without_sines(text: &str) -> String {
    let mut rest = text.to_owned();
    while let Some(start) = ["sin(", "cos(", "tan("].iter().filter_map(|name| rest.find(name)).min() {
        let mut depth = 0;
        let end = rest[start..].char_indices().find(|&(_, c)| {
            depth += i32::from(c == '(') - i32::from(c == ')');
            c == ')' && depth == 0
        });
        let Some((length, _)) = end else { break };
        rest.replace_range(start..=start + length, "1");
    }
    rest
}

/// Returns a number as it is written, with its unit if it has one.
fn text(node: &Node) -> Option<&str> {
    match &node.kind {
        Kind::Text(text) | Kind::Float(text) | Kind::Whole { digits: text, radix: 10 } => Some(text),
        _ => None,
    }
}
