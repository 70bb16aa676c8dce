//! Rigid-body dynamics: from mass to motion.
//!
//! The input is a body: particles, solids, meshes, assemblies, or a tensor. The crate computes its
//! mass, centre of mass, inertia tensor, and principal moments and axes. Euler's equations then
//! give the motion from the torque, or the torque from the motion. Results are exact where a closed
//! form is implemented. All others come with an estimate of their error.
//!
//! ```
//! use polhode::prelude::*;
//!
//! // A body of two parts: a brick, and a short rod across its top.
//! let brick = BoxShape::new([0.20, 0.10, 0.06])?.mass_properties(Substance::Density(1800.0))?;
//! let rod = Rod::new(0.30)?.mass_properties(Substance::Mass(0.4))?;
//! let across = Rotation::from_axis_angle(Direction::new(0.0, 1.0, 0.0), std::f64::consts::FRAC_PI_2)?;
//! let body = assemble(&[
//!     PlacedPart::new(brick, Position::ZERO, Rotation::identity())?,
//!     PlacedPart::new(rod, Position::new(0.02, 0.01, 0.05), across)?,
//! ])?;
//! let principal = body.principal();
//! let [i1, i2, i3] = principal.moments();
//! assert!(i1 < i2 && i2 < i3 && i1 + i2 > i3);
//!
//! // Thrown with a spin close to the intermediate axis, it flips.
//! let omega = principal.axis(1) * 5.0 + principal.axis(0) * 0.01;
//! let omega = AngularVelocity::from_array(omega.to_array());
//! let start = State { time: 0.0, attitude: Attitude::identity(), omega };
//! let rotor = Rotor::free(&body);
//! let flip = FreeRegime::of(&rotor, &start).flip_interval.ok_or("no flip")?;
//! let motion = Trajectory::compute(&rotor, &[], start, &[0.0, flip], Method::Auto, 1e-13)?;
//! let flipped = motion.samples()[1].state.omega.dot(principal.axis(1));
//! assert!((flipped + 5.0).abs() < 1e-3);
//! assert!(Drift::of(&motion).ok_or("no samples")?.momentum < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Conventions
//!
//! - SI units: m, kg, s, rad, N·m, J.
//! - Off-diagonal elements of an inertia tensor are *minus* the integrals, `I_xy` = −∫xy dm, so
//!   that L = I ω. The tensor is about the centre of mass, along body axes, unless its type
//!   ([`body::InertiaAbout`]) states otherwise.
//! - [`Rotation<A, B>`](math::Rotation) is `R_AB`, with `v_A = R_AB v_B`. The
//!   [`Attitude`](math::Attitude) is `R_space_body`. Its quaternion is a unit Hamilton quaternion,
//!   scalar first.
//! - ω is the body's angular velocity relative to [`Space`](math::Space), along
//!   [`Body`](math::Body) axes unless its type states otherwise.
//! - Principal moments are in ascending order, i1 ≤ i2 ≤ i3; their axes are right-handed.
//!
//! # Modules
//!
//! | module | contents | independent of |
//! |---|---|---|
//! | [`math`] | frames, vectors, rotations, elliptic functions, formulas | mass |
//! | [`body`] | mass, centre of mass, inertia tensor and principal axes of bodies | time |
//! | [`motion`] | motion from torque, and torque from motion | files |
//! | [`observe`] | quantities derived from a motion | integration |
//! | [`infer`] | verification of another program's motion, and the cause of its errors | files |
//!
//! Each module uses only the modules above it. [`prelude`] has the names that most programs use;
//! [`interop`] has conversions to nalgebra, glam, mint and serde.

#![forbid(unsafe_code)]

pub mod body;
pub mod infer;
pub mod interop;
pub mod math;
pub mod motion;
pub mod observe;

/// The names that most programs use.
pub mod prelude {
    pub use crate::body::mesh::{ClosedMesh, TriangleMesh};
    pub use crate::body::shape::{BoxShape, Cylinder, Rod, Shape, Sphere, Substance};
    pub use crate::body::{
        BodyError, InertiaTensor, MassProperties, Particle, PlacedPart, PrincipalFrame, assemble,
        mass_properties_of_particles,
    };
    pub use crate::math::{
        Acceleration, AngularMomentum, AngularVelocity, Attitude, Body, Direction, Force, Part, Position,
        Principal, Rotation, Scalar, Space, Torque, Vector, VectorAlgebra, Velocity,
    };
    pub use crate::motion::torque::{ConstantTorque, Law, LawInput, TorqueModel, UniformGravity};
    pub use crate::motion::{
        Event, FreeMotion, Method, MotionError, Rotor, Sample, Scenario, Simulation, State, Trajectory, Wheel,
    };
    pub use crate::observe::{Drift, FreeRegime};
}

/// The README's program, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
