//! Tables and values of TOML with their position in the file.

mod quantity;

use std::any::Any;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use polhode::body::BodyError;
use polhode::math::RotationError;
use polhode::motion::MotionError;

use super::asked::What;
use super::meant;
use super::source::{Rest, Source};
use super::tree::{Entries, Kind, Known, Node, Replacement};
use crate::expression::ExpressionError;
use crate::files::{Files, NotOpened};
use crate::nearest;
use crate::text::{cut, visible};
use crate::{FormatError, FormatErrorKind, Place};

/// Returns true for a table, and for a list that contains tables.
fn is_table(kind: &Kind) -> bool {
    match kind {
        Kind::Table(_) => true,
        Kind::List(elements) => elements.iter().any(|element| matches!(element.kind, Kind::Table(_))),
        _ => false,
    }
}

/// Table with its place and its name in messages.
#[derive(Clone, Debug)]
pub struct Table<'a> {
    source: Source<'a>,
    entries: &'a Entries,
    span: Range<usize>,
    name: String,
}

impl<'a> Table<'a> {
    /// Creates the root table, the whole file.
    pub fn root(source: Source<'a>, entries: &'a Entries) -> Self {
        Self { source, entries, span: 0..0, name: "the file".to_owned() }
    }

    /// Returns true if the scenario is displayed; the members of a sweep are not.
    pub fn is_shown(&self) -> bool {
        self.source.is_shown
    }

    /// Returns the table with another name for messages.
    pub fn called(self, name: String) -> Self {
        Self { name, ..self }
    }

    /// Refuses the first key that is not in `known`.
    pub fn allow(&self, known: &[&'static str]) -> Result<(), FormatError> {
        self.asks(|| What::Keys(self.name.clone(), known.to_vec()));
        let unknown = self.entries.iter().filter(|(key, _)| !known.contains(&key.as_ref()));
        let Some((key, entry)) = unknown.min_by_key(|(_, entry)| entry.key.start) else { return Ok(()) };
        let key = key.to_string();
        let (suggestion, advice) = match meant::key(&key, known) {
            Some((ours, "")) => (Some(ours), None),
            Some((_, advice)) => (None, Some(advice.to_owned())),
            None => (nearest(&key, known.iter().copied()), None),
        };
        let misplaced = match key.as_str() {
            "title" => Some("write title above the first table".to_owned()),
            // Only a table can be a misplaced top-level table.
            "torque" | "wheel" | "event" | "pointing" if is_table(&entry.node.kind) => {
                Some(format!("write [[{key}]] on a line of its own"))
            }
            key if self.source.headings.contains(&key) && is_table(&entry.node.kind) => {
                Some(format!("write [{key}] on a line of its own"))
            }
            _ => None,
        };
        let kind =
            FormatErrorKind::UnknownKey { key, table: self.name.clone(), suggestion, known: known.to_vec() };
        let error = self.source.error(entry.key.clone(), kind);
        Err(match advice.or(misplaced) {
            Some(hint) => error.with_hint(format!("{hint}; the known keys are {}", known.join(", "))),
            None => error,
        })
    }

    /// Returns the value of a key, if it is present.
    pub fn get(&self, key: &'static str) -> Option<Value<'a>> {
        self.entries.get(key).map(|entry| Value {
            source: self.source,
            key,
            value: &entry.node,
            is_element: false,
        })
    }

    /// Returns the value of a required key.
    pub fn require(&self, key: &'static str, example: &'static str) -> Result<Value<'a>, FormatError> {
        self.asks(|| What::Required(key));
        self.get(key).ok_or_else(|| self.missing(key, example))
    }

    /// Records what the reader accepts here, if the source keeps a record.
    fn asks(&self, what: impl FnOnce() -> What) {
        if let Some(asked) = self.source.asked {
            asked.put(&self.span, what());
        }
    }

    /// Returns every key with its value, in the order of the file; `called` names the values in
    /// messages.
    pub fn each(&self, called: &'static str) -> impl Iterator<Item = (&'a str, Value<'a>)> {
        self.asks(|| What::AnyKeys);
        let source = self.source;
        let mut all: Vec<_> = self.entries.iter().collect();
        all.sort_by_key(|(_, entry)| entry.node.span.start);
        all.into_iter().map(move |(key, entry)| {
            (key.as_ref(), Value { source, key: called, value: &entry.node, is_element: false })
        })
    }

    /// Returns the value of the only present key of several; `None` if none is present.
    pub fn at_most_one(
        &self,
        keys: &[&'static str],
        rule: &'static str,
    ) -> Result<Option<Value<'a>>, FormatError> {
        let mut given: Vec<Value<'a>> = keys.iter().filter_map(|key| self.get(key)).collect();
        given.sort_by_key(|value| value.span().start);
        match given[..] {
            [first, second, ..] => {
                Err(second.error(FormatErrorKind::Conflict { keys: [first.key, second.key], rule }))
            }
            _ => Ok(given.pop()),
        }
    }

    /// Creates the error for a required key that is absent, or misspelt.
    pub fn missing(&self, key: &'static str, example: &'static str) -> FormatError {
        // A key close to the missing one is a misspelling.
        let slip =
            self.entries.iter().find(|(other, _)| other.as_ref() != key && nearest(other, [key]).is_some());
        if let Some((other, entry)) = slip {
            let (table, suggestion) = (self.name.clone(), Some(key));
            let kind =
                FormatErrorKind::UnknownKey { key: other.to_string(), table, suggestion, known: vec![key] };
            return self.source.error(entry.key.clone(), kind).with_hint(format!("did you mean {key}?"));
        }
        self.error(FormatErrorKind::MissingKey { key, table: self.name.clone(), example })
    }

    /// Creates an error at the header of the table.
    pub fn error(&self, kind: FormatErrorKind) -> FormatError {
        self.source.error(self.span.clone(), kind)
    }
}

/// Value with its place, and the key to which it belongs, directly or as an element of an array.
#[derive(Clone, Copy, Debug)]
pub struct Value<'a> {
    source: Source<'a>,
    key: &'static str,
    value: &'a Node,
    is_element: bool,
}

