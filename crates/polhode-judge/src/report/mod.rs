//! What there is to say of runs of other programs, for people and for programs.

mod card;
mod graph;
mod hint;
mod json;
mod verdicts;
mod words;

use std::path::Path;

use polhode::infer::judge::{
    AccuracyOrder, Causes, DeclaredReading, JudgeError, Judgement, MotionLog, StepErrors, causes,
};
use polhode::motion::Scenario;
use polhode_document::layout::printable;

pub use card::{Card, CardCase, CardRun};
pub use hint::judge_hint;
pub use verdicts::JudgeReport;

/// A run of another program, judged.
#[derive(Clone, Debug)]
pub struct JudgedRun {
    /// What it is called: its file's name, if it has one.
    pub name: String,
    /// Its file.
    pub path: Option<String>,
    /// The program that made it, and how, if the run says so.
    pub engine: Option<String>,
    /// The program's time step, s.
    pub step: Option<f64>,
    /// Whether that was said; else it is the distance of the rows, which is the step of a program that writes every step.
    pub step_is_said: bool,
    /// What was found.
    pub judgement: Judgement,
    /// What may be the cause.
    pub causes: Causes,
    /// Columns that were not read.
    pub ignored: Vec<String>,
}

/// What a run is called that is no file.
const UNNAMED: &str = "run";

impl JudgedRun {
    /// A log of a scenario's motion, of a file or not, judged; `step` is the program's time step, if it is said, s.
    ///
    /// # Errors
    /// As [`Judgement::of`]; [`judge_hint`] says what helps.
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

    /// The largest angle between an attitude and the exact one, rad.
    fn largest(&self) -> f64 {
        self.judgement.largest_attitude_error()
    }

    /// The largest |δω| of the rows, as a part of the largest exact |ω|; `None` without ω.
    fn omega_off(&self) -> Option<f64> {
        let rates = self.judgement.errors.rates.as_ref()?;
        Some(rates.omega.iter().copied().fold(0.0, f64::max))
    }

    /// The worse of both: the attitude's in rad, ω's as a part of the largest.
    pub fn worst(&self) -> f64 {
        self.largest().max(self.omega_off().unwrap_or(0.0))
    }

    /// Whether it cannot be told from the exact motion.
    pub fn is_exact(&self) -> bool {
        self.is_attitude_exact() && self.omega_off().is_none_or(|off| off <= self.omega_floor())
    }

    /// True if the attitudes cannot be told from the exact ones.
    fn is_attitude_exact(&self) -> bool {
        self.largest() <= 3.0 * self.judgement.floor()
    }

    /// Error of ω, as a part of the largest, that rounding it and its time makes.
    fn omega_floor(&self) -> f64 {
        OMEGA_EXACT.max(3.0 * self.judgement.floor())
    }

    /// True if a mistake of the program was found, and the error can be told from zero.
    pub fn has_mistake(&self) -> bool {
        let is_explained = self.causes.mistake().is_some() && !self.is_attitude_exact();
        is_explained || !self.judgement.readings.mistakes.is_empty()
    }
}

/// Error of ω that rounding it makes, as a part of the largest.
const OMEGA_EXACT: f64 = 1e-12;

/// The distance of rows that are even, s.
fn spacing(times: &[f64]) -> Option<f64> {
    let (first, last) = (times.first()?, times.last()?);
    let mean = (last - first) / (times.len() - 1) as f64;
    // Times may be written in single precision.
    let rounding = 1e-3 * mean + 2e-7 * first.abs().max(last.abs());
    times.windows(2).all(|pair| (pair[1] - pair[0] - mean).abs() <= rounding).then_some(mean)
}

/// The order of accuracy of runs of one scenario by one program with several steps, which they say themselves.
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
