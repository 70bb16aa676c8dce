//! The error of a motion in gimbals: other runs of it, with larger rounding and from other inputs.

use super::ErrorEffort;
use super::comparison::ComparisonRun;
use super::held::{of_held, reached};
use super::inputs::Change;
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::math::vector::Vector;
use crate::motion::gimbal::GimbalSimulation;
use crate::motion::model::state::State;
use crate::motion::run::estimated_error::GlobalError;
use crate::motion::run::trajectory::Trajectory;

/// Estimates of the error of a trajectory that a simulation has computed.
pub(crate) fn of_gimbals(
    simulation: &GimbalSimulation<'_>,
    trajectory: &Trajectory,
    effort: ErrorEffort,
    progress: &mut dyn FnMut(f64) -> bool,
) -> GlobalError {
    let count = trajectory.gimbals().map_or(0, |motion| motion.statistics().accepted);
    of_held(trajectory, count, effort, &mut |run, times| states(simulation, run, times, progress))
}

/// The states of a motion from other inputs, as far as it gets: another tensor and another lever of the rotor, other angles and rates at the start.
fn states(
    simulation: &GimbalSimulation<'_>,
    run: ComparisonRun,
    times: &[f64],
    progress: &mut dyn FnMut(f64) -> bool,
) -> Vec<State> {
    let mut change = Change::new(run.inputs);
    let (body, gimbals) = (simulation.body(), simulation.gimbals());
    let inertia = InertiaTensor::from_symmetric(change.inertia(body.inertia().symmetric()));
    let lever = (body.center_of_mass() - gimbals.crossing()).to_array();
    let center = gimbals.crossing() + Vector::from_array(change.each(lever));
    let changed = inertia.and_then(|inertia| MassProperties::new(body.mass(), center, inertia));
    let axes = gimbals.axes().map(|axis| {
        let [angle, rate] = change.each([axis.angle(), axis.rate()]);
        axis.starting(angle, rate)
    });
    let (body, gimbals) = (changed.unwrap_or(*body), gimbals.with_axes(axes));
    let motion = GimbalSimulation::new(&body, &gimbals, simulation.start(), times)
        .tolerance(run.tolerance(simulation.bound()))
        .with_noise(Some(run.steps))
        .run_watched(progress);
    let Ok(motion) = motion else { return Vec::new() };
    reached(motion.samples().iter().map(|s| s.state), times, motion.failure().is_some())
}
