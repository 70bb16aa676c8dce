//! Model of the motion: state, body with pivot and wheels, Euler's equations, torques, orbits,
//! events.

pub(crate) mod energy;
pub(crate) mod euler;
pub(crate) mod event;
pub(crate) mod event_detection;
pub(crate) mod event_function;
pub(crate) mod event_slope;
pub(crate) mod kinematics;
pub(crate) mod law;
pub(crate) mod mass_history;
pub(crate) mod orbit;
pub(crate) mod orbital_elements;
pub(crate) mod passage;
pub(crate) mod pointing;
pub(crate) mod require;
pub(crate) mod rotor;
pub(crate) mod schedule;
pub(crate) mod state;
pub(crate) mod state_derivatives;
pub(crate) mod state_variables;
pub mod torque;
pub(crate) mod wheel;
