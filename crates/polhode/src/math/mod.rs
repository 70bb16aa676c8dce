//! Numbers, vectors and rotations. This module knows no physics: nothing here has a mass.
//!
//! A [`Vector`] has a quantity and a frame as its type, so that what does not belong together does not compile; a [`Rotation<A, B>`] turns
//! components along the axes of B into those along A, v_A = R_AB v_B. There are four frames: [`Space`], [`Body`], [`Principal`] and
//! [`Part`], in which a part of a body is described before it is put in its place.
//!
//! [`elliptic`] has Jacobi's functions and Legendre's integrals, [`formula`] expressions as text, and [`Scalar`] and [`VectorAlgebra`] the
//! operations that a law may use ([`crate::motion::torque::Law`]).

pub(crate) mod algebra;
pub(crate) mod complex;
pub(crate) mod derivative;
pub(crate) mod display;
pub(crate) mod double;
pub(crate) mod eigenvalues;
pub(crate) mod elementary;
pub mod elliptic;
pub(crate) mod fine_eigen;
pub mod formula;
pub(crate) mod frame;
pub(crate) mod frequency;
pub(crate) mod jet;
pub(crate) mod kepler;
pub(crate) mod landen;
pub(crate) mod lanes;
pub(crate) mod machine;
pub(crate) mod means;
pub(crate) mod number;
pub(crate) mod quaternion;
pub(crate) mod root;
pub(crate) mod rotation;
pub(crate) mod sign_changes;
pub(crate) mod spline;
pub(crate) mod sum;
pub(crate) mod symmetric3;
pub(crate) mod triple;
pub(crate) mod vector;

pub use algebra::{Scalar, VectorAlgebra};
pub use frame::{Body, Frame, Orbital, Part, Principal, Space};
pub use rotation::{Attitude, Rotation, RotationError};
pub use symmetric3::symmetric_eigen;
pub use vector::{
    Acceleration, AngularAcceleration, AngularMomentum, AngularVelocity, CrossProduct, Direction, Force,
    Momentum, Position, Torque, Vector, Velocity, quantity,
};
