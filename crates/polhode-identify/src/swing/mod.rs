//! Swing tests: inertia tensor from the periods of a body on wires or about an axis.
//!
//! A [`SwingPlan`] contains the body's mass and centre, numbers that rigs share, and tests. Each
//! test has a [`Rig`], the body's [`Placement`] in it, and a measurement. [`identify_swings`] fits
//! all tests together. It solves the full equations of motion at the measured amplitude and does
//! not use small-angle formulas.

mod course;
mod dual;
mod family;
mod hung_mass;
mod identify;
mod measurement;
mod mistake;
mod next;
mod number;
mod orbit;
mod plan;
mod problem;
mod rig;
#[cfg(test)]
mod tests;

pub use hung_mass::{Fixture, Placement};
pub use identify::{SwingEstimate, SwingResult, identify_swings};
pub use measurement::{AmplitudeReading, Counted, Damping, Interval, Logged, Measurement, Signal};
pub use mistake::{Mistake, MistakeKind};
pub use next::{NextSwing, next_swing};
pub use number::{Linear, Measured, NumberId, Point};
pub use plan::{Air, SwingPlan, SwingTest};
pub use rig::{Axis, Rig, Wire, Wires};
