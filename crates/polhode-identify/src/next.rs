//! The next experiment: what would be known with each that could be made, best first.

use core::cmp::Ordering;

use nalgebra::DMatrix;

use crate::error::IdentifyError;
use crate::knowledge::{BodyUnits, Knowledge};
use crate::least_squares::Information;

/// Experiments that could be made next, by what would be known then: the covariance that follows from what was measured and the derivatives of what would be, with
/// noise of the same size. Which measurement helps depends on the body, so this is that of the body that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct NextExperiment<E> {
    /// What is known now.
    pub now: Knowledge,
    /// Best first: the fewer directions in which nothing is known the better. Then the largest standard deviation counts; but as long as there are unknown directions
    /// the mean one, for what is known is another part of the numbers after each experiment.
    pub candidates: Vec<Candidate<E>>,
    /// Places of candidates that together make all known, each the best after those before it. None if all is known, or these do not do it.
    pub together: Vec<usize>,
    /// Experiments that cannot be made, and why.
    pub refused: Vec<(E, IdentifyError)>,
}

/// An experiment that could be made.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate<E> {
    /// What is done.
    pub experiment: E,
    /// What would be known then.
    pub then: Knowledge,
}

/// What counts as help: the part of the largest standard deviation that is left.
const HELP: f64 = 0.99;

impl<E> NextExperiment<E> {
    /// The experiment that helps most; `None` if none makes a direction known, or brings what is known least below 0.99 of what it is.
    pub fn best(&self) -> Option<&Candidate<E>> {
        let (now, first) = (&self.now, self.candidates.first()?);
        let helps = match (first.then.unknown, now.unknown) {
            (0, 0) => first.then.largest_sd < HELP * now.largest_sd,
            (then, now) => then < now,
        };
        helps.then_some(first)
    }
}

/// Experiments as they are compared.
pub(crate) struct Comparison<'a, E> {
    units: &'a BodyUnits,
    information: &'a Information,
    /// With the rows that they would add.
    made: Vec<(Candidate<E>, DMatrix<f64>)>,
    refused: Vec<(E, IdentifyError)>,
}

impl<'a, E> Comparison<'a, E> {
    pub(crate) const fn new(units: &'a BodyUnits, information: &'a Information) -> Self {
        Self { units, information, made: Vec::new(), refused: Vec::new() }
    }

    /// One experiment, with the rows that it would add.
    pub(crate) fn add(&mut self, experiment: E, rows: Result<DMatrix<f64>, IdentifyError>) {
        match rows.and_then(|rows| Ok((self.after(self.information, &rows)?, rows))) {
            Ok((then, rows)) => self.made.push((Candidate { experiment, then }, rows)),
            Err(error) => self.refused.push((experiment, error)),
        }
    }

    /// Returns the knowledge with more rows.
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

/// `x − z` of (1, 0, −1), however long.
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
