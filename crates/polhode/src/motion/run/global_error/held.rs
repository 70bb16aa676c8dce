//! The error of a motion that has series of its own, on the ground or in gimbals: other runs of it, with larger rounding and from other inputs.

use super::ErrorEffort;
use super::comparison::{ComparisonRun, error_by_steps};
use crate::motion::model::state::State;
use crate::motion::run::estimated_error::GlobalError;
use crate::motion::run::trajectory::Trajectory;

/// How much later or earlier an end may be and still be the same one, relative.
const SHIFT: f64 = 1e-6;

/// Up to so many steps and samples an estimate is thorough without being asked for: these steps cost more than others.
const FEW: u64 = 500;

/// Estimates of the error of a trajectory of so many steps.
pub(super) fn of_held(
    trajectory: &Trajectory,
    count: u64,
    effort: ErrorEffort,
    states: &mut dyn FnMut(ComparisonRun, &[f64]) -> Vec<State>,
) -> GlobalError {
    let is_thorough = effort.is_thorough(count + trajectory.samples().len() as u64, FEW);
    error_by_steps(trajectory, is_thorough, states)
}

/// The states that are at the times, as far as a motion gets; one that ended by itself ends a little earlier or later.
pub(super) fn reached(states: impl Iterator<Item = State>, times: &[f64], ended: bool) -> Vec<State> {
    let is_at = |k: usize, there: f64, time: f64| {
        there == time || ended && k + 1 == times.len() && (there - time).abs() <= SHIFT * time.abs()
    };
    let both = states.zip(times).enumerate();
    both.take_while(|(k, (state, time))| is_at(*k, state.time, **time)).map(|(_, (state, _))| state).collect()
}
