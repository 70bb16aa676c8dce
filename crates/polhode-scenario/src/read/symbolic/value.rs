//! Values of a scenario as exact formulas of its symbols.

use polhode::math::formula::{Binary, Formula, Instruction, Unary};
use polhode_algebra::{Kind, Rational, RationalFunction, Symbol, Symbols, Vector};
use polhode_source::toml::reader::Value;
use polhode_source::toml::symbols::Symbols as Table;
use polhode_source::unit::{self, Dimension};

use crate::symbolic::{Gap, Known, sine_and_cosine};

/// Digits that a decimal may have to be exact: an inexact one, such as π/6 in decimals, has more.
const MOST_DIGITS: usize = 14;

/// Symbols of a scenario, in the table of the file and in that of the algebra.
pub(super) struct Letters<'a> {
    pub table: &'a Table,
    pub symbols: Symbols,
    pub known: Vec<Known>,
    pub pi: Symbol,
}

impl<'a> Letters<'a> {
    /// Declares the symbols; `written` are the quantities of the file.
    pub(super) fn new(table: &'a Table, written: &[&str]) -> Result<Self, Gap> {
        let mut symbols = Symbols::new();
        let mut known = Vec::new();
        let refused = |what: &str| Gap::Kind {
            what: format!("the symbol {what}"),
            why: "has the name of another symbol or of π; rename it",
        };
        // π comes first in products: 4/3 π r³.
        let pi = symbols.declare("π", Kind::Positive).map_err(|_| refused("π"))?;
        for (symbol, written) in table.all().iter().zip(written) {
            let kind = if symbol.value > 0.0 { Kind::Positive } else { Kind::Constant };
            let letter = symbols.declare(&symbol.name, kind).map_err(|_| refused(&symbol.name))?;
            let name = symbols.notation(letter).to_text();
            known.push(Known { symbol: letter, written: format!("{name} = {written}"), value: symbol.value });
        }
        Ok(Self { table, symbols, known, pi })
    }

    /// Returns a quantity: a formula, or zero.
    pub(super) fn quantity(
        &self,
        value: &Value<'_>,
        dimension: Dimension,
        what: impl Fn() -> String,
    ) -> Result<RationalFunction, Gap> {
        if let Some(text) = value.string().ok().filter(|text| self.table.is_formula(text)) {
            let formula = self.table.formula(text, dimension).ok();
            let exact = formula.filter(|formula| self.table.holds_in_all_units(formula, dimension));
            let gap = || Gap::Formula { what: what(), written: text.to_owned() };
            return exact.and_then(|formula| self.exact(&formula)).ok_or_else(gap);
        }
        let written = value.source().text.get(value.span()).unwrap_or_default().trim_matches(['"', '\'']);
        let number = value.quantity(dimension).ok();
        let exact = match dimension {
            _ if number == Some(0.0) => Some(RationalFunction::zero()),
            Dimension::NONE => decimal(written),
            Dimension::ANGLE => self.angle(written),
            // Without symbols all numbers are in SI units.
            _ if self.known.is_empty() => number.and_then(|number| decimal(&number.to_string())),
            _ => None,
        };
        exact.ok_or_else(|| Gap::Number { what: what(), written: written.to_owned() })
    }

    /// Returns three quantities.
    pub(super) fn vector(
        &self,
        value: &Value<'_>,
        dimension: Dimension,
        what: impl Fn() -> String,
    ) -> Result<Vector, Gap> {
        let elements = value.fixed::<3>("quantities").map_err(|_| unreadable(what()))?;
        let [x, y, z] = elements.map(|element| self.quantity(&element, dimension, &what));
        Ok(Vector([x?, y?, z?]))
    }

    /// Returns an angle in degrees as a multiple of π, `"30 deg"`.
    fn angle(&self, written: &str) -> Option<RationalFunction> {
        let degrees = decimal(&unit::number_of(written)?)?;
        let half_turn = RationalFunction::from(180);
        matches!(unit::unit_of(written), "deg" | "°")
            .then(|| (degrees * RationalFunction::from(self.pi)).over(&half_turn))?
    }

    /// Returns a formula as a rational function; `None` if it is none.
    fn exact(&self, formula: &Formula) -> Option<RationalFunction> {
        let mut stack: Vec<RationalFunction> = Vec::new();
        for instruction in formula.instructions() {
            let value = match *instruction {
                Instruction::Constant(value) if value == std::f64::consts::PI => self.pi.into(),
                Instruction::Constant(value) => decimal(&value.to_string())?,
                Instruction::Variable(k) => self.known.get(k)?.symbol.into(),
                Instruction::Unary(function) => self.unary(function, &stack.pop()?)?,
                Instruction::Binary(function) => {
                    let b = stack.pop()?;
                    self.binary(function, &stack.pop()?, &b)?
                }
                Instruction::If | Instruction::Clip | Instruction::Local(_) | Instruction::EndLocal => {
                    return None;
                }
            };
            stack.push(value);
        }
        stack.pop()
    }

    fn unary(&self, function: Unary, x: &RationalFunction) -> Option<RationalFunction> {
        match function {
            Unary::Negate => Some(-x),
            Unary::Sqrt => x.square_root(&self.symbols).as_rational_function(),
            Unary::Sin => sine_and_cosine(x, self.pi).map(|[sin, _]| sin),
            Unary::Cos => sine_and_cosine(x, self.pi).map(|[_, cos]| cos),
            Unary::Tan => sine_and_cosine(x, self.pi).and_then(|[sin, cos]| sin.over(&cos)),
            Unary::Power(n) => x.pow(n),
            _ => None,
        }
    }

    fn binary(
        &self,
        function: Binary,
        a: &RationalFunction,
        b: &RationalFunction,
    ) -> Option<RationalFunction> {
        match function {
            Binary::Add => Some(a + b),
            Binary::Subtract => Some(a - b),
            Binary::Multiply => Some(a * b),
            Binary::Divide => a.over(b),
            Binary::Hypot => self.unary(Unary::Sqrt, &(a * a + b * b)),
            _ => None,
        }
    }
}

/// Returns a decimal number, if it has few enough digits to be exact.
fn decimal(written: &str) -> Option<RationalFunction> {
    let digits = written.bytes().filter(u8::is_ascii_digit).count();
    let number: Rational = written.trim().parse().ok().filter(|_| digits <= MOST_DIGITS)?;
    Some(RationalFunction::from(number))
}

/// Returns the gap for a value that is not an array of quantities.
pub(super) fn unreadable(what: String) -> Gap {
    Gap::Kind { what, why: "is not written as an array of quantities" }
}
