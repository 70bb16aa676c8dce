//! Numerical integration of the equations of motion, for everything that has no closed form.
//!
//! `dop853` is the rule for one step and knows no physics; `chart` writes the motion as an ordinary differential
//! equation that it can step; `orientation` adds up its turns; `piece` says what acts until something changes; `stepper` puts steps together and controls their error.
//! Taylor's method and splitting are beside `dop853`.

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
