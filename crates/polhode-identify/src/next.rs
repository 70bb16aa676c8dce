//! The next experiment: what would be known with each that could be made, best first.

use crate::error::IdentifyError;
use crate::knowledge::{BodyUnits, Knowledge};
use crate::least_squares::Information;

use nalgebra::DMatrix;

/// Experiments that could be made next, by what would be known then: the covariance that follows from what was measured and the derivatives of what would be, with
/// noise of the same size. Which measurement helps depends on the body, so this is that of the body that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct NextExperiment<E> {
    /// What is known now.
    pub now: Knowledge,
    /// Best first: the fewer directions in which nothing is known the better. Then the largest standard deviation counts; but as long as there are unknown directions
    /// the mean one, for what is known is another part of the numbers after each experiment.
    pub candidates: Vec<Candidate<E>>,
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

impl<E> NextExperiment<E> {
    pub(crate) fn of(units: &BodyUnits, information: &Information) -> Self {
        Self { now: units.knowledge(information), candidates: Vec::new(), refused: Vec::new() }
    }

    /// One experiment, with the rows that it would add.
    pub(crate) fn consider(
        &mut self,
        (units, information): (&BodyUnits, &Information),
        experiment: E,
        rows: Result<DMatrix<f64>, IdentifyError>,
    ) {
        match rows {
            Ok(rows) => {
                let then = units.knowledge(&information.with_rows(&rows));
                self.candidates.push(Candidate { experiment, then });
            }
            Err(error) => self.refused.push((experiment, error)),
        }
    }

    pub(crate) fn ranked(mut self) -> Self {
        self.candidates.sort_by(|a, b| {
            let (a, b) = (&a.then, &b.then);
            let size = |known: &Knowledge| if known.unknown > 0 { known.mean_sd } else { known.largest_sd };
            a.unknown.cmp(&b.unknown).then(size(a).total_cmp(&size(b)))
        });
        self
    }

    /// The experiment that helps most; `None` if none makes a direction known, or brings what is known least below 0.99 of what it is.
    pub fn best(&self) -> Option<&Candidate<E>> {
        let helps = |then: &Knowledge| {
            then.unknown < self.now.unknown
                || then.unknown == 0 && self.now.unknown == 0 && then.largest_sd < 0.99 * self.now.largest_sd
        };
        self.candidates.first().filter(|best| helps(&best.then))
    }
}
