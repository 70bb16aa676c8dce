//! A TOML document as a tree that owns its text: it is parsed once, and may be read many times.
//!
//! A node keeps what it was read as, for later readings. A tree in which something is replaced shares all nodes with the first but those above
//! what is replaced, and these know nothing: so a later reading computes what depends on it, and nothing else.

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

/// A value, its place, and what it was read as.
#[derive(Clone, Debug)]
pub struct Node {
    /// Bytes of the text; of a table with a header, the header's.
    pub span: Range<usize>,
    /// Type of the value, with its content.
    pub kind: Kind,
    /// Result of the first reading, kept for later readings.
    pub known: OnceLock<Known>,
}

/// What a value is.
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
    /// Value that takes the place of the written one.
    Replaced(Replacement),
}

/// What stands in the place of what is written.
#[derive(Clone, Debug)]
pub enum Replacement {
    /// A number, SI.
    Number(f64),
    /// The quaternion (w, x, y, z) of a rotation.
    Rotation([f64; 4]),
    /// Of a part of the body, which keeps its name, or of all parts together.
    MassProperties(String, MassProperties<Body>),
}

/// What a value was read as.
#[derive(Clone, Debug)]
pub enum Known {
    /// SI.
    Number(f64, Dimension),
    /// The quaternion (w, x, y, z) of a rotation.
    Rotation([f64; 4]),
    /// What is in the file that it names.
    File(Arc<dyn Any + Send + Sync>),
    /// The value that its reader made of it.
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

/// One step of the way to a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// Key of a table.
    Key(Arc<str>),
    /// Element of an array, from 0.
    Element(usize),
}

/// The way to a value from the file's own table.
pub type Way = Vec<Step>;

impl Node {
    /// The places of the values in it that have no others in them.
    pub fn places(&self) -> Vec<usize> {
        let mut places = Vec::new();
        self.each_leaf(&mut |leaf| places.push(leaf.span.start));
        places
    }

    /// Every value in it, or itself, that has no others in it.
    pub fn each_leaf<'a>(&'a self, see: &mut impl FnMut(&'a Self)) {
        match &self.kind {
            Kind::List(elements) => elements.iter().for_each(|element| element.each_leaf(see)),
            Kind::Table(entries) => entries.values().for_each(|entry| entry.node.each_leaf(see)),
            _ => see(self),
        }
    }

    /// Hashes what it says, wherever it stands.
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

    /// The name of a file, once that was read.
    pub fn file(&self) -> Option<&str> {
        match (&self.kind, self.known.get()) {
            (Kind::Text(name), Some(Known::File(_))) => Some(name),
            _ => None,
        }
    }
}

/// The values of a table by their keys.
pub type Entries = BTreeMap<Arc<str>, Entry>;

/// A value, and where its key stands.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Bytes of the text that the key occupies.
    pub key: Range<usize>,
    /// Value of the key.
    pub node: Arc<Node>,
}

/// Replaces the value at the end of a way, if it is there; what is above it is not known any more.
pub fn replace(entries: &mut Entries, way: &[Step], replacement: Replacement) {
    let Some((Step::Key(key), mut rest)) = way.split_first() else { return };
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

/// The tree of a document.
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

/// Keys of a table that do not change what the file that it names says.
const APART: [&str; 6] = ["position", "rotate", "density", "mass", "material", "on"];

/// Lets a tree know what another has read from files that both name, in tables that say the same of them: they are not read again.
pub fn adopt(entries: &mut Entries, from: &Entries) {
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
        (Kind::Table(entries), Kind::Table(from)) => adopt(entries, from),
        (Kind::List(elements), Kind::List(from)) => {
            elements.iter_mut().zip(from).for_each(|(element, from)| adopt_node(element, from));
        }
        _ => {}
    }
}

/// Whether two values say the same.
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
