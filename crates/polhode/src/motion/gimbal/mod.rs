//! Rotors in a Cardan suspension: gyroscopes in gimbals, gyrocompasses.
//!
//! [`Gimbals`] suspend a body, the rotor, from a [`Base`] that is at rest or turns with the Earth
//! or a vehicle. The outer gimbal turns about an axis of the base, the inner gimbal about an axis
//! of the outer one, and the rotor about an axis of the inner one. Each [`Axis`] is free, locked or
//! driven, and may have damping, a spring and a constant torque. Each [`Gimbal`] has mass
//! properties or is massless.
//!
//! [`Simulation::in_gimbals`](crate::motion::Simulation::in_gimbals) computes the motion by Taylor
//! series of Lagrange's equations.

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
