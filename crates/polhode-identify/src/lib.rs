//! From measured motion to mass properties, with honest errors.
//!
//! What is measured is predicted by a model of the body's motion, and the body is where the sum of squares of what is left is least. Every body that the method
//! looks at is a possible one. What the measurements do not determine is said, and not filled in ([`Estimate::unknown`]); whether what is left is noise is
//! tested ([`ResidualTest`]).
//!
//! [`run`] answers a [`Request`]: it reads what was measured, and finds the body.
//!
//! - [`tumble`]: the free motion of a thrown body, by a gyro on it or by tracked attitudes
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

/// Gravity at the Earth's surface, m/s²: 9.780 at the equator, 9.832 at the poles, and less on mountains.
pub const ON_EARTH: core::ops::Range<f64> = 9.7..9.9;
