//! Pairs of points that are near each other.

use super::threads::Threads;

/// Pairs of points at most some distance apart.
#[derive(Debug)]
pub(super) struct ClosePairs {
    /// Their numbers, ascending, each pair once.
    pub(super) pairs: Vec<[u32; 2]>,
    /// False if there were more than are worth having.
    pub(super) complete: bool,
}

/// Points of a box that is gone through pair by pair.
const FEW: usize = 32;

/// Boxes before they are given to threads.
const TASKS: usize = 64;

/// Pairs that are worth having: to a point, and more to all. A mesh whose every triangle was torn off has 5 for each 2 points, and 2 million where
/// 2,000 triangles meet.
const EACH: usize = 16;
const SOME: usize = 2_000_000;

/// Pairs of points among which there are too many that are kept as examples.
const EXAMPLES: usize = 10_000;

impl ClosePairs {
    /// The pairs of different points; the same for any number of threads.
    ///
    /// A box is cut in two across its longest side, and what is near the cut belongs to both halves: a close pair is whole in one of them.
    pub(super) fn of(points: &[[f64; 3]], reach: f64, threads: Threads) -> Self {
        let search = Search { points, reach };
        let mut tasks = vec![(0..points.len() as u32).collect::<Vec<u32>>()];
        let mut whole = Vec::new();
        while !tasks.is_empty() && tasks.len() + whole.len() < TASKS {
            let mut next = Vec::new();
            for task in tasks {
                match search.halves(&task) {
                    Some(halves) => next.extend(halves),
                    None => whole.push(task),
                }
            }
            tasks = next;
        }
        tasks.extend(whole);
        let found = threads.map(tasks.len(), |k| {
            let mut pairs = Vec::new();
            let complete = search.gather(&tasks[k], most(tasks[k].len()), &mut pairs);
            if !complete {
                pairs.truncate(EXAMPLES);
                pairs.shrink_to_fit();
            }
            (pairs, complete)
        });
        let complete = found.iter().all(|(_, complete)| *complete);
        let mut pairs: Vec<_> = found.into_iter().flat_map(|(pairs, _)| pairs).collect();
        pairs.sort_unstable();
        pairs.dedup();
        Self { complete: complete && pairs.len() <= most(points.len()), pairs }
    }
}

/// Pairs of so many points that are worth having.
const fn most(points: usize) -> usize {
    EACH * points + SOME
}

struct Search<'a> {
    points: &'a [[f64; 3]],
    reach: f64,
}

impl Search<'_> {
    /// The longest side of the points' box: along which axis, from where, how long.
    fn longest(&self, task: &[u32]) -> (usize, f64, f64) {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for p in task.iter().map(|&i| self.points[i as usize]) {
            low = core::array::from_fn(|k| low[k].min(p[k]));
            high = core::array::from_fn(|k| high[k].max(p[k]));
        }
        let sides = (0..3).map(|k| (k, low[k], high[k] - low[k]));
        sides.max_by(|a, b| a.2.total_cmp(&b.2)).unwrap_or((0, 0.0, 0.0))
    }

    /// Two halves, unless the points are few, or so near each other that it does not help.
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

    /// Adds the pairs of some points; false if there are more than `most`.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_close_pair_is_found_once() {
        let mut seed = 7_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let points: Vec<[f64; 3]> = (0..900).map(|_| [random(), 0.3 * random(), random().powi(3)]).collect();
        let reach = 0.031;
        let mut all = Vec::new();
        for i in 0..points.len() {
            for j in i + 1..points.len() {
                if distance(points[i], points[j]) <= reach {
                    all.push([i as u32, j as u32]);
                }
            }
        }
        assert!(all.len() > 500, "{}", all.len());
        for threads in [1, 3] {
            let found = ClosePairs::of(&points, reach, Threads::of(threads));
            assert!(found.complete && found.pairs == all, "{threads}");
        }
    }
}
