//! Changes of a row.

use polhode_document::number::number;
use serde_json::{Value, json};

/// One change of a row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Change {
    pub row: String,
    /// Name of the change in JSON.
    what: &'static str,
    before: Value,
    after: Value,
    /// Amount of the change, for a change without values before and after.
    by: Value,
    pub words: String,
}

/// Collector of the changes of one row.
pub(crate) struct Changes<'a> {
    pub row: &'a str,
    pub all: &'a mut Vec<Change>,
}

impl Changes<'_> {
    pub(crate) fn pair<T: Into<Value>>(&mut self, what: &'static str, both: [T; 2], words: String) {
        let [before, after] = both.map(Into::into);
        self.all.push(Change { row: self.row.to_owned(), what, before, after, by: Value::Null, words });
    }

    pub(crate) fn by(&mut self, what: &'static str, by: f64, words: String) {
        let (row, by) = (self.row.to_owned(), Value::from(by));
        self.all.push(Change { row, what, before: Value::Null, after: Value::Null, by, words });
    }

    /// Adds a change if two values differ, such as `maturity B to none`.
    pub(crate) fn unequal<T: PartialEq>(
        &mut self,
        [what, called]: [&'static str; 2],
        both: [Option<T>; 2],
        in_words: impl Fn(&T) -> String,
        in_json: impl Fn(&T) -> Value,
    ) {
        if both[0] != both[1] {
            let [before, after] =
                both.each_ref().map(|one| one.as_ref().map_or_else(|| "none".to_owned(), &in_words));
            let values = both.map(|one| one.as_ref().map_or(Value::Null, &in_json));
            self.pair(what, values, format!("{called} {before} to {after}"));
        }
    }
}

impl Change {
    pub(crate) fn to_json(&self) -> Value {
        let Self { row, what, before, after, by, .. } = self;
        json!({ "row": row, "what": what, "before": before, "after": after, "by": by })
    }
}

pub(crate) fn from_to(before: f64, after: f64, unit: &str) -> String {
    format!("{} to {} {unit}, by {} {unit}", number(before, 6), number(after, 6), signed(after - before))
}

pub(crate) fn signed(x: f64) -> String {
    let shown = number(x, 3);
    if x > 0.0 { format!("+{shown}") } else { shown }
}
