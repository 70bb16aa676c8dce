//! The error of a motion on the ground: other runs of it, with larger rounding and from other inputs.

use super::ErrorEffort;
use super::comparison::ComparisonRun;
use super::held::{of_held, reached};
use super::inputs::Change;
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::motion::contact::{ContactEnding, ContactSimulation, ContactStart};
use crate::motion::model::state::State;
use crate::motion::run::estimated_error::GlobalError;
use crate::motion::run::trajectory::Trajectory;

/// Estimates of the error of a trajectory that a simulation has computed.
pub(crate) fn of_contact(
    simulation: &ContactSimulation<'_>,
    trajectory: &Trajectory,
    effort: ErrorEffort,
    progress: &mut dyn FnMut(f64) -> bool,
) -> GlobalError {
    let count = trajectory.contact().map_or(0, |motion| motion.statistics().accepted);
    of_held(trajectory, count, effort, &mut |run, times| states(simulation, run, times, progress))
}

/// The states of a motion from other inputs, as far as it gets.
fn states(
    simulation: &ContactSimulation<'_>,
    run: ComparisonRun,
    times: &[f64],
    progress: &mut dyn FnMut(f64) -> bool,
) -> Vec<State> {
    let mut change = Change::new(run.inputs);
    let body = simulation.body();
    let inertia = InertiaTensor::from_symmetric(change.inertia(body.inertia().symmetric()));
    let changed =
        inertia.and_then(|inertia| MassProperties::new(body.mass(), body.center_of_mass(), inertia));
    let start = simulation.start();
    let start = ContactStart { state: change.start(start.state), ..start };
    // What stops the motion, or is only written down, does not change it.
    let body = changed.unwrap_or(*body);
    let motion = ContactSimulation::new(&body, simulation.contact(), start, times)
        .tolerance(run.tolerance(simulation.bound()))
        .with_noise(Some(run.steps))
        .run_watched(progress);
    let Ok(motion) = motion else { return Vec::new() };
    let ended = matches!(motion.ending(), ContactEnding::Changed { .. });
    reached(motion.samples().iter().map(|s| s.state), times, ended)
}
