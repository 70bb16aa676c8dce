//! `polhode simulate`

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode::motion::{Ending, ErrorEffort, Run, Sample, Scenario, Trajectory};
use polhode_document::SourceInfo;
use polhode_document::json::pretty;
use polhode_scenario::read::{ScenarioFile, TableFormat};
use polhode_scenario::report::{MotionFigures, MotionReport};
use polhode_source::files::Disk;
use polhode_source::given::{Times, times};
use polhode_source::shown;

use crate::browser::open;
use crate::failure::Failure;
use crate::folder::{Folder, PAGE, Replace};
use crate::page::{Page, Shown};
use crate::plot::PlotFlags;
use crate::progress::Progress;
use crate::stdout::{columns, print};
use crate::table::{self, Format};

/// Compute the motion of a scenario and write it to a folder.
///
/// The folder holds summary.json (mass properties, the kind of motion, the error of the numbers, the final state),
/// trajectory.parquet (one row per sample) and report.html (a page that shows the motion; it needs no network). It appears
/// with all its files or not at all. A motion that cannot be computed to its end is written as far as it is good, and marked
/// incomplete; the exit status is then 3.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode simulate examples/t-handle.toml
  polhode simulate examples/heavy-top.toml -o results/top --table csv --table parquet
  polhode simulate examples/t-handle.toml --plot overview.png --plot omega=omega.svg
  polhode simulate examples/cubesat.toml --at \"0 s, 1 h\" --plot pointing=pointing.svg
  polhode simulate examples/curtis-tube.toml --json | jq .motion")]
pub(crate) struct Simulate {
    /// The scenario, a TOML file with a [run] section.
    file: PathBuf,
    /// The folder to write [default: the scenario's name, here].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Replace the results and the plots of an earlier run, of another scenario too: those of this one are replaced anyway.
    #[arg(long)]
    force: bool,
    /// The format of the table; may be given more than once [default: that of [run], else parquet].
    #[arg(long, value_enum, value_name = "FORMAT")]
    table: Vec<Format>,
    /// Print the state at these times too: in s, or each with its unit; 0:1:0.1 are those from 0 to 1 in steps of 0.1.
    #[arg(long, value_name = "T,…", value_parser = times, allow_hyphen_values = true)]
    at: Vec<Times>,
    /// Leave out report.html.
    #[arg(long)]
    no_page: bool,
    /// Show report.html in the browser.
    #[arg(long, conflicts_with = "no_page")]
    open: bool,
    /// Estimate the error thoroughly, at 12 to 20 times the cost of the motion: without it, motions of more than
    /// some 10,000 steps and samples (3,000 of DOP853 or splitting) have a cheap estimate.
    #[arg(long)]
    error: bool,
    /// Print the summary as JSON.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    plots: PlotFlags,
}

impl Simulate {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let file = ScenarioFile::read(&Disk, &self.file)?;
        let (scenario, text) = (&file.scenario, &file.text);
        let target = self.output.clone().unwrap_or_else(|| default_folder(&self.file));
        let replace = Replace::results_of(&self.file, self.force);
        Folder::check(&target, &replace)?;
        let maker = format!("polhode simulate {}", self.file.display());
        self.plots.check(self.force, Some(&maker))?;
        // From now on nobody else begins with the same folder.
        let folder = Folder::create(&target, replace)?;
        let trajectory = self.trajectory(&file)?;

