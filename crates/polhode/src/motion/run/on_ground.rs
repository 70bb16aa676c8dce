//! Runs of a body on the ground.

use super::channel::Reading;
use super::ending::{Halt, MethodReason};
use super::march::March;
use super::solution::{Solution, Steps};
use super::trajectory::{HeldMotion, Trajectory};
use crate::motion::contact::problem::ContactProblem;
use crate::motion::contact::system::OnGround;
use crate::motion::error::MotionError;
use crate::motion::model::event_detection::EventDetector;
use crate::motion::model::rotor::Rotor;

/// Computes the motion. `progress` receives the time after each step; if it returns `false`, the
/// computation stops.
///
/// # Errors
/// The errors of [`OnGround::new`], and [`MotionError::Stopped`] if `progress` returned `false`.
pub(super) fn run(
    problem: &ContactProblem<'_>,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<Trajectory, MotionError> {
    let (system, start, halted) = OnGround::new(problem)?;
    let rotor = Rotor::free(problem.body);
    let detector = EventDetector::new(&rotor, &[], (problem.events, problem.event_sides), &start.state);
    let mut march = March::new(system, detector, problem.times);
    let ending = march.run(start, halted.map(Halt::Change), progress)?;
    let event_sides = march.detector().sides();
    let March { system, samples, crossings, .. } = march;
    let steps = Steps { tolerance: problem.bound(), statistics: system.statistics };
    let solution = match system.solvers() {
        [true, true] => Solution::CollocationAndTaylor(steps),
        [true, false] => Solution::Collocation(steps),
        [false, _] => Solution::Taylor(steps),
    };
    Trajectory::held(
        &rotor,
        HeldMotion {
            start: Reading::Contact(start),
            readings: samples.into_iter().map(Reading::Contact).collect(),
            changes: system.changes,
            crossings,
            event_sides,
            ending,
            reason: MethodReason::Contact,
            solution,
        },
    )
}
