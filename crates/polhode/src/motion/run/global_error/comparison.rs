//! The comparison runs of an estimate by steps: one in half steps, and others with larger rounding.

use super::perturbed::Distance;
use crate::motion::model::state::StateError;
use crate::motion::solve::propagate::noise::StepChange;

/// Amplitude of the rounding of a step in a comparison run, in units of ε.
const STEP_NOISE: f64 = 2.0;
/// Of the constants that steps are made with, in units of half an ε.
const CONSTANT_NOISE: f64 = 3.0;
/// Comparison runs with larger rounding of a thorough estimate.
const ROUNDING_RUNS: u64 = 8;
/// Factor on the rounding of a cheap estimate, which has a single sample of it.
const CHEAP: f64 = 4.0;

/// Inputs of a comparison run, and its steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct ComparisonRun {
    /// The seed of the changes of the inputs, and their amplitude in units of half an ε.
    pub(super) inputs: (u64, f64),
    pub(super) steps: StepChange,
}

/// The error of the steps of a run, from its `distance` to comparison runs.
///
/// The distance to a run in half steps, which is the truncation error, plus the largest distance to
/// the runs with larger rounding: eight of them, or one. They are separate runs, as truncation and
/// noise of one run may cancel.
pub(super) fn step_error(is_thorough: bool, distance: &mut dyn FnMut(ComparisonRun) -> Distance) -> Distance {
    let mut apart = |seed: u64, rounding: f64, halved: bool| {
        let steps = StepChange { seed: 2 * seed + 1, amplitude: rounding * STEP_NOISE, halved };
        distance(ComparisonRun { inputs: (2 * seed, rounding * CONSTANT_NOISE), steps }).within_linear()
    };
    let (runs, noise) = if is_thorough { (ROUNDING_RUNS, 1.0) } else { (1, CHEAP) };
    let truncation = apart(0, 0.0, true);
    let rounding = (0..runs).map(|seed| apart(seed, noise, false)).reduce(Distance::worse);
    truncation.plus(&rounding.unwrap_or_default())
}

/// Bound on the effect of the last bit of the inputs, from a cheap estimate, for one run of which
/// the inputs were changed by more than that.
pub(super) fn cheap_input_error(computation: &[StateError]) -> Vec<StateError> {
    let share = 1.0 / (CHEAP * CONSTANT_NOISE);
    let part = |e: &StateError| StateError { attitude: share * e.attitude, omega: share * e.omega };
    computation.iter().map(part).collect()
}
