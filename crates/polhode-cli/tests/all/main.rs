//! Integration tests of `polhode-cli`, built as one program so that the library is linked only
//! once.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod budget;
mod budget_diff;
mod budget_history;
mod budget_long;
mod budget_request;
mod budget_sweep;
mod check;
mod check_forms;
mod check_gate;
mod check_outputs;
mod command;
mod common;
mod compare;
mod contact;
mod cookbook;
mod corpus;
mod digits;
mod events;
mod example_files;
mod explain;
mod fix;
mod gimbals;
mod hints;
mod identify;
mod identify_body;
mod identify_next;
mod identify_swing;
mod inertia;
mod inertials;
mod interrupted;
mod judge;
mod judge_mistakes;
mod judge_without_scenario;
mod limits;
mod live;
mod mass_history;
mod mcp;
mod measures;
mod mend;
mod mesh;
mod names;
#[path = "../../../polhode-source/tests/common/obey.rs"]
mod obey;
mod options;
mod page;
mod pages;
mod picture;
mod plot;
mod resources;
mod robot;
#[path = "../../../polhode-robot/tests/all/common/schema.rs"]
mod schema;
mod schemas;
mod spin;
mod stability;
mod stability_ground;
mod starters;
mod sweep;
mod sweep_kill;
mod torque;
mod truncated;
#[cfg(unix)]
mod xacro;
