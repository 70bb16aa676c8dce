//! Pairs of points that are close together.

use super::threads::Threads;

/// Pairs of points at most a given distance apart.
#[derive(Debug)]
pub(super) struct ClosePairs {
    /// Indices of the two points, the smaller first. The order of the pairs is the same for any
    /// number of threads. A pair may occur more than once.
    pub(super) pairs: Vec<[u32; 2]>,
    /// False if the number of pairs exceeded the limit.
    pub(super) complete: bool,
}

/// Maximum number of points of a box that are compared pair by pair.
const FEW: usize = 32;

/// Number of slabs of boxes that are distributed to threads.
const SLABS: usize = 64;

/// Limit of the number of pairs: `EACH` per point plus `SOME`. A mesh whose triangles are all
/// separate has 5 pairs for every 2 points, and 2 million pairs where 2,000 triangles meet.
const EACH: usize = 16;
const SOME: usize = 2_000_000;

/// Number of pairs kept as examples if the limit is exceeded.
const EXAMPLES: usize = 10_000;

impl ClosePairs {
    /// Returns the pairs of different points; the same for any number of threads.
    ///
    /// Each point is assigned to every box of a grid within half the reach of it. Then both points
    /// of a close pair are in the box that contains their midpoint. The boxes are sized so that
    /// points of a surface leave few in each, and few points are in two boxes.
    pub(super) fn of(points: &[[f64; 3]], reach: f64, threads: Threads) -> Self {
        let search = Search { points, reach };
        let grid = Grid::of(points, reach);
        let slabs = grid.slabs(points);
        let found = threads.map(slabs.len(), |k| {
            let mut entries = slabs[k].clone();
            entries.sort_unstable();
            let most = most(entries.len());
            let mut pairs = Vec::new();
            let mut task = Vec::new();
            let mut boxes = entries.chunk_by(|a, b| a.0 == b.0).filter(|points| points.len() > 1);
            let complete = boxes.all(|points| {
                task.clear();
                task.extend(points.iter().map(|entry| entry.1));
                search.gather(&task, most, &mut pairs)
            });
            if !complete {
                pairs.truncate(EXAMPLES);
                pairs.shrink_to_fit();
            }
            (pairs, complete)
        });
        let complete = found.iter().all(|(_, complete)| *complete);
        let pairs: Vec<_> = found.into_iter().map(|(pairs, _)| pairs).collect::<Vec<_>>().concat();
        Self { complete: complete && pairs.len() <= most(points.len()), pairs }
    }
}

/// Returns the limit of the number of pairs for this number of points.
const fn most(points: usize) -> usize {
    EACH * points + SOME
}

struct Search<'a> {
    points: &'a [[f64; 3]],
    reach: f64,
}

impl Search<'_> {
    /// Returns the longest side of the points' bounding box: axis, lower end and length.
    fn longest(&self, task: &[u32]) -> (usize, f64, f64) {
        let (low, sides) = bounds(task.iter().map(|&i| self.points[i as usize]));
        let sides = (0..3).map(|k| (k, low[k], sides[k]));
        sides.max_by(|a, b| a.2.total_cmp(&b.2)).unwrap_or((0, 0.0, 0.0))
    }

    /// Splits the points into two halves; `None` if they are few or too close together.
    fn halves(&self, task: &[u32]) -> Option<[Vec<u32>; 2]> {
        let (axis, from, length) = self.longest(task);
        if task.len() <= FEW || length <= 4.0 * self.reach {
            return None;
        }
        let middle = from + 0.5 * length;
        let at = |i: &u32| self.points[*i as usize][axis];
        let lower: Vec<u32> = task.iter().copied().filter(|i| at(i) <= middle + self.reach).collect();
        let upper: Vec<u32> = task.iter().copied().filter(|i| at(i) >= middle - self.reach).collect();
        (lower.len() < task.len() && upper.len() < task.len()).then_some([lower, upper])
    }

    /// Adds the close pairs of some points. Returns false if there are more than `most`.
    fn gather(&self, task: &[u32], most: usize, pairs: &mut Vec<[u32; 2]>) -> bool {
        if let Some([lower, upper]) = self.halves(task) {
            return self.gather(&lower, most, pairs) && self.gather(&upper, most, pairs);
        }
        let (axis, ..) = self.longest(task);
        let mut sorted: Vec<_> = task.iter().map(|&i| (self.points[i as usize], i)).collect();
        sorted.sort_unstable_by(|a, b| a.0[axis].total_cmp(&b.0[axis]));
        for (k, &(p, i)) in sorted.iter().enumerate() {
            let near = sorted[k + 1..].iter().take_while(|(q, _)| q[axis] - p[axis] <= self.reach);
            let close = near.filter(|(q, _)| distance(p, *q) <= self.reach);
            pairs.extend(close.map(|&(_, j)| [i.min(j), i.max(j)]));
            if pairs.len() > most {
                return false;
            }
        }
        true
    }
}

