//! Robot and simulation models (URDF, SDF, MJCF): are these inertias right?
//!
//! - [`model`]: what a file says: links, inertials, geometry, joints, and where each number stands
//! - [`finding`]: what is wrong with it, why, and what would repair it
//! - [`repair`]: the text with repairs made, every other byte as it was
//! - [`body`]: a link's mass properties in its own frame
//! - [`mod@lump`]: links joined to one body
//! - [`line_index`]: lines and columns of places

pub mod body;
pub mod finding;
pub mod line_index;
pub mod lump;
pub mod model;
mod placement;
pub mod repair;
