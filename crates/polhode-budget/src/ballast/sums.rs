//! What pieces of given sizes can come to together.

use core::cmp::Reverse;
use std::collections::BinaryHeap;

/// Masses that pieces can come to, ascending from none. Sums nearer than rounding are one; beyond those that are listed every mass is taken for a sum.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sums {
    /// From where to where each is.
    of: Vec<[f64; 2]>,
    /// Of each the last piece and the sum before it, such that there are few pieces and such that there are many.
    last: Vec<[Last; 2]>,
}

/// The number of pieces of a sum, and what it is without the last.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Last {
    pieces: usize,
    before: usize,
    size: f64,
}

/// Sums of a site that are listed.
const LISTED: usize = 4096;

/// Pairs of sums that are added for those of all sites.
const ADDED: usize = 100_000;

/// Sums nearer than this part are one.
const SAME: f64 = 1e-12;

impl Sums {
    /// One of the sizes or none.
    pub(super) fn of_one(sizes: &[f64]) -> Self {
        let last =
            |(before, size): (usize, &f64)| [Last { pieces: before.min(1), before: 0, size: *size }; 2];
        Self {
            of: sizes.iter().map(|size| [*size; 2]).collect(),
            last: sizes.iter().enumerate().map(last).collect(),
        }
    }

    /// Any number of pieces, up to a mass.
    pub(super) fn of_any(sizes: &[f64], most: f64) -> Self {
        let mut all = Self { of: vec![[0.0; 2]], last: vec![[Last::default(); 2]] };
        // The sum to which each size is to be added next: so sums come in their order.
        let mut next = vec![0; sizes.len()];
        loop {
            let sum = |k: usize| all.of[next[k]].map(|sum: f64| sum + sizes[k]);
            let Some(k) = (0..sizes.len()).min_by(|i, j| sum(*i)[0].total_cmp(&sum(*j)[0])) else { break };
            let [low, high] = sum(k);
            if low > most {
                break;
            }
            let before = next[k];
            let last =
                [0, 1].map(|of| Last { pieces: all.last[before][of].pieces + 1, before, size: sizes[k] });
            next[k] += 1;
            if all.joins([low, high]) {
                if let Some(own) = all.last.last_mut() {
                    own[0] = if last[0].pieces < own[0].pieces { last[0] } else { own[0] };
                    own[1] = if last[1].pieces > own[1].pieces { last[1] } else { own[1] };
                }
            } else if all.of.len() < LISTED {
                all.of.push([low.next_down(), high.next_up()]);
                all.last.push(last);
            } else {
                all.of.push([low.next_down(), most]);
                all.last.push(last);
                break;
            }
        }
        all
    }

