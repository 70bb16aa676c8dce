//! Evaluation of closed forms at many times in SIMD lanes, bit-identical to one time at a time.

use crate::math::lanes::Lanes;
use crate::math::machine::in_widest_vectors;
use crate::math::rotation::Rotation;
use crate::math::vector::Vector;
use crate::motion::model::state::State;

use super::phase::Elapsed;
use super::reach::is_within;

/// Number of times per vector: one AVX-512 vector, or two AVX2 vectors.
const WIDTH: usize = 8;

/// Vector with one time per lane.
pub(super) type Lane = Lanes<WIDTH>;

/// Returns the states at many times of a motion with this start and reach. `after` returns
/// quaternion and ω at an elapsed time, in units of 1/`unit`.
pub(super) fn at_times(
    times: &[f64],
    start: &State,
    reach: f64,
    unit: f64,
    after: impl Fn(&Elapsed<Lane>) -> ([Lane; 4], [Lane; 3]),
) -> Vec<State> {
    let mut states = vec![*start; times.len()];
    in_widest_vectors(
        #[inline(always)]
        || {
            let (begin, unit) = (Lanes([start.time; WIDTH]), Lanes([unit; WIDTH]));
            for (times, states) in times.chunks(WIDTH).zip(states.chunks_mut(WIDTH)) {
                // Unused lanes get the start time.
                let lanes = Lanes::from_fn(|lane| times.get(lane).copied().unwrap_or(start.time));
                let (q, omega) = after(&Elapsed::since::<false>(begin, lanes, unit));
                for (lane, (&time, state)) in times.iter().zip(states).enumerate() {
                    *state = State {
                        time,
                        attitude: Rotation::from_unit(q.map(|c| c.0[lane])),
                        omega: Vector::from_array(omega.map(|c| c.0[lane])),
                    };
                }
            }
        },
    );
    for (state, &time) in states.iter_mut().zip(times) {
        if time == start.time {
            *state = *start;
        } else if !is_within(start, reach, time) {
            *state = State::unknown(time);
        }
    }
    states
}
