//! Numerical integration of the equations of motion, for every motion without a closed form.
//!
//! - `dop853` computes one Runge–Kutta step and contains no physics; `runge_kutta` controls its
//!   error.
//! - `taylor` and `splitting` are the other two integrators.
//! - `chart` writes the motion as an ordinary differential equation.
//! - `orientation` accumulates rotations.
//! - `piece` lists what acts until something changes.
//! - `stepper` is the common interface of the integrators.

pub(crate) mod balanced;
pub(crate) mod bound;
mod chart;
mod dop853;
mod half_turn;
mod ledger;
pub(crate) mod noise;
mod orientation;
mod piece;
mod rounding;
mod runge_kutta;
pub(crate) mod splitting;
pub(crate) mod step_statistics;
pub(crate) mod stepper;
mod tableau;
pub(in crate::motion) mod taylor;
