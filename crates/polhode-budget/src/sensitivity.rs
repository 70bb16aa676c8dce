//! Contributions of single errors to the variance of a result.

use polhode::body::MassPropertiesGradient;
use polhode::math::Body;

use crate::budget::Budget;
use crate::error::BudgetError;
use crate::growth::Basis;
use crate::uncertainty::{ErrorKind, NUMBERS};

/// Contribution of an error to the variance of a result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    /// Row or group that has the error.
    pub source: Source,
    /// Number that the error belongs to.
    pub kind: ErrorKind,
    /// Contribution to the variance, in the squared unit of the result. All contributions add up to
    /// the variance to first order.
    pub variance: f64,
}

/// Errors that contribute most to the variance of a result.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sensitivities {
    /// Largest contributions, in descending order. Errors without effect are left out.
    pub greatest: Vec<Sensitivity>,
    /// Sum of the variances of all other errors.
    pub rest: f64,
    /// Number of the other errors.
    pub others: usize,
}

/// Row or group that an error comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Index of a row. The error is the part that it does not share with its group.
    Row(usize),
    /// Index of a group. The error is the part that its rows share.
    Group(usize),
}

impl Budget {
    /// Returns the `most` greatest contributions to the variance of each result, and the sum of all
    /// others. A result is given by its gradient.
    ///
    /// # Errors
    /// Same as [`Budget::mass_properties`].
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
                let by = gradient.derivative_along(&change.alone);
                found.add(Source::Row(change.row), change.kind(), by * by);
                if let Some((group, by)) = &change.shared {
                    shared[*group][change.number] += gradient.derivative_along(by);
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

/// Collector of the greatest contributions. It keeps up to twice the wanted number between two
/// sorts.
struct Greatest {
    most: usize,
    found: Sensitivities,
    /// Running sum of one kind. The errors of a row arrive consecutively, grouped by kind.
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
