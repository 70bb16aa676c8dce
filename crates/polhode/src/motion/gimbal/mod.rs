//! A rotor in a Cardan suspension: a gyroscope in gimbals, a gyrocompass.
//!
//! [`Gimbals`] hang a body, the rotor, from a [`Base`] that stands still or turns (with the Earth, or a
//! vehicle): the outer gimbal turns about an axis of the base, the inner one about an axis of the outer,
//! the rotor about an axis of the inner. Each [`Axis`] is free, locked or driven, damped, sprung and turned
//! by a constant torque; each [`Gimbal`] has mass, or none.
//! [`Simulation::in_gimbals`](crate::motion::Simulation::in_gimbals) computes the motion by Taylor series of
//! Lagrange's equations.

mod axis;
mod base;
mod equations;
mod model;
pub(crate) mod problem;
mod state;
mod stepper;
mod suspension;
pub(crate) mod system;

pub use axis::{Axis, Hold, Spring};
pub use base::Base;
pub use state::GimbalState;
pub use suspension::{Gimbal, Gimbals};
