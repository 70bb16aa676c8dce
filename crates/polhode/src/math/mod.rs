//! Numbers, vectors and rotations. This module contains no physics: nothing here has a mass.
//!
//! The type of a [`Vector`] states its quantity and its frame, so that inconsistent operations do
//! not compile. A [`Rotation<A, B>`] converts components along the axes of B to those along A,
//! v_A = R_AB v_B. The frames are [`Space`], [`Body`], [`Principal`], [`Part`] (in which a part of
//! a body is described before it is placed), and [`Orbital`] (local vertical, local horizontal).
//!
//! [`elliptic`] has Jacobi's functions and Legendre's integrals. [`formula`] has expressions as
//! lists of instructions. [`Scalar`] and [`VectorAlgebra`] define the operations of a law
//! ([`crate::motion::torque::Law`]).

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
