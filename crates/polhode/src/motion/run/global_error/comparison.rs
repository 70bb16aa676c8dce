//! The comparison runs of an estimate by steps: one without truncation error, and others with larger rounding.

use super::compared_samples::ComparedSamples;
use super::distance::Distance;
use crate::motion::model::state::State;
use crate::motion::run::estimated_error::{GlobalError, NONE, ROUNDING};
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::limits::TIGHTEST_TOLERANCE;
use crate::motion::solve::propagate::noise::StepNoise;

/// Amplitude of the rounding of a step in a comparison run, in units of ε.
const STEP_NOISE: f64 = 2.0;
/// Amplitude of the rounding of the constants that steps are made with, in units of half an ε.
const CONSTANT_NOISE: f64 = 3.0;
/// Comparison runs with larger rounding of a thorough estimate.
const ROUNDING_RUNS: u64 = 8;
/// Comparison runs from other inputs of a thorough estimate.
pub(super) const INPUT_RUNS: u64 = 4;
/// First seed of the runs from other inputs.
pub(super) const INPUT_SEED: u64 = 1_000;
/// Amplitudes of the changes of inputs, in units of half an ε: powers of two, so large that the steps
/// do nothing compared with them, and so small that their effect stays linear ([`super::distance::LINEAR`]).
pub(super) const INPUT_AMPLITUDES: [f64; 3] = [4096.0, 64.0, 1.0];
/// Factor on the rounding of a cheap estimate, which has a single sample of it.
const CHEAP: f64 = 6.0;
/// Factor on the steps of the finest run: 0.7⁸ is 1/17, of order 20 it is 1/1250.
const FINEST_STEPS: f64 = 0.7;

/// A comparison run.
#[derive(Clone, Copy, Debug)]
pub(super) struct ComparisonRun {
    /// The seed of the changes of the inputs, and their amplitude in units of half an ε.
    pub(super) inputs: (u64, f64),
    pub(super) steps: StepNoise,
    /// True of the run at the tightest tolerance, whose distance is the truncation error.
    pub(super) is_finest: bool,
}

impl ComparisonRun {
    /// The run without truncation error.
    const FINEST: Self = Self {
        inputs: (0, 0.0),
        steps: StepNoise { seed: 0, amplitude: 0.0, stretch: FINEST_STEPS },
        is_finest: true,
    };

    /// A run with larger rounding.
    const fn rounding(run: u64, noise: f64) -> Self {
        let steps = StepNoise { seed: 2 * run + 1, amplitude: noise * STEP_NOISE, stretch: 1.0 };
        Self { inputs: (2 * run, noise * CONSTANT_NOISE), steps, is_finest: false }
    }

    /// A run from other inputs, by the steps of the motion.
    const fn from_inputs(run: u64) -> Self {
        let steps = StepNoise { seed: 0, amplitude: 0.0, stretch: 1.0 };
        Self { inputs: (INPUT_SEED + run, INPUT_AMPLITUDES[0]), steps, is_finest: false }
    }

    /// The tolerance of the run, where that of the motion is `own`.
    pub(super) const fn tolerance(&self, own: f64) -> f64 {
        if self.is_finest { TIGHTEST_TOLERANCE } else { own }
    }
}

/// Estimates of the error of a trajectory by steps, from the `states` of comparison runs at some times.
///
/// The computation has the distance to the finest run, which is the truncation error, plus the
/// largest distance to the runs with larger rounding: eight of them, or one. They are separate runs,
/// as truncation and noise of one run may cancel.
///
/// The effect of the last bit of the inputs is a share of the distance to runs whose inputs are
/// changed by more. Where that is not linear, rounding has taken all digits anyway.
pub(super) fn error_by_steps(
    trajectory: &Trajectory,
    is_thorough: bool,
    states: &mut dyn FnMut(ComparisonRun, &[f64]) -> Vec<State>,
) -> GlobalError {
    let watched = ComparedSamples::of_trajectory(trajectory);
    let mut distance =
        |run: ComparisonRun| Distance::between(&watched.states, &states(run, &watched.times)).within_linear();
    let truncation = distance(ComparisonRun::FINEST);
    let (runs, noise) = if is_thorough { (ROUNDING_RUNS, 1.0) } else { (1, CHEAP) };
    let rounding = (0..runs).map(|run| distance(ComparisonRun::rounding(run, noise)));
    let rounding = rounding.reduce(Distance::worse).unwrap_or_default();
    let inputs = if is_thorough {
        let found = (0..INPUT_RUNS).map(|run| distance(ComparisonRun::from_inputs(run)));
        found.reduce(Distance::worse).unwrap_or_default().over(INPUT_AMPLITUDES[0])
    } else {
        rounding.clone().over(CHEAP * CONSTANT_NOISE)
    };
    GlobalError {
        is_thorough,
        computation: watched.errors(&truncation.plus(&rounding), ROUNDING),
        inputs: watched.errors(&inputs, NONE),
    }
}
