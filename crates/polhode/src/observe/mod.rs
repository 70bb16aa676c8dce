//! What can be read off a motion. This room never integrates.

pub(crate) mod cone;
pub(crate) mod drift;
pub(crate) mod regime;
pub(crate) mod symmetric_top;
