//! The integration tests of `polhode-scenario`, as one program: each links the whole library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may")]

mod book;
mod common;
mod contact;
mod contact_examples;
mod examples;
mod explain;
mod explain_rows;
mod explain_symbols;
mod export;
mod files;
#[path = "../../../polhode-robot/tests/all/common/schema.rs"]
mod fit;
mod formula;
mod gimbal_examples;
mod gimbals;
mod golden;
mod json;
mod lagrangian;
mod mass_history;
mod mistakes;
mod motion_errors;
#[path = "../../../polhode-source/tests/common/obey.rs"]
mod obey;
mod page;
mod page_contact;
mod page_contract;
mod page_gimbals;
mod page_scene;
mod prescribed;
mod scenario;
mod schema;
mod symbols;
mod tables;
mod torque_formula;
mod torque_table;
mod worked;
mod worked_ground;
