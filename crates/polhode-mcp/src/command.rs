//! The commands that tools run: arguments and files in, an outcome out.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{SystemTime, UNIX_EPOCH};

use polhode::motion::{Ending, Scenario};
use polhode_document::Report as _;
use polhode_robot::policy::date::Date;
use polhode_robot::{Inputs, LinkChoice, LinkHost};
use polhode_scenario::read::ScenarioFile;
use polhode_scenario::request;
use polhode_shape::run_in;
use polhode_source::files::Files;
use polhode_source::given::{Given, Times};
use polhode_source::{Failure, shown};

use crate::arguments::Arguments;
use crate::outcome::Outcome;

/// Largest number of states that a call returns; also in schema/samples.json.
const MOST: usize = 200;

/// Line width of a worked solution, characters, as the command has it by default.
const WIDTH: usize = 100;

type Result = std::result::Result<Outcome, Failure>;

/// Computes mass properties.
pub(crate) fn inertia(mut arguments: Arguments, files: &dyn Files, _: &AtomicBool) -> Result {
    let links: LinkChoice = arguments.take(["link", "lump", "subtree", "skip-invalid", "joint"]).read()?;
    let request: polhode_shape::Request = arguments.read()?;
    if request.files.is_empty() && !request.primitive.is_given() {
        let hint =
            "name files, or give a shape with its mass: box = \"20 cm, 10 cm, 6 cm\" and mass = \"2.5 kg\"";
        return Err(Failure::usage("no body is given", hint));
    }
    let scenario = |files: &dyn Files, file: &Path| Ok(ScenarioFile::read(files, file)?.inertia());
    let bodies = run_in(&request, files, &mut LinkHost { files, links: links.require_one()?, scenario })?;
    let failures = bodies.files.iter().filter_map(|file| file.reports.as_ref().err());
    Ok(Outcome::of(&bodies, bodies.to_text(None), failures))
}

/// Checks robot models.
pub(crate) fn check(arguments: Arguments, files: &dyn Files, _: &AtomicBool) -> Result {
    let mut request: polhode_robot::Request = arguments.read()?;
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    request.today = Some(Date::of_days(seconds / 86_400));
    let inputs = Inputs::find(&request, files)?;
    let repeated = inputs.repeated().iter().map(|[again, first]| {
        format!("{} is the same file as {}; it is checked once\n", shown(again), shown(first))
    });
    let mut text: String = repeated.collect();
    let checked = inputs.check(&mut ());
    for part in [checked.to_diff(), checked.to_text(None)].iter().filter(|part| !part.is_empty()) {
        text += if text.is_empty() { "" } else { "\n" };
        text += part;
    }
    let failures = checked.files.iter().filter_map(|file| file.report.as_ref().err());
    Ok(Outcome::of(&checked, text, failures))
}

/// Computes the motion of a scenario.
pub(crate) fn simulate(mut arguments: Arguments, files: &dyn Files, cancelled: &AtomicBool) -> Result {
    #[derive(serde::Deserialize)]
    struct More {
        samples: Option<i64>,
    }
    let More { samples } = arguments.take(["samples"]).read()?;
    let mut request: request::simulate::Request = arguments.read()?;
    let file = ScenarioFile::read(files, &request.file)?;
    if let Some(samples) = samples {
        let count = usize::try_from(samples).ok().filter(|count| (2..=MOST).contains(count));
        let refused = || {
            let hint = "leave it out for the final state only";
            Failure::usage(format!("samples = {samples}: it must be from 2 to {MOST}"), hint)
        };
        request.at.push(spread(count.ok_or_else(refused)?, &file.scenario));
    }
    let asked = request.at.iter().map(|at| at.value.0.len()).sum::<usize>();
    if asked > MOST {
        return Err(Failure::usage(
            format!("at and samples ask for {asked} states; a call returns at most {MOST}"),
            "ask for fewer, or run `polhode simulate`, which writes all states to a table",
        ));
    }
    let goes_on = &mut |_| !cancelled.load(Ordering::Relaxed);
    let motion = request::simulate::run_watched(&request, file, goes_on)?;
    let failure = match motion.trajectory.ending() {
        Ending::Failed { cause, .. } => Some(Failure::of_motion(&request.file, cause.clone())),
        _ => None,
    };
    Ok(Outcome::of(&motion, motion.to_text(None), failure.iter()))
}

/// Returns times at equal intervals over the run, with both its ends; none without a run, which is
/// refused later.
fn spread(count: usize, scenario: &Scenario) -> Given<Times> {
    let first = scenario.start().time;
    let times = scenario.run().and_then(|run| run.times.last()).map_or_else(Vec::new, |last| {
        let time = |k: usize| first + (last - first) * (k as f64 / (count - 1) as f64);
        (0..count - 1).map(time).chain([*last]).collect()
    });
    Given { text: format!("{count} samples"), value: Times(times) }
}

/// Judges logs of other programs.
pub(crate) fn judge(arguments: Arguments, files: &dyn Files, _: &AtomicBool) -> Result {
    let judged = polhode_judge::run(&arguments.read()?, files)?;
    Ok(Outcome::of(&judged, judged.to_text(None), [].into_iter()))
}

/// Writes the worked solution of a scenario.
pub(crate) fn explain(arguments: Arguments, files: &dyn Files, _: &AtomicBool) -> Result {
    let solution = request::explain::run(&arguments.read()?, files)?;
    Ok(Outcome::of(&solution, solution.0.to_text(WIDTH), [].into_iter()))
}
