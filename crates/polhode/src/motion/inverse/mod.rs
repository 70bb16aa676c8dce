//! From motion to torque: prescribed motions, and what they need.

pub(crate) mod prescribed;
pub(crate) mod required;
