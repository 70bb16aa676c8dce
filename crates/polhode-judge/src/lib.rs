//! Judges whether another program computes the motion of a rigid body correctly.
//!
//! [`run`] executes a [`Request`]: it compares logs with the exact motion and reports the errors
//! and their causes. [`suite`] contains the scenarios for grading programs.
#![forbid(unsafe_code)]

mod against;
mod free_body;
mod grade;
mod report;
mod request;
mod run;
mod runs;
mod selection;
pub mod suite;

pub use free_body::{FirstRowError, FreeBody};
pub use report::{Card, CardCase, CardRun, Comparison, JudgeReport, JudgedRun, judge_hint};
pub use request::{Axes, AxesOfRun, Order, REQUEST_SCHEMA, ReadAs, Request, Sense};
pub use run::{Judged, REPORT_SCHEMA, run};
pub use runs::{is_run, scenario_named_by};
