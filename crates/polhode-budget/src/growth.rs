//! Growth allowance: by how much parts become heavier until they fly.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::error::BudgetError;

/// Allowances by maturity code, as the list gives them: fractions of the basic mass, 0.15 for 15 %.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GrowthTable {
    allowances: BTreeMap<String, f64>,
}

/// The growth allowance of a part.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Growth {
    /// None is given: the predicted mass is the basic one.
    #[default]
    None,
    /// That of a maturity code.
    Code(String),
    /// A fraction of the basic mass.
    Fraction(f64),
}

/// Masses of parts that count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Basis {
    /// As they are known today.
    Basic,
    // A part grows without changing its form, so its tensor and the errors of both grow with it.
    /// With the growth allowance.
    Predicted,
}

impl Basis {
    /// Both, with their names.
    pub(crate) const NAMED: [(&str, Self); 2] = [("basic", Self::Basic), ("predicted", Self::Predicted)];

    pub(crate) const fn name(self) -> &'static str {
        Self::NAMED[self as usize].0
    }
}

/// The masses of a row with all in it, all copies counted, in the words of AIAA S-120A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassStatement {
    /// What is known today, kg.
    pub basic: f64,
    /// Basic mass and growth allowance, kg.
    pub predicted: f64,
    /// What it may become at most, kg, where that is given.
    pub allowable: Option<f64>,
}

impl GrowthTable {
    /// Of codes and their allowances.
    ///
    /// # Errors
    /// [`BudgetError::Table`] if an allowance is negative or not finite; of a code that is given twice, by its second allowance if that differs.
    pub fn new(codes: impl IntoIterator<Item = (String, f64)>) -> Result<Self, BudgetError> {
        let mut allowances = BTreeMap::new();
        let what = "the growth allowance";
        for (name, value) in codes {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(BudgetError::Table { name, what, value, rule: RULE });
            }
            if allowances.get(&name).is_some_and(|before| *before != value) {
                return Err(BudgetError::Table { name, what, value, rule: "the same wherever it is given" });
            }
            allowances.insert(name, value);
        }
        Ok(Self { allowances })
    }

    /// The allowance of a code, as a fraction.
    pub fn get(&self, code: &str) -> Option<f64> {
        self.allowances.get(code).copied()
    }

    /// All codes with their allowances, in order.
    pub fn codes(&self) -> impl Iterator<Item = (&str, f64)> {
        self.allowances.iter().map(|(code, allowance)| (code.as_str(), *allowance))
    }
}

/// What an allowance has to be.
pub(crate) const RULE: &str = "a fraction, zero or positive";

impl MassStatement {
    /// Mass growth allowance, kg.
    pub fn growth_allowance(&self) -> f64 {
        self.predicted - self.basic
    }

    /// Allowable less predicted mass, kg: negative if what is promised cannot be kept.
    pub fn margin(&self) -> Option<f64> {
        self.allowable.map(|allowable| allowable - self.predicted)
    }

    /// The margin as a fraction of the basic mass.
    pub fn relative_margin(&self) -> Option<f64> {
        self.margin().map(|margin| margin / self.basic)
    }
}
