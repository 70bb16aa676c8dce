//! A record of a binary STL file.

/// One triangle of a binary STL file.
pub type Record = [u8; 50];

/// Triangles in a group: one vector of AVX-512 in `f32`.
pub(crate) const GROUP: usize = 16;

/// Where the vertices start in a record, behind the normal.
pub(crate) const VERTICES: usize = 12;
