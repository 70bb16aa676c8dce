//! Robot and simulation models (URDF, SDF, MJCF): are these inertias right?
//!
//! - [`model`]: what a file says: links, inertials, geometry, joints, and where each number stands
//! - [`read`]: files in, models out
//! - [`geometry`]: what the shapes of a link enclose
//! - [`finding`]: what is wrong with it, why, and what would repair it

pub mod finding;
pub mod geometry;
pub mod model;
mod pose;
pub mod read;
