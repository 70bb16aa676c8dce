//! Many states at once: side by side in the lanes of vectors.

use crate::math::lanes::Lanes;
use crate::math::rotation::Rotation;
use crate::math::vector::Vector;

use super::FreeMotion;
use super::flow::{Family, Flow, Series, Turned};
use super::kernel::Kernel;
use crate::motion::state::State;

/// States computed side by side: two vectors of AVX-512, four of AVX2, so that one computes while the other waits.
pub(super) const WIDTH: usize = 16;

impl FreeMotion {
    /// The states at many times, in their order: each with the bits that [`FreeMotion::at`] gives, several times as fast.
    #[must_use]
    pub fn at_times(&self, times: &[f64]) -> Vec<State> {
        let mut states = vec![self.start; times.len()];
        self.fill(times, &mut states);
        states
    }

    /// As [`FreeMotion::at_times`], into states that are there already; as many as there are both times and states.
    pub fn fill(&self, times: &[f64], states: &mut [State]) {
        match &self.kernel {
            Kernel::Trigonometric(flow) => fill(self, flow, times, states),
            Kernel::Hyperbolic(flow) => fill(self, flow, times, states),
        }
    }
}

fn fill<S: Family>(motion: &FreeMotion, flow: &Flow<f64, S>, times: &[f64], states: &mut [State]) {
    let lanes =
        Flow::<f64, S>::assembled(&|get: &dyn Fn(&Flow<f64, S>) -> f64| Lanes::<WIDTH>([get(flow); WIDTH]));
    let mut columns = Columns::default();
    for (times, states) in times.chunks(BLOCK).zip(states.chunks_mut(BLOCK)) {
        in_widest_vectors(
            #[inline(always)]
            || {
                if motion.start.time == 0.0 {
                    columns.compute::<true, _>(motion, &lanes, times);
                } else {
                    columns.compute::<false, _>(motion, &lanes, times);
                }
                columns.write(times, states);
            },
        );
        if times.contains(&motion.start.time) {
            for (state, _) in states.iter_mut().zip(times).filter(|(_, time)| **time == motion.start.time) {
                *state = motion.start;
            }
        }
    }
}

/// Times computed between two turns from columns to rows: their numbers stay in the nearest memory.
const BLOCK: usize = 64;

/// The seven numbers of a block of states, each in a column of its own.
struct Columns {
    attitude: [[Lanes<WIDTH>; BLOCK / WIDTH]; 4],
    omega: [[Lanes<WIDTH>; BLOCK / WIDTH]; 3],
}

#[cold]
fn padded(times: &[f64], rest: f64) -> [f64; WIDTH] {
    let mut lanes = [rest; WIDTH];
    lanes[..times.len()].copy_from_slice(times);
    lanes
}

impl Default for Columns {
    fn default() -> Self {
        let column = [Lanes([0.0; WIDTH]); BLOCK / WIDTH];
        Self { attitude: [column; 4], omega: [column; 3] }
    }
}

impl Columns {
    #[inline(always)]
    fn compute<const WHOLE: bool, S: Series<Lanes<WIDTH>>>(
        &mut self,
        motion: &FreeMotion,
        flow: &Flow<Lanes<WIDTH>, S>,
        times: &[f64],
    ) {
        // Two short loops: while one group waits for its own results, the processor begins the next.
        let groups = times.len().div_ceil(WIDTH);
        let mut turned = [Turned::still(); BLOCK / WIDTH];
        for (turned, group) in turned.iter_mut().zip(times.chunks(WIDTH)) {
            // The last group may be short: its lanes without a time stand still.
            let lanes = group.try_into().unwrap_or_else(|_| padded(group, motion.start.time));
            *turned = flow.turned::<WHOLE>(&motion.elapsed(Lanes(lanes)));
        }
        for (row, turned) in turned.iter().enumerate().take(groups) {
            let (q, w) = flow.state(turned);
            for (column, q) in self.attitude.iter_mut().zip(q) {
                column[row] = q;
            }
            for (column, w) in self.omega.iter_mut().zip(w) {
                column[row] = w;
            }
        }
    }

    #[inline(always)]
    fn write(&self, times: &[f64], states: &mut [State]) {
        let ([qw, qx, qy, qz], [wx, wy, wz]) = (&self.attitude, &self.omega);
        for (row, (times, states)) in times.chunks(WIDTH).zip(states.chunks_mut(WIDTH)).enumerate() {
            for (k, (&time, state)) in times.iter().zip(states).enumerate() {
                let q = [qw[row].0[k], qx[row].0[k], qy[row].0[k], qz[row].0[k]];
                let omega = Vector::new(wx[row].0[k], wy[row].0[k], wz[row].0[k]);
                *state = State { time, attitude: Rotation::from_unit(q), omega };
            }
        }
    }
}

/// Runs the loop compiled for the widest vectors of this machine.
#[cfg(feature = "simd")]
pub(super) fn in_widest_vectors(work: impl FnOnce()) {
    use fearless_simd::{Level, Simd as _, dispatch};
    dispatch!(Level::new(), simd => simd.vectorize(
        work
    ));
}

#[cfg(not(feature = "simd"))]
pub(super) fn in_widest_vectors(work: impl FnOnce()) {
    work();
}
