//! TOML document as a tree that owns its text: parsed once, read many times.
//!
//! A node caches the result of its first reading. A modified tree shares all nodes with the
//! original, except the replaced node and its ancestors, whose caches are empty. A later reading
//! therefore recomputes only what depends on the replacement.

use std::any::Any;
use std::collections::BTreeMap;
use std::hash::{Hash as _, Hasher};
use std::ops::Range;
use std::sync::{Arc, OnceLock};

use polhode::body::MassProperties;
use polhode::math::Body;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use crate::unit::Dimension;

/// Value with its place and the cached result of its first reading.
#[derive(Clone, Debug)]
pub struct Node {
    /// Bytes of the value in the text; for a table with a header, bytes of the header.
    pub span: Range<usize>,
    /// Type of the value, with its content.
    pub kind: Kind,
    /// Cached result of the first reading.
    pub known: OnceLock<Known>,
}

/// Type of a value, with its content.
#[derive(Clone, Debug)]
pub enum Kind {
    /// String without its quotes, escapes resolved.
    Text(String),
    /// Integer of any size.
    Whole {
        /// Digits without the prefix of the radix; they may have a sign.
        digits: String,
        /// Base of the digits: 2, 8, 10 or 16.
        radix: u32,
    },
    /// Floating-point number as digits, or `inf` or `nan`.
    Float(String),
    /// Boolean.
    Truth(bool),
    /// Date or time; no key accepts one.
    Date,
    /// Array, also an array of tables.
    List(Vec<Arc<Node>>),
    /// Table, inline or with a header.
    Table(Entries),
    /// Value that replaces the written one.
    Replaced(Replacement),
}

/// Replacement of a written value.
#[derive(Clone, Debug)]
pub enum Replacement {
    /// Number, SI units.
    Number(f64),
    /// Quaternion (w, x, y, z) of a rotation.
    Rotation([f64; 4]),
    /// Name and mass properties of a part of the body, or of all parts together.
    MassProperties(String, MassProperties<Body>),
}

/// Cached result of reading a value.
#[derive(Clone, Debug)]
pub enum Known {
    /// Value in SI units, with its dimension.
    Number(f64, Dimension),
    /// Quaternion (w, x, y, z) of a rotation.
    Rotation([f64; 4]),
    /// Contents of the named file.
    File(Arc<dyn Any + Send + Sync>),
    /// Value made by the reader.
    Value(Arc<dyn Any + Send + Sync>),
}

impl Known {
    /// Returns the contents of the file, or the value that a reader made of it, if that is a `T`.
    pub fn get<T: Any + Send + Sync>(&self) -> Option<Arc<T>> {
        match self {
            Self::File(known) | Self::Value(known) => known.clone().downcast().ok(),
            Self::Number(..) | Self::Rotation(_) => None,
        }
    }
}

/// One step of the path to a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// Key of a table.
    Key(Arc<str>),
    /// Element of an array, from 0.
    Element(usize),
}

/// Path to a value from the root table.
pub type Way = Vec<Step>;

impl Node {
    /// Returns the places of all leaf values below this node.
    pub fn places(&self) -> Vec<usize> {
        let mut places = Vec::new();
        self.each_leaf(&mut |leaf| places.push(leaf.span.start));
        places
    }

    /// Calls `see` with every leaf value below this node, or with the node itself if it is a leaf.
    pub fn each_leaf<'a>(&'a self, see: &mut impl FnMut(&'a Self)) {
        match &self.kind {
            Kind::List(elements) => elements.iter().for_each(|element| element.each_leaf(see)),
            Kind::Table(entries) => entries.values().for_each(|entry| entry.node.each_leaf(see)),
            _ => see(self),
        }
    }

    /// Hashes the content, independent of its place in the text.
    pub fn hash_into(&self, hasher: &mut impl Hasher) {
        match &self.kind {
            Kind::Text(text) | Kind::Float(text) | Kind::Whole { digits: text, .. } => text.hash(hasher),
            Kind::Truth(truth) => truth.hash(hasher),
            Kind::Date | Kind::Replaced(_) => {}
            Kind::List(elements) => elements.iter().for_each(|element| element.hash_into(hasher)),
            Kind::Table(entries) => entries.iter().for_each(|(key, entry)| {
                key.hash(hasher);
                entry.node.hash_into(hasher);
            }),
        }
    }

    /// Returns the name of the file, if the value names a file that has been read.
    pub fn file(&self) -> Option<&str> {
        match (&self.kind, self.known.get()) {
            (Kind::Text(name), Some(Known::File(_))) => Some(name),
            _ => None,
        }
    }
}

/// Values of a table by key.
pub type Entries = BTreeMap<Arc<str>, Entry>;

/// Value with the place of its key.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Bytes of the key in the text.
    pub key: Range<usize>,
    /// Value of the key, with its place.
    pub node: Arc<Node>,
}

