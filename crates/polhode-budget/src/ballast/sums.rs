//! What pieces of given sizes can come to together.

use core::cmp::Reverse;
use std::collections::BinaryHeap;

use super::unit::Unit;

/// Masses that pieces can come to, ascending from none. Sums nearer than rounding are one; beyond those that are listed every multiple of a common unit is taken for a sum, or every mass if sizes have none.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sums {
    /// From where to where each is that is listed.
    listed: Vec<[f64; 2]>,
    /// Of each the last piece and the sum before it, such that there are few pieces and such that there are many.
    last: Vec<[Last; 2]>,
    beyond: Beyond,
    /// The greatest of the sizes.
    largest: f64,
}

/// The number of pieces of a sum, and what it is without the last.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Last {
    pieces: usize,
    before: usize,
    size: f64,
}

/// What is taken for a sum above those that are listed.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Beyond {
    Nothing,
    /// So many multiples of a unit, from one on.
    Multiples {
        unit: Unit,
        from: u64,
        count: usize,
    },
    /// All from one mass to another.
    All([f64; 2]),
}

/// Some pieces of one size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pieces {
    pub(super) size: f64,
    pub(super) count: u64,
}

impl Pieces {
    /// Of all of them.
    pub(super) fn mass(&self) -> f64 {
        self.count as f64 * self.size
    }
}

/// Sums of a site that are listed.
const LISTED: usize = 4096;

/// Pairs of sums that are added for those of all sites.
const ADDED: usize = 100_000;

/// Sums nearer than this part are one.
const SAME: f64 = 1e-12;

/// A sum may be so much more than is allowed, as a part of it: by rounding.
const ROUNDING: f64 = 1e-14;

impl Sums {
    /// One of the sizes or none.
    pub(super) fn of_one(sizes: &[f64]) -> Self {
        let last =
            |(before, size): (usize, &f64)| [Last { pieces: before.min(1), before: 0, size: *size }; 2];
        Self {
            listed: sizes.iter().map(|size| [*size; 2]).collect(),
            last: sizes.iter().enumerate().map(last).collect(),
            beyond: Beyond::Nothing,
            largest: sizes.iter().copied().fold(0.0, f64::max),
        }
    }

