//! Inverse dynamics: prescribed motions and the torques that they require.

pub(crate) mod prescribed;
pub(crate) mod required;
