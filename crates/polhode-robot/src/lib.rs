//! Robot and simulation models (URDF, SDF, MJCF): are these inertias right?
//!
//! - [`model`]: what a file says: links, inertials, geometry, joints, and where each number stands
//! - [`read`]: files in, models out
//! - [`check`]: the rules
//! - [`geometry`]: what the shapes of a link enclose
//! - [`finding`]: what is wrong with it, why, and what would repair it
//! - [`moments`]: tensors that may be impossible, taken apart

pub mod check;
pub mod finding;
pub mod geometry;
pub mod model;
pub mod moments;
mod pose;
pub mod read;
