//! Search for the keys of scenario files by means of the reader.
//!
//! A sample is read. In each table that the reader requests, each key is tried with a number. Then
//! it is tried with a string, an array and a table if the reader requests these, and with each name
//! of a choice. If the reader refuses a sample, it is changed according to the error. Samples with
//! new keys are explored in turn.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use polhode_source::FormatErrorKind;
use polhode_source::toml::What;

use super::accepted::Accepted;
use super::answer::Answer;
use super::sample::{Sample, Step};
use super::seeds::seeds;

/// Largest number of changes to a refused sample.
const CHANGES: usize = 16;

/// Returns everything that scenario files accept.
pub(super) fn crawl() -> Accepted {
    let mut crawl = Crawl::default();
    for sample in seeds().iter().filter_map(|seed| Sample::parse(seed)) {
        let answer = Answer::of(&sample);
        crawl.found.add(&sample, &mut Vec::new(), &answer);
        crawl.samples.push_back((sample, answer));
    }
    while let Some((sample, answer)) = crawl.samples.pop_front() {
        crawl.explore(&sample, &answer);
    }
    crawl.found.complete();
    crawl.found
}

/// Type of a value, as far as the reader distinguishes types.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Number,
    Text,
    List,
    Table,
}

#[derive(Debug, Default)]
struct Crawl {
    found: Accepted,
    /// Samples still to be explored.
    samples: VecDeque<(Sample, Answer)>,
    /// Keys with known values: path to the table, name of the table, and key.
    known: BTreeSet<(Vec<Step>, String, &'static str)>,
    /// Names that the reader accepted, with their paths.
    named: BTreeSet<(Vec<Step>, &'static str)>,
}

impl Crawl {
    /// Tries every key and name that the reader requests for a sample.
    fn explore(&mut self, sample: &Sample, answer: &Answer) {
        let mut ways: Vec<&Vec<Step>> = answer.asked.keys().collect();
        ways.sort();
        for way in ways {
            for what in answer.at(way) {
                if let What::Choice(names) = what {
                    names.iter().for_each(|name| self.try_name(sample, way, name));
                }
            }
            if answer.refused_table() == Some(way) {
                continue;
            }
            if answer.at(way).iter().any(|what| matches!(what, What::AnyKeys)) {
                let inside = [&way[..], &[Step::Key("any".to_owned())]].concat();
                self.read(&sample.with(&inside, Sample::text("any")), &inside);
            }
            let Some((name, keys)) = answer.keys(way) else { continue };
            let table = format!("{name} {keys:?}");
            for key in keys {
                let this = (way.clone(), table.clone(), *key);
                let inside = [&way[..], &[Step::Key((*key).to_owned())]].concat();
                if !self.known.contains(&this) && self.try_values(sample, &inside) {
                    self.known.insert(this);
                }
            }
        }
    }

    /// Tries a name in its place, with the keys that it requires.
    fn try_name(&mut self, sample: &Sample, way: &[Step], name: &'static str) {
        let this = (way.to_vec(), name);
        if self.named.contains(&this) {
            return;
        }
        let (sample, answer) = self.read(&sample.with(way, Sample::text(name)), way);
        let refused = answer.refused_table();
        if refused.is_none_or(|table| !way.starts_with(table)) {
            self.named.insert(this);
            self.samples.push_back((sample, answer));
        }
    }

    /// Tries a value of each type that the reader distinguishes; returns true if one was reached.
    fn try_values(&mut self, sample: &Sample, way: &[Step]) -> bool {
        let (mut kinds, mut k, mut is_reached) = (vec![Kind::Number], 0, true);
        let mut scalars: Vec<(Sample, Answer)> = Vec::new();
        while let Some(kind) = kinds.get(k).copied() {
            k += 1;
            let (read, answer) = self.read(&sample.with(way, kind.value()), way);
            // After a table with a missing key, requests are unreliable.
            if answer.at(way).is_empty() || answer.refused_table().is_some_and(|table| way.starts_with(table))
            {
                is_reached &= kind == Kind::List || kind == Kind::Text;
                continue;
            }
            for other in answer.at(way).iter().filter_map(Kind::asked) {
                if !kinds.contains(&other) {
                    kinds.push(other);
                }
            }
            match kind {
                Kind::Number | Kind::Text => scalars.push((read, answer)),
                Kind::List => self.try_elements(&read, way, &answer),
                Kind::Table => self.samples.push_back((read, answer)),
            }
        }
        // Keys that require or exclude this one are tried with it later.
        let accepted = scalars.iter().position(|(_, answer)| answer.refusal.is_none());
        self.samples.extend(scalars.into_iter().nth(accepted.unwrap_or(0)));
        is_reached
    }

    /// Tries an array with elements of each type.
    fn try_elements(&mut self, sample: &Sample, way: &[Step], answer: &Answer) {
        let length = |what: &What| if let What::Array(length) = what { Some(*length) } else { None };
        let lengths = match answer.at(way).iter().rev().find_map(length) {
            Some(Some(length)) => vec![length],
            Some(None) => vec![1, 2],
            None => Vec::new(),
        };
        for length in lengths {
            let list = sample.with(way, Sample::List(vec![Kind::Number.value(); length]));
            self.try_values(&list, &[way, &[Step::Each]].concat());
        }
    }

    /// Reads a sample, changed until the reader reaches the value at the path.
    fn read(&mut self, sample: &Sample, way: &[Step]) -> (Sample, Answer) {
        let mut sample = sample.clone();
        let mut answer = Answer::of(&sample);
        for _ in 0..CHANGES {
            let Some(other) = changed(&sample, &answer, way) else { break };
            sample = other;
            answer = Answer::of(&sample);
        }
        self.found.add(&sample, &mut Vec::new(), &answer);
        (sample, answer)
    }
}

impl Kind {
    fn value(self) -> Sample {
        match self {
            Self::Number => Sample::Plain("1".to_owned()),
            Self::Text => Sample::text("any"),
            Self::List => Sample::List(Vec::new()),
            Self::Table => Sample::Table(BTreeMap::new()),
        }
    }

    /// Returns the type that a request concerns.
    fn asked(what: &What) -> Option<Self> {
        match what {
            What::Text | What::Choice(_) => Some(Self::Text),
            What::Array(_) | What::PerhapsArray => Some(Self::List),
            What::Table | What::Keys(..) | What::AnyKeys | What::Required(_) => Some(Self::Table),
            What::Quantity(_) | What::Number | What::Count | What::Truth => None,
        }
    }
}

/// Returns the sample without the refused key, or with the missing one; the value at the path is
/// kept.
fn changed(sample: &Sample, answer: &Answer, way: &[Step]) -> Option<Sample> {
    let refusal = answer.refusal.as_ref()?;
    let is_kept = |other: &[Step]| way.starts_with(other);
    match &refusal.kind {
        FormatErrorKind::MissingKey { key, example, .. } => with_example(sample, &refusal.way, key, example),
        FormatErrorKind::Conflict { keys, .. } => {
            let (_, table) = refusal.way.split_last()?;
            let ways = keys.map(|key| [table, &[Step::Key(key.to_owned())]].concat());
            let other = ways.iter().rev().find(|way| !is_kept(way))?;
            Some(sample.without(other))
        }
        FormatErrorKind::UnknownKey { .. } if !is_kept(&refusal.way) => Some(sample.without(&refusal.way)),
        FormatErrorKind::Value { rule, .. } if rule.starts_with("left out") && !is_kept(&refusal.way) => {
            Some(sample.without(&refusal.way))
        }
        _ => None,
    }
}

/// Returns the sample with the missing key of a table, from the reader's example.
fn with_example(sample: &Sample, table: &[Step], key: &str, example: &str) -> Option<Sample> {
    // Advice in words may follow the example.
    let cuts = example.match_indices(", ").chain(example.match_indices(" and ")).map(|(at, _)| at);
    let mut ends: Vec<usize> = cuts.chain([example.len()]).collect();
    ends.sort_unstable();
    let parse = |end: &usize| {
        let text = example.get(..*end)?;
        let line = if text.starts_with('{') { format!("{key} = {text}") } else { text.to_owned() };
        Sample::parse(&line)
    };
    let Sample::Table(mut pairs) = ends.iter().rev().find_map(parse)? else { return None };
    // An example `{ body = [0, 0, 1] }` is the table itself.
    if let [Sample::Table(inner)] = pairs.values().collect::<Vec<_>>()[..]
        && inner.contains_key(key)
    {
        pairs = inner.clone();
    }
    let mut with = sample.clone();
    for (key, value) in pairs {
        let way = [table, &[Step::Key(key)]].concat();
        if sample.get(&way).is_none() {
            with = with.with(&way, value);
        }
    }
    (with != *sample).then_some(with)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    #[test]
    fn every_key_is_reached() {
        let mut unknown = Vec::new();
        crawl().unknown("", &mut unknown);
        assert!(unknown.is_empty(), "no sample of `seeds` reaches them: {unknown:#?}");
    }

    #[test]
    fn the_samples_to_begin_with_are_read() {
        let refused = |seed: &String| {
            let sample = Sample::parse(seed).unwrap();
            Answer::of(&sample).refusal.map(|refusal| (seed.clone(), refusal))
        };
        let refused: Vec<_> = seeds().iter().filter_map(refused).collect();
        assert!(refused.is_empty(), "{refused:#?}");
    }
}
