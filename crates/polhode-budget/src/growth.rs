//! Growth allowance: expected increase of the masses of parts until flight.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::error::BudgetError;

/// Growth allowances by maturity code: fractions of the basic mass, 0.15 for 15 %.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GrowthTable {
    allowances: BTreeMap<String, f64>,
}

/// Growth allowance of a part.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Growth {
    /// No allowance: the predicted mass is the basic mass.
    #[default]
    None,
    /// Allowance of a maturity code, see [`GrowthTable`].
    Code(String),
    /// Fraction of the basic mass.
    Fraction(f64),
}

/// Choice of the masses from which results are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Basis {
    /// Masses as currently known.
    Basic,
    // A part grows without changing its form. Its tensor and the errors of both scale with its
    // mass.
    /// Masses with the growth allowance.
    Predicted,
}

impl Basis {
    /// Both variants with their names.
    pub(crate) const NAMED: [(&str, Self); 2] = [("basic", Self::Basic), ("predicted", Self::Predicted)];

    pub(crate) const fn name(self) -> &'static str {
        Self::NAMED[self as usize].0
    }
}

/// Masses of a row with its descendants, all copies counted. The terms are those of AIAA S-120A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassStatement {
    /// Basic mass, kg: the current estimate.
    pub basic: f64,
    /// Predicted mass, kg: basic mass plus growth allowance.
    pub predicted: f64,
    /// Allowable mass, kg, if given.
    pub allowable: Option<f64>,
}

impl GrowthTable {
    /// Makes a table from codes and allowances.
    ///
    /// # Errors
    /// [`BudgetError::Table`] if an allowance is negative or not finite, or if a code has two
    /// different allowances.
    pub fn new(codes: impl IntoIterator<Item = (String, f64)>) -> Result<Self, BudgetError> {
        let mut allowances = BTreeMap::new();
        let what = "the growth allowance";
        for (name, value) in codes {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(BudgetError::Table { name, what, value, rule: RULE });
            }
            if allowances.get(&name).is_some_and(|before| *before != value) {
                return Err(BudgetError::Table { name, what, value, rule: "the same everywhere" });
            }
            allowances.insert(name, value);
        }
        Ok(Self { allowances })
    }

    /// Returns the allowance of a code as a fraction.
    pub fn get(&self, code: &str) -> Option<f64> {
        self.allowances.get(code).copied()
    }

    /// Iterates over all codes and their allowances, in ascending order of the codes.
    pub fn codes(&self) -> impl Iterator<Item = (&str, f64)> {
        self.allowances.iter().map(|(code, allowance)| (code.as_str(), *allowance))
    }
}

/// Condition on an allowance, for messages.
pub(crate) const RULE: &str = "a fraction, zero or positive";

impl MassStatement {
    /// Returns the mass growth allowance, kg.
    pub fn growth_allowance(&self) -> f64 {
        self.predicted - self.basic
    }

    /// Returns allowable minus predicted mass, kg. It is negative if the allowable mass is
    /// exceeded.
    pub fn margin(&self) -> Option<f64> {
        self.allowable.map(|allowable| allowable - self.predicted)
    }

    /// Returns the margin as a fraction of the basic mass.
    pub fn relative_margin(&self) -> Option<f64> {
        self.margin().map(|margin| margin / self.basic)
    }
}
