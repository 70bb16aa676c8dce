//! A TOML document as a tree that owns its text: it is parsed once, and may be read many times.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

/// A value and its place.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    /// Bytes of the text; of a table with a header, the header's.
    pub(crate) span: Range<usize>,
    pub(crate) kind: Kind,
}

/// What a value is.
#[derive(Clone, Debug)]
pub(crate) enum Kind {
    Text(String),
    Whole { digits: String, radix: u32 },
    Float(String),
    Truth(bool),
    Date,
    List(Vec<Node>),
    Table(Entries),
}

impl Node {
    /// The places of the values in it that have no others in them.
    pub(crate) fn places(&self) -> Vec<usize> {
        match &self.kind {
            Kind::List(elements) => elements.iter().flat_map(Self::places).collect(),
            Kind::Table(entries) => entries.values().flat_map(|entry| entry.node.places()).collect(),
            _ => vec![self.span.start],
        }
    }
}

/// The values of a table by their keys.
pub(crate) type Entries = BTreeMap<String, Entry>;

/// A value, and where its key stands.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) key: Range<usize>,
    pub(crate) node: Node,
}

/// The tree of a document.
pub(crate) fn parse(text: &str) -> Result<Entries, toml::de::Error> {
    DeTable::parse(text).map(|document| entries(document.get_ref()))
}

fn entries(table: &DeTable<'_>) -> Entries {
    let entry = |(key, value): (&Spanned<DeString<'_>>, _)| {
        (key.get_ref().to_string(), Entry { key: key.span(), node: node(value) })
    };
    table.iter().map(entry).collect()
}

fn node(value: &Spanned<DeValue<'_>>) -> Node {
    let kind = match value.get_ref() {
        DeValue::String(text) => Kind::Text(text.to_string()),
        DeValue::Integer(integer) => {
            Kind::Whole { digits: integer.as_str().to_owned(), radix: integer.radix() }
        }
        DeValue::Float(float) => Kind::Float(float.as_str().to_owned()),
        DeValue::Boolean(truth) => Kind::Truth(*truth),
        DeValue::Datetime(_) => Kind::Date,
        DeValue::Array(elements) => Kind::List(elements.iter().map(node).collect()),
        DeValue::Table(table) => Kind::Table(entries(table)),
    };
    Node { span: value.span(), kind }
}