        let title = scenario.title().unwrap_or("scenario");
        let source = SourceInfo::new(self.file.display().to_string(), "scenario").described(title);
        let at = self.states_at(scenario)?;
        let report = MotionReport::new(source, scenario, &trajectory).at(&at);
        let summary = pretty(&report.summary_json()) + "\n";
        let page = Page {
            command: format!("simulate {}", self.file.display()),
            shown: Shown::Scenario { scenario, text, file: &self.file },
        };
        let figures = MotionFigures::of_scenario(scenario, &trajectory);
        let plots = self.plots.draw(&figures, self.force, Some(&maker))?;
        let written = self.write(folder, &target, &summary, &file, &trajectory, &page)?;
        let plotted = plots.publish()?;
        if self.json {
            print(&summary)?;
        } else {
            let text = columns().map_or_else(|| report.to_text(), |columns| report.to_screen(columns));
            print(&format!("{text}{written}\n{plotted}{}", self.look(&target)))?;
        }
        if self.open {
            open(&target.join(PAGE));
        }
        // What there is of the motion is written; that it is not all is a failure all the same.
        match trajectory.ending() {
            Ending::Failed { cause, .. } => {
                Err(Failure::Incomplete { path: shown(&self.file), error: cause.clone() })
            }
            _ => Ok(()),
        }
    }

    fn trajectory(&self, file: &ScenarioFile) -> Result<Trajectory, Failure> {
        let scenario = &file.scenario;
        let path = shown(&self.file);
        if self.error && scenario.prescribed().is_some() {
            return Err(Failure::usage(
                format!("{path} prescribes its motion: there is no error to estimate"),
                "leave out --error, or write [start] and torques in place of the prescribed motion",
            ));
        }
        let end = scenario.run().and_then(|run| run.times.last().copied()).unwrap_or_default();
        let mut progress = Progress::new(end);
        let effort = if self.error { ErrorEffort::Thorough } else { ErrorEffort::Auto };
        match scenario.simulate_with_error(effort, &mut |time| {
            progress.reached(time);
            true
        }) {
            Some(motion) => motion.map_err(|error| match file.placed(&error) {
                Some(placed) => placed.into(),
                None => Failure::motion(path, error),
            }),
            None => Err(Failure::usage(
                format!("{path} has no [run] section, so there is no time to simulate"),
                "write [run] with duration = \"10 s\" and samples = 1001; or ask `polhode explain` or `polhode inertia`",
            )),
        }
    }

    /// The samples at the times of `--at`, in their order. The motion is computed to each as it is to those of the run.
    fn states_at(&self, scenario: &Scenario) -> Result<Vec<Sample>, Failure> {
        let wanted: Vec<f64> = self.at.iter().flat_map(|Times(times)| times.iter().copied()).collect();
        let Some(run) = scenario.run().filter(|_| !wanted.is_empty()) else { return Ok(Vec::new()) };
        let (first, last) = (scenario.start().time, run.times.last().copied().unwrap_or_default());
        if let Some(time) = wanted.iter().find(|time| !(first..=last).contains(*time)) {
            let hint = "ask for times of the run, or give it a longer duration";
            let what = format!("--at {time} s is outside of the run, which goes from {first} to {last} s");
            return Err(Failure::usage(what, hint));
        }
        let mut times = wanted.clone();
        times.sort_by(f64::total_cmp);
        times.dedup();
        let asked = scenario.clone().sampled(Run { times, ..run.clone() });
        let failed = |error| Failure::motion(shown(&self.file), error);
        let samples = match asked.simulate() {
            Some(trajectory) => trajectory.map_err(failed)?.samples().to_vec(),
            None => Vec::new(),
        };
        // Of a motion that ends before there is no more than it has.
        let at = |time: &f64| samples.iter().find(|sample| sample.state.time == *time).copied();
        Ok(wanted.iter().filter_map(at).collect())
    }

    /// The formats of the table: those asked for, else the scenario's, else Parquet.
    fn tables(&self, of_scenario: &[TableFormat]) -> Vec<Format> {
        match (self.table.as_slice(), of_scenario) {
            ([], []) => vec![Format::Parquet],
            ([], formats) => formats.iter().map(|format| Format::from(*format)).collect(),
            (formats, _) => formats.to_vec(),
        }
    }

    /// How to look at what was written.
    fn look(&self, target: &Path) -> String {
        match self.no_page || self.open {
            true => String::new(),
            false => {
                format!("open {} in a browser to see it move (or add --open)\n", shown(&target.join(PAGE)))
            }
        }
    }

    /// Writes the folder; says what was written.
    fn write(
        &self,
        folder: Folder,
        target: &Path,
        summary: &str,
        ScenarioFile { scenario, tables: formats, .. }: &ScenarioFile,
        trajectory: &Trajectory,
        page: &Page<'_>,
    ) -> Result<String, Failure> {
        folder.file("summary.json", |out| out.write_all(summary.as_bytes()))?;
        let metadata = metadata(scenario, trajectory, &self.file);
        let mut names =
            table::write(&self.tables(formats), trajectory, &scenario.into(), &metadata, &folder)?;
        if !self.no_page {
            names.push(page.write(trajectory, &folder)?);
        }
        folder.publish()?;
        let more: String = names.iter().map(|name| format!("  {name}")).collect();
        Ok(format!("wrote {}{more}", shown(&target.join("summary.json"))))
    }
}

fn metadata(scenario: &Scenario, trajectory: &Trajectory, file: &Path) -> Vec<(String, String)> {
    let pair = |key: &str, value: String| (format!("polhode.{key}"), value);
    let title = scenario.title().map(str::to_owned).map(|title| pair("title", title));
    let source = pair("source", file.display().to_string());
    let complete = pair("complete", trajectory.ending().is_complete().to_string());
    let cause = match trajectory.ending() {
        Ending::Failed { cause, .. } => Some(pair("cause", cause.to_string())),
        _ => None,
    };
    title.into_iter().chain([source, complete]).chain(cause).collect()
}

/// The scenario's name, in the current folder.
fn default_folder(file: &Path) -> PathBuf {
    PathBuf::from(file.file_stem().unwrap_or_default())
}
