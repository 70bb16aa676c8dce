//! Runs of a rotor in gimbals.

use super::channel::Reading;
use super::ending::MethodReason;
use super::march::March;
use super::solution::{Solution, Steps};
use super::trajectory::{HeldMotion, Trajectory};
use crate::motion::error::MotionError;
use crate::motion::gimbal::problem::GimbalProblem;
use crate::motion::gimbal::system::InGimbals;
use crate::motion::model::event_detection::EventDetector;
use crate::motion::model::rotor::Rotor;

/// Computes the motion. `progress` receives the time after each step; if it returns `false`, the
/// computation stops.
///
/// # Errors
/// The errors of [`InGimbals::new`], and [`MotionError::Stopped`] if `progress` returned `false`.
pub(super) fn run(
    problem: &GimbalProblem<'_>,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<Trajectory, MotionError> {
    let (system, start) = InGimbals::new(problem)?;
    let rotor = Rotor::pivoted(problem.body, problem.gimbals.crossing());
    let detector = EventDetector::new(&rotor, &[], (problem.events, problem.event_sides), &start.state);
    let mut march = March::new(system, detector, problem.times);
    let ending = march.run(start, None, progress)?;
    let event_sides = march.detector().sides();
    let March { system, mut samples, crossings, .. } = march;
    if let Some(first) = samples.first_mut() {
        first.state.attitude = first.state.attitude.continuous_with(start.state.attitude);
    }
    let steps = Steps { tolerance: problem.tolerance, statistics: system.statistics };
    Trajectory::held(
        &rotor,
        HeldMotion {
            start: Reading::Gimbals(start),
            readings: samples.into_iter().map(Reading::Gimbals).collect(),
            changes: Vec::new(),
            crossings,
            event_sides,
            ending,
            reason: MethodReason::Gimbals,
            solution: Solution::Taylor(steps),
        },
    )
}