    /// Any number of pieces, up to a mass.
    pub(super) fn of_any(sizes: &[f64], most: f64) -> Self {
        let mut all = Self {
            listed: vec![[0.0; 2]],
            last: vec![[Last::default(); 2]],
            beyond: Beyond::Nothing,
            largest: sizes.iter().copied().fold(0.0, f64::max),
        };
        let most = most * (1.0 + ROUNDING);
        // Multiples of one size need no list.
        let listed = if sizes.len() == 1 { 1 } else { LISTED };
        // The sum to which each size is to be added next: so sums come in their order.
        let mut next = vec![0; sizes.len()];
        loop {
            let sum = |k: usize| all.listed[next[k]].map(|sum: f64| sum + sizes[k]);
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
            } else if all.listed.len() < listed {
                all.listed.push([low.next_down(), high.next_up()]);
                all.last.push(last);
            } else {
                all.beyond = Beyond::from(Unit::of(sizes.iter().copied()), [low.next_down(), most]);
                break;
            }
        }
        all
    }

    /// A sum of each, of pieces of all these sizes.
    pub(super) fn totals<'a>(all: impl Iterator<Item = &'a Self>, sizes: impl Iterator<Item = f64>) -> Self {
        let none = Self { listed: vec![[0.0; 2]], last: Vec::new(), beyond: Beyond::Nothing, largest: 0.0 };
        let unit = Unit::of(sizes);
        all.fold(none, |sum, one| sum.plus(one, unit))
    }

    fn plus(&self, other: &Self, unit: Option<Unit>) -> Self {
        let mut all = Self { listed: Vec::new(), last: Vec::new(), beyond: Beyond::Nothing, largest: 0.0 };
        let least = |i: usize, j: usize| self.at(i)[0] + other.at(j)[0];
        // Masses are not negative: their bits are in their order.
        let mut heap = BinaryHeap::from([Reverse((0.0_f64.to_bits(), 0, 0))]);
        let mut added = 0;
        while let Some(Reverse((_, i, j))) = heap.pop() {
            added += 1;
            if j + 1 < other.len() {
                heap.push(Reverse((least(i, j + 1).to_bits(), i, j + 1)));
            }
            if j == 0 && i + 1 < self.len() {
                heap.push(Reverse((least(i + 1, 0).to_bits(), i + 1, 0)));
            }
            let ([a, b], [c, d]) = (self.at(i), other.at(j));
            if all.joins([a + c, b + d]) {
                continue;
            }
            let [low, high] = if a + c > 0.0 { [(a + c).next_down(), (b + d).next_up()] } else { [0.0; 2] };
            let ends = [self, other].map(|sums| sums.at(sums.len() - 1)[1]);
            if added >= ADDED {
                all.beyond = Beyond::from(unit, [low, (ends[0] + ends[1]).next_up()]);
                break;
            }
            all.listed.push([low, high]);
        }
        all
    }

    /// Whether a sum, no less than the last, is one with it.
    fn joins(&mut self, [low, high]: [f64; 2]) -> bool {
        match self.listed.last_mut() {
            Some(last) if low <= last[1] * (1.0 + SAME) => {
                last[1] = last[1].max(high.next_up());
                true
            }
            _ => false,
        }
    }

    pub(super) fn len(&self) -> usize {
        let beyond = match self.beyond {
            Beyond::Nothing => 0,
            Beyond::Multiples { count, .. } => count,
            Beyond::All(_) => 1,
        };
        self.listed.len() + beyond
    }

    /// Between which masses a sum is.
    pub(super) fn at(&self, index: usize) -> [f64; 2] {
        let Some(over) = index.checked_sub(self.listed.len()) else { return self.listed[index] };
        match self.beyond {
            Beyond::Multiples { unit, from, count } if over < count => unit.times(from + over as u64),
            Beyond::All(all) if over == 0 => all,
            _ => [f64::INFINITY; 2],
        }
    }

    /// The first sum that is not below a mass.
    pub(super) fn first_from(&self, mass: f64) -> usize {
        let first = self.listed.partition_point(|[_, high]| *high < mass);
        match self.beyond {
            Beyond::Multiples { unit, from, count } if first == self.listed.len() => {
                first + unit.first_from(mass).saturating_sub(from).min(count as u64) as usize
            }
            Beyond::All([_, most]) if first == self.listed.len() && most < mass => first + 1,
            _ => first,
        }
    }

    /// The last sum that is not above a mass.
    pub(super) fn last_to(&self, mass: f64) -> Option<usize> {
        let last = self.listed.partition_point(|[low, _]| *low <= mass).checked_sub(1)?;
        let beyond = match self.beyond {
            _ if last + 1 < self.listed.len() => 0,
            Beyond::Multiples { unit, from, count } => {
                (unit.last_to(mass) + 1).saturating_sub(from).min(count as u64) as usize
            }
            Beyond::All([least, _]) => usize::from(least <= mass),
            Beyond::Nothing => 0,
        };
        Some(last + beyond)
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

    /// What pieces come to that is near a mass, from one sum to another.
    pub(super) fn near(&self, mass: f64, range: [usize; 2]) -> f64 {
        let index = self.nearest(mass, range);
        let middle = |index: usize| self.at(index).map(|x| 0.5 * x).iter().sum::<f64>();
        if index < self.listed.len() || !matches!(self.beyond, Beyond::All(_)) {
            return middle(index);
        }
        let [least, most] = self.at(index);
        let (mass, top) = (mass.clamp(least, most), self.at(self.listed.len() - 1)[1]);
        let others = ((mass - top) / self.largest).max(0.0).ceil() * self.largest;
        others + middle(self.nearest(mass - others, [0, self.listed.len() - 1]))
    }

    /// The pieces of a mass, the greatest first: few, or many where sums are listed; `None` if it is no sum, or is not known to be one.
    pub(super) fn pieces(&self, mass: f64, many: bool) -> Option<Vec<Pieces>> {
        /// Of the largest pieces that are left out for a sum that is listed, so many fewer are tried.
        const TRIED: u64 = 64;
        let is_same =
            |[low, high]: [f64; 2], rest: f64| rest >= low - SAME * mass && rest <= high + SAME * mass;
        let top = self.listed.last()?[1];
        // Of one size none but nothing is listed.
        let over = if self.beyond == Beyond::Nothing { 0.0 } else { ((mass - top) / self.largest).max(0.0) };
        let counts = if self.listed.len() == 1 {
            [over.round(); 2]
        } else {
            [over.ceil(), over.ceil() + TRIED as f64]
        };
        let mut count = counts[0];
        while count <= counts[1] && count < u64::MAX as f64 {
            let rest = mass - count * self.largest;
            let index = self.nearest(rest.max(0.0), [0, self.listed.len() - 1]);
            if is_same(self.listed[index], rest) {
                let mut all = vec![Pieces { size: self.largest, count: count as u64 }];
                let mut index = index;
                while let Some(last) = self.last.get(index).map(|last| last[usize::from(many)])
                    && last.pieces > 0
                {
                    match all.iter_mut().find(|one| one.size == last.size) {
                        Some(one) => one.count += 1,
                        None => all.push(Pieces { size: last.size, count: 1 }),
                    }
                    index = last.before;
                }
                all.retain(|one| one.count > 0);
                all.sort_by(|a, b| b.size.total_cmp(&a.size));
                return Some(all);
            }
            count += 1.0;
        }
        None
    }
}

