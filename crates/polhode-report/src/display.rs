//! What a page is sent, for other pages than the report's: numbers as base64, shapes, meshes made coarser, boxes for tensors.

pub use crate::base64::{f32s, u32s};
pub use crate::page::{decimated, equivalent_box, shape_of};
