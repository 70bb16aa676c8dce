//! The error of a motion on the ground: other runs of it, with larger rounding and from other inputs.

use super::compared_samples::ComparedSamples;
use super::estimation::{CONSTANT_NOISE, INPUT_AMPLITUDES, INPUT_SEED, RUNS, STEP_NOISE};
use super::inputs::Change;
use super::perturbed::Distance;
use super::{ErrorEffort, GlobalError, NONE, ROUNDING};
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::motion::contact::{ContactEnding, ContactSimulation, ContactStart, StepNoise};
use crate::motion::model::state::State;
use crate::motion::model::state::StateError;
use crate::motion::run::trajectory::Trajectory;

/// Up to so many steps and samples an estimate is thorough without being asked for: steps of a contact cost more than others.
const FEW: u64 = 500;

/// How much later or earlier an end may be and still be the same one, relative.
const SHIFT: f64 = 1e-6;

/// How much longer steps are in a thorough run and in a cheap one; what a cheap one shows of the truncation error; and its noise, as it is a single
/// sample. As of Taylor's method without a contact.
const THOROUGH: [f64; 3] = [0.8, 1.0, 1.0];
const CHEAP: [f64; 3] = [0.9, 0.25, 4.0];

/// Estimates of the error of a trajectory that a simulation has computed.
pub(crate) fn of_contact(
    simulation: &ContactSimulation<'_>,
    trajectory: &Trajectory,
    effort: ErrorEffort,
    progress: &mut dyn FnMut(f64) -> bool,
) -> GlobalError {
    let steps = trajectory.contact().map_or(0, |motion| motion.statistics().accepted);
    let watched = ComparedSamples::of_trajectory(trajectory);
    let is_thorough = effort.is_thorough(steps + trajectory.samples().len() as u64, FEW);
    let ([stretch, gain, noise], runs) = if is_thorough { (THOROUGH, RUNS[0]) } else { (CHEAP, 1) };
    let mut distance = |inputs: (u64, f64), steps: Option<StepNoise>| {
        let states = states(simulation, inputs, steps, &watched.times, progress);
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

/// The states of a motion from other inputs, as far as it gets.
fn states(
    simulation: &ContactSimulation<'_>,
    (seed, amplitude): (u64, f64),
    noise: Option<StepNoise>,
    times: &[f64],
    progress: &mut dyn FnMut(f64) -> bool,
) -> Vec<State> {
    let mut change = Change::new(seed, amplitude);
    let body = simulation.body();
    let inertia = InertiaTensor::from_symmetric(change.inertia(body.inertia().symmetric()));
    let changed =
        inertia.and_then(|inertia| MassProperties::new(body.mass(), body.center_of_mass(), inertia));
    let start = simulation.start();
    let start = ContactStart { state: change.start(start.state), ..start };
    // What stops the motion, or is only written down, does not change it.
    let body = changed.unwrap_or(*body);
    let run = ContactSimulation::new(&body, simulation.contact(), start, times)
        .tolerance(simulation.bound())
        .with_noise(noise)
        .run_watched(progress);
    let Ok(motion) = run else { return Vec::new() };
    // Where a change of the contact ends the motion, it ends a little earlier or later.
    let ended = matches!(motion.ending(), ContactEnding::Changed { .. });
    let is_at = |k: usize, there: f64, time: f64| {
        there == time || ended && k + 1 == times.len() && (there - time).abs() <= SHIFT * time.abs()
    };
    let both = motion.samples().iter().zip(times).enumerate();
    both.take_while(|(k, (s, time))| is_at(*k, s.state.time, **time)).map(|(_, (s, _))| s.state).collect()
}
