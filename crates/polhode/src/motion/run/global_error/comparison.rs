//! Comparison runs for the error of an integration: one without truncation error, and others with
//! amplified rounding.

use super::compared_samples::ComparedSamples;
use super::distance::Distance;
use crate::motion::model::state::State;
use crate::motion::run::estimated_error::{GlobalError, NONE, ROUNDING};
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::limits::TIGHTEST_TOLERANCE;
use crate::motion::solve::propagate::noise::StepNoise;

/// Amplitude of the noise per step in a comparison run, in units of ε.
const STEP_NOISE: f64 = 2.0;
/// Amplitude of the perturbation of constants of the integration, in units of ε/2.
const CONSTANT_NOISE: f64 = 3.0;
/// Number of comparison runs with amplified rounding in a thorough estimate.
const ROUNDING_RUNS: u64 = 8;
/// Number of comparison runs from other inputs in a thorough estimate.
pub(super) const INPUT_RUNS: u64 = 4;
/// First seed of the runs from other inputs.
pub(super) const INPUT_SEED: u64 = 1_000;
/// Amplitudes of the changes of inputs, in units of ε/2: powers of two. They are so large that the
/// error of the steps is negligible. The effect must stay linear ([`super::distance::LINEAR`]);
/// smaller amplitudes are tried otherwise.
pub(super) const INPUT_AMPLITUDES: [f64; 3] = [4096.0, 64.0, 1.0];
/// Safety factor on the rounding in a cheap estimate, which has a single sample of it.
const CHEAP: f64 = 6.0;
/// Factor on the step length of the finest run. It reduces the truncation error to 1/17 (0.7⁸) at
/// order 8, and to 1/1250 at order 20.
const FINEST_STEPS: f64 = 0.7;

/// Settings of a comparison run.
#[derive(Clone, Copy, Debug)]
pub(super) struct ComparisonRun {
    /// Seed of the changes of the inputs, and their amplitude in units of ε/2.
    pub(super) inputs: (u64, f64),
    pub(super) steps: StepNoise,
    /// True for the run at the tightest tolerance, whose distance is the truncation error.
    pub(super) is_finest: bool,
}

impl ComparisonRun {
    /// Run without truncation error.
    const FINEST: Self = Self {
        inputs: (0, 0.0),
        steps: StepNoise { seed: 0, amplitude: 0.0, stretch: FINEST_STEPS },
        is_finest: true,
    };

    /// Returns a run with amplified rounding.
    const fn rounding(run: u64, noise: f64) -> Self {
        let steps = StepNoise { seed: 2 * run + 1, amplitude: noise * STEP_NOISE, stretch: 1.0 };
        Self { inputs: (2 * run, noise * CONSTANT_NOISE), steps, is_finest: false }
    }

    /// Returns a run from other inputs, with the steps of the motion.
    const fn from_inputs(run: u64) -> Self {
        let steps = StepNoise { seed: 0, amplitude: 0.0, stretch: 1.0 };
        Self { inputs: (INPUT_SEED + run, INPUT_AMPLITUDES[0]), steps, is_finest: false }
    }

    /// Returns the tolerance of the run; `own` is that of the motion.
    pub(super) const fn tolerance(&self, own: f64) -> f64 {
        if self.is_finest { TIGHTEST_TOLERANCE } else { own }
    }
}

/// Estimates the error of an integrated trajectory from the `states` of comparison runs at some
/// times.
///
/// The error of the computation is the distance to the finest run (truncation error), plus the
/// largest distance to the runs with amplified rounding (one, or eight if thorough). The runs are
/// separate, because truncation and noise in one run could cancel.
///
/// The effect of input rounding is scaled down from runs with larger changes of the inputs. If that
/// effect is not linear, rounding has destroyed all digits anyway.
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
