//! Repairs: applies the edits of findings to a model's text and leaves every other byte unchanged.

use std::collections::{BTreeMap, BTreeSet};

use crate::finding::{Finding, Repair};
use crate::model::{RobotModel, Span};

/// Text of a model after repairs.
#[derive(Clone, Debug, PartialEq)]
pub struct Repaired {
    pub text: String,
    /// Indices of the findings whose repairs are applied, in the list of findings, ascending.
    pub applied: Vec<usize>,
    /// Findings whose repairs are not applied, with the reason.
    pub left: Vec<Left>,
    /// Number of text positions that changed.
    pub changes: usize,
    /// Replaced spans of the model's text with their new text, ascending and without overlap.
    pub edits: Vec<(Span, String)>,
}

/// Repair that was not applied.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Left {
    /// Index of the finding in the list of findings.
    pub finding: usize,
    pub why: LeftReason,
}

/// Reason why a repair was not applied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeftReason {
    /// The repair overlaps an earlier repair.
    Overlaps,
    /// The edits do not fit the text, or overlap one another.
    Misplaced,
    /// The repair changes an included file.
    Included,
    /// The repair was tried, and the finding remained.
    Fails,
}

impl LeftReason {
    /// Returns the reason in words, to follow "left:".
    pub const fn in_words(self) -> &'static str {
        match self {
            Self::Overlaps => "it overlaps another fix; run --fix again on the result",
            Self::Misplaced => "its edits do not match the text",
            Self::Included => "it is in an included file; fix that file",
            Self::Fails => "it does not remove the finding",
        }
    }
}

/// Applies the repairs of these findings to the model's text.
///
/// A repair is applied completely or not at all. If two repairs change the same place, the first is
/// applied and the second is left; identical edits are applied once. All other bytes are kept: line
/// ends, byte order mark, comments, spaces.
pub fn repaired(model: &RobotModel, findings: &[Finding]) -> Repaired {
    repaired_but(model, findings, &BTreeSet::new())
}

/// Applies repairs as [`repaired`] does, and verifies that every applied repair removes its
/// finding.
///
/// `check` returns the findings of a changed text. Findings are identified by code and subject. If
/// the new text has more of a kind than the repairs leave, no repair of that kind is applied, and
/// the rest is tried again. Also returns the findings of the repaired text.
///
/// # Errors
/// Errors of `check`.
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
        // Permitted number of each kind: the original number minus the number of repairs.
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
        failing.extend(more); // each iteration excludes at least one more repair, so the loop ends
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

/// Applies the repairs of all findings except those known to fail.
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
    Repaired::of(model, edits, applied, left)
}

impl Repaired {
    fn of(model: &RobotModel, edits: Edits, applied: Vec<usize>, left: Vec<Left>) -> Self {
        let text = edits.text(&model.text);
        let edits: Vec<(Span, String)> =
            edits.0.into_iter().map(|((start, end), new)| (start..end, new)).collect();
        Self { text, applied, left, changes: edits.len(), edits }
    }
}

/// Applies edits without findings to the model's own text; `None` if they overlap or do not fit it.
pub(crate) fn edited(model: &RobotModel, edits: Vec<(Span, String)>) -> Option<Repaired> {
    let mut own = Edits::default();
    own.add(&model.text, &Repair { description: String::new(), edits }).ok()?;
    Some(Repaired::of(model, own, Vec::new(), Vec::new()))
}

/// Edits that do not overlap, by start and end of the replaced bytes.
#[derive(Debug, Default)]
struct Edits(BTreeMap<(usize, usize), String>);

impl Edits {
    /// Adds all edits of a repair, or none.
    fn add(&mut self, text: &str, repair: &Repair) -> Result<(), LeftReason> {
        let mut own = Self::default();
        for (span, new) in &repair.edits {
            // `get` refuses spans beyond the text, reversed spans, and spans that split a
            // character.
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

    /// Returns true if a span shares a byte with an edit, or equals its span. The order of two
    /// insertions at one place is undefined.
    fn meets(&self, span: &Span) -> bool {
        let apart = |&(start, end): &(usize, usize)| end <= span.start || span.end <= start;
        let same = self.0.contains_key(&(span.start, span.end));
        // Edits do not overlap. Only the last edit that starts before the end of the span, or one
        // at its start, can meet it.
        same || !self.0.range(..(span.end, 0)).next_back().is_none_or(|(place, _)| apart(place))
    }

    /// Returns the text with the edits applied.
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
