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

use super::reader::{Table, Value};
use crate::expression::{ExpressionError, ExpressionErrorKind, is_reserved, measured};
use crate::unit::{self, Dimension};
use crate::{FormatError, FormatErrorKind};

/// Named quantities of a scenario.
#[derive(Debug, Default)]
pub struct Symbols(Vec<Symbol>);

/// Named quantity.
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

impl Symbols {
    /// Reads the table `[symbols]`, if there is one.
    ///
    /// # Errors
    /// [`FormatError`] for a name that formulas cannot contain, or a value that is not a quantity.
    pub fn read(root: &Table<'_>) -> Result<Self, FormatError> {
        let Some(table) = root.get("symbols") else { return Ok(Self::default()) };
        let mut all = Vec::new();
        for (name, value) in table.table()?.each("symbols") {
            let (number, dimension) = value.any_quantity()?;
            require_name(name, dimension, &value)?;
            let (name, is_used) = (name.to_owned(), AtomicBool::new(false));
            all.push(Symbol { name, value: number, dimension, is_used });
        }
        Ok(Self(all))
    }

    /// Returns the symbols in the order of the file.
    pub fn all(&self) -> &[Symbol] {
        &self.0
    }

    /// Returns true if a text is a formula, in a scenario with symbols: it is no quantity of any
    /// dimension.
    pub(crate) fn is_formula(&self, text: &str) -> bool {
        !self.0.is_empty() && unit::measured(text).is_err()
    }

    /// Returns true if a text contains the name of a symbol.
    pub(crate) fn are_in(&self, text: &str) -> bool {
        let mut words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
        words.any(|word| self.0.iter().any(|symbol| symbol.name == word))
    }

    /// Returns the value of a formula, SI units.
    pub(crate) fn evaluate(&self, text: &str, dimension: Dimension) -> Result<f64, ExpressionError> {
        let variables: Vec<(&str, Dimension)> =
            self.0.iter().map(|symbol| (symbol.name.as_str(), symbol.dimension)).collect();
        let (formula, _) = measured(text, &variables, Some(dimension))?;
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

    /// Checks that each symbol is in a formula.
    ///
    /// # Errors
    /// [`FormatError`] at the first symbol that is in none.
    pub fn require_used(&self, root: &Table<'_>) -> Result<(), FormatError> {
        let Some(table) = root.get("symbols") else { return Ok(()) };
        for (symbol, (name, value)) in self.0.iter().zip(table.table()?.each("symbols")) {
            if !symbol.is_used.load(Ordering::Relaxed) {
                let error = value.invalid(format!("in a formula of the scenario, such as \"{name}/2\""));
                return Err(error.with_hint(format!("use {name} in a formula, or remove it")));
            }
        }
        Ok(())
    }
}

/// Checks that formulas can contain the name of a symbol.
fn require_name(name: &str, dimension: Dimension, value: &Value<'_>) -> Result<(), FormatError> {
    let is_word = name.chars().next().is_some_and(char::is_alphabetic)
        && name.chars().all(|c| c.is_alphanumeric() || c == '_');
    let refused = |rule: &str| {
        let (key, rule) = ("a symbol".to_owned(), rule.to_owned());
        value.error(FormatErrorKind::Value { key, value: name.to_owned(), rule })
    };
    if !is_word {
        let error = refused("a letter, then letters, digits and _");
        return Err(error.with_hint("rename the symbol, such as m_1"));
    }
    if is_reserved(name) {
        let error = refused("no name that formulas already have");
        return Err(error.with_hint(format!("rename the symbol, such as {name}_0")));
    }
    // "2 m" is two metres also where m is a mass; where m is a length, it could be either.
    if unit::factor(name, dimension).is_ok() {
        let error = refused("no unit of its own dimension");
        return Err(
            error.with_hint(format!("\"2 {name}\" would be unclear: rename the symbol, such as {name}_0"))
        );
    }
    Ok(())
}
