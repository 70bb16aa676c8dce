//! `--fix OUT`: the model with its repairs, in a file of its own.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_formats::FormatError;
use polhode_robot::finding::Finding;
use polhode_robot::repair::proved;
use polhode_robot::report::{CheckReport, Fixed};

use crate::failure::Failure;
use crate::partial;
use crate::stderr::shown;

/// Flags for repairs.
#[derive(Debug, Args)]
pub(super) struct FixFlags {
    /// Write the model with all repairs that can be proved; every other byte stays as it is.
    #[arg(long = "fix", value_name = "OUT", conflicts_with_all = ["baseline", "write_baseline"])]
    out: Option<PathBuf>,
    /// Replace what --fix, --output or --write-baseline writes if it is there; never the model itself.
    #[arg(long, requires = "written")]
    pub(super) force: bool,
}

impl FixFlags {
    /// Where the repaired model goes, if anywhere: a file that is not there yet, or may be replaced.
    pub(super) fn target(&self, inputs: &[&Path]) -> Result<Option<(&Path, bool)>, Failure> {
        let Some(out) = self.out.as_deref() else { return Ok(None) };
        let shown = shown(out);
        let [input] = *inputs else {
            return Err(Failure::usage(
                format!("--fix writes one model, and {} are named", inputs.len()),
                "repair them one by one",
            ));
        };
        require_not_read("--fix", Some(out), &[input])?;
        match fs::symlink_metadata(out) {
            Ok(meta) if meta.is_dir() || out.is_dir() => Err(Failure::usage(
                format!("{shown} is a folder, and --fix writes a file"),
                "name a file in it",
            )),
            Ok(_) if !self.force => Err(Failure::usage(
                format!("{shown} is there already"),
                "choose another file, or replace it with --force",
            )),
            _ => Ok(Some((out, self.force))),
        }
    }
}

/// Refuses to write over a model that is read, whatever --force says.
pub(super) fn require_not_read(option: &str, out: Option<&Path>, inputs: &[&Path]) -> Result<(), Failure> {
    let Some(out) = out else { return Ok(()) };
    let real = fs::canonicalize(out).ok();
    let is_out = |input: &&&Path| out == **input || real.is_some() && real == fs::canonicalize(input).ok();
    match inputs.iter().find(is_out) {
        Some(_) => Err(Failure::usage(
            format!("{option} would overwrite the model itself, {}", shown(out)),
            "write beside it, look at the difference, then move it there",
        )),
        None => Ok(()),
    }
}

/// The report with the model repaired and written.
///
/// What is to be written is read and checked first, in the place of the model: a repair that does not remove its finding is
/// left out.
pub(super) fn fixed(
    report: CheckReport,
    (out, force): (&Path, bool),
    check: impl FnMut(&str) -> Result<Vec<Finding>, FormatError>,
) -> Result<CheckReport, Failure> {
    let unreadable = |error: FormatError| {
        Failure::usage(
            format!("the repaired model could not be read again, so it was not written: {}", error.message()),
            "this is a mistake of polhode's: please report it, with the model",
        )
    };
    let (repaired, remaining) = proved(&report.model, report.findings(), check).map_err(unreadable)?;
    partial::write(out, force, |file| file.write_all(repaired.text.as_bytes()))?;
    let fixed = Fixed { out: out.display().to_string(), repaired, remaining };
    Ok(CheckReport { fixed: Some(fixed), ..report })
}
