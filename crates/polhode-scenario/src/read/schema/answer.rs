//! Requests of the reader for a sample, by the paths to its values.

use std::collections::HashMap;
use std::path::Path;

use polhode_source::FormatErrorKind;
use polhode_source::files::Memory;
use polhode_source::toml::source::Source;
use polhode_source::toml::{Asked, What, tree};

use super::sample::{Sample, Step};
use crate::read::{TOP, file_of_root};

/// Requests of the reader for a sample, and its first error.
#[derive(Debug, Default)]
pub(super) struct Answer {
    /// Requests by the path to their value, in the order of the reader.
    pub asked: HashMap<Vec<Step>, Vec<What>>,
    /// The first error.
    pub refusal: Option<Refusal>,
}

/// Error of the reader.
#[derive(Debug)]
pub(super) struct Refusal {
    /// Path to the refused value, or to the value of the refused key.
    pub way: Vec<Step>,
    pub kind: FormatErrorKind,
}

impl Answer {
    /// Reads a sample as a scenario file that cannot name other files.
    pub(super) fn of(sample: &Sample) -> Self {
        let written = sample.written();
        let (asked, nothing) = (Asked::default(), Memory::default());
        let new = Source::new(&nothing, Path::new("scenario.toml"), &written.text);
        let source = Source { asked: Some(&asked), headings: &TOP, is_shown: false, ..new };
        let Ok(entries) = tree::parse(&written.text) else { return Self::default() };
        let read = file_of_root(source, &entries);
        let mut ways: HashMap<(usize, usize), &[Step]> = HashMap::from([((0, 0), &[][..])]);
        ways.extend(
            written.keys.iter().chain(&written.values).map(|(span, way)| ((span.start, span.end), &way[..])),
        );
        let mut by_way: HashMap<Vec<Step>, Vec<What>> = HashMap::new();
        for question in asked.all() {
            if let Some(way) = ways.get(&(question.span.start, question.span.end)) {
                by_way.entry(way.to_vec()).or_default().push(question.what);
            }
        }
        let refusal = read.err().map(|error| {
            let span = error.place().map(|place| (place.span.start, place.span.end));
            let way = span.and_then(|span| ways.get(&span)).map_or_else(Vec::new, |way| way.to_vec());
            Refusal { way, kind: error.kind().clone() }
        });
        Self { asked: by_way, refusal }
    }

    /// Returns the requests for the value at the end of a path.
    pub(super) fn at(&self, way: &[Step]) -> &[What] {
        self.asked.get(way).map_or(&[], Vec::as_slice)
    }

    /// Returns the name and keys of the table at the end of a path; for a table requested twice,
    /// the later request has more information.
    pub(super) fn keys(&self, way: &[Step]) -> Option<(&str, &[&'static str])> {
        self.at(way).iter().rev().find_map(|what| {
            if let What::Keys(name, keys) = what { Some((name.as_str(), keys.as_slice())) } else { None }
        })
    }

    /// Returns the path to the table with a missing, unknown or conflicting key, if that is the
    /// error.
    pub(super) fn refused_table(&self) -> Option<&[Step]> {
        let Refusal { way, kind } = self.refusal.as_ref()?;
        match kind {
            FormatErrorKind::MissingKey { .. } => Some(way),
            FormatErrorKind::UnknownKey { .. } | FormatErrorKind::Conflict { .. } => {
                way.split_last().map(|(_, table)| table)
            }
            _ => None,
        }
    }
}
