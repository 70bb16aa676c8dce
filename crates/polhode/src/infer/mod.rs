//! From motions back to what made them: whether a program's motion is right, and if not why.
//!
//! [`judge`] compares a motion that another program computed with the exact one.

pub mod correlated;
pub mod covariance;
pub mod judge;
pub mod possible;
pub mod random;
