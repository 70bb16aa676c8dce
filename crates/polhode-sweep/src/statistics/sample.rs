//! Sample of the members, chosen by their numbers, for figures and correlations.

use crate::batch::{Batch, MEMBER, Values};
use crate::plan::mix;
use crate::report::SweepSample;

/// Approximate size of the sample.
const SIZE: u64 = 4096;

/// Rows of the sampled members, with their regimes.
#[derive(Clone, Debug, Default)]
pub(super) struct Sampled {
    rows: Vec<Vec<Option<f64>>>,
    regimes: Vec<Option<String>>,
    /// Answers of the sampled members to each question.
    answers: Vec<Vec<Option<bool>>>,
}

impl Sampled {
    /// Samples a part of a sweep with `members` members; `answers` are its rows' answers to each
    /// question.
    pub(super) fn of(batch: &Batch, names: &[&str], members: u64, answers: &[Vec<Option<bool>>]) -> Self {
        let Ok(Values::Whole(numbers)) = batch.column(MEMBER).map(|column| &column.values) else {
            return Self::default();
        };
        let columns: Vec<&Values> =
            names.iter().filter_map(|name| Some(&batch.column(name).ok()?.values)).collect();
        let regime = batch.column("regime").map(|column| &column.values);
        let mut sampled = Self { answers: vec![Vec::new(); answers.len()], ..Self::default() };
        for (row, _) in numbers.iter().enumerate().filter(|(_, number)| is_drawn(**number, members)) {
            for (drawn, all) in sampled.answers.iter_mut().zip(answers) {
                drawn.push(all.get(row).copied().flatten());
            }
            sampled.rows.push(columns.iter().map(|values| values.number(row)).collect());
            sampled.regimes.push(match regime {
                Ok(Values::Text(texts)) => texts.get(row).cloned().flatten(),
                _ => None,
            });
        }
        sampled
    }

    pub(super) fn append(&mut self, other: Self) {
        self.rows.extend(other.rows);
        self.regimes.extend(other.regimes);
        self.answers.iter_mut().zip(other.answers).for_each(|(mine, theirs)| mine.extend(theirs));
    }

    /// Returns the sample in columns.
    pub(super) fn finish(&self, names: &[&str], inputs: &[String]) -> SweepSample {
        let column = |k: usize| self.rows.iter().map(|row| row.get(k).copied().flatten()).collect();
        SweepSample {
            names: names.iter().map(|name| (*name).to_owned()).collect(),
            columns: (0..names.len()).map(column).collect(),
            regimes: self.regimes.clone(),
            inputs: inputs.to_vec(),
            answers: self.answers.clone(),
        }
    }
}

/// Returns true if a member is sampled. A hash of the number decides, because regular steps through
/// a grid would repeat one value of a variable.
fn is_drawn(member: u64, members: u64) -> bool {
    if members <= SIZE {
        return true;
    }
    // Generator SplitMix64.
    mix(member.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15)) < u64::MAX / members * SIZE
}
