//! Compares two models of one robot: mass, centre and tensor of each link, and the axes of the joints.
//!
//! Each model is divided into rigid groups, links joined by fixed joints. Groups correspond by the
//! names of their links, or of the joint above. The pose of a group of the first model in its
//! partner follows from the joints (`frames.rs`), so other link frames, other joint zeros, and links
//! merged by fixed joints do not count. Numbers are compared as the files state them, whether
//! physical or not.

mod axis;
mod comparison;
mod difference;
mod evidence;
mod explanation;
mod frames;
mod groups;
mod link;
mod mass;
mod names;
mod pairs;
mod request;
mod robot;
mod structure;
mod sums;
mod text;

use std::path::Path;

use polhode_source::files::Files;
use polhode_source::{Failure, read_text_file, shown};

use crate::checked::{Checked, FileChecked};
use crate::finding::{Finding, Severity};
use crate::found::Names as FileNames;
use crate::model::RobotModel;
use crate::policy::Judged;
use crate::read::{ReadOptions, read_model};
use crate::remarks::{is_harmless, remarks};
use crate::report::CheckReport;
use crate::trace::trace;
use difference::Sides;
use frames::Aligned;
use names::Names;
use pairs::Pairs;
use robot::Robot;

pub use comparison::Comparison;
pub use request::Request;

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../schema/compare/request.json");

/// JSON schema of the report of a [`Comparison`].
pub const REPORT_SCHEMA: &str = include_str!("../schema/compare/report.json");

/// Compares the models of a request.
///
/// # Errors
/// [`Failure`] if a model or the map cannot be read, if joints do not form a tree, or if a number
/// cannot be used.
pub fn run(request: &Request, files: &dyn Files) -> Result<Comparison, Failure> {
    polhode_source::file::require_folders(files, &request.roots)?;
    let read = |path: &Path| {
        let options = ReadOptions { files, roots: request.roots.clone(), ..ReadOptions::default() };
        read_model(path, &options).map_err(|error| Failure::from(error).in_file(path))
    };
    let (a, b) = (read(&request.a)?, read(&request.b)?);
    let names = match &request.map {
        Some(path) => read_text_file(files, path, |text| Ok(Names::read(path, text, &a, &b)))??,
        None => Names::default(),
    };
    let (mut findings, summaries) = compared(request, &a, &b, &names)?;
    trace(&b, &mut findings);
    let name = FileNames::new(files).of(&b.path);
    let report = CheckReport::new(b, Vec::new(), Judged::open(&name, findings));
    let checked = Checked {
        files: vec![FileChecked { path: request.b.clone(), name, report: Ok(report) }],
        remarks: Vec::new(),
        excluded: 0,
        fail_on: Severity::Suspect,
        command: "polhode compare",
        is_one: true,
    };
    Ok(Comparison { checked, summaries, tolerance: request.tolerance() })
}

/// Returns the findings in the order of the second file, and the sizes of the models.
fn compared(
    request: &Request,
    a: &RobotModel,
    b: &RobotModel,
    names: &Names,
) -> Result<(Vec<Finding>, [comparison::Summary; 2]), Failure> {
    for model in [a, b] {
        remarks(model, None).map_err(|error| error.in_model(model))?;
    }
    let (robot_a, robot_b) = (Robot::of(a)?, Robot::of(b)?);
    let pairs = Pairs::of(&robot_a, &robot_b, names);
    if pairs.list.is_empty() {
        let message =
            format!("no link and no joint of {} has a partner in {}", shown(&request.a), shown(&request.b));
        return Err(Failure::usage(
            message,
            "map the names with --map FILE: [links], then \"name in A\" = \"name in B\"",
        ));
    }
    let tolerance = request.tolerance();
    let size = f64::max(robot_a.size, robot_b.size);
    let aligned = Aligned { a: &robot_a, b: &robot_b, pairs: &pairs, tolerance, size };
    let alignments = aligned.alignments();
    let (name_a, name_b) = (shown(&request.a), shown(&request.b));
    let sides = Sides { a: &robot_a, b: &robot_b, name_a, name_b };
    let mut findings = notes(&sides);
    for (pair, alignment) in pairs.list.iter().zip(&alignments) {
        findings.extend(structure::joints(&sides, &pairs, pair, alignment));
    }
    findings.extend(structure::divided(&sides, &aligned));
    findings.extend(structure::alone(&sides, &aligned));
    findings.extend(groups::differences(&sides, &aligned, &alignments)?);
    findings.sort_by_key(|finding| (std::cmp::Reverse(finding.severity), finding.span.start));
    let summaries = [&robot_a, &robot_b].map(comparison::Summary::of);
    Ok((findings, summaries))
}

/// Returns the notes of the readers about skipped content.
fn notes(sides: &Sides<'_, '_>) -> Vec<Finding> {
    let mut found = Vec::new();
    for (is_first, robot) in [(true, sides.a), (false, sides.b)] {
        for note in robot.model.notes.iter().filter(|note| !is_harmless(note)) {
            let span = Some(note.span.clone());
            let spans = if is_first { [None, span] } else { [span, None] };
            let finding = sides.finding(note.code, &note.subject, spans, note.message.clone());
            found.push(Finding { severity: Severity::Note, ..finding });
        }
    }
    found
}
