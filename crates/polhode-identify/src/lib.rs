//! Estimation of mass properties from measured motion, with error estimates.
//!
//! A model of the body's motion predicts the measurements, and nonlinear least squares minimizes
//! the residuals. Every iterate is a physically consistent body. Directions that the measurements
//! do not determine are reported ([`Estimate::unknown`]) and not filled in. A test compares the
//! residuals with the noise ([`ResidualTest`]).
//!
//! [`run`] executes a [`Request`]: it reads the measurements and estimates the body.
//!
//! - [`tumble`]: free motion of a thrown body, from a gyro or tracked attitudes
//! - [`swing`]: periods of a body on wires, a pivot or an edge
//! - [`payload`]: wrenches and motion at a robot's wrist

mod coordinates;
mod decomposition;
mod error;
mod estimate;
mod given_plan;
mod knowledge;
mod least_squares;
mod next;
pub mod payload;
mod principal;
pub mod read;
pub mod report;
mod request;
mod residuals;
mod run;
mod six;
pub mod swing;
pub mod tumble;

pub use error::IdentifyError;
pub use estimate::{ANGLE, Estimate, Number, Undetermined};
pub use given_plan::GivenPlan;
pub use knowledge::Knowledge;
pub use next::{Candidate, NextExperiment};
pub use principal::PrincipalEstimate;
pub use request::{REQUEST_SCHEMA, Request};
pub use residuals::ResidualTest;
pub use run::{Identified, REPORT_SCHEMA, run};

/// Plausible range of gravity at the Earth's surface, m/s²: 9.780 at the equator, 9.832 at the
/// poles, less on mountains.
pub const ON_EARTH: core::ops::Range<f64> = 9.7..9.9;
