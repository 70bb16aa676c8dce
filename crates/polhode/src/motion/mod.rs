//! Motion: states in time, and what moves them. This room reads and writes no files.
//!
//! `state` and `rotor` say what turns; `euler` how; `torque` what turns it; `free` has the closed forms; `propagate`
//! integrates everything else; `trajectory` puts the two together; `inverse` goes from motion to torque.

pub(crate) mod error;
pub(crate) mod euler;
pub(crate) mod event;
pub(crate) mod free;
pub(crate) mod inverse;
pub(crate) mod kinematics;
pub(crate) mod orbit;
pub(crate) mod pendulum;
pub(crate) mod prescribed;
pub(crate) mod propagate;
pub(crate) mod rotor;
pub(crate) mod scenario;
pub(crate) mod shaft;
pub(crate) mod state;
pub(crate) mod state_variables;
pub(crate) mod torque;
pub(crate) mod trajectory;
pub(crate) mod wheel;
