//! Changes of the text, and computation of the new motion.

use std::sync::{Mutex, PoisonError};

use polhode::body::{Finding, Severity};
use polhode::motion::{ErrorEffort, MotionError, Run, Scenario, Trajectory};
use polhode_document::VERSION;
use polhode_scenario::read::{Draft, ScenarioFile};
use polhode_scenario::report::{PageInput, PageSubject, explain_motion, page_rows};
use polhode_source::files::Files;

use crate::edit::edited;
use crate::knob::{knobs, switches};
use crate::limits;
use crate::protocol::{Motion, MotionAnswer, MotionRequest, TextError};
use crate::refusal::{Refusal, RefusalKind};
use crate::watch::{Watch, require_wanted};

/// Applies the requested changes and computes the motion.
pub(crate) fn answer(
    draft: &Mutex<Draft>,
    request: &MotionRequest,
    files: &dyn Files,
    watch: &dyn Watch,
) -> Result<MotionAnswer, Refusal> {
    if request.edits.len() > limits::EDITS {
        let rule = format!("a request has at most {} edits", limits::EDITS);
        return Err(Refusal::new(RefusalKind::BadRequest, rule));
    }
    // A copy, because another tab may read another text meanwhile. Contents of files are shared.
    let mut own = draft.lock().unwrap_or_else(PoisonError::into_inner).clone();
    let mut edits_on = own.clone();
    let goes_on = || watch.goes_on();
    let changed = edited(&request.text, &request.edits, |text| {
        edits_on.read_watched(files, text.to_owned(), &goes_on).ok()
    });
    let mut answer = MotionAnswer {
        text: request.text.clone(),
        motion: None,
        knobs: Vec::new(),
        switches: Vec::new(),
        errors: Vec::new(),
        took: 0.0,
    };
    match changed {
        Ok(text) => answer.text = text,
        Err(error) => answer.errors.push(TextError { message: error.to_string(), ..TextError::default() }),
    }
    match own.read_watched(files, answer.text.clone(), &goes_on) {
        Ok(file) => {
            answer.switches = switches(&file.scenario, &answer.text);
            match computed(&file, request.error, watch) {
                Ok(trajectory) => answer.motion = Some(motion(&file, &trajectory, &own, request)),
                Err(error) => answer.errors.push(error),
            }
        }
        Err(error) => answer.errors.push(TextError::of_format(&error, own.path(), &answer.text)),
    }
    if answer.motion.is_none() {
        require_wanted(watch)?;
    }
    answer.knobs = knobs(&own.numbers());
    *draft.lock().unwrap_or_else(PoisonError::into_inner) = own;
    Ok(answer)
}

/// Computes the trajectory, at no more times than the page shows.
pub(crate) fn computed(
    file: &ScenarioFile,
    with_error: bool,
    watch: &dyn Watch,
) -> Result<Trajectory, TextError> {
    let run = file.scenario.run().map_or_else(without_run, thinned);
    let scenario = file.scenario.clone().sampled(run);
    let mut goes_on = |_| watch.goes_on();
    let motion = match with_error {
        true => scenario.simulate_with_error(ErrorEffort::Auto, &mut goes_on),
        false => scenario.simulate_watched(&mut goes_on),
    };
    motion.unwrap_or(Err(MotionError::Stopped { time: 0.0 })).map_err(|error| of_motion(file, &error))
}

/// Duration shown for a scenario without a run, s.
const WITHOUT_RUN: f64 = 10.0;

fn without_run() -> Run {
    Run::evenly(WITHOUT_RUN, 1_001, polhode::motion::Method::Auto, 1e-13)
}

/// Reports differences between the motion shown and the scenario's run.
fn shown_otherwise(scenario: &Scenario) -> Option<Finding> {
    let message = match scenario.run().map(|run| run.times.len()) {
        None => format!("the scenario has no [run]: the motion is shown for {WITHOUT_RUN} s"),
        Some(count) if count > limits::SAMPLES => {
            format!("{} of {count} samples are computed and shown, evenly spaced", limits::SAMPLES)
        }
        Some(_) => return None,
    };
    Some(Finding { code: "live.run", severity: Severity::Info, message, place: None })
}

/// Keeps the first and the last time, and times evenly between them.
fn thinned(run: &Run) -> Run {
    let (count, most) = (run.times.len(), limits::SAMPLES);
    if count <= most {
        return run.clone();
    }
    let times = (0..most).filter_map(|k| run.times.get(k * (count - 1) / (most - 1))).copied().collect();
    Run { times, ..run.clone() }
}

fn motion(file: &ScenarioFile, trajectory: &Trajectory, draft: &Draft, request: &MotionRequest) -> Motion {
    let scenario = &file.scenario.clone().noting(shown_otherwise(&file.scenario));
    let explanation =
        if request.working { explain_motion(scenario, trajectory, &file.exact()).ok() } else { None };
    let name = draft.path().file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let input = PageInput {
        title: scenario.title().unwrap_or(&name),
        source: &format!("polhode {VERSION} live"),
        scenario_text: None,
        subject: PageSubject::Scenario(scenario),
        trajectory,
        explanation: explanation.as_ref(),
        whole: true,
    };
    // Fingerprint of the body, and of the body with its other free motions, which a page that has
    // shown a free motion already has.
    let body = format!("{:016x}", draft.body_fingerprint());
    let with_free = format!("{body} free");
    let is_known = |known: &&String| **known == with_free || (**known == body && !input.is_free());
    if let Some(known) = request.body.as_ref().filter(is_known) {
        let (page, rows) = page_rows(&PageInput { whole: false, ..input });
        return Motion { page, rows, body: known.clone() };
    }
    let (page, rows) = page_rows(&input);
    let body = if page["free"].is_null() { body } else { with_free };
    Motion { page, rows, body }
}

fn of_motion(file: &ScenarioFile, error: &MotionError) -> TextError {
    let placed = file.placed(error);
    match (placed, error) {
        (Some(placed), _) => TextError::at_place(&placed, &file.text),
        (None, MotionError::Stopped { time }) => TextError {
            message: format!(
                "the motion takes more than {} s to compute: it was stopped at t = {time} s",
                limits::MOTION.as_secs()
            ),
            hint: Some("shorten the run, or use polhode simulate, which has no time limit".to_owned()),
            ..TextError::default()
        },
        (None, error) => TextError {
            message: error.to_string(),
            hint: error.hint().map(str::to_owned),
            ..TextError::default()
        },
    }
}
