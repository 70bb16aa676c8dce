//! `polhode check`

mod files;
mod fix;

use std::path::{Path, PathBuf};

use clap::Args;
use polhode_formats::FormatError;
use polhode_report::pretty;
use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::{Inspection, inspect};
use polhode_robot::read::{ReadOptions, read_model, read_text};
use polhode_robot::report::CheckReport;
use serde_json::Value;

use crate::failure::Failure;
use crate::progress::FileProgress;
use crate::stdout::print;
use files::Unread;
use fix::FixFlags;

/// Are the inertias of a robot or simulation model right? URDF, SDF, MJCF, USD, OpenSim.
///
/// Impossible: these numbers are unphysical. Suspect: a body may, but hardly this link, by its own geometry. Each finding says
/// where, by which rule, and what would repair it, if that can be proved. Folders are searched for .urdf, .sdf, .world,
/// .usda and .osim files, and for .xml files that are models.
///
/// Exit status: 0 nothing impossible or suspect, 1 something is, 2 a file cannot be read.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode check robot.urdf
  polhode check robot.urdf --table
  polhode check robot.urdf --fix robot-fixed.urdf
  polhode check src/ --root src --json | jq '.[].findings[]'
  polhode check world.sdf --root models --strict")]
pub(crate) struct Check {
    /// Models, and folders to search for them.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// A folder that holds packages, for package:// and model://; may be repeated. No mesh outside is opened.
    #[arg(long = "root", value_name = "DIR")]
    roots: Vec<PathBuf>,
    /// Print JSON: one object for one file, an array for several or for a folder.
    #[arg(long)]
    json: bool,
    /// Print a table, a line a link: mass, centre, principal moments, equivalent box, density, verdict.
    #[arg(long, conflicts_with = "json")]
    table: bool,
    /// Exit with 1 for notes too, such as a mesh that cannot be read.
    #[arg(long)]
    strict: bool,
    #[command(flatten)]
    fix: FixFlags,
}

impl Check {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let inputs = files::models(&self.files);
        let one = inputs.len() == 1 && !self.files.iter().any(|file| file.is_dir());
        let models: Vec<&Path> = inputs.iter().filter_map(|input| input.as_deref().ok()).collect();
        let target = self.fix.target(&models)?;
        let (mut texts, mut values) = (Vec::new(), Vec::new());
        let (mut failures, mut found) = (Vec::new(), false);
        let mut shapes = Shapes::default();
        let mut progress = FileProgress::new(models.len());
        for input in inputs {
            let answer = input.and_then(|file| {
                progress.next(&file);
                let report = self.report(&file, target, &mut shapes);
                report.map_err(|failure| Unread { failure: failure.about(&file), path: file })
            });
            let report = match answer {
                Ok(report) => report,
                Err(Unread { path, failure }) => {
                    values.push(failure.to_json(&path));
                    failures.push(failure);
                    continue;
                }
            };
            found |= self.fails(report.fixed.as_ref().map_or(&report.findings, |fixed| &fixed.remaining));
            match (self.json, self.table) {
                (true, _) => values.push(report.to_json()),
                (_, true) => texts.push(report.to_table()),
                _ => texts.push(report.to_text()),
            }
        }
        drop(progress);
        let text = match values.as_slice() {
            _ if !self.json => texts.join("\n"),
            [value] if one => pretty(value) + "\n",
            _ => pretty(&Value::Array(values)) + "\n",
        };
        print(&text)?;
        if found {
            failures.push(Failure::Findings);
        }
        Failure::unless_empty(failures)
    }

    /// What is found in a file, and repaired if that is asked for.
    fn report(
        &self,
        file: &Path,
        target: Option<(&Path, bool)>,
        shapes: &mut Shapes<'_>,
    ) -> Result<CheckReport, Failure> {
        let model = read_model(file, &self.reading())?;
        let Inspection { geometry, findings } = inspect(&model, shapes);
        let report = CheckReport { model, geometry, findings, fixed: None };
        match target {
            Some(target) => fix::fixed(report, target, |text| self.findings_in(text, file, shapes)),
            None => Ok(report),
        }
    }

    /// What is found in a text in place of the file's.
    fn findings_in(
        &self,
        text: &str,
        file: &Path,
        shapes: &mut Shapes<'_>,
    ) -> Result<Vec<Finding>, FormatError> {
        let model = read_text(text, file, &self.reading())?;
        Ok(inspect(&model, shapes).findings)
    }

    fn reading(&self) -> ReadOptions {
        ReadOptions { roots: self.roots.clone(), confined: false }
    }

    /// True if one of these is enough to fail.
    fn fails(&self, findings: &[Finding]) -> bool {
        let least = if self.strict { Severity::Note } else { Severity::Suspect };
        findings.iter().any(|finding| finding.severity >= least)
    }
}
