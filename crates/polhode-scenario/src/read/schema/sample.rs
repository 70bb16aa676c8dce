//! Scenario as replaceable values, and its text with the place of each value.

use std::collections::BTreeMap;
use std::ops::Range;

use polhode_source::toml::tree::{self, Entries, Kind, Node};

/// Value of a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Sample {
    /// String, number or boolean in TOML syntax.
    Plain(String),
    /// Elements of an array.
    List(Vec<Self>),
    /// Values by their keys.
    Table(BTreeMap<String, Self>),
}

/// One step of the path from the file to a value; the elements of an array are not distinguished.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Step {
    /// Key of a table.
    Key(String),
    /// All elements of an array.
    Each,
}

/// Text of a sample with the places in it.
#[derive(Debug, Default)]
pub(super) struct Written {
    pub text: String,
    /// Bytes of each value, and the path to it; the file itself has none.
    pub values: Vec<(Range<usize>, Vec<Step>)>,
    /// Bytes of each key, and the path to its value.
    pub keys: Vec<(Range<usize>, Vec<Step>)>,
}

impl Sample {
    /// Creates a string value.
    pub(super) fn text(text: &str) -> Self {
        Self::Plain(format!("\"{text}\""))
    }

    /// Parses TOML into values; `None` if it is not TOML.
    pub(super) fn parse(text: &str) -> Option<Self> {
        tree::parse(text).ok().map(|entries| Self::of_entries(text, &entries))
    }

    fn of_entries(text: &str, entries: &Entries) -> Self {
        let entry = |(key, entry): (&std::sync::Arc<str>, &tree::Entry)| {
            (key.to_string(), Self::of_node(text, &entry.node))
        };
        Self::Table(entries.iter().map(entry).collect())
    }

    fn of_node(text: &str, node: &Node) -> Self {
        match &node.kind {
            Kind::List(elements) => {
                Self::List(elements.iter().map(|element| Self::of_node(text, element)).collect())
            }
            Kind::Table(entries) => Self::of_entries(text, entries),
            Kind::Text(_)
            | Kind::Whole { .. }
            | Kind::Float(_)
            | Kind::Truth(_)
            | Kind::Date
            | Kind::Replaced(_) => Self::Plain(text.get(node.span.clone()).unwrap_or_default().to_owned()),
        }
    }

    /// Returns the value at the end of a path; for an array, that of its first element.
    pub(super) fn get(&self, way: &[Step]) -> Option<&Self> {
        let Some((step, rest)) = way.split_first() else { return Some(self) };
        match (self, step) {
            (Self::Table(entries), Step::Key(key)) => entries.get(key)?.get(rest),
            (Self::List(elements), Step::Each) => elements.first()?.get(rest),
            _ => None,
        }
    }

    /// Returns the sample with another value at the end of a path; its tables and arrays must
    /// exist.
    pub(super) fn with(&self, way: &[Step], value: Self) -> Self {
        let mut changed = self.clone();
        changed.set(way, &Some(value));
        changed
    }

    /// Returns the sample without the value at the end of a path.
    pub(super) fn without(&self, way: &[Step]) -> Self {
        let mut changed = self.clone();
        changed.set(way, &None);
        changed
    }

    fn set(&mut self, way: &[Step], value: &Option<Self>) {
        match (way, self) {
            ([], this) => value.iter().for_each(|value| this.clone_from(value)),
            ([Step::Key(key)], Self::Table(entries)) => {
                match value {
                    Some(value) => entries.insert(key.clone(), value.clone()),
                    None => entries.remove(key),
                };
            }
            ([Step::Key(key), rest @ ..], Self::Table(entries)) => {
                entries.get_mut(key).into_iter().for_each(|inner| inner.set(rest, value));
            }
            ([Step::Each, rest @ ..], Self::List(elements)) => {
                elements.iter_mut().for_each(|element| element.set(rest, value));
            }
            _ => {}
        }
    }

    /// Returns the text with one line for each key of the file.
    pub(super) fn written(&self) -> Written {
        let mut written = Written::default();
        if let Self::Table(entries) = self {
            for (key, value) in entries {
                written.pair(key, value, &mut Vec::new());
                written.text += "\n";
            }
        }
        written
    }
}

impl Written {
    fn pair(&mut self, key: &str, value: &Sample, way: &mut Vec<Step>) {
        way.push(Step::Key(key.to_owned()));
        self.keys.push((self.text.len()..self.text.len() + key.len(), way.clone()));
        self.text += key;
        self.text += " = ";
        self.value(value, way);
        way.pop();
    }

    fn value(&mut self, value: &Sample, way: &mut Vec<Step>) {
        let start = self.text.len();
        match value {
            Sample::Plain(plain) => self.text += plain,
            Sample::List(elements) => {
                self.text += "[";
                way.push(Step::Each);
                for (k, element) in elements.iter().enumerate() {
                    self.text += if k == 0 { "" } else { ", " };
                    self.value(element, way);
                }
                way.pop();
                self.text += "]";
            }
            Sample::Table(entries) => {
                self.text += "{";
                for (k, (key, inner)) in entries.iter().enumerate() {
                    self.text += if k == 0 { " " } else { ", " };
                    self.pair(key, inner, way);
                }
                self.text += " }";
            }
        }
        self.values.push((start..self.text.len(), way.clone()));
    }
}
