//! The reader's requests for a sample, by the ways to its values.

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
    /// Requests by the way to the value that they are about, in the order of the reader.
    pub asked: HashMap<Vec<Step>, Vec<What>>,
    /// The first error.
    pub refusal: Option<Refusal>,
}

/// An error of the reader.
#[derive(Debug)]
pub(super) struct Refusal {
    /// The way to the value, or to the value of the key, that is refused.
    pub way: Vec<Step>,
    pub kind: FormatErrorKind,
}

impl Answer {
    /// Reads a sample as a scenario file that may name no other file.
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

    /// The requests for the value at the end of a way.
    pub(super) fn at(&self, way: &[Step]) -> &[What] {
        self.asked.get(way).map_or(&[], Vec::as_slice)
    }

    /// The name and the keys of the table at the end of a way; of a table that was asked twice, the later request knows more.
    pub(super) fn keys(&self, way: &[Step]) -> Option<(&str, &[&'static str])> {
        self.at(way).iter().rev().find_map(|what| {
            if let What::Keys(name, keys) = what { Some((name.as_str(), keys.as_slice())) } else { None }
        })
    }

    /// The table whose keys are refused: one is missing, unknown, or excludes another.
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
