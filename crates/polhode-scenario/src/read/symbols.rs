//! Table `[symbols]`: named quantities for formulas.

use polhode_source::expression::is_reserved;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::toml::symbols::Symbols;
use polhode_source::unit::{self, Dimension};
use polhode_source::{FormatError, FormatErrorKind};

/// Reads the table `[symbols]`, if there is one.
///
/// # Errors
/// [`FormatError`] for a name that formulas cannot contain, or a value that is not a quantity.
pub(super) fn symbols(root: &Table<'_>) -> Result<Symbols, FormatError> {
    let Some(table) = root.get("symbols") else { return Ok(Symbols::default()) };
    let mut all = Symbols::default();
    for (name, value) in table.table()?.each("symbols") {
        let (number, dimension) = value.any_quantity()?;
        require_name(name, dimension, &value)?;
        all.add(name.to_owned(), number, dimension);
    }
    Ok(all)
}

/// Checks that each symbol is in a formula.
///
/// # Errors
/// [`FormatError`] at the first symbol that is in none.
pub(super) fn require_used(symbols: &Symbols, root: &Table<'_>) -> Result<(), FormatError> {
    let Some(table) = root.get("symbols") else { return Ok(()) };
    for (symbol, (name, value)) in symbols.all().iter().zip(table.table()?.each("symbols")) {
        if !symbol.is_used() {
            let error = value.invalid(format!("in a formula of the scenario, such as \"{name}/2\""));
            return Err(error.with_hint(format!("use {name} in a formula, or remove it")));
        }
    }
    Ok(())
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
