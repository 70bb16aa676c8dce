//! Worked solutions of scenarios.

use std::sync::atomic::AtomicBool;

use polhode_document::Report as _;
use polhode_scenario::request::explain::{self, REPORT_SCHEMA, REQUEST_SCHEMA, Request};
use polhode_source::Failure;
use polhode_source::files::Files;

use crate::arguments::Arguments;
use crate::definition::Definition;
use crate::outcome::Outcome;

/// Line width of the text, characters, as the command has it by default.
const WIDTH: usize = 100;

pub(super) const DEFINITION: Definition = Definition {
    name: "explain",
    title: "Worked solution of a scenario",
    description: "\
How is the motion of this body derived? For a scenario, a TOML file: every step with its formula and its numbers in SI units, from the \
inertia tensor and its principal axes over Euler's equations to ω(t) and the attitude; for a prescribed motion the required torque. \
Example: {\"file\": \"box.toml\"}",
    request: REQUEST_SCHEMA,
    report: || REPORT_SCHEMA.as_str(),
    more: "",
    without: &[],
    required: &["file"],
};

pub(super) fn run(arguments: Arguments, files: &dyn Files, _: &AtomicBool) -> Result<Outcome, Failure> {
    let request: Request = arguments.read()?;
    let solution = explain::run(&request, files)?;
    Ok(Outcome::of(&solution, solution.to_document().to_text(WIDTH), &[]))
}
