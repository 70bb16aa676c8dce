//! The error of a motion that has series of its own, on the ground or in gimbals: other runs of it, with larger rounding and from other inputs.

use super::compared_samples::ComparedSamples;
use super::estimation::{CONSTANT_NOISE, INPUT_AMPLITUDES, INPUT_SEED, RUNS, STEP_NOISE};
use super::perturbed::Distance;
use super::{ErrorEffort, GlobalError, NONE, ROUNDING};
use crate::motion::model::state::{State, StateError};
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::propagate::noise::StepNoise;

/// How much later or earlier an end may be and still be the same one, relative.
const SHIFT: f64 = 1e-6;

/// Up to so many steps and samples an estimate is thorough without being asked for: these steps cost more than others.
const FEW: u64 = 500;

/// How much longer steps are in a thorough run and in a cheap one; what a cheap one shows of the truncation error; and its noise, as it is a single
/// sample. As of Taylor's method elsewhere.
const THOROUGH: [f64; 3] = [0.8, 1.0, 1.0];
const CHEAP: [f64; 3] = [0.9, 0.25, 4.0];

/// The states at given times from other inputs (seed and amplitude), with noise.
type StatesFrom<'a> = dyn FnMut((u64, f64), Option<StepNoise>, &[f64]) -> Vec<State> + 'a;

/// Estimates of the error of a trajectory of so many steps.
pub(super) fn of_held(
    trajectory: &Trajectory,
    steps: u64,
    effort: ErrorEffort,
    states: &mut StatesFrom<'_>,
) -> GlobalError {
    let watched = ComparedSamples::of_trajectory(trajectory);
    let is_thorough = effort.is_thorough(steps + trajectory.samples().len() as u64, FEW);
    let ([stretch, gain, noise], runs) = if is_thorough { (THOROUGH, RUNS[0]) } else { (CHEAP, 1) };
    let mut distance = |inputs: (u64, f64), steps: Option<StepNoise>| {
        let states = states(inputs, steps, &watched.times);
        Distance::between(&watched.states, &states).within_linear()
    };
    let computed = (0..runs).map(|run| {
        let steps = StepNoise { seed: 2 * run + 1, amplitude: noise * gain * STEP_NOISE, stretch };
        distance((2 * run, noise * gain * CONSTANT_NOISE), Some(steps)).over(gain)
    });
    let computed = computed.reduce(Distance::worse).unwrap_or_default();
    let computation = watched.errors(&computed, ROUNDING);
    let inputs = if is_thorough {
        let [amplitude, ..] = INPUT_AMPLITUDES;
        let found = (0..RUNS[1]).map(|run| distance((INPUT_SEED + run, amplitude), None).over(amplitude));
        watched.errors(&found.reduce(Distance::worse).unwrap_or_default(), NONE)
    } else {
        // The inputs were made different too, so that what they are worth is no more than this part of it.
        let part = |e: &StateError| StateError {
            attitude: e.attitude / (noise * CONSTANT_NOISE),
            omega: e.omega / (noise * CONSTANT_NOISE),
        };
        computation.iter().map(part).collect()
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
