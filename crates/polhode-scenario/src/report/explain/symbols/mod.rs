//! Steps in symbols: exact formulas of the `[symbols]` of a file, before the numbers.
//!
//! Every printed formula has been compared with the computed number at the values of the symbols.

mod body;
mod fractions;
mod momentum;
mod pendulum;
mod principal;
mod tensor;
mod top;
mod torque;

use polhode_algebra::{Fence, Formula, RationalFunction, Style, Vector};
use polhode_document::Section;

use crate::symbolic::{Gap, Symbolic};

pub(crate) use body::body;
pub(crate) use fractions::fractions;
pub(crate) use momentum::{momentum, omega};
pub(crate) use pendulum::pendulum;
pub(crate) use tensor::tensor;
pub(crate) use top::top;
pub(crate) use torque::{euler, needed};

/// Largest relative difference between a formula and the computed number.
const ROUNDING: f64 = 1e-9;

/// Adds a formula to a section.
fn write(s: &mut Section, formula: &Formula) {
    s.formula(&formula.to_text(), &formula.to_latex());
}

/// Writes the reason for which a quantity has no formula.
pub(crate) fn gap(s: &mut Section, gap: &Gap) {
    s.say(format!("Not in symbols: {gap}."));
}

/// Writes a formula if its value is the computed one, and otherwise says that it is not.
fn checked(s: &mut Section, what: &str, value: Option<f64>, computed: f64, formula: &Formula) {
    match value.filter(|value| (value - computed).abs() <= ROUNDING * computed.abs()) {
        Some(_) => write(s, formula),
        None => gap(s, &Gap::Differs { what: what.to_owned() }),
    }
}

/// Returns the letter {I} of the tensor.
fn tensor_letter() -> Formula {
    Formula::Letter("I".to_owned(), Style::Bold).grouped(Fence::Braces)
}

/// Returns a vector as a sum along x̂, ŷ and ẑ.
fn along_axes(of: &Symbolic, vector: &Vector) -> Formula {
    let unit = |name: &str| Formula::vector(name).accented(polhode_algebra::Accent::Hat);
    vector.in_basis(&["x", "y", "z"].map(unit), &of.symbols)
}

/// Returns the formula of a value.
fn formula(of: &Symbolic, value: &RationalFunction) -> Formula {
    value.to_formula(&of.symbols)
}
