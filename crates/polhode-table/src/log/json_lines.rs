//! JSON lines: one object for each row,
//! `{"t": 0.5, "q": [1, 0, 0, 0], "omega": {"x": 0.1, "y": 2, "z": 0}}`.

use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Mutex;

use polhode_source::json_value;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};
use serde_json::{Map, Value};

use super::blocks::Lines;
use super::choice::{Header, Plan};
use super::columns::Columns;
use super::head::Head;
use super::name::{Kind, Name};
use super::rows::{MOST, Problem, RowError, Rows};

/// Contents of the first lines, and the start of the rows.
#[derive(Debug, Default)]
pub(crate) struct Opening {
    pub head: Head,
    pub header: Header,
    paths: Vec<Path>,
    keys: BTreeSet<String>,
    pub rows: usize,
}

/// Path of a value in an object: `q[0]`, `pose.orientation.w`.
type Path = Vec<Step>;

#[derive(Clone, Debug)]
enum Step {
    Key(String),
    Element(usize),
}

/// Largest number of values in a row.
const MOST_VALUES: usize = 10_000;

/// Reads the lines up to the first row. A first line without a time is the head.
pub(crate) fn opening(bytes: &[u8], columns: &Columns) -> Result<Opening, ContentError> {
    let mut opening =
        Opening { rows: if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 }, ..Opening::default() };
    let mut has_head = false;
    while let Some(line) = next_line(bytes, opening.rows) {
        let place = ContentPlace::Text(line.clone());
        let object = object(&bytes[line.clone()]).map_err(|(at, message)| {
            let kind = ContentErrorKind::Expected {
                what: format!("an object of JSON ({message})"),
                found: shown(&bytes[line.clone()]),
            };
            ContentError::new(kind, ContentPlace::Text((line.start + at).min(line.end)..line.end))
                .hint("a log in JSON lines has one object in each line, and no NaN")
        })?;
        let mut leaves = Vec::new();
        for (key, value) in &object {
            flatten(value, key.clone(), vec![Step::Key(key.clone())], &mut leaves);
        }
        let told = columns.time.as_ref().or(opening.head.columns.as_ref().and_then(|own| own.time.as_ref()));
        let is_time = |name: &String| match told {
            Some(told) => told.columns.contains(name),
            None => Name::of(name).is_some_and(|name| name.kind == Kind::Time),
        };
        if has_head || leaves.iter().any(|(name, _)| is_time(name)) {
            (opening.header.names, opening.paths) = leaves.into_iter().unzip();
            opening.header.spans = vec![line; opening.header.names.len()];
            opening.keys = object.keys().cloned().collect();
            return Ok(opening);
        }
        has_head = true;
        for (key, value) in &object {
            let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
            opening.head.add(key, &text, &place)?;
        }
        opening.rows = line.end;
    }
    let kind = ContentErrorKind::Missing { what: "rows with a time".to_owned() };
    let hint = "a row is an object such as {\"t\": 0.5, \"q\": [1, 0, 0, 0]}";
    Err(ContentError::new(kind, ContentPlace::Whole).hint(hint))
}

/// Returns the next line that is not blank, without white space around it.
fn next_line(bytes: &[u8], from: usize) -> Option<Range<usize>> {
    let rest = bytes.get(from..)?;
    let start = from + rest.iter().position(|b| !b.is_ascii_whitespace())?;
    let length = bytes[start..].iter().position(|b| *b == b'\n').unwrap_or(bytes.len() - start);
    Some(start..start + bytes[start..start + length].trim_ascii_end().len())
}

/// Parses a line as an object. The error has a position and a message.
fn object(line: &[u8]) -> Result<Map<String, Value>, (usize, String)> {
    let value = json_value(line).map_err(|error| {
        let message = error.to_string();
        let message = message.split(" at line ").next().unwrap_or_default();
        (error.column().saturating_sub(1), message.to_owned())
    })?;
    match value {
        Value::Object(object) => Ok(object),
        _ => Err((0, "an object belongs here".to_owned())),
    }
}

