//! Solvers: closed forms (`free`, `heavy_top`, `swinging_body`, `pendulum_motion`) and integrators
//! (`propagate`, `collocation`).

mod at_times;
pub(crate) mod closed_form;
pub(in crate::motion) mod collocation;
pub(crate) mod free;
pub(crate) mod heavy_top;
pub(crate) mod limits;
pub(crate) mod method;
pub(crate) mod pendulum_motion;
mod phase;
pub(crate) mod propagate;
pub(crate) mod reach;
pub(in crate::motion) mod series;
pub(crate) mod start;
pub(crate) mod swinging_body;
pub(crate) mod system;
mod theta;
