//! What is asked of scenarios, and the functions that answer: a request and files in, a report out.
//!
//! | module | answers |
//! |---|---|
//! | [`simulate`] | how the body moves |
//! | [`spin`] | how a free body moves, exactly, or which spins have two periods |
//! | [`stability`] | which steady motions last |
//! | [`torque`] | what a given motion needs |
//! | [`explain`] | the motion, worked through |
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

/// A failure of a scenario's motion: at its place in the file, if it has one.
fn failed(file: &ScenarioFile, error: MotionError) -> Failure {
    match file.placed(&error) {
        Some(placed) => placed.into(),
        None => Failure::of_motion(&file.path, error),
    }
}

/// Where a report's scenario came from.
fn source(file: &Path, scenario: &Scenario) -> SourceInfo {
    let title = scenario.title().unwrap_or("scenario");
    SourceInfo::new(file.display().to_string(), "scenario").described(title)
}
