//! The error of a motion on the ground: other runs of it, with larger rounding and from other inputs.

use super::held::of_held;
use super::inputs::Change;
use super::{ErrorEffort, GlobalError};
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::motion::contact::{ContactEnding, ContactSimulation, ContactStart};
use crate::motion::model::state::State;
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::propagate::noise::StepNoise;

/// How much later or earlier an end may be and still be the same one, relative.
const SHIFT: f64 = 1e-6;

/// Estimates of the error of a trajectory that a simulation has computed.
pub(crate) fn of_contact(
    simulation: &ContactSimulation<'_>,
    trajectory: &Trajectory,
    effort: ErrorEffort,
    progress: &mut dyn FnMut(f64) -> bool,
) -> GlobalError {
    let steps = trajectory.contact().map_or(0, |motion| motion.statistics().accepted);
    of_held(trajectory, steps, effort, &mut |inputs, noise, times| {
        states(simulation, inputs, noise, times, progress)
    })
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
