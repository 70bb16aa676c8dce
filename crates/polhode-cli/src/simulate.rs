//! `polhode simulate`

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode::motion::Ending;
use polhode_document::Report as _;
use polhode_document::json::pretty;
use polhode_scenario::read::{ScenarioFile, TableFormat};
use polhode_scenario::request::simulate::{Motion, Request, run_watched};
use polhode_source::files::Disk;
use polhode_source::shown;

use crate::browser::open;
use crate::failure::Failure;
use crate::folder::{Folder, PAGE, Replace, wrote};
use crate::page::{Page, Shown};
use crate::plot::PlotFlags;
use crate::progress::Progress;
use crate::stdout::{columns, print};
use crate::table::{self, Format};

/// Compute the motion of a scenario and write it to a folder.
///
/// The folder contains summary.json (mass properties, kind of motion, error estimates, final
/// state), trajectory.parquet (one row per sample) and report.html (an animated page that needs no
/// network). The folder is written completely or not at all. A motion that cannot be computed to
/// its end is written up to the last valid time and marked incomplete; the exit status is then 3.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode simulate examples/t-handle.toml
  polhode simulate examples/heavy-top.toml -o results/top --table csv --table parquet
  polhode simulate examples/t-handle.toml --plot overview.png --plot omega=omega.svg
  polhode simulate examples/cubesat.toml --at \"0 s, 1 h\" --plot pointing=pointing.svg
  polhode simulate examples/curtis-tube.toml --json | jq .motion")]
pub(crate) struct Simulate {
    #[command(flatten)]
    request: Request,
    /// Output folder [default: the scenario's name, in the working directory].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Replace the results and plots of another scenario. Earlier results of this scenario are
    /// always replaced.
    #[arg(long)]
    force: bool,
    /// Table format; may be repeated [default: that of [run], else parquet].
    #[arg(long, value_enum, value_name = "FORMAT")]
    table: Vec<Format>,
    /// Do not write report.html.
    #[arg(long)]
    no_page: bool,
    /// Open report.html in the browser.
    #[arg(long, conflicts_with = "no_page")]
    open: bool,
    /// Print the summary as JSON.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    plots: PlotFlags,
}

impl Simulate {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let path = &self.request.file;
        let file = ScenarioFile::read(&Disk, path)?;
        let target = self.output.clone().unwrap_or_else(|| default_folder(path));
        let replace = Replace::results_of(path, self.force);
        Folder::check(&target, &replace)?;
        let maker = format!("polhode simulate {}", path.display());
        self.plots.check(self.force, Some(&maker))?;
        // From here on no other process can write to the same folder.
        let folder = Folder::create(&target, replace)?;
        let end = file.scenario.run().and_then(|run| run.times.last().copied()).unwrap_or_default();
        let mut progress = Progress::new(end);
        let motion = run_watched(&self.request, file, &mut |time| {
            progress.reached(time);
            true
        })?;
        drop(progress);

        let summary = pretty(&motion.to_json()) + "\n";
        let plots = self.plots.draw(&motion.figures(), self.force, Some(&maker))?;
        let written = self.write(folder, &target, &summary, &motion)?;
        let plotted = plots.publish()?;
        if self.json {
            print(&summary)?;
        } else {
            let text = motion.to_text(columns());
            print(&format!("{text}{written}\n{plotted}{}", self.look(&target)))?;
        }
        if self.open {
            open(&target.join(PAGE));
        }
        // An incomplete motion is written, and is still a failure.
        match motion.trajectory.ending() {
            Ending::Failed { cause, .. } => {
                Err(Failure::Incomplete { path: shown(path), error: cause.clone() })
            }
            _ => Ok(()),
        }
    }

    /// Returns the table formats: those of the options, else those of the scenario, else Parquet.
    fn tables(&self, of_scenario: &[TableFormat]) -> Vec<Format> {
        match (self.table.as_slice(), of_scenario) {
            ([], []) => vec![Format::Parquet],
            ([], formats) => formats.iter().map(|format| Format::from(*format)).collect(),
            (formats, _) => formats.to_vec(),
        }
    }

    /// Returns a hint how to view the results.
    fn look(&self, target: &Path) -> String {
        match self.no_page || self.open {
            true => String::new(),
            false => {
                format!("open {} in a browser to see the motion (or add --open)\n", shown(&target.join(PAGE)))
            }
        }
    }

    /// Writes the folder; returns a summary of the files written.
    fn write(
        &self,
        folder: Folder,
        target: &Path,
        summary: &str,
        motion: &Motion,
    ) -> Result<String, Failure> {
        let Motion { file: ScenarioFile { scenario, text, path, tables, .. }, trajectory, .. } = motion;
        folder.file("summary.json", |out| out.write_all(summary.as_bytes()))?;
        let mut names = vec!["summary.json"];
        let tables = self.tables(tables);
        names.extend(table::write(&tables, trajectory, &scenario.into(), &motion.metadata(), &folder)?);
        if !self.no_page {
            let command = format!("simulate {}", path.display());
            let page = Page { command, shown: Shown::Scenario { scenario, text, file: path } };
            names.push(page.write(trajectory, &folder)?);
        }
        folder.publish()?;
        Ok(wrote(target, &names))
    }
}

/// Returns the scenario's name as a folder in the current folder.
fn default_folder(file: &Path) -> PathBuf {
    PathBuf::from(file.file_stem().unwrap_or_default())
}
