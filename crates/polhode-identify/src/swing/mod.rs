//! Swing tests: from the periods of a body that hangs on wires or turns about an axis to its inertia tensor.
//!
//! A [`SwingPlan`] has the body's mass and centre, numbers that rigs share, and tests: each a [`Rig`], the body's [`Placement`] in it, and what was measured.
//! The motion is that of the equations, at its amplitude, not of a small-angle formula; [`identify_swings`] fits all tests at once.

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
