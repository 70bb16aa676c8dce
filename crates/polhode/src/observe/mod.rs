//! What can be read off a motion. This room never integrates.

pub(crate) mod cone;
pub(crate) mod drift;
pub(crate) mod geometric_phase;
pub(crate) mod least_energy;
pub(crate) mod regime;
pub(crate) mod symmetric_top;
pub(crate) mod tumbler;
pub(crate) mod tumbling;
