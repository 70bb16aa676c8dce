//! Vertices that are not finite.

/// Vertices that are not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotFinite {
    /// How many: each corner of each triangle counts.
    pub vertices: u64,
    /// The first triangle with one, from 0.
    pub triangle: u64,
    /// Where in its record the first coordinate of them is, in bytes.
    pub offset: usize,
    /// That coordinate.
    pub value: f32,
}
