//! Order statistics of columns too long to sort: radix selection.
//!
//! The bits of a number are transformed so that integer order equals numerical order. They are
//! determined from the most significant one, eleven in each pass. A pass counts the continuations
//! of all numbers that begin with the bits already known. The cumulative count determines the
//! continuation for a rank.

use super::passes::Parts;
use super::values;
use crate::error::SweepError;

/// Number of bits per pass.
const DIGIT: u32 = 11;
const WAYS: usize = 1 << DIGIT;
/// Number of passes for 64 bits.
const PASSES: u32 = 6;

/// Values of a column at some ranks.
#[derive(Clone, Debug, Default)]
pub(super) struct Selection {
    /// Ranks from 0, ascending, with their values.
    found: Vec<(u64, f64)>,
}

/// Ranks among the numbers that begin with the same bits.
#[derive(Clone, Debug)]
struct Group {
    prefix: u64,
    /// Rank among all numbers, and rank within the group.
    ranks: Vec<(u64, u64)>,
}

impl Selection {
    /// Returns the value at a selected rank.
    pub(super) fn at(&self, rank: u64) -> Option<f64> {
        let k = self.found.binary_search_by_key(&rank, |(rank, _)| *rank).ok()?;
        self.found.get(k).map(|(_, value)| *value)
    }
}

/// Returns the values of each column at its ranks (from 0, ascending, distinct).
pub(super) fn select(
    parts: &Parts<'_>,
    names: &[&str],
    ranks: Vec<Vec<u64>>,
) -> Result<Vec<Selection>, SweepError> {
    let group = |ranks: Vec<u64>| Group { prefix: 0, ranks: ranks.into_iter().map(|r| (r, r)).collect() };
    let mut columns: Vec<Vec<Group>> = ranks
        .into_iter()
        .map(|ranks| if ranks.is_empty() { Vec::new() } else { vec![group(ranks)] })
        .collect();
    for pass in 0..PASSES {
        // Number of bits below those of this pass; the last pass has fewer bits.
        let below = 64_u32.saturating_sub(DIGIT * (pass + 1));
        let width = 64 - DIGIT * pass - below;
        let firsts: Vec<usize> = columns
            .iter()
            .scan(0, |first, groups| {
                let here = *first;
                *first += groups.len();
                Some(here)
            })
            .collect();
        let total: usize = columns.iter().map(Vec::len).sum();
        let counts = parts.counts(total * WAYS, |batch, counts| {
            for ((name, groups), first) in names.iter().zip(&columns).zip(&firsts) {
                if groups.is_empty() {
                    continue;
                }
                for value in values(batch, name) {
                    let bits = key(value) >> below;
                    let (prefix, way) = (bits >> width, (bits & ((1 << width) - 1)) as usize);
                    let Ok(k) = groups.binary_search_by_key(&prefix, |group| group.prefix) else { continue };
                    if let Some(count) = counts.get_mut((first + k) * WAYS + way) {
                        *count += 1;
                    }
                }
            }
        })?;
        let mut histograms = counts.chunks_exact(WAYS);
        for groups in &mut columns {
            let split = groups.iter().zip(histograms.by_ref().take(groups.len()));
            *groups = split.flat_map(|(group, counts)| group.split(counts, width)).collect();
        }
    }
    let found = |groups: Vec<Group>| Selection {
        found: groups
            .into_iter()
            .flat_map(|group| group.ranks.into_iter().map(move |(rank, _)| (rank, number(group.prefix))))
            .collect(),
    };
    Ok(columns.into_iter().map(found).collect())
}

impl Group {
    /// Splits the group by the next bits.
    fn split(&self, counts: &[u64], width: u32) -> Vec<Self> {
        let mut groups: Vec<Self> = Vec::new();
        let mut ranks = self.ranks.iter().peekable();
        let mut before = 0;
        for (way, &count) in counts.iter().enumerate() {
            let mut here = Vec::new();
            while let Some((rank, within)) = ranks.next_if(|(_, within)| *within < before + count) {
                here.push((*rank, within - before));
            }
            if !here.is_empty() {
                groups.push(Self { prefix: (self.prefix << width) | way as u64, ranks: here });
            }
            before += count;
        }
        groups
    }
}

/// Returns bits whose integer order is the numerical order, with −0 before 0.
const fn key(value: f64) -> u64 {
    let bits = value.to_bits();
    if bits >> 63 == 1 { !bits } else { bits | 1 << 63 }
}

/// Returns the number of such bits.
const fn number(key: u64) -> f64 {
    f64::from_bits(if key >> 63 == 1 { key & !(1 << 63) } else { !key })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may")]

    use super::*;
    use crate::batch::{Batch, Column, Values};

    fn batch(values: Vec<Option<f64>>) -> Batch {
        let column = |name: &str, values| Column::new([name, "", ""], values);
        let squares = values.iter().map(|x| x.map_or(-7.0, |x| x * x)).collect();
        Batch::new(vec![column("x", Values::Perhaps(values)), column("y", Values::Numbers(squares))]).unwrap()
    }

    #[test]
    fn ranks_are_those_of_sorting() {
        // Numbers of every magnitude and sign, many duplicates, some missing.
        let mut state = 12_345_u64;
        let mut draw = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64
        };
        let values: Vec<Option<f64>> = (0..5000)
            .map(|k| match k % 7 {
                0 => None,
                1 => Some(draw() % 10.0 - 5.0),
                2 => Some(-1.0 / (1.0 + draw())),
                3 => Some(draw() * 1e-300),
                _ => Some(1.0 + draw() * 1e-12),
            })
            .collect();
        let mut sorted: Vec<f64> = values.iter().flatten().copied().collect();
        sorted.sort_by(f64::total_cmp);
        let read = |part: u64| Ok(batch(values[part as usize * 1000..][..1000].to_vec()));
        let ranks: Vec<u64> = (0..sorted.len() as u64).step_by(61).collect();
        for threads in [1, 3] {
            let parts = Parts { count: 5, threads, read: &read };
            let found = select(&parts, &["x", "y"], vec![ranks.clone(), vec![0]]).unwrap();
            for &rank in &ranks {
                assert_eq!(found[0].at(rank).unwrap().to_bits(), sorted[rank as usize].to_bits());
            }
            assert_eq!((found[0].at(1), found[1].at(0)), (None, Some(-7.0)));
        }
    }
}