/// Replaces the value at the end of a path, if it exists, and clears the caches of all nodes on the
/// path.
pub fn replace(entries: &mut Entries, way: &[Step], replacement: Replacement) {
    let Some((Step::Key(key), mut rest)) = way.split_first() else { return };
    if key.as_ref() == "symbols" {
        // Any value may be a formula with the symbol.
        entries.values_mut().for_each(|entry| forget(&mut entry.node));
    }
    let Some(entry) = entries.get_mut(key) else { return };
    let mut node = Arc::make_mut(&mut entry.node);
    loop {
        node.known = OnceLock::new();
        let Some((step, further)) = rest.split_first() else { break };
        let inside = match (&mut node.kind, step) {
            (Kind::Table(entries), Step::Key(key)) => entries.get_mut(key).map(|entry| &mut entry.node),
            (Kind::List(elements), Step::Element(k)) => elements.get_mut(*k),
            _ => None,
        };
        let Some(inside) = inside else { return };
        (node, rest) = (Arc::make_mut(inside), further);
    }
    node.kind = Kind::Replaced(replacement);
}

/// Clears the caches of a node and of all nodes below it.
fn forget(node: &mut Arc<Node>) {
    let node = Arc::make_mut(node);
    node.known = OnceLock::new();
    match &mut node.kind {
        Kind::Table(entries) => entries.values_mut().for_each(|entry| forget(&mut entry.node)),
        Kind::List(elements) => elements.iter_mut().for_each(forget),
        _ => {}
    }
}

/// Parses a document into a tree.
pub fn parse(text: &str) -> Result<Entries, toml::de::Error> {
    DeTable::parse(text).map(|document| entries(document.get_ref()))
}

fn entries(table: &DeTable<'_>) -> Entries {
    let entry = |(key, value): (&Spanned<DeString<'_>>, _)| {
        (Arc::from(key.get_ref().as_ref()), Entry { key: key.span(), node: node(value) })
    };
    table.iter().map(entry).collect()
}

fn node(value: &Spanned<DeValue<'_>>) -> Arc<Node> {
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
    Arc::new(Node { span: value.span(), kind, known: OnceLock::new() })
}

/// Keys that do not affect how the file named in the same table is read.
const APART: [&str; 6] = ["position", "rotate", "density", "mass", "material", "on"];

/// Copies to a document the files that another one has read, for tables with the same content.
/// These files are not read again, unless the symbols have changed.
pub fn adopt(entries: &mut Entries, from: &Entries) {
    let is_alike = match [&*entries, from].map(|entries| entries.get("symbols")) {
        [Some(mine), Some(theirs)] => same(&mine.node, &theirs.node),
        [mine, theirs] => mine.is_none() && theirs.is_none(),
    };
    if is_alike {
        adopt_table(entries, from);
    }
}

fn adopt_table(entries: &mut Entries, from: &Entries) {
    let telling = |entries: &Entries| -> Vec<(Arc<str>, Arc<Node>)> {
        let told = entries.iter().filter(|(key, _)| !APART.contains(&key.as_ref()));
        told.map(|(key, entry)| (key.clone(), entry.node.clone())).collect()
    };
    let (mine, theirs) = (telling(entries), telling(from));
    let is_alike = mine.len() == theirs.len()
        && mine.iter().zip(&theirs).all(|((key, node), (other, old))| key == other && same(node, old));
    for (key, entry) in entries {
        let Some(old) = from.get(key) else { continue };
        if is_alike && old.node.file().is_some() {
            let known = old.node.known.clone();
            Arc::make_mut(&mut entry.node).known = known;
        } else {
            adopt_node(&mut entry.node, &old.node);
        }
    }
}

fn adopt_node(node: &mut Arc<Node>, from: &Node) {
    match (&mut Arc::make_mut(node).kind, &from.kind) {
        (Kind::Table(entries), Kind::Table(from)) => adopt_table(entries, from),
        (Kind::List(elements), Kind::List(from)) => {
            elements.iter_mut().zip(from).for_each(|(element, from)| adopt_node(element, from));
        }
        _ => {}
    }
}

/// Returns true if two values have the same content.
fn same(a: &Node, b: &Node) -> bool {
    match (&a.kind, &b.kind) {
        (Kind::Text(a), Kind::Text(b)) | (Kind::Float(a), Kind::Float(b)) => a == b,
        (Kind::Whole { digits: a, radix: r }, Kind::Whole { digits: b, radix: s }) => a == b && r == s,
        (Kind::Truth(a), Kind::Truth(b)) => a == b,
        (Kind::List(a), Kind::List(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b)),
        (Kind::Table(a), Kind::Table(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|((k, a), (l, b))| k == l && same(&a.node, &b.node))
        }
        _ => false,
    }
}
