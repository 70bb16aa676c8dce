//! What there is to say of runs of other programs, for people and for programs.

mod card;
mod graph;
mod json;
mod report;
mod words;

use polhode::infer::judge::{AccuracyOrder, Causes, Judgement, StepErrors};

pub use card::{Card, CardCase, CardRun};
pub use report::JudgeReport;

/// A run of another program, judged.
#[derive(Clone, Debug)]
pub struct JudgedRun {
    /// What it is called: its file's name.
    pub name: String,
    /// Its file.
    pub path: String,
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

impl JudgedRun {
    /// The largest angle between an attitude and the exact one, rad.
    fn largest(&self) -> f64 {
        self.judgement.largest_attitude_error()
    }

    /// Whether it cannot be told from the exact motion.
    fn is_exact(&self) -> bool {
        self.largest() <= 3.0 * self.judgement.floor()
    }
}

/// The order of accuracy of runs of one scenario by one program with several steps.
fn accuracy_order(runs: &[JudgedRun]) -> Option<AccuracyOrder> {
    let angles: Vec<Vec<f64>> = runs.iter().map(|run| run.judgement.errors.angles()).collect();
    let steps = runs.iter().zip(&angles).filter_map(|(run, errors)| {
        let (times, floor) = (run.judgement.motion.times.as_slice(), run.judgement.floor());
        run.step.map(|step| StepErrors { step, times, errors, floor })
    });
    AccuracyOrder::of(&steps.collect::<Vec<_>>())
}
