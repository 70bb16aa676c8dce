//! Execution of a request in memory.

use polhode::body::Finding;
use polhode_document::{Document, Report};
use polhode_source::Failure;
use polhode_source::files::Files;
use serde_json::Value;

use crate::dataset::Manifest;
use crate::error::SweepError;
use crate::plan::Plan;
use crate::report::SweepSummary;
use crate::request::Request;
use crate::rows::{inputs, simulate};
use crate::statistics;

/// Computes all members of a plan, and their statistics.
///
/// The rows are kept in memory; a [`Dataset`](crate::Dataset) keeps them in a folder.
///
/// # Errors
/// [`Failure`] for a plan that cannot be read or has no times.
pub fn run(request: &Request, files: &dyn Files) -> Result<Swept, Failure> {
    let plan = Plan::read(files, &request.plan)?;
    let manifest = Manifest::of(&plan)?;
    let compute = |part| Ok(simulate(&plan, &inputs(&plan, manifest.rows(part)))?);
    let rows = statistics::each(manifest.parts(), request.threads(), &compute)?;
    let read = |part| {
        let rows = usize::try_from(part).ok().and_then(|part| rows.get(part));
        rows.cloned().ok_or(SweepError::Incomplete { part })
    };
    let (summary, _) = statistics::of(&plan, manifest.parts(), request.threads(), &read)?;
    Ok(Swept { summary, findings: plan.findings() })
}

/// JSON schema of the data of [`Swept`], and of `summary.json`.
pub const REPORT_SCHEMA: &str = include_str!("../schema/report.json");

/// Result of a [`Request`].
#[derive(Clone, Debug, PartialEq)]
pub struct Swept {
    /// Statistics over the members.
    pub summary: SweepSummary,
    /// Findings about the plan.
    pub findings: Vec<Finding>,
}

impl Report for Swept {
    fn to_json(&self) -> Value {
        self.summary.to_json()
    }

    fn to_document(&self) -> Document {
        self.summary.to_document(self.findings.clone())
    }
}
