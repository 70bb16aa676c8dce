//! Motion: states in time, and what moves them. This room reads and writes no files.
//!
//! `state` and `rotor` say what turns; `euler` how; `torque` what turns it; `free` has the closed forms; `propagate`
//! integrates everything else; `event` and `watch` look out on the way; `global_error` says how right it is; `trajectory` puts these together; `inverse` goes from motion
//! to torque.

pub(crate) mod closed_form;
pub(crate) mod course;
pub(crate) mod ending;
pub(crate) mod ensemble;
pub(crate) mod error;
pub(crate) mod euler;
pub(crate) mod event;
pub(crate) mod free;
pub(crate) mod global_error;
pub(crate) mod heavy_top;
pub(crate) mod inverse;
pub(crate) mod kinematics;
pub(crate) mod orbit;
pub(crate) mod orbital_elements;
pub(crate) mod pendulum;
pub(crate) mod pendulum_motion;
pub(crate) mod prescribed;
pub(crate) mod propagate;
pub(crate) mod reach;
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
