//! Motion: states in time, and what moves them. This room reads and writes no files.
//!
//! `state` and `rotor` say what turns; `euler` how; `torque` what turns it; `free` has the closed forms; `propagate`
//! integrates everything else; `event` and `watch` look out on the way; `trajectory` puts these together; `inverse` goes from motion
//! to torque.

pub(crate) mod closed_form;
pub(crate) mod course;
pub(crate) mod ending;
pub(crate) mod ensemble;
pub(crate) mod error;
pub(crate) mod euler;
pub(crate) mod event;
pub(crate) mod free;
pub(crate) mod heavy_top;
pub(crate) mod inverse;
pub(crate) mod kinematics;
pub(crate) mod orbit;
pub(crate) mod orbital_elements;
pub(crate) mod pendulum;
pub(crate) mod pendulum_motion;
pub(crate) mod prescribed;
pub(crate) mod propagate;
pub(crate) mod rotor;
pub(crate) mod sample;
pub(crate) mod scenario;
pub(crate) mod shaft;
pub(crate) mod simulation;
pub(crate) mod solution;
pub(crate) mod state;
pub(crate) mod state_variables;
pub(crate) mod swinging_body;
pub(crate) mod torque;
pub(crate) mod trajectory;
pub(crate) mod watch;
pub(crate) mod wheel;
// SCRATCH
#[doc(hidden)]
pub fn scratch_advance(
    bodies: &[(rotor::Rotor, Vec<torque::TorqueModel>, state::State)],
    times: &[f64],
    tolerance: f64,
    states: &mut [state::State],
) -> Vec<(usize, error::MotionError)> {
    use propagate::taylor::{Body, advance, kind};
    let bodies: Vec<Body<'_>> =
        bodies.iter().map(|(rotor, torques, start)| Body { rotor, torques, start: *start }).collect();
    let first = kind(bodies[0].rotor, bodies[0].torques, tolerance);
    assert!(first.is_some() && bodies.iter().all(|b| kind(b.rotor, b.torques, tolerance) == first));
    advance(&bodies, times, tolerance, states)
}
