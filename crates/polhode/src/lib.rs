//! Rigid-body dynamics: from mass to motion.
#![forbid(unsafe_code)]

mod body;
mod math;

pub use body::assembly::{PlacedPart, assemble};
pub use body::error::BodyError;
pub use body::finding::{Finding, Severity};
pub use body::inertia::{InertiaAbout, InertiaTensor};
pub use body::mass_properties::MassProperties;
pub use body::material::Material;
pub use body::mesh::{ClosedMesh, Triangle};
pub use body::particles::{Particle, mass_properties_of_particles};
pub use body::principal::{PrincipalFrame, Symmetry};
pub use body::shape::r#box::BoxShape;
pub use body::shape::{Extent, Shape, Spread, Substance};
pub use math::frame::{Body, Frame, Part, Principal, Space};
pub use math::rotation::{Attitude, Rotation, RotationError};
pub use math::vector::{
    Acceleration, AngularAcceleration, AngularMomentum, AngularVelocity, CrossProduct, Direction, Force, Momentum,
    Position, Torque, Vector, Velocity, quantity,
};
