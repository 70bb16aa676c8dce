//! One motion at many times.

use core::hint::black_box;

use crate::math::lanes::Lanes;
use crate::math::machine::in_widest_vectors;
use crate::motion::model::state::State;
use crate::motion::solve::reach::is_within;

use super::FreeMotion;
use super::block::{Block, Vectors, WIDTH};
use super::compact::{CompactConstants, ScalarThetaParameters};
use super::flow::{Flow, Series};
use super::kernel::Kernel;
use crate::motion::solve::phase::Elapsed;

/// Number of groups in a block. The L1 cache holds the intermediate results of four. All other
/// numbers except the times are already loaded.
const GROUPS: usize = 4;

impl FreeMotion {
    /// Returns the states at many times (s), in their order.
    ///
    /// Each state is bit-identical to that of [`FreeMotion::at`]; the computation is several times
    /// faster.
    #[must_use]
    pub fn at_times(&self, times: &[f64]) -> Vec<State> {
        let mut states = vec![self.start; times.len()];
        self.fill(times, &mut states);
        states
    }

    /// Writes the states at many times into a slice, as [`FreeMotion::at_times`] returns them.
    /// Stops at the end of the shorter of the two slices.
    pub fn fill(&self, times: &[f64], states: &mut [State]) {
        self.put(times, &mut Places::States(states));
    }

    /// Writes the motion at many times (s) into arrays, like [`FreeMotion::fill`]: rows of ω (body
    /// axes, rad/s) and of unit quaternions (w, x, y, z).
    ///
    /// Stops at the end of the shortest of the three slices.
    pub fn fill_rows(&self, times: &[f64], omega: &mut [[f64; 3]], attitude: &mut [[f64; 4]]) {
        self.put(times, &mut Places::Rows { omega, attitude });
    }

    fn put(&self, times: &[f64], places: &mut Places) {
        let times = &times[..times.len().min(places.len())];
        match &self.kernel {
            Kernel::Trigonometric(compact, flow) => {
                fill(self, compact, flow.phase_rates.precession.third, times, places);
            }
            Kernel::Hyperbolic(compact, flow) => {
                fill(self, compact, flow.phase_rates.precession.third, times, places);
            }
        }
    }
}

/// Destination of the states.
enum Places<'a> {
    States(&'a mut [State]),
    Rows { omega: &'a mut [[f64; 3]], attitude: &'a mut [[f64; 4]] },
}

impl Places<'_> {
    fn len(&self) -> usize {
        match self {
            Self::States(states) => states.len(),
            Self::Rows { omega, attitude } => omega.len().min(attitude.len()),
        }
    }

    fn set(&mut self, k: usize, state: State) {
        match self {
            Self::States(states) => states[k] = state,
            Self::Rows { omega, attitude } => {
                (omega[k], attitude[k]) = (state.omega.to_array(), state.attitude.quaternion());
            }
        }
    }

    /// Writes the states of a block at these times, beginning at index `first`.
    #[inline(always)]
    fn set_block(&mut self, first: usize, times: &[f64], block: &Block<GROUPS>) {
        let places = first..first + times.len();
        match self {
            Self::States(states) => {
                for (k, (&time, state)) in times.iter().zip(&mut states[places]).enumerate() {
                    *state = block.state(k / WIDTH, k % WIDTH, time);
                }
            }
            Self::Rows { omega, attitude } => {
                let rows = omega[places.clone()].iter_mut().zip(&mut attitude[places]);
                for (k, (omega, attitude)) in rows.enumerate() {
                    (*attitude, *omega) = block.rows(k / WIDTH, k % WIDTH);
                }
            }
        }
    }
}

fn fill<N: ScalarThetaParameters>(
    motion: &FreeMotion,
    compact: &CompactConstants<f64, N>,
    third: f64,
    times: &[f64],
    places: &mut Places,
) {
    in_widest_vectors(
        #[inline(always)]
        || {
            let compact =
                CompactConstants::<f64, N>::assembled(&|get: &dyn Fn(&CompactConstants<f64, N>) -> f64| {
                    Lanes([get(compact); WIDTH])
                });
            // `black_box` keeps the flow in memory; otherwise the compiler would recompute parts of
            // it for each block.
            let flow = &black_box(compact.flow(Lanes([third; WIDTH])));
            let mut block = Block::<GROUPS>::new();
            for (k, times) in times.chunks(GROUPS * WIDTH).enumerate() {
                if motion.start.time == 0.0 {
                    start::<true, _>(&mut block, motion, flow, times);
                } else {
                    start::<false, _>(&mut block, motion, flow, times);
                }
                block.finish(
                    times.len().div_ceil(WIDTH),
                    #[inline(always)]
                    |_| flow,
                );
                places.set_block(k * GROUPS * WIDTH, times, &block);
            }
        },
    );
    for (k, &time) in times.iter().enumerate() {
        if time == motion.start.time {
            places.set(k, motion.start);
        } else if !is_within(&motion.start, motion.reach, time) {
            places.set(k, State::unknown(time));
        }
    }
}

#[inline(always)]
fn start<const WHOLE: bool, S: Series<Vectors>>(
    block: &mut Block<GROUPS>,
    motion: &FreeMotion,
    flow: &Flow<Vectors, S>,
    times: &[f64],
) {
    let groups = times.len().div_ceil(WIDTH);
    let mut near = true;
    for g in 0..groups {
        near &= elapsed::<WHOLE>(motion, times, g).is_within(flow.phase_rates.reach);
    }
    if near {
        block.start(
            groups,
            #[inline(always)]
            |g| flow.phase_rates.phases::<WHOLE, false>(&elapsed::<WHOLE>(motion, times, g)),
        );
    } else {
        block.start(
            groups,
            #[inline(always)]
            |g| flow.phase_rates.phases::<WHOLE, true>(&elapsed::<WHOLE>(motion, times, g)),
        );
    }
}

#[inline(always)]
fn elapsed<const WHOLE: bool>(motion: &FreeMotion, times: &[f64], group: usize) -> Elapsed<Vectors> {
    motion.elapsed::<WHOLE, _>(group_of(&times[group * WIDTH..], motion.start.time))
}

/// Returns the next times as one vector. If fewer remain, `rest` fills the unused lanes.
#[inline(always)]
fn group_of(times: &[f64], rest: f64) -> Vectors {
    match times.first_chunk() {
        Some(group) => Lanes(*group),
        None => Lanes::from_fn(|lane| times.get(lane).copied().unwrap_or(rest)),
    }
}
