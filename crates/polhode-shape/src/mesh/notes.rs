//! Findings of a reader, with counts: a file may repeat an error a million times.

use polhode::body::{Finding, Severity};
use polhode_source::text::escaped;

/// Findings, one for each kind.
#[derive(Debug, Default)]
pub(crate) struct Notes(Vec<Note>);

#[derive(Debug)]
struct Note {
    code: &'static str,
    severity: Severity,
    sentence: [&'static str; 2],
    count: usize,
    first: String,
}

impl Notes {
    /// Adds a note at a place. `sentence` has two forms: for one occurrence, and for several, to
    /// follow their number.
    pub(crate) fn add(
        &mut self,
        code: &'static str,
        severity: Severity,
        sentence: [&'static str; 2],
        place: impl FnOnce() -> String,
    ) {
        match self.0.iter_mut().find(|note| note.code == code && note.sentence == sentence) {
            Some(note) => note.count += 1,
            None => self.0.push(Note { code, severity, sentence, count: 1, first: place() }),
        }
    }

    /// Returns the findings in the order of their first occurrence, with its place.
    pub(crate) fn findings(self) -> Vec<Finding> {
        let finding = |note: Note| {
            let message = match (note.count, note.sentence) {
                (1, [one, _]) => one.to_owned(),
                (count, [_, many]) => format!("{count} {many}"),
            };
            Finding { code: note.code, severity: note.severity, message, place: Some(escaped(&note.first)) }
        };
        self.0.into_iter().map(finding).collect()
    }
}
