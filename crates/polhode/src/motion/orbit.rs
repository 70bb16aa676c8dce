//! The orbit of a centre of mass about a point mass.

/// An orbit about a point mass.
#[derive(Clone, Debug, PartialEq)]
pub struct Orbit {}
