//! Tasks: a scenario and its motion, a pendulum, a shaft in bearings.

pub(crate) mod asked;
mod check;
mod continuation;
mod exclusive;
mod history_check;
pub(crate) mod mounted_shaft;
pub(crate) mod pendulum;
pub(crate) mod run;
pub(crate) mod scenario;
pub(crate) mod shaft;
mod simulate;