impl<'a> Value<'a> {
    /// Returns the key; an element of an array has the key of the array.
    pub fn key(&self) -> &'static str {
        self.key
    }

    /// Returns the bytes of the text that the value occupies; for a headed table, its header.
    pub fn span(&self) -> Range<usize> {
        self.value.span.clone()
    }

    /// Returns the line and column of the value.
    pub fn place(&self) -> Place {
        self.source.place(self.span())
    }

    /// Returns the text that contains the value, with its path.
    pub fn source(&self) -> Source<'a> {
        self.source
    }

    /// Returns the replacement of the value, if it is replaced.
    pub fn replacement(&self) -> Option<&'a Replacement> {
        match &self.value.kind {
            Kind::Replaced(replacement) => Some(replacement),
            _ => None,
        }
    }

    /// Returns the cached result of an earlier reading.
    pub fn known(&self) -> Option<&'a Known> {
        self.value.known.get()
    }

    /// Returns the cached contents of the named file, or the cached value of its reader, if that is
    /// a `T`.
    pub fn known_as<T: Any + Send + Sync>(&self) -> Option<Arc<T>> {
        self.known().and_then(Known::get)
    }

    /// Caches the result of a reading for later readings.
    pub fn keep(&self, known: Known) {
        // A value that is set already is the same.
        let _ = self.value.known.set(known);
    }

    /// Returns the path of the file that the value names, relative to the file that contains the
    /// value.
    pub fn path(&self) -> Result<PathBuf, FormatError> {
        let name = Path::new(self.string()?);
        let folder = self.rest().map_or(self.source.path, |rest| rest.path).parent();
        let folder = folder.unwrap_or(Path::new(""));
        match self.files().named(folder, name) {
            // The reader of the file reports a missing file.
            Ok(_) | Err(NotOpened::Missing) => Ok(folder.join(name)),
            Err(NotOpened::Outside) => Err(self
                .invalid("a file in the folder of the data file that names it, or below it")
                .with_hint("--root DIR allows files in another folder")),
            Err(NotOpened::NotRegular) => Err(self.invalid("a regular file")),
            Err(NotOpened::NotGiven) => Err(self
                .invalid("a file that was opened or dropped together with the scenario")
                .with_hint("a page can read no other files")),
        }
    }

    /// Returns the source of files for the named file.
    pub fn files(&self) -> &'a dyn Files {
        self.rest().map_or(self.source.files, |rest| rest.files)
    }

    /// Returns the second file of a joined text, if the value is in it.
    fn rest(&self) -> Option<Rest<'a>> {
        self.source.rest.filter(|rest| self.span().start >= rest.from)
    }

    /// Returns true for an array, also for an array of tables.
    pub fn is_array(&self) -> bool {
        self.asks(|| What::PerhapsArray);
        matches!(self.value.kind, Kind::List(_))
    }

    /// Returns the value as a table; a value of another type is an error.
    pub fn table(&self) -> Result<Table<'a>, FormatError> {
        self.asks(|| What::Table);
        match &self.value.kind {
            Kind::Table(entries) => {
                // The name of a headed table is its header, such as `[start]`; of an inline table,
                // its key.
                let text = self.source.text.get(self.span()).unwrap_or_default();
                let name = if text.starts_with('[') { cut(text) } else { self.key.to_owned() };
                Ok(Table { source: self.source, entries, span: self.span(), name })
            }
            _ => Err(self.wrong_type("a table", &self.as_table())),
        }
    }

    /// Returns advice to write a table instead of the value.
    fn as_table(&self) -> String {
        let elements = if let Kind::List(elements) = &self.value.kind { elements.len() } else { 0 };
        let text = self.source.text.get(self.span()).unwrap_or_default();
        match meant::table(self.key, text, elements) {
            _ if self.is_element => meant::element(self.key, text, elements),
            Some(advice) => advice,
            None if self.source.headings.contains(&self.key) => {
                format!("write [{}] on a line of its own, and its keys below", self.key)
            }
            None => self.write("{ key = value }"),
        }
    }

    /// Returns the tables of an array with headers `[[header]]`.
    pub fn tables(&self, header: &str) -> Result<Vec<Table<'a>>, FormatError> {
        self.array_of_tables(header)?.iter().map(Value::table).collect()
    }

    /// Returns the tables of an array with headers `[[header]]` as values.
    pub fn array_of_tables(&self, header: &str) -> Result<Vec<Self>, FormatError> {
        let hint = || format!("write [[{header}]] on a line of its own, once for each");
        let elements = self.elements(&format!("an array of tables: [[{header}]]"));
        let is_table = |value: &Self| matches!(value.value.kind, Kind::Table(_) | Kind::Replaced(_));
        elements
            .and_then(|elements| match elements.iter().find(|element| !is_table(element)) {
                Some(other) => other.table().map(|_| elements),
                None => Ok(elements),
            })
            .map_err(|error| error.with_hint(hint()))
    }

    /// Returns all elements of an array; `expected` describes the array in messages.
    pub fn elements(&self, expected: &str) -> Result<Vec<Self>, FormatError> {
        self.asks(|| What::Array(None));
        self.written_elements(expected)
    }

    fn written_elements(&self, expected: &str) -> Result<Vec<Self>, FormatError> {
        match &self.value.kind {
            Kind::List(elements) => {
                Ok(elements.iter().map(|value| Self { value, is_element: true, ..*self }).collect())
            }
            _ => Err(self.wrong_type(expected, &self.write("[...]"))),
        }
    }

    /// Returns the elements of an array of length N; `of` describes the elements in messages.
    pub fn fixed<const N: usize>(&self, of: &str) -> Result<[Self; N], FormatError> {
        self.asks(|| What::Array(Some(N)));
        let expected = format!("an array of {N} {of}");
        let elements = self.written_elements(&expected)?;
        let found = elements.len();
        let hint = || self.write(&format!("[{}]", ["..."; N].join(", ")));
        elements
            .try_into()
            .map_err(|_| self.mismatch(expected, format!("an array of {found}")).with_hint(hint()))
    }

    /// Returns the value as a string; a value of another type is an error.
    pub fn string(&self) -> Result<&'a str, FormatError> {
        self.asks(|| What::Text);
        self.written_string()
    }

    fn written_string(&self) -> Result<&'a str, FormatError> {
        match &self.value.kind {
            Kind::Text(text) => Ok(text),
            _ => Err(self.wrong_type("a string", "put it in quotes")),
        }
    }

    /// Returns the value as a boolean; a value of another type is an error.
    pub fn boolean(&self) -> Result<bool, FormatError> {
        self.asks(|| What::Truth);
        match &self.value.kind {
            Kind::Truth(value) => Ok(*value),
            _ => Err(self.wrong_type("true or false", &self.write("true"))),
        }
    }

    /// Returns the value, which must be one of several names.
    pub fn choice(&self, names: &[&'static str]) -> Result<&'static str, FormatError> {
        self.named(&names.iter().map(|name| (*name, *name)).collect::<Vec<_>>())
    }

    /// Returns the value assigned to the name; the name must be one of those listed.
    pub fn named<T: Copy>(&self, named: &[(&'static str, T)]) -> Result<T, FormatError> {
        let names: Vec<&'static str> = named.iter().map(|(name, _)| *name).collect();
        self.asks(|| What::Choice(names.clone()));
        let text = self.written_string()?;
        match named.iter().find(|(name, _)| *name == text) {
            Some((_, value)) => Ok(*value),
            None => {
                let error = self.invalid(format!("one of {}", names.join(", ")));
                let near =
                    || nearest(text, names.iter().copied()).map(|name| format!("did you mean \"{name}\"?"));
                let only = || {
                    names.first().filter(|_| names.len() == 1).map(|name| self.write(&format!("\"{name}\"")))
                };
                let hint = meant::name(text, &names).or_else(near).or_else(only);
                Err(error.with_hint_of(hint))
            }
        }
    }

    /// Returns the value as a nonnegative integer.
    pub fn count(&self) -> Result<u64, FormatError> {
        self.asks(|| What::Count);
        match &self.value.kind {
            Kind::Whole { digits, radix } => u64::from_str_radix(digits, *radix)
                .map_err(|_| self.invalid("a whole number, not negative, below 2^64"))
                .map_err(|error| error.with_hint(self.write("1000"))),
            _ => Err(self.wrong_type("a whole number", &self.write("1000"))),
        }
    }

    /// Returns the elements of N rows of K, where K is two or three.
    pub fn rows<const N: usize, const K: usize>(&self) -> Result<[[Self; K]; N], FormatError> {
        let mut rows = [[*self; K]; N];
        let of = if K == 2 { "rows of two" } else { "rows of three" };
        for (slot, row) in rows.iter_mut().zip(self.fixed::<N>(of)?) {
            *slot = row.fixed("values")?;
        }
        Ok(rows)
    }

    /// Creates an error at the place of the value.
    pub fn error(&self, kind: FormatErrorKind) -> FormatError {
        self.source.error(self.span(), kind)
    }

    /// Creates an error in a formula, at its place in the string; for a string with escapes, at the
    /// string.
    pub fn formula(&self, error: ExpressionError) -> FormatError {
        self.source.formula(self.span(), self.written_string().unwrap_or_default(), error)
    }

    /// Creates an error about mass properties at the place of the value.
    pub fn body(&self, error: BodyError) -> FormatError {
        self.error(FormatErrorKind::Body(error))
    }

    /// Creates an error about a motion at the place of the value.
    pub fn motion(&self, error: MotionError) -> FormatError {
        self.error(FormatErrorKind::Motion(error))
    }

    /// Creates an error about a rotation at the place of the value.
    pub fn rotation(&self, error: RotationError) -> FormatError {
        self.error(FormatErrorKind::Rotation(error))
    }

    /// Creates an error for a value that breaks a rule; the message quotes the value from the file.
    pub fn invalid(&self, rule: impl Into<String>) -> FormatError {
        let value = cut(&self.source.current(self.value)).chars().map(visible).collect();
        self.error(FormatErrorKind::Value { key: self.key.to_owned(), value, rule: rule.into() })
    }

    /// Records what the reader accepts here, if the source keeps a record.
    fn asks(&self, what: impl FnOnce() -> What) {
        if let Some(asked) = self.source.asked {
            asked.put(&self.value.span, what());
        }
    }

    /// Returns the advice to write something else in place of the value.
    fn write(&self, what: &str) -> String {
        if self.is_element { format!("write {what}") } else { format!("write {} = {what}", self.key) }
    }

    fn wrong_type(&self, expected: &str, hint: &str) -> FormatError {
        let found = match &self.value.kind {
            Kind::Text(_) => "a string",
            Kind::Whole { .. } | Kind::Float(_) => "a number",
            Kind::Truth(_) => "true or false",
            Kind::Date => "a date",
            Kind::List(_) => "an array",
            Kind::Table(_) => "a table",
            Kind::Replaced(Replacement::Number(_)) => "a number",
            Kind::Replaced(_) => "a value in its place",
        };
        self.mismatch(expected.to_owned(), found.to_owned()).with_hint(hint)
    }

    fn mismatch(&self, expected: String, found: String) -> FormatError {
        self.error(FormatErrorKind::WrongType { key: self.key.to_owned(), expected, found })
    }
}

/// Reads one number from each of N values; stops at the first error.
pub fn each<'a, const N: usize>(
    values: [Value<'a>; N],
    read: impl Fn(&Value<'a>) -> Result<f64, FormatError>,
) -> Result<[f64; N], FormatError> {
    let mut numbers = [0.0; N];
    for (number, value) in numbers.iter_mut().zip(&values) {
        *number = read(value)?;
    }
    Ok(numbers)
}
