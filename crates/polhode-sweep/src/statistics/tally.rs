//! Results of one pass: counts, moments, extremes.

use std::collections::BTreeMap;
use std::ops::Range;

use super::answers::Answers;
use super::sample::Sampled;
use super::{Design, values_of};
use crate::batch::{Batch, MEMBER, Values};
use crate::error::SweepError;
use crate::plan::Plan;

/// Maximum number of failures in a summary.
const SHOWN: usize = 5;

/// Name of the column with causes of failures.
const CAUSE: &str = "cause";

/// Maximum number of different texts counted in a column.
const MOST_TEXTS: usize = 1000;

/// Results of one pass.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    /// Counts and moments of all members.
    pub(super) all: Set,
    /// First members that failed, with the cause.
    pub(super) failures: Vec<(u64, String)>,
    pub(super) sample: Sampled,
    /// Answers to each question.
    pub(super) answers: Vec<Answers>,
    /// Counts and moments of each set, if there are several.
    pub(super) sets: BTreeMap<u64, Set>,
}

/// Counts and moments of some members.
#[derive(Clone, Debug, Default)]
pub(super) struct Set {
    /// Moments of each column of numbers.
    pub(super) moments: Vec<Moments>,
    /// Number of members with each text, by column.
    pub(super) texts: BTreeMap<String, BTreeMap<String, u64>>,
}

impl Set {
    /// Returns the number of members with a text in a column.
    pub(super) fn count(&self, column: &str, text: &str) -> u64 {
        self.texts.get(column).and_then(|counts| counts.get(text)).copied().unwrap_or(0)
    }
}

/// Moments of values: count, mean, Σ (x − mean)², smallest and largest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moments {
    pub(super) count: u64,
    pub(super) mean: f64,
    squares: f64,
    pub(super) min: f64,
    pub(super) max: f64,
}

impl Tally {
    /// Computes the results for the rows of a part.
    pub(super) fn of(batch: &Batch, names: &[&str], plan: &Plan, design: Design) -> Result<Self, SweepError> {
        let members = plan.members();
        let answers: Vec<_> = plan.questions().iter().map(|condition| condition.answers(batch)).collect();
        let mut tally = Self {
            all: Set::of(batch, names, 0..batch.rows()),
            sample: Sampled::of(batch, names, members, &answers),
            ..Self::default()
        };
        let Values::Whole(numbers) = &batch.column(MEMBER)?.values else { return Ok(tally) };
        tally.answers = answers.iter().map(|all| Answers::of(all, numbers, members, design)).collect();
        let mut first = 0;
        for same in numbers.chunk_by(|a, b| design.set(*a) == design.set(*b)) {
            let rows = first..first + same.len();
            first = rows.end;
            if let (Design::Sets { .. }, Some(member)) = (design, same.first()) {
                tally.sets.insert(design.set(*member), Set::of(batch, names, rows));
            }
        }
        if let Ok(Values::Text(causes)) = batch.column(CAUSE).map(|column| &column.values) {
            let causes = numbers.iter().zip(causes);
            let causes = causes.filter_map(|(member, cause)| Some((*member, cause.clone()?)));
            tally.failures = causes.take(SHOWN).collect();
        }
        Ok(tally)
    }

    /// Adds the results of the following parts.
    pub(super) fn merge(mut self, other: Self) -> Self {
        self.all.merge(other.all);
        self.answers.iter_mut().zip(&other.answers).for_each(|(mine, theirs)| mine.merge(theirs));
        for (set, theirs) in other.sets {
            match self.sets.get_mut(&set) {
                Some(mine) => mine.merge(theirs),
                None => {
                    self.sets.insert(set, theirs);
                }
            }
        }
        self.failures.extend(other.failures);
        self.failures.truncate(SHOWN);
        self.sample.append(other.sample);
        self
    }
}

impl Set {
    /// Computes counts and moments of some rows of a part.
    fn of(batch: &Batch, names: &[&str], rows: Range<usize>) -> Self {
        let moments = names.iter().map(|name| Moments::of(|| values_of(batch, name, rows.clone()))).collect();
        let mut texts: BTreeMap<String, BTreeMap<String, u64>> = BTreeMap::new();
        for column in batch.columns().iter().filter(|column| column.name != CAUSE) {
            if let Values::Text(all) = &column.values {
                let counts = texts.entry(column.name.clone()).or_default();
                for text in all.get(rows.clone()).unwrap_or_default().iter().flatten() {
                    match counts.get_mut(text) {
                        Some(count) => *count += 1,
                        None => {
                            counts.insert(text.clone(), 1);
                        }
                    }
                }
            }
        }
        Self { moments, texts }
    }

    fn merge(&mut self, other: Self) {
        for (mine, theirs) in self.moments.iter_mut().zip(&other.moments) {
            *mine = mine.merge(theirs);
        }
        add(&mut self.texts, other.texts);
    }
}

/// Adds the counts of other rows.
fn add(all: &mut BTreeMap<String, BTreeMap<String, u64>>, others: BTreeMap<String, BTreeMap<String, u64>>) {
    for (column, counts) in others {
        let mine = all.entry(column).or_default();
        for (text, count) in counts {
            if mine.len() < MOST_TEXTS || mine.contains_key(&text) {
                *mine.entry(text).or_default() += count;
            }
        }
    }
}

impl Moments {
    pub(super) fn of<I: Iterator<Item = f64>>(values: impl Fn() -> I) -> Self {
        let count = values().count() as u64;
        let mean = if count == 0 { 0.0 } else { sum(values()) / count as f64 };
        let squares = sum(values().map(|x| (x - mean) * (x - mean)));
        let min = values().fold(f64::INFINITY, f64::min);
        let max = values().fold(f64::NEG_INFINITY, f64::max);
        Self { count, mean, squares, min, max }
    }

    /// Combines two sets of values: M = Ma + Mb + δ² na nb / n, δ = mean_b − mean_a (Chan, Golub &
    /// LeVeque 1979).
    pub(super) fn merge(&self, other: &Self) -> Self {
        if other.count == 0 || self.count == 0 {
            return if self.count == 0 { *other } else { *self };
        }
        let count = self.count + other.count;
        let (a, b, n) = (self.count as f64, other.count as f64, count as f64);
        let delta = other.mean - self.mean;
        Self {
            count,
            mean: self.mean + delta * (b / n),
            squares: self.squares + other.squares + delta * delta * (a * (b / n)),
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Returns √(Σ (x − mean)² / (n − 1)); `None` for fewer than two values.
    pub(super) fn standard_deviation(&self) -> Option<f64> {
        (self.count > 1).then(|| (self.squares / (self.count - 1) as f64).sqrt())
    }
}

/// Returns a sum with compensation of rounding errors (Neumaier 1974).
fn sum(values: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut rest) = (0.0_f64, 0.0);
    for x in values {
        let next = sum + x;
        rest += if sum.abs() >= x.abs() { (sum - next) + x } else { (x - next) + sum };
        sum = next;
    }
    if sum.is_finite() { sum + rest } else { sum }
}