/// Collects all values inside a value, with their names.
fn flatten(value: &Value, name: String, path: Path, leaves: &mut Vec<(String, Path)>) {
    let with = |step: Step| [path.as_slice(), &[step]].concat();
    match value {
        _ if leaves.len() >= MOST_VALUES => {}
        Value::Array(elements) => {
            for (k, element) in elements.iter().enumerate() {
                flatten(element, format!("{name}[{k}]"), with(Step::Element(k)), leaves);
            }
        }
        Value::Object(members) => {
            for (key, member) in members {
                flatten(member, format!("{name}.{key}"), with(Step::Key(key.clone())), leaves);
            }
        }
        _ => leaves.push((name, path)),
    }
}

fn shown(line: &[u8]) -> String {
    const MOST: usize = 256;
    String::from_utf8_lossy(&line[..line.len().min(MOST)]).trim().to_owned()
}

/// Rows of a text.
#[derive(Debug)]
pub(crate) struct Objects<'a> {
    plan: &'a Plan,
    /// Path of each slot.
    paths: Vec<&'a [Step]>,
    keys: &'a BTreeSet<String>,
    /// Keys that the first row does not have.
    others: Mutex<BTreeSet<String>>,
}

impl<'a> Objects<'a> {
    pub(crate) fn new(plan: &'a Plan, opening: &'a Opening) -> Self {
        let paths = plan.slots.iter().map(|slot| opening.paths[slot.column].as_slice()).collect();
        Self { plan, paths, keys: &opening.keys, others: Mutex::default() }
    }

    /// Returns keys that some row has and the first row does not have.
    pub(crate) fn others(self) -> BTreeSet<String> {
        self.others.into_inner().unwrap_or_default()
    }

    fn row(&self, line: &[u8], numbers: &mut [f64; MOST]) -> Result<(), (usize, Problem)> {
        let object =
            object(line).map_err(|(at, message)| (at, Problem::NotJson { message, line: shown(line) }))?;
        for (slot, path) in self.paths.iter().enumerate() {
            let value = value(&object, path).ok_or((0, Problem::Missing { slot }))?;
            let not_number = || (0, Problem::NotNumber { slot, found: value.to_string() });
            numbers[slot] = value.as_f64().ok_or_else(not_number)?;
        }
        if object.keys().any(|key| !self.keys.contains(key))
            && let Ok(mut others) = self.others.lock()
        {
            others.extend(object.into_iter().map(|(key, _)| key).filter(|key| !self.keys.contains(key)));
        }
        Ok(())
    }
}

fn value<'v>(object: &'v Map<String, Value>, path: &[Step]) -> Option<&'v Value> {
    let (Step::Key(key), rest) = path.split_first()? else { return None };
    rest.iter().try_fold(object.get(key)?, |value, step| match step {
        Step::Key(key) => value.get(key),
        Step::Element(k) => value.get(k),
    })
}

impl Lines for Objects<'_> {
    fn rows(&self, text: &[u8], offset: usize) -> Result<Rows, RowError> {
        let (mut rows, mut at, mut numbers) = (Rows::default(), 0, [0.0; MOST]);
        while let Some(line) = next_line(text, at) {
            let place = offset + line.start..offset + line.end;
            let read = self.row(&text[line.clone()], &mut numbers);
            let pushed = read.and_then(|()| {
                let numbers = &numbers[..self.plan.slots.len()];
                rows.push(self.plan, numbers, place.clone()).map_err(|problem| (0, problem))
            });
            pushed.map_err(|(within, problem)| RowError {
                row: rows.times.len(),
                place: ContentPlace::Text((place.start + within).min(place.end)..place.end),
                problem,
            })?;
            at = line.end;
        }
        Ok(rows)
    }
}
