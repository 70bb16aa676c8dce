//! Tests of derivations and exercises.

mod derivations;
mod exercises;