impl Beyond {
    fn from(unit: Option<Unit>, [least, most]: [f64; 2]) -> Self {
        let Some(unit) = unit.filter(|unit| unit.counts_to(most)) else { return Self::All([least, most]) };
        let from = unit.first_from(least);
        let count = (unit.last_to(most) + 1).saturating_sub(from);
        if count == 0 { Self::Nothing } else { Self::Multiples { unit, from, count: count as usize } }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may")]
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
            let counts = [false, true].map(|many| {
                let pieces = sums.pieces(*sum, many).unwrap();
                let total: f64 = pieces.iter().map(|p| p.size * p.count as f64).sum();
                assert!((total - sum).abs() < 1e-14 && pieces.iter().all(|p| sizes.contains(&p.size)));
                pieces.iter().map(|p| p.count).sum::<u64>()
            });
            assert!(counts[0] <= counts[1]);
            assert_eq!(sums.pieces(sum + 1e-9, false), None);
        }
        assert_eq!(sums.pieces(0.06, false), Some(vec![Pieces { size: 0.02, count: 3 }]));
        assert_eq!(sums.pieces(0.06, true), Some(vec![Pieces { size: 0.005, count: 12 }]));
    }

    #[test]
    fn sums_that_are_not_listed_are_multiples_of_a_unit() {
        // Of one size, however many there are.
        let sums = Sums::of_any(&[2e-5], 0.3);
        assert_eq!(sums.len(), 15_001);
        assert!((sums.least_from(0.012_21) - 0.012_22).abs() < 1e-15);
        assert_eq!(sums.pieces(0.2, false), Some(vec![Pieces { size: 2e-5, count: 10_000 }]));
        assert_eq!((sums.pieces(0.200_01, false), sums.last_to(0.300_01)), (None, Some(15_000)));
        let sums = Sums::of_any(&[0.001], 1e3);
        assert!((sums.least_from(7.012_34) - 7.013).abs() < 1e-13 && sums.len() == 1_000_001);
        // Of several: the last that is listed is 40.99 kg.
        let sizes = [0.03, 0.05];
        let sums = Sums::of_any(&sizes, 1e3);
        assert!((sums.at(1)[0] - 0.03).abs() < 1e-15 && (sums.least_from(0.061) - 0.08).abs() < 1e-15);
        for mass in [40.0, 41.5, 700.01, 999.99] {
            assert!((sums.least_from(mass - 0.003) - mass).abs() < 1e-11, "{mass}");
            let index = sums.first_from(mass - 0.003);
            assert_eq!(
                (sums.last_to(mass + 0.003), sums.nearest(mass + 0.001, [0, sums.len() - 1])),
                (Some(index), index)
            );
            let pieces = sums.pieces(mass, false).unwrap();
            let total: f64 = pieces.iter().map(|p| p.size * p.count as f64).sum();
            assert!((total - mass).abs() < 1e-11 && pieces.iter().all(|p| sizes.contains(&p.size)));
        }
        // Sizes without a unit: any mass, but what is near it.
        let sizes = [0.001, 0.001 * core::f64::consts::SQRT_2, 0.001 * core::f64::consts::E];
        let sums = Sums::of_any(&sizes, 1.0);
        assert_eq!((sums.len(), sums.least_from(0.7)), (LISTED + 1, 0.7));
        let near = sums.near(0.7, [0, LISTED]);
        assert!((near - 0.7).abs() < 1e-5 && sums.pieces(near, false).is_some());
    }

    #[test]
    fn totals_are_sums_of_each() {
        let parts = [Sums::of_one(&[0.0, 0.3, 0.7]), Sums::of_any(&[0.25], 0.6)];
        let totals = Sums::totals(parts.iter(), [0.3, 0.7, 0.25].into_iter());
        let want = [0.0, 0.25, 0.3, 0.5, 0.55, 0.7, 0.8, 0.95, 1.2];
        assert_eq!(totals.len(), want.len());
        assert!(want.iter().enumerate().all(|(k, sum)| (totals.at(k)[0] - sum).abs() < 1e-14));
        assert_eq!(totals.least_from(1.3), f64::INFINITY);
        // More pairs than are added: multiples of 2 mg.
        let parts = [Sums::of_any(&[1e-5], 10.0), Sums::of_any(&[1.2e-5], 10.0)];
        let totals = Sums::totals(parts.iter(), [1e-5, 1.2e-5].into_iter());
        assert!((totals.least_from(7.000_001_1) - 7.000_002).abs() < 1e-13);
        assert!((totals.least_from(1.1e-5) - 1.2e-5).abs() < 1e-18);
    }
}
