//! Ear clipping of a polygon in a plane.

use std::collections::VecDeque;

use super::dents::Dents;
use super::turn;

/// Buffers for one polygon, reused for the next.
#[derive(Debug, Default)]
pub(crate) struct Ears {
    /// Previous and next corner of each remaining corner.
    ring: Vec<[u32; 2]>,
    state: Vec<State>,
    dents: Dents,
    /// Corners to be tested.
    waiting: VecDeque<u32>,
    /// Last corner hidden by each reflex corner, as an index into `hidden`.
    hides: Vec<u32>,
    /// Hidden corner, and the index of the previous one hidden by the same reflex corner.
    hidden: Vec<[u32; 2]>,
}

/// State of a corner.
#[derive(Clone, Copy, Debug, Default)]
struct State {
    is_dent: bool,
    is_cut: bool,
    is_waiting: bool,
    /// True if a neighbour was cut in this round.
    is_late: bool,
}

const NONE: u32 = u32::MAX;

/// Maximum number of search steps per corner; far more than real faces need, and a limit for
/// malicious ones.
const PATIENCE: u64 = 4096;

/// Maximum number of steps for one polygon, independently of its corners; a few seconds.
const MOST_STEPS: u64 = 1 << 29;

impl Ears {
    /// Emits all n − 2 triangles by point indices. Returns true if they do not overlap.
    pub(crate) fn cut(&mut self, points: &[[f64; 2]], mut give: impl FnMut([u32; 3])) -> bool {
        let n = points.len() as u32;
        self.start(points);
        let mut steps = PATIENCE.saturating_mul(n.into()).min(MOST_STEPS);
        let (mut left, mut k, mut is_clean) = (n, 0, true);
        while left > 3 && steps > 0 {
            let next = self.waiting.pop_front();
            let is_forced = next.is_none();
            match next {
                Some(next) => k = next,
                // The polygon intersects itself, or touches itself where no ear can be cut.
                None => is_clean = false,
            }
            let state = &mut self.state[k as usize];
            state.is_waiting = false;
            if state.is_cut || state.is_dent && !is_forced {
                continue;
            }
            if state.is_late && !is_forced {
                state.is_late = false;
                self.wait(k);
                continue;
            }
            let [a, c] = self.ring[k as usize];
            let obstacle = if is_forced { None } else { self.dents.inside(points, [a, k, c], &mut steps) };
            if let Some(dent) = obstacle {
                self.hidden.push([k, self.hides[dent as usize]]);
                self.hides[dent as usize] = self.hidden.len() as u32 - 1;
                continue;
            }
            give([a, k, c]);
            left -= 1;
            (self.ring[a as usize][1], self.ring[c as usize][0]) = (c, a);
            self.state[k as usize].is_cut = true;
            self.dent_is_gone(k);
            for neighbour in [a, c] {
                self.state[neighbour as usize].is_late = true;
                // The corner may turn left now. The converse happens only in a self-intersecting
                // polygon.
                if self.state[neighbour as usize].is_dent && !self.is_dent(points, neighbour) {
                    self.state[neighbour as usize].is_dent = false;
                    self.dent_is_gone(neighbour);
                }
                self.wait(neighbour);
            }
            k = c;
        }
        // The remaining corners, usually a triangle, form a fan.
        while self.state[k as usize].is_cut {
            k = self.ring[k as usize][1];
        }
        let [_, mut b] = self.ring[k as usize];
        for _ in 2..left {
            let [_, c] = self.ring[b as usize];
            give([k, b, c]);
            b = c;
        }
        is_clean && left <= 3
    }

    fn start(&mut self, points: &[[f64; 2]]) {
        let n = points.len() as u32;
        self.ring.clear();
        self.ring.extend((0..n).map(|k| [(k + n - 1) % n, (k + 1) % n]));
        self.state.clear();
        self.state.resize(points.len(), State::default());
        for k in 0..n {
            self.state[k as usize].is_dent = self.is_dent(points, k);
        }
        self.dents.start(points, (0..n).filter(|&k| self.state[k as usize].is_dent));
        self.waiting.clear();
        for k in 0..n {
            self.wait((k + 1) % n);
        }
        self.hides.clear();
        self.hides.resize(points.len(), NONE);
        self.hidden.clear();
    }

    fn is_dent(&self, points: &[[f64; 2]], k: u32) -> bool {
        let [a, c] = self.ring[k as usize];
        !(turn(points[a as usize], points[k as usize], points[c as usize]) > 0.0)
    }

    /// Adds a corner to the end of the queue.
    fn wait(&mut self, k: u32) {
        let state = &mut self.state[k as usize];
        if !(state.is_waiting || state.is_cut || state.is_dent) {
            state.is_waiting = true;
            self.waiting.push_back(k);
        }
    }

    /// Queues the corners that a reflex corner had hidden.
    fn dent_is_gone(&mut self, dent: u32) {
        if self.dents.remove(dent) {
            let mut entry = std::mem::replace(&mut self.hides[dent as usize], NONE);
            while let Some(&[k, before]) = self.hidden.get(entry as usize) {
                self.wait(k);
                entry = before;
            }
        }
    }
}
