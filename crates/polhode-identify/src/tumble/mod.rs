//! Tumbles: free motion of a thrown body, measured by a gyro on it or by tracked attitudes.

mod cut;
mod first_guess;
mod flaw;
mod flight;
mod gap;
mod handedness;
mod identify;
mod inspection;
mod model;
mod motion;
mod next;
mod noise;
mod options;
mod range;
mod sensor;
#[expect(clippy::module_inception, reason = "the noun of the module")]
mod tumble;
mod unit;

pub use cut::{FlightSearch, find_flights};
pub use flaw::Flaw;
pub use flight::{AttitudeReading, Flight, GyroReading};
pub use identify::identify_tumbles;
pub use next::{NextFlight, next_flight};
pub use options::TumbleOptions;
pub use range::{GyroRange, Reached};
pub use sensor::GyroErrors;
pub use tumble::{FlightFit, Tumble};
