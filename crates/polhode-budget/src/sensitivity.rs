//! Which errors matter.

use polhode::body::MassPropertiesGradient;
use polhode::math::Body;

use crate::budget::Budget;
use crate::error::BudgetError;
use crate::growth::Basis;
use crate::uncertainty::{ErrorKind, NUMBERS};

/// What an error contributes to the variance of a result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    /// Whose error.
    pub source: Source,
    /// Of which numbers.
    pub kind: ErrorKind,
    /// Its part of the variance, in the square of the result's unit; all parts together are the variance to first order.
    pub variance: f64,
}

/// The errors that matter most to a result.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sensitivities {
    /// The greatest first; errors that do not matter are left out.
    pub greatest: Vec<Sensitivity>,
    /// Sum of the variances of all other errors.
    pub rest: f64,
    /// Number of the other errors.
    pub others: usize,
}

/// Where an error comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A row, by its place in the list: what it does not share with its group.
    Row(usize),
    /// A group, by its place in the list: what its rows have in common.
    Group(usize),
}

impl Budget {
    /// Returns the `most` greatest contributions to the variance of each result, and the sum of all
    /// others. A result is given by its gradient.
    ///
    /// # Errors
    /// As [`Budget::mass_properties`].
    pub fn sensitivities(
        &self,
        basis: Basis,
        gradients: &[MassPropertiesGradient<Body>],
        most: usize,
    ) -> Result<Vec<Sensitivities>, BudgetError> {
        let subtrees = self.subtrees(basis)?;
        let whole = self.whole(&subtrees)?;
        let mut all: Vec<Greatest> = gradients.iter().map(|_| Greatest::new(most)).collect();
        let mut shared = vec![vec![[0.0; NUMBERS]; self.groups.len()]; gradients.len()];
        self.changes(basis, &subtrees, &whole, |change| {
            for ((gradient, found), shared) in gradients.iter().zip(&mut all).zip(&mut shared) {
                let by = gradient.along(&change.alone);
                found.add(Source::Row(change.row), change.kind(), by * by);
                if let Some((group, by)) = &change.shared {
                    shared[*group][change.number] += gradient.along(by);
                }
            }
        })?;
        for (found, shared) in all.iter_mut().zip(shared) {
            for (group, sums) in shared.iter().enumerate() {
                for (number, sum) in sums.iter().enumerate() {
                    found.add(Source::Group(group), ErrorKind::of(number), sum * sum);
                }
            }
        }
        Ok(all.into_iter().map(Greatest::done).collect())
    }
}

/// Collects the greatest contributions. Twice as many as are wanted are kept between two sorts.
struct Greatest {
    most: usize,
    found: Sensitivities,
    /// Errors of a row come one after the other, and of each kind together: the sum of one kind.
    last: Option<Sensitivity>,
}

impl Greatest {
    fn new(most: usize) -> Self {
        Self { most, found: Sensitivities::default(), last: None }
    }

    fn add(&mut self, source: Source, kind: ErrorKind, variance: f64) {
        if variance == 0.0 {
            return;
        }
        match &mut self.last {
            Some(last) if last.source == source && last.kind == kind => last.variance += variance,
            _ => {
                self.keep();
                self.last = Some(Sensitivity { source, kind, variance });
            }
        }
    }

    fn keep(&mut self) {
        self.found.greatest.extend(self.last.take());
        if self.found.greatest.len() > self.most.saturating_mul(2) {
            self.shorten();
        }
    }

    fn shorten(&mut self) {
        let Sensitivities { greatest, rest, others } = &mut self.found;
        greatest.sort_by(|a, b| b.variance.total_cmp(&a.variance));
        let dropped = greatest.drain(self.most.min(greatest.len())..);
        *others += dropped.len();
        *rest += dropped.map(|one| one.variance).sum::<f64>();
    }

    fn done(mut self) -> Sensitivities {
        self.keep();
        self.shorten();
        self.found
    }
}
