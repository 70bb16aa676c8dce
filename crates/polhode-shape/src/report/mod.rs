//! Mass properties for people and for programs.

pub mod block;
mod inertia;
mod molecule;

pub use inertia::InertiaReport;
pub use molecule::MoleculeReport;
