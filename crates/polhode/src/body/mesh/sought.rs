//! What a mesh is looked through for.

/// What a mesh is looked through for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sought {
    /// All that can be said of it.
    All,
    /// What it bounds, or why it bounds no solid, and no remarks.
    FirstError,
}
