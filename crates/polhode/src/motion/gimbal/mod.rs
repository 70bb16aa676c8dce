//! A rotor in a Cardan suspension: a gyroscope in gimbals, a gyrocompass.
//!
//! [`Gimbals`] hang a body, the rotor, from a [`Base`] that stands still or turns (with the Earth, or a vehicle): the outer gimbal turns about an axis of the
//! base, the inner one about an axis of the outer, the rotor about an axis of the inner. Each [`Axis`] is free, locked or driven, damped, sprung and turned by
//! a constant torque; each [`Gimbal`] has mass, or none. [`GimbalSimulation`] computes the motion by Taylor series of Lagrange's equations.

mod axis;
mod base;
mod equations;
mod model;
mod run;
mod sample;
mod simulation;
mod stepper;
mod suspension;
mod trajectory;

pub use axis::{Axis, Hold, Spring};
pub use base::Base;
pub use sample::GimbalSample;
pub use simulation::GimbalSimulation;
pub use suspension::{Gimbal, Gimbals};
pub use trajectory::GimbalTrajectory;
