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

/// Where an error comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A row, by its place in the list: what it does not share with its group.
    Row(usize),
    /// A group, by its place in the list: what its rows have in common.
    Group(usize),
}

impl Budget {
    /// What each error contributes to the variance of each result whose gradient is given, the greatest first; errors that do not matter to a result are left out.
    ///
    /// # Errors
    /// As [`Budget::mass_properties`].
    pub fn sensitivities(
        &self,
        basis: Basis,
        gradients: &[MassPropertiesGradient<Body>],
    ) -> Result<Vec<Vec<Sensitivity>>, BudgetError> {
        let subtrees = self.subtrees(basis)?;
        let whole = self.whole(&subtrees)?;
        let mut all: Vec<Vec<Sensitivity>> = vec![Vec::new(); gradients.len()];
        let mut shared = vec![vec![[0.0; NUMBERS]; self.list.groups.len()]; gradients.len()];
        self.changes(basis, &subtrees, &whole, |change| {
            for ((gradient, found), shared) in gradients.iter().zip(&mut all).zip(&mut shared) {
                let by = gradient.along(&change.alone);
                add(found, Source::Row(change.row), change.kind(), by * by);
                if let Some((group, by)) = &change.shared {
                    shared[*group][change.number] += gradient.along(by);
                }
            }
        })?;
        for (found, shared) in all.iter_mut().zip(shared) {
            for (group, sums) in shared.iter().enumerate() {
                for (number, sum) in sums.iter().enumerate() {
                    add(found, Source::Group(group), ErrorKind::of(number), sum * sum);
                }
            }
            found.sort_by(|a, b| b.variance.total_cmp(&a.variance));
        }
        Ok(all)
    }
}

/// The errors of a row come one after the other, and of each kind together.
fn add(found: &mut Vec<Sensitivity>, source: Source, kind: ErrorKind, variance: f64) {
    if variance == 0.0 {
        return;
    }
    match found.last_mut() {
        Some(last) if last.source == source && last.kind == kind => last.variance += variance,
        _ => found.push(Sensitivity { source, kind, variance }),
    }
}
