//! Meshes that are written in the model itself.

use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash as _, Hasher as _};

use polhode::body::mesh::TriangleMesh;

/// Triangles that are written in the model itself, in its own unit of length.
#[derive(Clone, Debug, PartialEq)]
pub struct InlineMesh {
    surface: TriangleMesh,
    is_hull: bool,
    hash: u64,
}

impl InlineMesh {
    /// Returns the shape that these triangles bound or, with `is_hull`, their convex hull.
    pub fn new(surface: TriangleMesh, is_hull: bool) -> Self {
        let mut hasher = DefaultHasher::new();
        is_hull.hash(&mut hasher);
        surface.coordinates().as_flattened().iter().for_each(|c| c.to_bits().hash(&mut hasher));
        surface.triangles().hash(&mut hasher);
        Self { surface, is_hull, hash: hasher.finish() }
    }

    /// Returns the triangles.
    pub const fn surface(&self) -> &TriangleMesh {
        &self.surface
    }

    /// Returns true if the shape is the convex hull of the triangles.
    pub const fn is_hull(&self) -> bool {
        self.is_hull
    }

    /// Returns a hash of the content.
    pub(crate) const fn content_hash(&self) -> u64 {
        self.hash
    }
}
