//! A plan that names a file of parts, and what that file says besides them: together one set of keys.

use polhode_source::text::cut;
use polhode_source::toml::document;
use polhode_source::toml::reader::Table;
use polhode_source::toml::source::{Rest, Source};
use polhode_source::toml::tree::{self, Entries};
use polhode_source::{FormatError, FormatErrorKind, Place, Spot};

use super::plan::table_file::Sheets;
use super::plan::{self, Plan};

/// A plan that names a file of parts.
pub(crate) struct Naming<'a> {
    pub source: Source<'a>,
    pub entries: &'a Entries,
}

impl Naming<'_> {
    /// The plan with what the file of parts says as TOML, of which no key may be the plan's; `moved` puts an error in that text where its reader looks for it.
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
        // One text, the plan's and the other, in which each keeps its places.
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
                // In a file that one of them names.
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

    /// Is it TOML, and does it say nothing that the plan says?
    fn check(&self, beside: Source<'_>) -> Result<(), FormatError> {
        let entries = document(beside)?;
        let twice = entries.iter().filter(|(key, _)| self.entries.contains_key(*key));
        let Some((key, entry)) = twice.min_by_key(|(_, entry)| entry.key.start) else { return Ok(()) };
        let value = cut(beside.text.get(entry.node.span.clone()).unwrap_or_default());
        let rule = "given in one place: the plan has it too".to_owned();
        let kind = FormatErrorKind::Value { key: key.to_string(), value, rule };
        let error = beside.error(entry.key.clone(), kind);
        let error =
            error.with_hint("a key or a section stands in the plan or in the file of its parts, not in both");
        Err(match self.entries.get(key) {
            Some(entry) => error.named_in(self.source.path, self.source.place(entry.key.clone())),
            None => error,
        })
    }
}
