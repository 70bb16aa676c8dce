//! Requests about scenarios, and the functions that answer them: a request and files in, a report
//! out.
//!
//! | module | answers |
//! |---|---|
//! | [`simulate`] | the motion of a body |
//! | [`spin`] | the exact motion of a free body, or the spins with two given periods |
//! | [`stability`] | the stability of steady motions |
//! | [`torque`] | the torque required for a prescribed motion |
//! | [`explain`] | the motion with its derivation |
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

pub mod explain;
mod schema;
pub mod simulate;
pub mod spin;
pub mod stability;
pub mod torque;

use polhode::motion::{MotionError, Scenario};
use polhode_document::SourceInfo;
use polhode_source::Failure;
use std::path::Path;

use crate::read::ScenarioFile;

/// Returns a failure of a scenario's motion, at its place in the file if it has one.
fn failed(file: &ScenarioFile, error: MotionError) -> Failure {
    match file.placed(&error) {
        Some(placed) => placed.into(),
        None => Failure::of_motion(&file.path, error),
    }
}

/// Returns the source of a report on a scenario.
fn source(file: &Path, scenario: &Scenario) -> SourceInfo {
    let title = scenario.title().unwrap_or("scenario");
    SourceInfo::new(file.display().to_string(), "scenario").described(title)
}
