//! Motions of scenarios.

use std::sync::atomic::{AtomicBool, Ordering};

use polhode::motion::{Ending, Scenario};
use polhode_document::Report as _;
use polhode_scenario::read::ScenarioFile;
use polhode_scenario::request::simulate::{REPORT_SCHEMA, REQUEST_SCHEMA, Request, run_watched};
use polhode_source::Failure;
use polhode_source::files::Files;
use polhode_source::given::{Given, Times};

use crate::arguments::Arguments;
use crate::definition::Definition;
use crate::outcome::Outcome;

/// Largest number of states that a call returns; also in [`SAMPLES`].
const MOST: usize = 200;

/// Schema of the arguments that the command does not have.
const SAMPLES: &str = r#"{
    "properties": {
        "samples": {
            "description": "Number of states at equal intervals over the run, with both its ends: 2 to 200, together with those of at. By default only the final state is returned.",
            "type": ["integer", "null"],
            "minimum": 2,
            "maximum": 200
        }
    }
}"#;

pub(super) const DEFINITION: Definition = Definition {
    name: "simulate",
    title: "Motion of a scenario",
    description: "\
How does this body move? For a scenario: a TOML file with the body, its start, torques and a [run] section. \
Returns the kind of motion, its periods (s), energy (J), angular momentum (kg m²/s), the final state, and the estimated error of the \
attitude (rad) and of ω (rad/s); ω is along body axes, attitudes are unit quaternions w, x, y, z from body to space. \
The states between are returned only at the times of at, or as many as samples states. `polhode simulate` writes all of them to a table. \
Example: {\"file\": \"box.toml\", \"samples\": 5, \"contents\": {\"box.toml\": \"[[body.part]]\\nshape = 'box'\\nsize = [0.2, 0.1, 0.06]\\nmass = 2.5\\n\
[start]\\nspin = { body = [0.1, 3, 0.2] }\\n[run]\\nduration = 10\\n\"}}",
    request: REQUEST_SCHEMA,
    report: || REPORT_SCHEMA.as_str(),
    more: SAMPLES,
    without: &[],
    required: &["file"],
};

/// Arguments that the command does not have.
#[derive(serde::Deserialize)]
struct More {
    samples: Option<i64>,
}

pub(super) fn run(
    mut arguments: Arguments,
    files: &dyn Files,
    cancelled: &AtomicBool,
) -> Result<Outcome, Failure> {
    let More { samples } = arguments.take(["samples"]).read()?;
    let mut request: Request = arguments.read()?;
    let samples = samples.map(number).transpose()?;
    let asked = request.at.iter().map(|at| at.value.0.len()).sum::<usize>() + samples.unwrap_or_default();
    if asked > MOST {
        return Err(Failure::usage(
            format!("at and samples ask for {asked} states; a call returns at most {MOST}"),
            "ask for fewer, or run `polhode simulate`, which writes all states to a table",
        ));
    }
    let file = ScenarioFile::read(files, &request.file)?;
    if let Some(samples) = samples {
        request.at.push(spread(samples, &file.scenario));
    }
    let motion = run_watched(&request, file, &mut |_| !cancelled.load(Ordering::Relaxed))?;
    let failure = match motion.trajectory.ending() {
        Ending::Failed { cause, .. } => Some(Failure::of_motion(&request.file, cause.clone())),
        _ => None,
    };
    Ok(Outcome::of(&motion, motion.to_text(None), failure.as_slice()))
}

/// Returns a valid number of states.
fn number(samples: i64) -> Result<usize, Failure> {
    usize::try_from(samples).ok().filter(|samples| (2..=MOST).contains(samples)).ok_or_else(|| {
        let hint = "leave it out for the final state only";
        Failure::usage(format!("samples = {samples}: it must be from 2 to {MOST}"), hint)
    })
}

/// Returns times at equal intervals over the run, with both its ends; none without a run, which is
/// refused later.
fn spread(samples: usize, scenario: &Scenario) -> Given<Times> {
    let first = scenario.start().time;
    let times = scenario.run().and_then(|run| run.times.last()).map_or_else(Vec::new, |last| {
        let time = |k: usize| first + (last - first) * (k as f64 / (samples - 1) as f64);
        (0..samples - 1).map(time).chain([*last]).collect()
    });
    Given { text: format!("{samples} samples"), value: Times(times) }
}
