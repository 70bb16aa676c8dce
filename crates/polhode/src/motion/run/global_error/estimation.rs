//! Estimation of the error from other runs and their distances.

use super::ErrorEffort;
use super::compared_samples::ComparedSamples;
use super::comparison::{INPUT_AMPLITUDES, INPUT_RUNS, INPUT_SEED, error_by_steps};
use super::distance::{Distance, LINEAR};
use super::inputs::Inputs;
use super::repeatable::{IntegratedRotor, Repeatable};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;
use crate::motion::model::state::StateError;
use crate::motion::run::estimated_error::{GlobalError, NONE};
use crate::motion::run::rotor_problem::RotorProblem;
use crate::motion::run::sample::Sample;
use crate::motion::run::simulation::{Problem, Simulation};
use crate::motion::run::solution::Solution;
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::closed_form::{ClosedForm, OF_ROUNDED_CONSTANTS};
use crate::motion::solve::propagate::stepper::Rule;

impl Simulation<'_> {
    /// Computes the motion like [`Simulation::run`], with an estimate of its error, which
    /// [`Trajectory::error`] returns.
    ///
    /// During the estimation `progress` receives the end time repeatedly. If it returns `false`,
    /// the computation stops.
    ///
    /// # Errors
    /// The errors of [`Simulation::run_watched`].
    pub fn run_with_error(
        &self,
        effort: ErrorEffort,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Trajectory, MotionError> {
        let trajectory = self.run_watched(progress)?;
        let end = self.ends();
        let mut goes_on = true;
        let error = self.estimate(&trajectory, effort, &mut |_| {
            goes_on = progress(end);
            goes_on
        });
        if goes_on { Ok(trajectory.with_error(error)) } else { Err(MotionError::Stopped { time: end }) }
    }

    /// Estimates the error of a trajectory that this simulation has computed; `None` for a
    /// prescribed motion.
    pub fn global_error(&self, trajectory: &Trajectory, effort: ErrorEffort) -> Option<GlobalError> {
        self.estimate(trajectory, effort, &mut |_| true)
    }

    /// Estimates the error. `progress` receives the time that each run has reached. If it returns
    /// false, the result is meaningless.
    fn estimate(
        &self,
        trajectory: &Trajectory,
        effort: ErrorEffort,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Option<GlobalError> {
        let problem = self.problem().ok()?;
        let solution = trajectory.solution();
        let rotor;
        let motion: &dyn Repeatable = match (&problem, solution) {
            (_, Solution::Prescribed(_)) => return None,
            (Problem::Rotor(problem), Solution::ClosedForm(motion)) => {
                return Some(problem.exact_error(motion, trajectory));
            }
            (Problem::Rotor(problem), solution) => {
                rotor = IntegratedRotor { problem, rule: rule(solution)? };
                &rotor
            }
            (Problem::Ground(problem), _) => problem,
            (Problem::Gimbals(problem), _) => problem,
        };
        let steps = solution.statistics()?.accepted;
        let is_thorough = effort.is_thorough(steps + trajectory.samples().len() as u64, motion.few());
        Some(error_by_steps(trajectory, is_thorough, &mut |run, times| {
            motion.states(run, times, progress).unwrap_or_default()
        }))
    }
}

impl RotorProblem<'_> {
    /// Estimates the error of a closed form, which has no accumulating step errors. Some hundreds
    /// of states suffice, so the estimate is always thorough.
    fn exact_error(&self, motion: &ClosedForm, trajectory: &Trajectory) -> GlobalError {
        let samples = trajectory.samples();
        let watched = ComparedSamples::of_trajectory(trajectory);
        let inputs = input_error(&watched, |seed, amplitude| {
            let Inputs { rotor, start, .. } = Inputs::of(self, (seed, amplitude));
            // A change of the body may break the symmetry that a closed form needs; then only the
            // start is changed.
            ClosedForm::of(&rotor, self.torques, start)
                .or_else(|_| ClosedForm::of(self.rotor, self.torques, start))
                .map_or_else(|_| Vec::new(), |motion| motion.at_times(&watched.times))
        });
        let error = |(sample, worth): (&Sample, &StateError)| {
            let error = motion.formula_error(sample.state.time - self.start.time, *worth);
            // The tensor about a pivot is rounded when it is computed from that about the centre of
            // mass.
            let is_rounded = matches!(motion, ClosedForm::Free(_)) && self.rotor.is_pivoted();
            if is_rounded { error.plus(*worth, OF_ROUNDED_CONSTANTS) } else { error }
        };
        let computation = samples.iter().zip(&inputs).map(error).collect();
        GlobalError { is_thorough: true, computation, inputs }
    }
}

/// Estimates the effect of input rounding from larger changes of the inputs. `states` computes the
/// motion for a seed and an amplitude.
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

/// Returns the integrator of a rotor's solution; `None` if it has none, or is on the ground.
const fn rule(solution: &Solution) -> Option<Rule> {
    match solution {
        Solution::Taylor(_) => Some(Rule::Taylor),
        Solution::Dop853(_) => Some(Rule::Dop853),
        Solution::Splitting { order, step, .. } => Some(Rule::Splitting { order: *order, step: *step }),
        Solution::ClosedForm(_)
        | Solution::Prescribed(_)
        | Solution::Collocation(_)
        | Solution::CollocationAndTaylor(_) => None,
    }
}
