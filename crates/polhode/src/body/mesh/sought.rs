//! Scope of a mesh analysis.

/// Scope of a mesh analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sought {
    /// All errors, corrections and remarks.
    All,
    /// The solid that the mesh bounds, or the first error, without remarks.
    FirstError,
    /// Everything that follows from edges, orientations and nesting, without intersections.
    NoIntersections,
}
