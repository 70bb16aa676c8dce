//! Answers to the questions of a plan: number of members that fulfil a condition, and its
//! convergence.

use super::interval;
use super::{CONFIDENCE, Design};
use crate::plan::Condition;
use crate::report::{SweepQuestion, SweepStep};

/// Number of stretches of members for the convergence of a share.
const STEPS: u64 = 64;

/// Number of members that fulfil a condition.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Count {
    pub(super) yes: u64,
    /// Number of members with all columns of the condition.
    pub(super) of: u64,
}

/// Answers to one question, by stretch of members and by set.
#[derive(Clone, Debug, Default)]
pub(super) struct Answers {
    stretches: Vec<Count>,
    sets: Vec<Count>,
}

impl Answers {
    /// Counts the answers of members with these numbers; `None` is not counted.
    pub(super) fn of(answers: &[Option<bool>], numbers: &[u64], members: u64, design: Design) -> Self {
        let steps = STEPS.min(members).max(1);
        let sets = if let Design::Sets { count, .. } = design { count } else { 0 };
        let mut found = Self {
            stretches: vec![Count::default(); steps as usize],
            sets: vec![Count::default(); sets as usize],
        };
        for (member, answer) in numbers.iter().zip(answers) {
            let Some(yes) = *answer else { continue };
            let stretch = (u128::from(*member) * u128::from(steps) / u128::from(members.max(1))) as usize;
            let set = design.set(*member) as usize;
            for count in found.stretches.get_mut(stretch).into_iter().chain(found.sets.get_mut(set)) {
                count.of += 1;
                count.yes += u64::from(yes);
            }
        }
        found
    }

    pub(super) fn merge(&mut self, other: &Self) {
        let add = |mine: &mut Vec<Count>, theirs: &Vec<Count>| {
            for (mine, theirs) in mine.iter_mut().zip(theirs) {
                mine.yes += theirs.yes;
                mine.of += theirs.of;
            }
        };
        add(&mut self.stretches, &other.stretches);
        add(&mut self.sets, &other.sets);
    }

    /// Returns the answer, and its value after each stretch of members.
    pub(super) fn finish(&self, condition: &Condition, members: u64, design: Design) -> SweepQuestion {
        let share = |count: Count| (count.of > 0).then(|| count.yes as f64 / count.of as f64);
        let steps = self.stretches.len() as u64;
        let mut total = Count::default();
        let convergence = (1..=steps).zip(&self.stretches).filter_map(|(k, count)| {
            total = Count { yes: total.yes + count.yes, of: total.of + count.of };
            let interval = (design == Design::Independent).then(|| interval::of_share(total.yes, total.of));
            let members = (u128::from(members) * u128::from(k)).div_ceil(u128::from(steps)) as u64;
            Some(SweepStep { members, share: share(total)?, interval })
        });
        let convergence: Vec<SweepStep> = convergence.collect();
        SweepQuestion {
            name: condition.name.clone(),
            condition: condition.text.clone(),
            count: total.yes,
            of: total.of,
            share: share(total),
            interval: design.share(total, self.sets.iter().copied()).filter(|_| total.of > 0),
            convergence,
        }
    }
}

impl Design {
    /// Returns the confidence interval of a proportion, from all members or from each set.
    pub(super) fn share(self, total: Count, sets: impl Iterator<Item = Count>) -> Option<[f64; 2]> {
        match self {
            Self::Independent => Some(interval::of_share(total.yes, total.of)),
            Self::Sets { .. } => {
                let shares: Vec<f64> =
                    sets.filter(|set| set.of > 0).map(|set| set.yes as f64 / set.of as f64).collect();
                // If all sets agree, they contain no information on rare cases. Use the wider
                // interval of independent members.
                if shares.windows(2).all(|pair| pair[0] == pair[1]) {
                    return (shares.len() > 1).then(|| interval::of_share(total.yes, total.of));
                }
                // Shares of small sets are coarse. Add two sets, with one member more and one
                // member less than the mean.
                let sets = shares.len() as f64;
                let (mean, step) = (shares.iter().sum::<f64>() / sets, sets / total.of as f64);
                let shares = [&shares[..], &[mean - step, mean + step]].concat();
                let [low, high] = interval::of_sets(&shares, CONFIDENCE)?;
                Some([low.max(0.0), high.min(1.0)])
            }
            Self::Fixed => None,
        }
    }
}
