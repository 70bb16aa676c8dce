//! Tests of derivations and exercises.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod derivations;
mod exercise_answers;
mod exercise_values;
mod exercises;
#[path = "../../../polhode-robot/tests/all/common/schema.rs"]
mod schema;
