//! Reports of mass properties, as text and JSON.

pub mod block;
mod error_estimate;
mod inertia;
mod molecule;
mod parts;
mod sign_proof;

pub use error_estimate::error_estimate;
pub use inertia::InertiaReport;
pub use molecule::MoleculeReport;
pub use parts::{PartRow, parts};
pub use sign_proof::sign_proof;
