//! Inference from motions: whether a program's motion is correct, and the causes if it is not.
//!
//! [`judge`] compares a motion that another program computed with the exact one.

pub mod correlated;
pub mod covariance;
pub mod judge;
pub mod possible;
pub mod random;
