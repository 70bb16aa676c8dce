//! Judges whether another program computes the motion of a rigid body correctly.
//!
//! [`run`] answers a [`Request`]: it holds logs against the exact motion, and says what is wrong.
//! [`suite`] has the scenarios by which programs are graded.
#![forbid(unsafe_code)]

mod grade;
mod report;
mod request;
mod run;
mod runs;
pub mod suite;

pub use report::{Card, CardCase, CardRun, JudgeReport, JudgedRun, judge_hint};
pub use request::{Axes, AxesOfRun, Order, REQUEST_SCHEMA, ReadAs, Request, Sense};
pub use run::{Judged, REPORT_SCHEMA, run};
