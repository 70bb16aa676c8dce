//! How the error is estimated: other runs, and how far they are apart.

use super::compared_samples::ComparedSamples;
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
use crate::motion::solve::closed_form::ClosedForm;
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::noise::Noise;
use crate::motion::solve::propagate::stepper::{LOOSEST_TOLERANCE, Rule, TIGHTEST_TOLERANCE};

/// Amplitude of the rounding of a step in a perturbed run, in units of ε.
pub(super) const STEP_NOISE: f64 = 2.0;
/// Of the constants that steps are made with, in units of half an ε.
pub(super) const CONSTANT_NOISE: f64 = 3.0;
/// The last bit of the inputs, times: a power of two, so large that what steps do is nothing beside it, and so small that its effect stays linear ([`LINEAR`]).
pub(super) const INPUT_AMPLITUDES: [f64; 3] = [4096.0, 64.0, 1.0];
/// Where the seeds of other inputs begin.
pub(super) const INPUT_SEED: u64 = 1_000;
/// Perturbed runs of a thorough estimate, with larger rounding and from other inputs.
pub(super) const RUNS: [u64; 2] = [8, 4];
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
        let (method, steps) = match trajectory.solution() {
            Solution::Prescribed(_) => return None,
            Solution::Exact(motion) => return Some(self.exact_error(motion, trajectory)),
            Solution::Integrated { method, statistics, .. } => (*method, statistics.accepted),
        };
        let rule = rule(method)?;
        let few = if rule == Rule::Taylor { FEW } else { FEW_OF_MANY_STAGES };
        if effort.is_thorough(steps + trajectory.samples().len() as u64, few) {
            let finer = Refinement::finer(rule, self.tolerance);
            let computation = self.step_error(finer, trajectory, RUNS[0], progress);
            let inputs = self.input_error_of_steps(rule, trajectory, progress);
            Some(GlobalError { is_thorough: true, computation, inputs })
        } else {
            let refinement = Refinement::cheap(rule, self.tolerance);
            let computation = self.step_error(refinement, trajectory, 1, progress);
            // The inputs were made different too, so that what they are worth is no more than this part of it.
            let part = |e: &StateError| StateError {
                attitude: e.attitude / (refinement.noise * CONSTANT_NOISE),
                omega: e.omega / (refinement.noise * CONSTANT_NOISE),
            };
            let inputs = computation.iter().map(part).collect();
            Some(GlobalError { is_thorough: false, computation, inputs })
        }
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
            motion.formula_error(sample.state.time - self.start.time, *worth)
        };
        let computation = samples.iter().zip(&inputs).map(error).collect();
        GlobalError { is_thorough: true, computation, inputs }
    }

    /// The error of steps: truncation, and rounding made larger.
    fn step_error(
        &self,
        refinement: Refinement,
        trajectory: &Trajectory,
        runs: u64,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Vec<StateError> {
        let Refinement { rule, tolerance, stretch, gain, noise } = refinement;
        let watched = ComparedSamples::of_trajectory(trajectory);
        let distances = (0..runs).map(|run| {
            let inputs = Inputs::of(self, 2 * run, noise * gain * CONSTANT_NOISE);
            let noise = Some((Noise::new(2 * run + 1, noise * gain * STEP_NOISE), stretch));
            let perturbed = Perturbed { simulation: self, inputs, rule, tolerance, noise };
            let distance = Distance::between(&watched.states, &perturbed.states(&watched.times, progress));
            distance.within_linear().over(gain)
        });
        watched.errors(&distances.reduce(Distance::worse).unwrap_or_default(), ROUNDING)
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
        let distances = (0..RUNS[1]).map(|run| {
            let inputs = Inputs::of(self, INPUT_SEED + run, amplitude);
            let tolerance = self.tolerance;
            let perturbed = Perturbed { simulation: self, inputs, rule, tolerance, noise: None };
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
    let distances = (0..RUNS[1]).map(|run| {
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

/// Other steps than those of a motion: the distance between the two is so many times (or more) the motion's own truncation error.
#[derive(Clone, Copy, Debug)]
struct Refinement {
    rule: Rule,
    tolerance: f64,
    /// How many times as long steps are whose length is no matter of the tolerance; of Taylor's method all.
    stretch: f64,
    gain: f64,
    /// Amplitude of the noise, times: a single sample has to be larger.
    noise: f64,
}

impl Refinement {
    /// Steps with so small an error that the distance is nearly that of the motion.
    fn finer(rule: Rule, tolerance: f64) -> Self {
        let (rule, tolerance, stretch) = match rule {
            // 0.8ⁿ is 0.01 of order 20
            Rule::Taylor => (rule, tolerance, 0.8),
            // 0.7⁸ is 1/16
            Rule::Dop853 => (rule, (tolerance / 16.0).max(TIGHTEST_TOLERANCE), 0.7),
            Rule::Splitting { order, step } => (Rule::Splitting { order, step: 0.5 * step }, tolerance, 1.0),
        };
        // Twelve stages of DOP853 round more than one series.
        let noise = if rule == Rule::Dop853 { 2.0 } else { 1.0 };
        Self { rule, tolerance, stretch, gain: 1.0, noise }
    }

    /// Steps that take no longer than the motion's own.
    fn cheap(rule: Rule, tolerance: f64) -> Self {
        let (rule, tolerance, stretch, gain) = match rule {
            // 1 − 0.9ⁿ is 0.87 of order 19, and as little as a quarter where steps end at other places.
            Rule::Taylor => (rule, tolerance, 0.9, 0.25),
            Rule::Dop853 if 4.0 * tolerance > LOOSEST_TOLERANCE => return Self::finer(rule, tolerance),
            // 1.19⁸ is 4: the distance is three times the error, and as little as a sixth of that where it has another direction.
            Rule::Dop853 => (rule, 4.0 * tolerance, 1.19, 0.5),
            // 2ᵖ − 1 times as large; half of that, as steps so long may do better than their order
            Rule::Splitting { order, step } => {
                let gain = 0.5 * (f64::from(order.number()).exp2() - 1.0);
                (Rule::Splitting { order, step: 2.0 * step }, tolerance, 1.0, gain)
            }
        };
        Self { rule, tolerance, stretch, gain, noise: 4.0 }
    }
}

/// The integrator of a method; `None` of what has no steps.
fn rule(method: Method) -> Option<Rule> {
    match method {
        Method::Taylor => Some(Rule::Taylor),
        Method::Dop853 => Some(Rule::Dop853),
        Method::Splitting { order, step } => Some(Rule::Splitting { order, step }),
        Method::Auto | Method::Exact => None,
    }
}
