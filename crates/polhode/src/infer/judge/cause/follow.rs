//! Integration of a correct or wrong law by extrapolation.

use super::law::{Law, Numbers, advanced, derivative, numbers, state};
use crate::motion::model::state::State;

/// Rotation angle per step, rad; the error is about 1e-10.
const ANGLE: f64 = 0.4;

/// Rotation angle per step if ω may be limited after a step, rad.
const CUT_ANGLE: f64 = 0.01;

/// Integrates the motion from a start to each of the ascending times, for at most `most` steps, and
/// while `is_of_use` returns true for each state.
///
/// Each step is Gragg's modified midpoint rule with 2, 4, 6 and 8 parts, extrapolated: order 8.
pub(super) fn follow(
    law: &Law<'_>,
    start: State,
    times: &[f64],
    most: usize,
    mut is_of_use: impl FnMut(&State) -> bool,
) -> Vec<State> {
    let mut now = limited(law, start);
    let mut steps = 0;
    let mut states = Vec::with_capacity(times.len());
    let angle = if law.speed_limit.is_finite() { CUT_ANGLE } else { ANGLE };
    for &time in times {
        while now.time != time {
            let longest = angle / law.rate(&now);
            let change = law.next_change(now.time);
            let end = if time < now.time {
                time.max(now.time - longest)
            } else {
                time.min(change).min(now.time + longest)
            };
            steps += 1;
            if steps > most || end == now.time || !now.omega.is_finite() {
                return states;
            }
            now = limited(law, step(law, &now, end));
        }
        states.push(now);
        if !is_of_use(&now) {
            break;
        }
    }
    states
}

fn limited(law: &Law<'_>, state: State) -> State {
    let speed = state.omega.norm();
    if speed > law.speed_limit {
        State { omega: state.omega * (law.speed_limit / speed), ..state }
    } else {
        state
    }
}

fn step(law: &Law<'_>, from: &State, end: f64) -> State {
    const PARTS: [f64; 4] = [2.0, 4.0, 6.0, 8.0];
    let (start, h) = (numbers(from), end - from.time);
    let first = derivative(law, from.time, &start, from.time);
    let mut before: Vec<Numbers> = Vec::with_capacity(PARTS.len());
    for (row, &parts) in PARTS.iter().enumerate() {
        let mut now = vec![midpoint(law, from.time, (&start, &first), h, parts)];
        for column in 1..=row {
            let ratio = parts / PARTS[row - column];
            let weight = 1.0 / (ratio * ratio - 1.0);
            let (finer, coarser) = (now[column - 1], before[column - 1]);
            now.push(core::array::from_fn(|k| finer[k] + weight * (finer[k] - coarser[k])));
        }
        before = now;
    }
    state(end, before.last().copied().unwrap_or(start))
}

fn midpoint(law: &Law<'_>, time: f64, (start, first): (&Numbers, &Numbers), h: f64, parts: f64) -> Numbers {
    let part = h / parts;
    let (mut before, mut now) = (*start, advanced(start, part, first));
    let mut done = 1.0;
    while done < parts {
        let slope = derivative(law, time + done * part, &now, time);
        (before, now) = (now, advanced(&before, 2.0 * part, &slope));
        done += 1.0;
    }
    now
}
