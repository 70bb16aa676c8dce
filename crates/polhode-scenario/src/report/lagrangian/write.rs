//! Formulas and numbers of a section.

use polhode_algebra::{Formula, Style};
use polhode_document::Section;
use polhode_document::number::number;

/// Number of significant digits.
const DIGITS: usize = 6;

/// Adds a formula.
pub(super) fn put(s: &mut Section, formula: &Formula) {
    s.formula(&formula.to_text(), &formula.to_latex());
}

/// Formats a number.
pub(super) fn n(x: f64) -> String {
    number(x, DIGITS)
}

/// Returns the second derivative `d²f/dq²`.
pub(super) fn second_derivative(function: Formula, variable: Formula) -> Formula {
    let d = Formula::Letter("d".to_owned(), Style::Italic).squared();
    let below = Formula::Differential { is_partial: false, of: Box::new(variable.squared()) };
    Formula::product(vec![d, function]).over(below)
}
