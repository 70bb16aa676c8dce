//! The integration tests of `polhode-cli`, as one program: each links the whole library.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod check;
mod check_forms;
mod check_gate;
mod check_outputs;
mod command;
mod common;
mod cookbook;
mod corpus;
mod digits;
mod example_files;
mod explain;
mod fix;
mod identify;
mod identify_swing;
mod inertia;
mod interrupted;
mod judge;
mod limits;
mod live;
mod mend;
mod mesh;
mod names;
mod options;
mod page;
mod picture;
mod plot;
mod resources;
mod robot;
mod spin;
mod stability;
mod sweep;
mod sweep_kill;
mod torque;
mod truncated;
