//! Runs: simulations and their events, trajectories and their errors, ensembles.

pub(crate) mod channel;
pub mod channels;
pub(crate) mod derivative_log;
pub(crate) mod derivatives;
pub(crate) mod ending;
pub(crate) mod ensemble;
pub(crate) mod estimated_error;
pub(crate) mod global_error;
mod in_gimbals;
mod march;
mod on_ground;
mod rotor_problem;
pub(crate) mod sample;
pub(crate) mod simulation;
pub(crate) mod solution;
pub(crate) mod trajectory;
mod turning;
