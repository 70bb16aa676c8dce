//! Shapes, decimated meshes and equivalent boxes of tensors, for pages other than the report's.

pub use crate::report::page::{decimated, equivalent_box, shape_of};
