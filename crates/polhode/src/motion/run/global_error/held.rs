//! The error of a motion that has series of its own, on the ground or in gimbals: other runs of it, with larger rounding and from other inputs.

use super::compared_samples::ComparedSamples;
use super::comparison::{ComparisonRun, cheap_input_error, step_error};
use super::estimation::{INPUT_AMPLITUDES, INPUT_RUNS, INPUT_SEED};
use super::perturbed::Distance;
use super::{ErrorEffort, GlobalError, NONE, ROUNDING};
use crate::motion::model::state::State;
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::propagate::noise::StepChange;

/// How much later or earlier an end may be and still be the same one, relative.
const SHIFT: f64 = 1e-6;

/// Up to so many steps and samples an estimate is thorough without being asked for: these steps cost more than others.
const FEW: u64 = 500;

/// The states at given times from other inputs (seed and amplitude), by the steps of a comparison run.
type StatesFrom<'a> = dyn FnMut((u64, f64), Option<StepChange>, &[f64]) -> Vec<State> + 'a;

/// Estimates of the error of a trajectory of so many steps.
pub(super) fn of_held(
    trajectory: &Trajectory,
    count: u64,
    effort: ErrorEffort,
    states: &mut StatesFrom<'_>,
) -> GlobalError {
    let watched = ComparedSamples::of_trajectory(trajectory);
    let is_thorough = effort.is_thorough(count + trajectory.samples().len() as u64, FEW);
    let mut distance = |inputs: (u64, f64), steps: Option<StepChange>| {
        Distance::between(&watched.states, &states(inputs, steps, &watched.times))
    };
    let computed =
        step_error(is_thorough, &mut |ComparisonRun { inputs, steps }| distance(inputs, Some(steps)));
    let computation = watched.errors(&computed, ROUNDING);
    let inputs = if is_thorough {
        let [amplitude, ..] = INPUT_AMPLITUDES;
        let found = (0..INPUT_RUNS)
            .map(|run| distance((INPUT_SEED + run, amplitude), None).within_linear().over(amplitude));
        watched.errors(&found.reduce(Distance::worse).unwrap_or_default(), NONE)
    } else {
        cheap_input_error(&computation)
    };
    GlobalError { is_thorough, computation, inputs }
}

/// The states that are at the times, as far as a motion gets; one that ended by itself ends a little earlier or later.
pub(super) fn reached(states: impl Iterator<Item = State>, times: &[f64], ended: bool) -> Vec<State> {
    let is_at = |k: usize, there: f64, time: f64| {
        there == time || ended && k + 1 == times.len() && (there - time).abs() <= SHIFT * time.abs()
    };
    let both = states.zip(times).enumerate();
    both.take_while(|(k, (state, time))| is_at(*k, state.time, **time)).map(|(_, (state, _))| state).collect()
}
