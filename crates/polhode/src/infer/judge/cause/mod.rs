//! Why a motion is wrong: causes, each tried.
//!
//! A residual does not say what made it. So each mistake that programs make with rigid bodies is made here too, from the same start: the
//! equations of motion with the mistake in them (`law.rs`, followed by extrapolation in `follow.rs`), or the steps of the method
//! (`scheme.rs`), with the step that is declared or the one that fits best (`methods.rs`). A cause whose motion is nearer to the run than
//! the exact motion by far ([`TriedCause::explained`]) is named; if none is, nothing is said. Causes with numbers fitted to the run have to
//! explain more, and are named after those without.

pub(crate) mod bodies;
pub(crate) mod follow;
pub(crate) mod found;
pub(crate) mod law;
pub(crate) mod laws;
pub(crate) mod methods;
pub(crate) mod name;
pub(crate) mod other_body;
pub(crate) mod rounding;
pub(crate) mod rows;
pub(crate) mod scheme;
pub(crate) mod search;
pub(crate) mod trial;

pub use found::{Causes, TriedCause, TriedStart, Untried};
pub use name::Cause;
pub use scheme::{Scheme, Turn};
pub use search::causes;
