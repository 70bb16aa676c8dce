//! Robot and simulation models (URDF, SDF, MJCF): are these inertias right?
//!
//! - [`model`]: what a file says: links, inertials, geometry, joints, and where each number stands
//! - [`check`]: the rules
//! - [`finding`]: what is wrong with it, why, and what would repair it
//! - [`moments`]: tensors that may be impossible, taken apart
