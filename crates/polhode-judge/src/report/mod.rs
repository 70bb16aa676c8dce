//! Reports on runs of other programs, as text and JSON.

mod card;
mod compared;
mod graph;
mod hint;
mod json;
mod verdicts;
mod words;

use std::path::Path;

use polhode::infer::judge::{
    AccuracyOrder, Causes, DeclaredReading, JudgeError, Judgement, MotionLog, StepErrors, Untried, causes,
};
use polhode::motion::Scenario;
use polhode_document::layout::printable;

pub use card::{Card, CardCase, CardRun};
pub(crate) use compared::ComparedRun;
pub use compared::Comparison;
pub use hint::judge_hint;
pub use verdicts::JudgeReport;

/// Judged run of another program.
#[derive(Clone, Debug)]
pub struct JudgedRun {
    /// Name of the run: that of its file, if any.
    pub name: String,
    /// Path of the file.
    pub path: Option<String>,
    /// Program and method that produced the run, if the run names them.
    pub engine: Option<String>,
    /// Time step of the program, s.
    pub step: Option<f64>,
    /// True if the step was specified. Otherwise it is the spacing of the rows, which equals the
    /// step if every step is written.
    pub step_is_said: bool,
    /// Errors and interpretation of the run.
    pub judgement: Judgement,
    /// Possible causes of the error.
    pub causes: Causes,
    /// Columns without use.
    pub ignored: Vec<String>,
}

/// Name of a run without file.
const UNNAMED: &str = "run";

impl JudgedRun {
    /// Judges a log of a scenario's motion. `step` is the program's time step, s, if specified.
    ///
    /// # Errors
    /// Same as [`Judgement::of`]; [`judge_hint`] returns a hint.
    pub fn of(
        file: Option<&Path>,
        scenario: &Scenario,
        log: &MotionLog,
        declared: &DeclaredReading,
        step: Option<f64>,
    ) -> Result<Self, JudgeError> {
        let judgement = Judgement::of(scenario, log, declared)?;
        let (step, step_is_said) = (step.or_else(|| spacing(&judgement.motion.times)), step.is_some());
        let causes = causes(scenario, &judgement.motion, judgement.reference.states(), step);
        let name = file.map(|file| file.file_name().unwrap_or(file.as_os_str()).to_string_lossy());
        let name = name.map_or_else(|| UNNAMED.to_owned(), |name| printable(&name));
        let path = file.map(|file| file.display().to_string());
        Ok(Self { name, path, engine: None, step, step_is_said, judgement, causes, ignored: Vec::new() })
    }

    /// Returns the largest angle between an attitude and the exact one, rad.
    fn largest(&self) -> f64 {
        self.judgement.largest_attitude_error()
    }

    /// Returns the largest |δω|, relative to the largest exact |ω|; `None` without ω.
    fn omega_off(&self) -> Option<f64> {
        let rates = self.judgement.errors.rates.as_ref()?;
        Some(rates.omega.iter().copied().fold(0.0, f64::max))
    }

    /// Returns the larger of the attitude error, rad, and the relative error of ω.
    pub fn worst(&self) -> f64 {
        self.largest().max(self.omega_off().unwrap_or(0.0))
    }

    /// Returns true if the run is indistinguishable from the exact motion.
    pub fn is_exact(&self) -> bool {
        self.is_attitude_exact() && self.omega_off().is_none_or(|off| off <= self.omega_floor())
    }

    /// Returns true if the attitudes are indistinguishable from the exact ones.
    fn is_attitude_exact(&self) -> bool {
        self.largest() <= 3.0 * self.judgement.floor()
    }

    /// Returns the error of ω, relative to its largest value, that rounding of ω and of time
    /// explains.
    fn omega_floor(&self) -> f64 {
        OMEGA_EXACT.max(3.0 * self.judgement.floor())
    }

    /// Returns true if the error is small, or its most likely cause is known.
    fn is_explained(&self) -> bool {
        self.is_exact() || self.causes.untried == Some(Untried::Exact) || self.causes.likeliest().is_some()
    }

    /// Returns true if the program has a detected mistake, and the error is above the floor.
    pub fn has_mistake(&self) -> bool {
        let is_explained = self.causes.mistake().is_some() && !self.is_attitude_exact();
        is_explained || !self.judgement.readings.mistakes.is_empty()
    }
}

/// Relative error of ω caused by its rounding.
const OMEGA_EXACT: f64 = 1e-12;

/// Returns a text with an upper-case first letter.
fn capitalized(mut text: String) -> String {
    if let Some(first) = text.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    text
}

/// Returns the spacing of equidistant rows, s; `None` if they are not equidistant.
fn spacing(times: &[f64]) -> Option<f64> {
    let (first, last) = (times.first()?, times.last()?);
    let mean = (last - first) / (times.len() - 1) as f64;
    // Times may have single precision.
    let rounding = 1e-3 * mean + 2e-7 * first.abs().max(last.abs());
    times.windows(2).all(|pair| (pair[1] - pair[0] - mean).abs() <= rounding).then_some(mean)
}

/// Returns the order of accuracy from runs of one program with several specified steps.
fn accuracy_order(runs: &[JudgedRun]) -> Option<AccuracyOrder> {
    let [first, others @ ..] = runs else { return None };
    if others.iter().any(|run| run.engine != first.engine) || runs.iter().any(|run| !run.step_is_said) {
        return None;
    }
    let angles: Vec<Vec<f64>> = runs.iter().map(|run| run.judgement.errors.angles()).collect();
    let steps = runs.iter().zip(&angles).filter_map(|(run, errors)| {
        let (times, floor) = (run.judgement.motion.times.as_slice(), run.judgement.floor());
        run.step.map(|step| StepErrors { step, times, errors, floor })
    });
    AccuracyOrder::of(&steps.collect::<Vec<_>>())
}
