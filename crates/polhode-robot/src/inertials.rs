//! Inertials of a whole model from its geometry: mass, centre and tensor of each link, written into
//! the model's text.
//!
//! - [`InertialsRequest`]: choice of links, geometry and masses
//! - [`write_inertials`]: reads the model, computes, edits, and reads and checks the result
//! - [`Inertials`]: the links with the reason for each, the new text, and its diff
//!
//! A link keeps its mass unless the request states another one. Its solid is uniform unless parts
//! have their own substances. An inertial is written only if the edited model reads back with the
//! intended numbers and without a finding about that link.

mod choice;
mod digits;
mod element;
mod outcome;
#[cfg(feature = "usd")]
mod prim;
mod report;
mod request;
mod run;
mod selection;
mod substance;

pub use outcome::{Inertials, LinkOutcome, Outcome, Written};
pub use request::{InertialsOptions, InertialsRequest, Only, Origin};
pub use run::write_inertials;
