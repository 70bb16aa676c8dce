//! Tests of derivations and exercises.

mod derivations;
mod exercise_answers;
mod exercise_values;
mod exercises;
#[path = "../../../polhode-robot/tests/all/common/schema.rs"]
mod schema;
