//! Plan that refers to a file of parts: its keys and those of the head of that file are joined.

use polhode_source::text::cut;
use polhode_source::toml::document;
use polhode_source::toml::reader::Table;
use polhode_source::toml::source::{Rest, Source};
use polhode_source::toml::tree::{self, Entries};
use polhode_source::{FormatError, FormatErrorKind, Place, Spot};

use super::plan::table_file::Sheets;
use super::plan::{self, Plan};

/// Plan that refers to a file of parts.
pub(crate) struct Naming<'a> {
    pub source: Source<'a>,
    pub entries: &'a Entries,
}

impl Naming<'_> {
    /// Reads the plan, joined with the TOML of the file of parts. No key may be in both. `moved`
    /// changes the position of an error in that TOML to the position in the file.
    pub(crate) fn plan(
        &self,
        beside: Source<'_>,
        sheets: Option<&Sheets<'_>>,
        moved: &dyn Fn(FormatError) -> FormatError,
    ) -> Result<Plan, FormatError> {
        let others = ["parts"];
        if beside.text.trim().is_empty() {
            return plan::plan(&Table::root(self.source, self.entries), &others, sheets);
        }
        self.check(beside).map_err(moved)?;
        // One text with both TOML documents, in which each keeps its positions up to an offset.
        let text = format!("{}\n{}", self.source.text, beside.text);
        let from = text.len() - beside.text.len();
        let padded = format!("{}{}", " ".repeat(from), beside.text);
        let rest = Some(Rest { from, path: beside.path, files: beside.files });
        let source = Source { text: &text, rest, ..self.source };
        let mut entries = self.entries.clone();
        entries.extend(tree::parse(&padded).map_err(|error| source.syntax(&error))?);
        let of_other = |place: &Place| {
            let start = place.span.start.checked_sub(from)?;
            Some(Place::in_text(beside.text, start..place.span.end - from))
        };
        let apart = |error: FormatError| {
            if error.path() != self.source.path {
                // The error is in a file that one of the two refers to.
                return match error.origin().and_then(|(_, place)| of_other(place)) {
                    Some(place) => moved(error.named_in(beside.path, place)),
                    None => error,
                };
            }
            let Some(place) = error.place().and_then(of_other) else { return error };
            let there = FormatError::at(beside.path, Some(Spot::Text(place)), error.kind().clone());
            moved(there.with_hint_of(error.hint()))
        };
        match plan::plan(&Table::root(source, &entries), &others, sheets) {
            Ok(plan) => Ok(plan.moved(apart)),
            Err(error) => Err(apart(error)),
        }
    }

    /// Checks that a text is valid TOML, and that no key is also in the plan.
    fn check(&self, beside: Source<'_>) -> Result<(), FormatError> {
        let entries = document(beside)?;
        let twice = entries.iter().filter(|(key, _)| self.entries.contains_key(*key));
        let Some((key, entry)) = twice.min_by_key(|(_, entry)| entry.key.start) else { return Ok(()) };
        let value = cut(beside.text.get(entry.node.span.clone()).unwrap_or_default());
        let rule = "given only once: the plan has it too".to_owned();
        let kind = FormatErrorKind::Value { key: key.to_string(), value, rule };
        let error = beside.error(entry.key.clone(), kind);
        let error = error.with_hint("write a key or a section in the plan or in the parts file, not in both");
        Err(match self.entries.get(key) {
            Some(entry) => error.named_in(self.source.path, self.source.place(entry.key.clone())),
            None => error,
        })
    }
}
