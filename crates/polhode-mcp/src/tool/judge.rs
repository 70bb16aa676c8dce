//! Judgements of logs of other programs.

use std::sync::atomic::AtomicBool;

use polhode_document::Report as _;
use polhode_judge::{REPORT_SCHEMA, REQUEST_SCHEMA, Request};
use polhode_source::Failure;
use polhode_source::files::Files;

use crate::arguments::Arguments;
use crate::definition::Definition;
use crate::outcome::Outcome;

pub(super) const DEFINITION: Definition = Definition {
    name: "judge",
    title: "Verdict on a simulator's log",
    description: "\
Did this program compute the rotation of a rigid body correctly, and if not, what is its mistake? \
For a log (CSV, Parquet or JSON lines) with times (s), attitudes and optionally angular velocities, compared with the exact motion of a \
scenario or of a free body with principal moments (kg m²). The conventions of the log (order and sense of quaternions, axes, frame and unit of ω) are detected. \
The error is an angle (rad). exit_status 1 means that a mistake was found or that the error is above limit. \
Without a scenario, moments is given, such as \"1,2,3\". Example: {\"files\": [\"tumbling.toml\", \"run.csv\"]}",
    request: REQUEST_SCHEMA,
    report: || REPORT_SCHEMA,
    more: "",
    without: &[],
    required: &[],
};

pub(super) fn run(arguments: Arguments, files: &dyn Files, _: &AtomicBool) -> Result<Outcome, Failure> {
    let request: Request = arguments.read()?;
    let judged = polhode_judge::run(&request, files)?;
    Ok(Outcome::of(&judged, judged.to_text(None), &[]))
}
