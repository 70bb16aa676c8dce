//! How the error is estimated: other runs, and how far they are apart.

use super::compared_samples::ComparedSamples;
use super::comparison::{ComparisonRun, cheap_input_error, step_error};
use super::inputs::Inputs;
use super::perturbed::{Distance, LINEAR, Perturbed};
use super::{ErrorEffort, GlobalError, NONE, ROUNDING};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;
use crate::motion::model::state::StateError;
use crate::motion::run::sample::Sample;
use crate::motion::run::simulation::Simulation;
use crate::motion::run::solution::Solution;
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::closed_form::{ClosedForm, OF_ROUNDED_CONSTANTS};
use crate::motion::solve::propagate::stepper::{Rule, TIGHTEST_TOLERANCE};
use crate::motion::solve::solver::Solver;

/// The last bit of the inputs, times: a power of two, so large that what steps do is nothing beside it, and so small that its effect stays linear ([`LINEAR`]).
pub(super) const INPUT_AMPLITUDES: [f64; 3] = [4096.0, 64.0, 1.0];
/// Where the seeds of other inputs begin.
pub(super) const INPUT_SEED: u64 = 1_000;
/// Comparison runs from other inputs of a thorough estimate.
pub(super) const INPUT_RUNS: u64 = 4;
/// Factor by which the tolerance of DOP853 is tighter in half steps: at a kink of a torque, which
/// its error control resolves, half steps alone have errors as large as whole ones.
const TIGHTER: f64 = 16.0;
/// Up to so many steps and samples a thorough estimate is made without being asked for: some hundredths of a second.
const FEW: u64 = 10_000;
/// Steps of DOP853 and of splitting take several times as long as Taylor's for the same accuracy.
const FEW_OF_MANY_STAGES: u64 = 3_000;

