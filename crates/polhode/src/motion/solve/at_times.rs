//! Closed forms at many times: in the lanes of vectors, with the bits of each time alone.

use crate::math::lanes::Lanes;
use crate::math::machine::in_widest_vectors;
use crate::math::rotation::Rotation;
use crate::math::vector::Vector;
use crate::motion::model::state::State;

use super::phase::Elapsed;
use super::reach::is_within;

/// Times in a vector of AVX-512, or in two of AVX2.
const WIDTH: usize = 8;

/// The quaternion and ω so long after the start, of each lane.
pub(super) type Lane = Lanes<WIDTH>;

/// The states at some times of a motion with this start and reach, by what gives quaternion and ω after a time, in units of 1/`unit`.
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
                // Lanes without a time stand still.
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
