//! What a page is sent, for other pages than the report's: shapes, meshes made coarser, boxes for tensors.

pub use crate::report::page::{decimated, equivalent_box, shape_of};