impl Simulation<'_> {
    /// [`Simulation::run`], with the estimate of its error: [`Trajectory::error`]. `progress` is told the end again and again while that is
    /// made; `false` ends the work.
    ///
    /// # Errors
    /// As [`Simulation::run_watched`].
    pub fn run_with_error(
        &self,
        effort: ErrorEffort,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Trajectory, MotionError> {
        let trajectory = self.run_watched(progress)?;
        let end = self.times.last().copied().unwrap_or(self.start.time);
        let mut goes_on = true;
        let error = self.estimate(&trajectory, effort, &mut |_| {
            goes_on = progress(end);
            goes_on
        });
        if goes_on { Ok(trajectory.with_error(error)) } else { Err(MotionError::Stopped { time: end }) }
    }

    /// Estimates of the error of a trajectory that this simulation has computed; `None` of one that was prescribed.
    pub fn global_error(&self, trajectory: &Trajectory, effort: ErrorEffort) -> Option<GlobalError> {
        self.estimate(trajectory, effort, &mut |_| true)
    }

    /// `progress` is told the time that each of the runs has reached; after `false` what is estimated is nothing.
    fn estimate(
        &self,
        trajectory: &Trajectory,
        effort: ErrorEffort,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Option<GlobalError> {
        let (solver, steps) = match trajectory.solution() {
            Solution::Prescribed(_) => return None,
            Solution::Exact(motion) => return Some(self.exact_error(motion, trajectory)),
            Solution::Integrated { solver, statistics, .. } => (*solver, statistics.accepted),
        };
        let rule = rule(solver)?;
        let few = if rule == Rule::Taylor { FEW } else { FEW_OF_MANY_STAGES };
        let is_thorough = effort.is_thorough(steps + trajectory.samples().len() as u64, few);
        let computation = self.step_error(is_thorough, rule, trajectory, progress);
        let inputs = if is_thorough {
            self.input_error_of_steps(rule, trajectory, progress)
        } else {
            cheap_input_error(&computation)
        };
        Some(GlobalError { is_thorough, computation, inputs })
    }

    /// Of a closed form, which has no steps whose errors add up: of some hundreds of states, so that it is always thorough.
    fn exact_error(&self, motion: &ClosedForm, trajectory: &Trajectory) -> GlobalError {
        let samples = trajectory.samples();
        let watched = ComparedSamples::of_trajectory(trajectory);
        let inputs = input_error(&watched, |seed, amplitude| {
            let Inputs { rotor, start, .. } = Inputs::of(self, seed, amplitude);
            // Not every change of a body keeps the symmetry that a closed form needs.
            ClosedForm::of(&rotor, self.torques, start)
                .or_else(|_| ClosedForm::of(self.rotor, self.torques, start))
                .map_or_else(|_| Vec::new(), |motion| motion.at_times(&watched.times))
        });
        let error = |(sample, worth): (&Sample, &StateError)| {
            let error = motion.formula_error(sample.state.time - self.start.time, *worth);
            // The tensor about a pivot is rounded when it is formed from that about the centre of mass.
            let is_rounded = matches!(motion, ClosedForm::Free(_)) && self.rotor.is_pivoted();
            if is_rounded { error.plus(*worth, OF_ROUNDED_CONSTANTS) } else { error }
        };
        let computation = samples.iter().zip(&inputs).map(error).collect();
        GlobalError { is_thorough: true, computation, inputs }
    }

    /// The error of steps: truncation, and rounding made larger.
    fn step_error(
        &self,
        is_thorough: bool,
        rule: Rule,
        trajectory: &Trajectory,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Vec<StateError> {
        let watched = ComparedSamples::of_trajectory(trajectory);
        let tighter = (self.tolerance / TIGHTER).max(TIGHTEST_TOLERANCE);
        let found = step_error(is_thorough, &mut |ComparisonRun { inputs: (seed, amplitude), steps }| {
            let inputs = Inputs::of(self, seed, amplitude);
            let is_tighter = steps.halved && rule == Rule::Dop853;
            let tolerance = if is_tighter { tighter } else { self.tolerance };
            let perturbed = Perturbed { simulation: self, inputs, rule, tolerance, steps: Some(steps) };
            Distance::between(&watched.states, &perturbed.states(&watched.times, progress))
        });
        watched.errors(&found, ROUNDING)
    }

    /// What the last bit of the inputs does to a motion by steps.
    ///
    /// Steps are not taken again for less where that is too much to be linear: rounding has eaten all digits there anyway.
    fn input_error_of_steps(
        &self,
        rule: Rule,
        trajectory: &Trajectory,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Vec<StateError> {
        let watched = ComparedSamples::of_trajectory(trajectory);
        let [amplitude, ..] = INPUT_AMPLITUDES;
        let distances = (0..INPUT_RUNS).map(|run| {
            let inputs = Inputs::of(self, INPUT_SEED + run, amplitude);
            let tolerance = self.tolerance;
            let perturbed = Perturbed { simulation: self, inputs, rule, tolerance, steps: None };
            let distance = Distance::between(&watched.states, &perturbed.states(&watched.times, progress));
            distance.within_linear().over(amplitude)
        });
        watched.errors(&distances.reduce(Distance::worse).unwrap_or_default(), NONE)
    }
}

/// What the last bit of the inputs does, by what many times as much does: `states` of a seed and an amplitude.
pub(super) fn input_error(
    watched: &ComparedSamples,
    states: impl Fn(u64, f64) -> Vec<State>,
) -> Vec<StateError> {
    let distances = (0..INPUT_RUNS).map(|run| {
        let distance = |amplitude: f64| {
            Distance::between(&watched.states, &states(INPUT_SEED + run, amplitude)).over(amplitude)
        };
        let mut found = distance(INPUT_AMPLITUDES[0]);
        for pair in INPUT_AMPLITUDES.windows(2) {
            let limit = LINEAR / pair[0];
            if found.is_within(limit) {
                break;
            }
            found = found.or_beyond(limit, &distance(pair[1]));
        }
        found
    });
    watched.errors(&distances.reduce(Distance::worse).unwrap_or_default(), NONE)
}

/// The integrator of a solver; `None` of those on the ground, which have an estimate of their own.
const fn rule(solver: Solver) -> Option<Rule> {
    match solver {
        Solver::Taylor => Some(Rule::Taylor),
        Solver::Dop853 => Some(Rule::Dop853),
        Solver::Splitting { order, step } => Some(Rule::Splitting { order, step }),
        Solver::Collocation | Solver::CollocationAndTaylor => None,
    }
}