pub(super) fn distance(p: [f64; 3], q: [f64; 3]) -> f64 {
    let [x, y, z] = [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    (x * x + y * y + z * z).sqrt()
}

/// Grid of cubic boxes that contains all points.
struct Grid {
    low: [f64; 3],
    side: f64,
    /// Half the reach, increased by 1e-9 (relative).
    half: f64,
}

/// Box, as its three indices packed into one number, and a point that belongs to it.
type Entry = (u64, u32);

/// Bits of a box index along an axis. There are fewer boxes along an axis than the square root of
/// the number of points.
const BITS: u32 = 21;

impl Grid {
    fn of(points: &[[f64; 3]], reach: f64) -> Self {
        let (low, sides) = bounds(points.iter().copied());
        let longest = sides.into_iter().fold(0.0, f64::max);
        let side = (4.0 * reach).max(4.0 * longest / (points.len().max(1) as f64).sqrt());
        Self { low, side, half: 0.5 * reach * (1.0 + 1e-9) }
    }

    /// Returns the first and the last box along an axis within half the reach of a point.
    fn range(&self, p: [f64; 3], axis: usize) -> [u64; 2] {
        let number = |x: f64| (((x - self.low[axis]) / self.side) as u64).min((1 << BITS) - 1);
        [number(p[axis] - self.half), number(p[axis] + self.half)]
    }

    /// Assigns all points to boxes, and the boxes to slabs across the first axis with about equally
    /// many entries.
    fn slabs(&self, points: &[[f64; 3]]) -> Vec<Vec<Entry>> {
        let mut counts: Vec<usize> = Vec::new();
        for &p in points {
            let [first, last] = self.range(p, 0).map(|number| number as usize);
            counts.resize(counts.len().max(last + 1), 0);
            counts[first..=last].iter_mut().for_each(|count| *count += 1);
        }
        let all: usize = counts.iter().sum();
        let mut before = 0;
        let slab_of = counts.iter().map(|count| {
            before += count;
            (before - count) * SLABS / all.max(1)
        });
        let slab_of: Vec<usize> = slab_of.collect();
        let mut slabs = vec![Vec::new(); SLABS];
        for (number, &p) in (0..).zip(points) {
            let [x, y, z] = [0, 1, 2].map(|axis| self.range(p, axis));
            for i in x[0]..=x[1] {
                for j in y[0]..=y[1] {
                    for k in z[0]..=z[1] {
                        slabs[slab_of[i as usize]].push(((i << BITS | j) << BITS | k, number));
                    }
                }
            }
        }
        slabs
    }
}

/// Returns the lowest coordinates of the points, and the sides of their bounding box.
fn bounds(points: impl Iterator<Item = [f64; 3]>) -> ([f64; 3], [f64; 3]) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for p in points {
        low = core::array::from_fn(|k| low[k].min(p[k]));
        high = core::array::from_fn(|k| high[k].max(p[k]));
    }
    (low, core::array::from_fn(|k| high[k] - low[k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_close_pair_is_found() {
        let mut seed = 7_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let spread: Vec<[f64; 3]> = (0..900).map(|_| [random(), 0.3 * random(), random().powi(3)]).collect();
        // Points on box corners, on a line, all in one box, and one pair a million times as far
        // away.
        let grid: Vec<_> = (0..900).map(|k| [f64::from(k % 30), f64::from(k / 30), 0.0]).collect();
        let line: Vec<_> = (0..900).map(|_| [-3.0, random(), 7.0]).collect();
        let far = spread.iter().copied().chain([[3e6; 3], [3e6 + 0.01, 3e6, 3e6]]).collect();
        for (points, reach, least) in [
            (spread.clone(), 0.031, 500),
            (grid, 1.0, 1_700),
            (line, 1e-3, 500),
            (far, 0.031, 500),
            (spread, 2.0, 300_000),
        ] {
            let mut all = Vec::new();
            for i in 0..points.len() {
                for j in i + 1..points.len() {
                    if distance(points[i], points[j]) <= reach {
                        all.push([i as u32, j as u32]);
                    }
                }
            }
            assert!(all.len() > least, "{}", all.len());
            for threads in [1, 3] {
                let mut found = ClosePairs::of(&points, reach, Threads::of(threads));
                found.pairs.sort_unstable();
                found.pairs.dedup();
                assert!(found.complete && found.pairs == all, "{reach} {threads}");
            }
        }
    }
}
