//! Execution of a request.

use polhode_document::{Document, Level, Report, Verdict};
use polhode_source::Failure;
use polhode_source::files::Files;
use serde_json::Value;

use crate::grade::grade;
use crate::report::{Card, Comparison, JudgeReport};
use crate::request::Request;
use crate::runs::Judge;

/// Judges the runs of a request by their scenario, compares them with another log, or grades those
/// of the suite.
///
/// # Errors
/// [`Failure`] for files that cannot be read, runs without a scenario or of several, options that
/// contradict each other, and runs that cannot be judged.
pub fn run(request: &Request, files: &dyn Files) -> Result<Judged, Failure> {
    let judge = Judge { request, files };
    judge.require_one_reference()?;
    match (&request.suite, &request.against) {
        (Some(folder), _) => grade(folder, judge).map(Judged::Suite),
        (None, Some(other)) => {
            judge.compared(other).map(|report| Judged::Compared(Box::new(report), request.limit()))
        }
        (None, None) => judge.report().map(|report| Judged::Runs(Box::new(report), request.limit())),
    }
}

/// JSON schema of the data of [`Judged`].
pub const REPORT_SCHEMA: &str = include_str!("../schema/report.json");

/// Result of a [`Request`].
#[derive(Debug)]
pub enum Judged {
    /// Report on runs of one scenario, and the largest acceptable error, rad.
    Runs(Box<JudgeReport>, f64),
    /// Differences of runs from another log, and the largest acceptable one, rad.
    Compared(Box<Comparison>, f64),
    /// Grade card of the suite's cases.
    Suite(Card),
}

impl Report for Judged {
    fn to_json(&self) -> Value {
        match self {
            Self::Runs(report, _) => report.to_json(),
            Self::Compared(report, _) => report.to_json(),
            Self::Suite(card) => card.to_json(),
        }
    }

    fn to_document(&self) -> Document {
        let mut document = match self {
            Self::Runs(report, _) => report.to_document(),
            Self::Compared(report, _) => report.to_document(),
            Self::Suite(card) => card.to_document(),
        };
        if self.has_failed() && document.verdict.as_ref().is_none_or(|v| v.level != Level::Failure) {
            document.verdict = Some(Verdict::new(Level::Failure, "An error is above the limit"));
        }
        document
    }

    fn has_failed(&self) -> bool {
        match self {
            Self::Runs(report, limit) => report.is_beyond(*limit),
            Self::Compared(report, limit) => report.is_beyond(*limit),
            Self::Suite(card) => card.has_failed(),
        }
    }
}
