//! Symbols of a scenario: named quantities, and formulas of them in place of quantities.
//!
//! ```toml
//! [symbols]
//! M = "2 kg"
//! b = "0.3 m"
//!
//! [[body.part]]
//! shape = "box"
//! size = ["b", "b", "2*b"]
//! mass = "M/4"
//! ```

use std::sync::atomic::{AtomicBool, Ordering};

use polhode::math::formula::Formula;

use crate::expression::{ExpressionError, ExpressionErrorKind, measured};
use crate::unit::{self, Dimension};

/// Named quantities of a scenario.
#[derive(Debug, Default)]
pub struct Symbols(Vec<Symbol>);

/// Quantity with a name.
#[derive(Debug)]
pub struct Symbol {
    /// Name in formulas.
    pub name: String,
    /// Value, SI units.
    pub value: f64,
    /// Dimension of the value.
    pub dimension: Dimension,
    is_used: AtomicBool,
}

impl Symbol {
    /// Returns true if a formula that has been evaluated contains it.
    pub fn is_used(&self) -> bool {
        self.is_used.load(Ordering::Relaxed)
    }
}

impl Symbols {
    /// Adds a symbol.
    pub fn add(&mut self, name: String, value: f64, dimension: Dimension) {
        self.0.push(Symbol { name, value, dimension, is_used: AtomicBool::new(false) });
    }

    /// Returns the symbols in the order of the file.
    pub fn all(&self) -> &[Symbol] {
        &self.0
    }

    /// Returns true if a text is a formula, in a scenario with symbols: it is not a quantity of any
    /// dimension.
    pub fn is_formula(&self, text: &str) -> bool {
        !self.0.is_empty() && unit::measured(text).is_err()
    }

    /// Returns true if a text contains the name of a symbol.
    pub(crate) fn are_in(&self, text: &str) -> bool {
        words(text).any(|word| self.0.iter().any(|symbol| symbol.name == word))
    }

    /// Returns a formula; variable n is symbol n.
    ///
    /// # Errors
    /// [`ExpressionError`] for a text that is not a formula of the symbols with this dimension.
    pub fn formula(&self, text: &str, dimension: Dimension) -> Result<Formula, ExpressionError> {
        let variables: Vec<(&str, Dimension)> =
            self.0.iter().map(|symbol| (symbol.name.as_str(), symbol.dimension)).collect();
        Ok(measured(text, &variables, Some(dimension))?.0)
    }

    /// Returns true if all constants of a formula are plain numbers, so that it holds in all systems
    /// of units.
    pub fn holds_in_all_units(&self, formula: &Formula, dimension: Dimension) -> bool {
        /// Units of mass, length and time for the trial, in SI units.
        const UNITS: [f64; 3] = [1.7, 0.6, 2.3];
        let value = |units: [f64; 3]| {
            let values = self.0.iter().map(|symbol| symbol.value / symbol.dimension.size(units));
            formula.evaluate(&values.collect::<Vec<_>>()) * dimension.size(units)
        };
        let (in_si, in_others) = (value([1.0; 3]), value(UNITS));
        (in_others - in_si).abs() <= 1e-12 * in_si.abs()
    }

    /// Returns the value of a formula, SI units.
    pub(crate) fn evaluate(&self, text: &str, dimension: Dimension) -> Result<f64, ExpressionError> {
        let formula = self.formula(text, dimension)?;
        for (_, symbol) in self.0.iter().enumerate().filter(|(k, _)| formula.depends_on(*k)) {
            symbol.is_used.store(true, Ordering::Relaxed);
        }
        let values: Vec<f64> = self.0.iter().map(|symbol| symbol.value).collect();
        let value = formula.evaluate(&values);
        if value.is_finite() {
            return Ok(value);
        }
        Err(ExpressionError { kind: ExpressionErrorKind::Number { found: text.to_owned() }, column: 1 })
    }
}

/// Returns the words of a formula.
pub(super) fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_')
}
