//! Exercises on the themes of Thornton & Marion, chapter 11: problems with generic numbers or in
//! symbols, their solutions, and grades of answer files.
//!
//! [`run`] executes a [`Request`]. A topic and a seed give the same exercise on every machine and in
//! every version: the numbers come from integers of a fixed generator, and each topic has its own
//! sequence.

mod answers;
mod document;
mod generator;
mod grade;
mod prepared;
mod problem;
mod report;
mod request;
mod run;
mod topic;
mod value;

pub use grade::Grade;
pub use problem::{Exercise, Exercises, topics};
pub use report::{ExerciseReport, REPORT_SCHEMA};
pub use request::{REQUEST_SCHEMA, Request, Solution};
pub use run::run;
