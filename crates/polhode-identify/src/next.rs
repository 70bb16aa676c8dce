//! Ranking of possible next experiments by the uncertainty that would remain after each.

use core::cmp::Ordering;

use nalgebra::DMatrix;

use crate::error::IdentifyError;
use crate::knowledge::{BodyUnits, Knowledge};
use crate::least_squares::Information;

/// Possible next experiments, ranked by the uncertainty that would remain.
///
/// The predicted covariance follows from the measurements so far and the derivatives of the new
/// ones, with noise of the same size. The ranking holds for the estimated body, because the benefit
/// of a measurement depends on the body.
#[derive(Clone, Debug, PartialEq)]
pub struct NextExperiment<E> {
    /// Uncertainty after the measurements so far.
    pub now: Knowledge,
    /// Candidates, best first.
    ///
    /// Fewer unobservable directions are better. Among equals, the smaller largest standard
    /// deviation is better. While unobservable directions remain, the mean standard deviation
    /// counts instead, because each experiment then determines another subset of the parameters.
    pub candidates: Vec<Candidate<E>>,
    /// Indices of candidates that together make all directions observable, chosen greedily. Empty
    /// if all are observable already, or if the candidates do not suffice.
    pub together: Vec<usize>,
    /// Infeasible experiments, each with the reason.
    pub refused: Vec<(E, IdentifyError)>,
}

/// Feasible next experiment.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate<E> {
    /// Description of the experiment.
    pub experiment: E,
    /// Predicted uncertainty after the experiment.
    pub then: Knowledge,
}

/// Threshold of a useful experiment: ratio of the largest standard deviation after to before.
const HELP: f64 = 0.99;

impl<E> NextExperiment<E> {
    /// Returns the most useful experiment; `None` if none makes a direction observable or lowers
    /// the largest standard deviation below 0.99 of its present value.
    pub fn best(&self) -> Option<&Candidate<E>> {
        let (now, first) = (&self.now, self.candidates.first()?);
        let helps = match (first.then.unknown, now.unknown) {
            (0, 0) => first.then.largest_sd < HELP * now.largest_sd,
            (then, now) => then < now,
        };
        helps.then_some(first)
    }
}

/// Builder of a [`NextExperiment`]: the experiments compared so far.
pub(crate) struct Comparison<'a, E> {
    units: &'a BodyUnits,
    information: &'a Information,
    /// Feasible experiments, each with the rows of derivatives that it would add.
    made: Vec<(Candidate<E>, DMatrix<f64>)>,
    refused: Vec<(E, IdentifyError)>,
}

impl<'a, E> Comparison<'a, E> {
    pub(crate) const fn new(units: &'a BodyUnits, information: &'a Information) -> Self {
        Self { units, information, made: Vec::new(), refused: Vec::new() }
    }

    /// Adds one experiment with its rows of derivatives, or the error that makes it infeasible.
    pub(crate) fn add(&mut self, experiment: E, rows: Result<DMatrix<f64>, IdentifyError>) {
        match rows.and_then(|rows| Ok((self.after(self.information, &rows)?, rows))) {
            Ok((then, rows)) => self.made.push((Candidate { experiment, then }, rows)),
            Err(error) => self.refused.push((experiment, error)),
        }
    }

    /// Returns the uncertainty after adding rows.
    fn after(&self, information: &Information, rows: &DMatrix<f64>) -> Result<Knowledge, IdentifyError> {
        self.units.knowledge(&information.with_rows(rows)?)
    }

    pub(crate) fn finish(mut self) -> Result<NextExperiment<E>, IdentifyError> {
        self.made.sort_by(|(a, _), (b, _)| order(&a.then, &b.then));
        Ok(NextExperiment {
            now: self.units.knowledge(self.information)?,
            together: self.together()?,
            candidates: self.made.into_iter().map(|(candidate, _)| candidate).collect(),
            refused: self.refused,
        })
    }

    fn together(&self) -> Result<Vec<usize>, IdentifyError> {
        let mut information = self.information.clone();
        let mut unknown = self.units.knowledge(&information)?.unknown;
        let mut chosen = Vec::new();
        while unknown > 0 {
            let all = self.made.iter().enumerate();
            let all = all.map(|(k, (_, rows))| Ok((k, self.after(&information, rows)?)));
            let all = all.collect::<Result<Vec<_>, IdentifyError>>()?;
            match all.into_iter().min_by(|(_, a), (_, b)| order(a, b)) {
                Some((best, then)) if then.unknown < unknown => {
                    unknown = then.unknown;
                    information = information.with_rows(&self.made[best].1)?;
                    chosen.push(best);
                }
                _ => return Ok(Vec::new()),
            }
        }
        Ok(chosen)
    }
}

/// Returns a direction as text: `x − z` for (1, 0, −1) of any length.
pub(crate) fn signed_axes(v: [f64; 3]) -> String {
    let mut text = String::new();
    for (part, axis) in v.into_iter().zip(["x", "y", "z"]).filter(|(part, _)| part.abs() > 0.1) {
        text.push_str(match (text.is_empty(), part > 0.0) {
            (true, true) => "",
            (true, false) => "−",
            (false, true) => " + ",
            (false, false) => " − ",
        });
        text.push_str(axis);
    }
    text
}

fn order(a: &Knowledge, b: &Knowledge) -> Ordering {
    let size = |known: &Knowledge| if known.unknown > 0 { known.mean_sd } else { known.largest_sd };
    a.unknown.cmp(&b.unknown).then(size(a).total_cmp(&size(b)))
}
