//! Motions of scenarios.

use std::path::PathBuf;
use std::sync::LazyLock;

use polhode::motion::{Ending, ErrorEffort, Run, Sample, Scenario, Trajectory};
use polhode_document::{Document, Report};
use polhode_source::files::Files;
use polhode_source::given::{Given, Times};
use polhode_source::{Failure, shown};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::schema::complete;
use super::{failed, source};
use crate::read::ScenarioFile;
use crate::report::{MotionFigures, MotionReport};

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../../schema/simulate/request.json");

/// JSON schema of the JSON of a [`Motion`].
pub static REPORT_SCHEMA: LazyLock<String> =
    LazyLock::new(|| complete(include_str!("../../schema/simulate/report.json")));

/// Request for the motion of a scenario.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_scenario::request::simulate::{Request, run};
/// use polhode_source::files::Memory;
/// let text = "[[body.part]]\nshape = 'box'\nsize = [0.1, 0.2, 0.3]\nmass = 2\n\
///     [start]\nspin = { body = [0.1, 3, 0] }\n[run]\nduration = 5\n";
/// let request = Request { file: "box.toml".into(), at: vec!["2 s".parse()?], ..Request::default() };
/// let motion = run(&request, &Memory::from([("box.toml", text)])).map_err(|error| error.to_string())?;
/// assert_eq!(motion.to_json()["motion"]["regime"], "short_axis");
/// assert_eq!(motion.at[0].state.time, 2.0);
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// The scenario, a TOML file with a [run] section.
    pub file: PathBuf,
    /// Print the state at these times too: in s, or each with its unit; 0:1:0.1 are those from 0 to 1 in
    /// steps of 0.1.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "T,…", allow_hyphen_values = true))]
    pub at: Vec<Given<Times>>,
    /// Estimate the error thoroughly, at 12 to 20 times the cost of the motion: without it, motions of more
    /// than some 10,000 steps and samples (3,000 of DOP853 or splitting) have a cheap estimate.
    #[cfg_attr(feature = "arguments", arg(long))]
    pub error: bool,
    /// Print the details too: the method and its steps, the rounding of the inputs, Poinsot's picture.
    #[cfg_attr(feature = "arguments", arg(short, long))]
    pub verbose: bool,
}

/// Computes the motion of a scenario.
///
/// # Errors
/// Same as [`run_watched`].
pub fn run(request: &Request, files: &dyn Files) -> Result<Motion, Failure> {
    run_watched(request, ScenarioFile::read(files, &request.file)?, &mut |_| true)
}

/// Computes the motion of a scenario that has been read. `progress` gets the time reached, s, and
/// cancels the computation by returning `false`.
///
/// # Errors
/// [`Failure`] for a scenario without a run, times outside the run, and a motion that cannot start.
/// A motion that ends early is a result; [`Motion::trajectory`] states the reason.
pub fn run_watched(
    request: &Request,
    file: ScenarioFile,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<Motion, Failure> {
    let name = shown(&file.path);
    if request.error && file.scenario.prescribed().is_some() {
        return Err(Failure::usage(
            format!("{name} prescribes its motion: there is no error to estimate"),
            "remove --error, or write [start] and torques in place of the prescribed motion",
        ));
    }
    let effort = if request.error { ErrorEffort::Thorough } else { ErrorEffort::Auto };
    let Some(motion) = file.scenario.simulate_with_error(effort, progress) else {
        return Err(Failure::usage(
            format!("{name} has no [run] section: the duration of the motion is unknown"),
            "write [run] with duration = \"10 s\" and samples = 1001; `polhode explain` and `polhode inertia` need no [run]",
        ));
    };
    let trajectory = motion.map_err(|error| failed(&file, error))?;
    let at = states_at(request, &file, progress)?;
    Ok(Motion { file, trajectory, at, is_verbose: request.verbose })
}

/// Returns the samples at the requested times, in their order. They have the accuracy of the
/// samples of the run.
fn states_at(
    request: &Request,
    file: &ScenarioFile,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<Vec<Sample>, Failure> {
    let scenario = &file.scenario;
    let wanted: Vec<f64> = request.at.iter().flat_map(|at| at.value.0.iter().copied()).collect();
    let Some(run) = scenario.run().filter(|_| !wanted.is_empty()) else { return Ok(Vec::new()) };
    let (first, last) = (scenario.start().time, run.times.last().copied().unwrap_or_default());
    if let Some(time) = wanted.iter().find(|time| !(first..=last).contains(*time)) {
        let hint = "choose times within the run, or give it a longer duration";
        let what = format!("--at {time} s is outside of the run, which goes from {first} to {last} s");
        return Err(Failure::usage(what, hint));
    }
    let mut times = wanted.clone();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let asked = scenario.clone().sampled(Run { times, ..run.clone() });
    let samples = match asked.simulate_watched(progress) {
        Some(motion) => motion.map_err(|error| Failure::of_motion(&file.path, error))?.samples().to_vec(),
        None => Vec::new(),
    };
    // A motion that ends early has no samples after its end.
    let at = |time: &f64| samples.iter().find(|sample| sample.state.time == *time).copied();
    Ok(wanted.iter().filter_map(at).collect())
}

/// Motion of a scenario.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Scenario with its file.
    pub file: ScenarioFile,
    /// Motion as far as it was computed.
    pub trajectory: Trajectory,
    /// Samples at the requested times.
    pub at: Vec<Sample>,
    /// True if the text includes details.
    pub is_verbose: bool,
}

impl Motion {
    /// Returns the scenario.
    pub const fn scenario(&self) -> &Scenario {
        &self.file.scenario
    }

    /// Returns the report, which borrows the motion.
    pub fn report(&self) -> MotionReport<'_> {
        let source = source(&self.file.path, self.scenario());
        MotionReport::new(source, self.scenario(), &self.trajectory).at(&self.at).verbose(self.is_verbose)
    }

    /// Returns the plots of the motion.
    pub fn figures(&self) -> MotionFigures<'_> {
        MotionFigures::of_scenario(self.scenario(), &self.trajectory)
    }

    /// Returns the metadata of a table of the motion: keys and values.
    pub fn metadata(&self) -> Vec<(String, String)> {
        let pair = |key: &str, value: String| (format!("polhode.{key}"), value);
        let title = self.scenario().title().map(|title| pair("title", title.to_owned()));
        let source = pair("source", self.file.path.display().to_string());
        let complete = pair("complete", self.trajectory.ending().is_complete().to_string());
        let cause = match self.trajectory.ending() {
            Ending::Failed { cause, .. } => Some(pair("cause", cause.to_string())),
            _ => None,
        };
        title.into_iter().chain([source, complete]).chain(cause).collect()
    }
}

impl Report for Motion {
    fn to_json(&self) -> Value {
        self.report().summary_json()
    }

    fn to_document(&self) -> Document {
        Document::of_text("Motion", &self.report().to_text())
    }

    fn to_text(&self, columns: Option<usize>) -> String {
        let report = self.report();
        columns.map_or_else(|| report.to_text(), |columns| report.to_screen(columns))
    }
}
