//! Reports of mass properties, as text and JSON.

pub mod block;
mod error_estimate;
mod inertia;
mod mass_bound;
mod molecule;
mod parts;
mod sign_proof;

pub use error_estimate::error_estimate;
pub use inertia::InertiaReport;
pub use mass_bound::mass_bound;
pub use molecule::MoleculeReport;
pub use parts::{PartRow, parts};
pub use sign_proof::sign_proof;
