//! How the error is estimated: other runs, and how far they are apart.

use super::ErrorEffort;
use super::compared_samples::ComparedSamples;
use super::comparison::{INPUT_AMPLITUDES, INPUT_RUNS, INPUT_SEED, error_by_steps};
use super::inputs::Inputs;
use super::perturbed::{Distance, LINEAR, Perturbed};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;
use crate::motion::model::state::StateError;
use crate::motion::run::estimated_error::{GlobalError, NONE};
use crate::motion::run::sample::Sample;
use crate::motion::run::simulation::Simulation;
use crate::motion::run::solution::Solution;
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::closed_form::{ClosedForm, OF_ROUNDED_CONSTANTS};
use crate::motion::solve::propagate::stepper::Rule;
use crate::motion::solve::solver::Solver;

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
        // Taylor's method is the most accurate, and of another order than the others.
        let finest = if self.rough_torque().is_none() { Rule::Taylor } else { Rule::Dop853 };
        Some(error_by_steps(trajectory, is_thorough, &mut |run, times| {
            let perturbed = Perturbed {
                simulation: self,
                inputs: Inputs::of(self, run.inputs),
                rule: if run.is_finest { finest } else { rule },
                tolerance: run.tolerance(self.tolerance),
                steps: run.steps,
            };
            perturbed.states(times, progress)
        }))
    }

    /// Of a closed form, which has no steps whose errors add up: of some hundreds of states, so that it is always thorough.
    fn exact_error(&self, motion: &ClosedForm, trajectory: &Trajectory) -> GlobalError {
        let samples = trajectory.samples();
        let watched = ComparedSamples::of_trajectory(trajectory);
        let inputs = input_error(&watched, |seed, amplitude| {
            let Inputs { rotor, start, .. } = Inputs::of(self, (seed, amplitude));
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
