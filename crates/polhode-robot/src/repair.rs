//! Repairs: a model's text with the edits of its findings made, and every other byte as it was.

use std::collections::{BTreeMap, BTreeSet};

use crate::finding::{Finding, Repair};
use crate::model::{RobotModel, Span};

/// A model's text after repairs.
#[derive(Clone, Debug, PartialEq)]
pub struct Repaired {
    /// The whole text.
    pub text: String,
    /// The findings whose repairs are in it, by their place in the list that was given, ascending.
    pub applied: Vec<usize>,
    /// The findings whose repairs are not, and why.
    pub left: Vec<Left>,
    /// Places of the text that were changed.
    pub changes: usize,
    /// What was put in place of which spans of the model's text, ascending; they do not overlap.
    pub edits: Vec<(Span, String)>,
}

/// A repair that was not made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Left {
    /// The finding, by its place in the list that was given.
    pub finding: usize,
    /// Why.
    pub why: LeftReason,
}

/// Why a repair was not made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeftReason {
    /// It changes what an earlier repair has changed.
    Overlaps,
    /// Its edits do not fit the text, or one another.
    Misplaced,
    /// It changes a file that the model includes.
    Included,
    /// It was tried, and the finding was still there.
    Fails,
}

impl LeftReason {
    /// In words, after "left:".
    pub const fn in_words(self) -> &'static str {
        match self {
            Self::Overlaps => "it changes what another repair changes: repair again after this one",
            Self::Misplaced => "its edits do not fit the text",
            Self::Included => "it stands in a file that the model includes: repair that file",
            Self::Fails => "it does not remove the finding",
        }
    }
}

/// The model's text with the repairs of these findings.
///
/// A repair is made whole or not at all. Where two change the same place, the first is made and the second is left; the same
/// edit asked for twice is made once. Every byte that no edit names is kept: line ends, byte order mark, comments, spaces.
pub fn repaired(model: &RobotModel, findings: &[Finding]) -> Repaired {
    repaired_but(model, findings, &BTreeSet::new())
}

/// As [`repaired`], and every repair has removed its finding.
///
/// `check` says what is found in a text in place of the model's. A finding is known again by its code and its subject: if the
/// text has more of these than repairs leave over, none of theirs is made, and the rest is tried again. What is found in the
/// repaired text comes with it.
///
/// # Errors
/// What `check` fails with.
pub fn proved<E>(
    model: &RobotModel,
    findings: &[Finding],
    mut check: impl FnMut(&str) -> Result<Vec<Finding>, E>,
) -> Result<(Repaired, Vec<Finding>), E> {
    let mut failing = BTreeSet::new();
    loop {
        let result = repaired_but(model, findings, &failing);
        if result.applied.is_empty() {
            return Ok((result, findings.to_vec()));
        }
        // How many of each kind there may be: those that were there, less those that are repaired.
        let mut expected = count(findings);
        for finding in result.applied.iter().filter_map(|&k| findings.get(k)) {
            expected.entry(key(finding)).and_modify(|count| *count = count.saturating_sub(1));
        }
        let after = check(&result.text)?;
        let found = count(&after);
        let fails = |k: &usize| {
            let key = findings.get(*k).map(key);
            key.is_some_and(|key| {
                found.get(&key).copied().unwrap_or(0) > expected.get(&key).copied().unwrap_or(0)
            })
        };
        let more: Vec<usize> = result.applied.iter().copied().filter(fails).collect();
        if more.is_empty() {
            return Ok((result, after));
        }
        failing.extend(more); // each turn leaves one repair more: the loop ends
    }
}

fn key(finding: &Finding) -> (&'static str, &str) {
    (finding.code, &finding.subject)
}

fn count(findings: &[Finding]) -> BTreeMap<(&'static str, &str), usize> {
    let mut counts = BTreeMap::new();
    for finding in findings {
        *counts.entry(key(finding)).or_default() += 1;
    }
    counts
}

/// Repairs of all findings but those that are known to fail.
fn repaired_but(model: &RobotModel, findings: &[Finding], failing: &BTreeSet<usize>) -> Repaired {
    let mut edits = Edits::default();
    let (mut applied, mut left) = (Vec::new(), Vec::new());
    for (k, finding) in findings.iter().enumerate() {
        let Some(repair) = &finding.repair else { continue };
        let is_included = repair.edits.iter().any(|(span, _)| model.is_included(span));
        let made = match () {
            () if is_included => Err(LeftReason::Included),
            () if failing.contains(&k) => Err(LeftReason::Fails),
            () => edits.add(&model.text, repair),
        };
        match made {
            Ok(()) => applied.push(k),
            Err(why) => left.push(Left { finding: k, why }),
        }
    }
    let text = edits.text(&model.text);
    let edits: Vec<(Span, String)> =
        edits.0.into_iter().map(|((start, end), new)| (start..end, new)).collect();
    Repaired { text, applied, left, changes: edits.len(), edits }
}

/// Edits that do not overlap, by the bytes that they replace: first, then last.
#[derive(Debug, Default)]
struct Edits(BTreeMap<(usize, usize), String>);

impl Edits {
    /// Adds all edits of a repair, or none.
    fn add(&mut self, text: &str, repair: &Repair) -> Result<(), LeftReason> {
        let mut own = Self::default();
        for (span, new) in &repair.edits {
            // `get` refuses spans beyond the text, backward ones, and those that cut a character
            if text.get(span.clone()).is_none() || own.meets(span) {
                return Err(LeftReason::Misplaced);
            }
            own.0.insert((span.start, span.end), new.clone());
        }
        own.0.retain(|place, new| self.0.get(place) != Some(new));
        if own.0.keys().any(|&(start, end)| self.meets(&(start..end))) {
            return Err(LeftReason::Overlaps);
        }
        self.0.append(&mut own.0);
        Ok(())
    }

    /// True if a span has a byte in common with an edit, or nothing but its place: the order of two insertions is open.
    fn meets(&self, span: &Span) -> bool {
        let apart = |&(start, end): &(usize, usize)| end <= span.start || span.end <= start;
        let same = self.0.contains_key(&(span.start, span.end));
        // Edits do not overlap, so only the last that starts before the end of the span, and those at its start, can meet it.
        same || !self.0.range(..(span.end, 0)).next_back().is_none_or(|(place, _)| apart(place))
    }

    /// The text with the edits made.
    fn text(&self, text: &str) -> String {
        let (mut new, mut done) = (String::with_capacity(text.len()), 0);
        for (&(start, end), replacement) in &self.0 {
            new.push_str(text.get(done..start).unwrap_or_default());
            new.push_str(replacement);
            done = end;
        }
        new.push_str(text.get(done..).unwrap_or_default());
        new
    }
}