    /// A sum of each.
    pub(super) fn totals<'a>(all: impl Iterator<Item = &'a Self>) -> Self {
        let none = Self { of: vec![[0.0; 2]], last: Vec::new() };
        all.fold(none, |sum, one| sum.plus(one))
    }

    fn plus(&self, other: &Self) -> Self {
        let mut all = Self { of: Vec::new(), last: Vec::new() };
        let least = |i: usize, j: usize| self.of[i][0] + other.of[j][0];
        // Masses are not negative: their bits are in their order.
        let mut heap: BinaryHeap<Reverse<(u64, usize, usize)>> =
            (0..self.of.len()).map(|i| Reverse((least(i, 0).to_bits(), i, 0))).collect();
        let mut added = 0;
        while let Some(Reverse((_, i, j))) = heap.pop() {
            added += 1;
            if j + 1 < other.of.len() {
                heap.push(Reverse((least(i, j + 1).to_bits(), i, j + 1)));
            }
            let ([a, b], [c, d]) = (self.of[i], other.of[j]);
            if all.joins([a + c, b + d]) {
                continue;
            }
            let [low, high] = if a + c > 0.0 { [(a + c).next_down(), (b + d).next_up()] } else { [0.0; 2] };
            if added >= ADDED {
                all.of.push([low, f64::INFINITY]);
                break;
            }
            all.of.push([low, high]);
        }
        all
    }

    /// Whether a sum, no less than the last, is one with it.
    fn joins(&mut self, [low, high]: [f64; 2]) -> bool {
        match self.of.last_mut() {
            Some(last) if low <= last[1] * (1.0 + SAME) => {
                last[1] = last[1].max(high.next_up());
                true
            }
            _ => false,
        }
    }

    pub(super) fn len(&self) -> usize {
        self.of.len()
    }

    /// Between which masses a sum is.
    pub(super) fn at(&self, index: usize) -> [f64; 2] {
        self.of.get(index).copied().unwrap_or([f64::INFINITY; 2])
    }

    /// The first sum that is not below a mass.
    pub(super) fn first_from(&self, mass: f64) -> usize {
        self.of.partition_point(|[_, high]| *high < mass)
    }

    /// The last sum that is not above a mass.
    pub(super) fn last_to(&self, mass: f64) -> Option<usize> {
        self.of.partition_point(|[low, _]| *low <= mass).checked_sub(1)
    }

    /// The least mass from one on that is a sum.
    pub(super) fn least_from(&self, mass: f64) -> f64 {
        self.at(self.first_from(mass))[0].max(mass)
    }

    /// The sum nearest to a mass, from one to another.
    pub(super) fn nearest(&self, mass: f64, [least, most]: [usize; 2]) -> usize {
        let above = self.first_from(mass).clamp(least, most);
        let below = above.saturating_sub(1).max(least);
        if mass - self.at(below)[1] < self.at(above)[0] - mass { below } else { above }
    }

    /// The pieces of a sum, the greatest first: few, or many.
    pub(super) fn pieces(&self, mut index: usize, many: bool) -> Vec<f64> {
        let mut pieces = Vec::new();
        while let Some(last) = self.last.get(index).map(|last| last[usize::from(many)])
            && last.pieces > 0
        {
            pieces.push(last.size);
            index = last.before;
        }
        pieces.sort_by(|a, b| b.total_cmp(a));
        pieces
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_all_combinations() {
        let sizes = [0.005, 0.012, 0.02];
        let sums = Sums::of_any(&sizes, 0.1);
        let mut all: Vec<f64> = Vec::new();
        for k in 0..=20 {
            for l in 0..=8 {
                for m in 0..=5 {
                    let sum = [k, l, m].iter().zip(sizes).map(|(n, s)| f64::from(*n) * s).sum::<f64>();
                    if sum < 0.1 + 1e-12 && !all.iter().any(|other| (other - sum).abs() < 1e-9) {
                        all.push(sum);
                    }
                }
            }
        }
        all.sort_by(f64::total_cmp);
        assert_eq!(sums.len(), all.len());
        for (k, sum) in all.iter().enumerate() {
            let [low, high] = sums.at(k);
            assert!(low <= *sum + 1e-16 && *sum <= high + 1e-16 && high - low < 1e-14, "{sum} {low} {high}");
            for many in [false, true] {
                let pieces = sums.pieces(k, many);
                assert!(
                    (pieces.iter().sum::<f64>() - sum).abs() < 1e-14
                        && pieces.iter().all(|p| sizes.contains(p))
                );
            }
            assert!(sums.pieces(k, false).len() <= sums.pieces(k, true).len());
        }
        assert_eq!(sums.pieces(sums.first_from(0.06 - 1e-9), false), [0.02; 3]);
        assert_eq!(sums.pieces(sums.first_from(0.06 - 1e-9), true), [0.005; 12]);
    }

    #[test]
    fn what_is_not_listed_may_be_any_mass() {
        let sums = Sums::of_any(&[0.001], 1e3);
        assert_eq!(sums.len(), LISTED + 1);
        assert!((sums.least_from(0.0122) - 0.013).abs() < 1e-15);
        assert_eq!(sums.least_from(7.01234), 7.01234);
        let totals = Sums::totals([Sums::of_one(&[0.0, 0.3, 0.7]), Sums::of_any(&[0.25], 0.6)].iter());
        let want = [0.0, 0.25, 0.3, 0.5, 0.55, 0.7, 0.8, 0.95, 1.2];
        assert_eq!(totals.len(), want.len());
        assert!(want.iter().enumerate().all(|(k, sum)| (totals.at(k)[0] - sum).abs() < 1e-15));
        assert_eq!(totals.least_from(1.3), f64::INFINITY);
    }
}
