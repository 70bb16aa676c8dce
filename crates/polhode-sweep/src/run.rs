//! Execution of a request in memory.

use polhode_source::Failure;
use polhode_source::files::Files;

use crate::dataset::Manifest;
use crate::error::SweepError;
use crate::plan::Plan;
use crate::request::Request;
use crate::rows::{inputs, simulate};
use crate::statistics;
use crate::swept::Swept;

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
    let (summary, sample) = statistics::of(&plan, manifest.parts(), request.threads(), &read)?;
    Ok(Swept::new(summary, sample, &plan))
}

/// JSON schema of the data of [`Swept`], and of `summary.json`.
pub const REPORT_SCHEMA: &str = include_str!("../schema/report.json");
