//! `--fix`: what repairs change, as a diff; `--fix OUT`: the model with its repairs too, in a file of its own.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_robot::finding::Finding;
use polhode_robot::repair::proved;
use polhode_robot::report::{CheckReport, Fixed};
use polhode_source::FormatError;
use polhode_source::shown;

use super::files::real_name;
use crate::failure::Failure;
use crate::partial;

/// Flags for repairs.
#[derive(Debug, Args)]
pub(super) struct FixFlags {
    /// Print the diff of all fixes that are the only consistent ones, the evidence of each above
    /// it, and write nothing; with OUT also write the fixed model there, after the diff. Every
    /// other byte stays as it is.
    #[arg(long = "fix", value_name = "OUT", num_args = 0..=1, conflicts_with_all = ["baseline", "write_baseline"])]
    out: Option<Option<PathBuf>>,
    /// Replace what --fix, --output or --write-baseline writes if it is there; never the model itself.
    #[arg(long, requires = "written")]
    pub(super) force: bool,
}

impl FixFlags {
    /// Whether repairs are asked for.
    pub(super) const fn is_given(&self) -> bool {
        self.out.is_some()
    }

    /// Whether only the diff is.
    pub(super) const fn is_diff(&self) -> bool {
        matches!(self.out, Some(None))
    }

    /// A model has to be named before --fix, which takes the file after it.
    pub(super) fn require_models(&self, models: &[PathBuf]) -> Result<(), Failure> {
        match &self.out {
            Some(Some(out)) if models.is_empty() => Err(Failure::usage(
                format!("no model is named: {} is the file that --fix is to write", shown(out)),
                format!("name the model first: polhode check {} --fix", shown(out)),
            )),
            _ => Ok(()),
        }
    }

    /// Refuses a file for several models, and --force without a file.
    pub(super) fn require_one(&self, models: usize) -> Result<(), Failure> {
        match self.out {
            Some(None) if self.force => Err(Failure::usage(
                "--fix without a file writes nothing, and --force replaces a file",
                "name the file, or leave --force out",
            )),
            Some(Some(_)) if models != 1 => Err(Failure::usage(
                format!("--fix writes one model, and {models} are named"),
                "repair them one by one",
            )),
            _ => Ok(()),
        }
    }

    /// Where the repaired model goes, if anywhere.
    pub(super) fn file(&self) -> Option<&Path> {
        self.out.as_ref()?.as_deref()
    }
}

/// The report with the model repaired; nothing is written yet.
///
/// What is to be written is read and checked first, in the place of the model: a repair that does not remove its finding is
/// left out.
pub(super) fn fixed(
    report: CheckReport,
    out: Option<&Path>,
    check: impl FnMut(&str) -> Result<Vec<Finding>, FormatError>,
) -> Result<CheckReport, Failure> {
    let unreadable = |error: FormatError| {
        Failure::usage(
            format!("the repaired model could not be read again, so it was not written: {}", error.message()),
            "this is a mistake of polhode's: please report it, with the model",
        )
    };
    let (repaired, remaining) = proved(&report.model, report.findings(), check).map_err(unreadable)?;
    let diff = repaired.diff(&report.model, report.findings(), &real_name(&report.model.path));
    let out = out.map(|out| out.display().to_string());
    Ok(CheckReport { fixed: Some(Fixed { out, repaired, diff, remaining }), ..report })
}

/// Writes the repaired model.
pub(super) fn write(report: &CheckReport, out: &Path, force: bool) -> Result<(), Failure> {
    let Some(fixed) = &report.fixed else { return Ok(()) };
    partial::write(out, force, |file| file.write_all(fixed.repaired.text.as_bytes()))
}
