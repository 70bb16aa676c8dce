//! Causes of a wrong motion, each tried.
//!
//! A residual does not show its cause. Therefore each mistake that programs make with rigid bodies
//! is reproduced here, from the same start. Wrong equations of motion (`law.rs`) are integrated by
//! extrapolation (`follow.rs`). Wrong or inaccurate methods (`scheme.rs`) are run with the declared
//! step size, or with the one that fits best (`methods.rs`). A cause is named if its motion is much
//! closer to the run than the exact motion ([`TriedCause::explained`]); otherwise none is named.
//! Causes with numbers fitted to the run must explain more, and rank after those without.

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
