//! What can be read off a motion. This room never integrates.

pub(crate) mod cone;
pub(crate) mod curve;
pub(crate) mod drift;
pub(crate) mod geometric_phase;
pub(crate) mod herpolhode;
pub(crate) mod least_energy;
pub(crate) mod libration;
pub(crate) mod momentum_trace;
pub(crate) mod polhode;
mod polhode_family;
pub(crate) mod regime;
pub(crate) mod rolling_cones;
pub(crate) mod rotational_constants;
mod sampling;
pub(crate) mod small_oscillations;
pub(crate) mod stability;
pub(crate) mod symmetric_top;
pub(crate) mod tumbler;
pub(crate) mod tumbling;
