//! Judges whether another program computes the motion of a rigid body correctly.
//!
//! [`JudgeReport`] holds a log against the exact motion and says what is wrong; [`suite`] has the scenarios by which
//! programs are graded.
#![forbid(unsafe_code)]

mod report;
pub mod suite;

pub use report::{Card, CardCase, CardRun, JudgeReport, JudgedRun, judge_hint};
