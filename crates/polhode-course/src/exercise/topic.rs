//! Vocabulary of topics: an exercise as data.
//!
//! Answers and mistakes are formulas in the symbols of the data, so that one statement gives the
//! problem in numbers, the problem in symbols, the solution of both, and the wrong values.

/// Topic of exercises.
#[derive(Debug)]
pub(super) struct Topic {
    /// Name in commands and answer files: `box-about-corner`.
    pub(super) name: &'static str,
    /// Title.
    pub(super) title: &'static str,
    /// Problem in words, with the symbols of the data.
    pub(super) text: &'static str,
    /// Quantities that are given, and hidden ones from which they are computed.
    pub(super) data: &'static [&'static [Datum]],
    /// Formulas that are positive for a possible and instructive body.
    pub(super) rules: &'static [&'static str],
    /// Way to the solution.
    pub(super) steps: &'static [Step],
    /// Quantities to be found.
    pub(super) questions: &'static [Question],
}

/// Quantity of a problem.
#[derive(Debug)]
pub(super) struct Datum {
    /// Symbol in formulas.
    pub(super) symbol: &'static str,
    /// Unit in which it is given.
    pub(super) unit: &'static str,
    /// Source of its value.
    pub(super) origin: Origin,
}

/// Source of a value.
#[derive(Clone, Copy, Debug)]
pub(super) enum Origin {
    /// Random decimal with two or three significant digits.
    Drawn(Range),
    /// Random decimal that only formulas of other data contain, SI units.
    Hidden(Range),
    /// Random sign ±1 that only formulas contain.
    Sign,
    /// Random angle with rational sine and cosine.
    Triple,
    /// Formula in the other data.
    Formula(&'static str),
    /// Constant, as it is printed.
    Fixed(&'static str),
}

/// Integers from `from` to `to`, divided by a power of ten.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub(super) from: u64,
    pub(super) to: u64,
    /// Number of decimals.
    pub(super) decimals: usize,
    /// True if either sign may be drawn.
    pub(super) is_signed: bool,
}

/// Step of a solution.
#[derive(Debug)]
pub(super) enum Step {
    /// Law in words and symbols.
    Say(&'static str),
    /// Intermediate result: name, formula, SI unit.
    Show(&'static str, &'static str, &'static str),
}

/// Quantity to be found.
#[derive(Debug)]
pub(super) struct Question {
    /// Name in the answer file.
    pub(super) name: &'static str,
    /// Meaning.
    pub(super) is: &'static str,
    /// Unit in the solution and in the template of the answer file.
    pub(super) unit: &'static str,
    /// Relation of the quantity to its formulas.
    pub(super) form: Form,
    /// Formula of a number; formulas of the three components of a vector; or of the elements xx, yy,
    /// zz, xy, xz, yz of a tensor.
    pub(super) right: &'static [&'static str],
    /// Likeliest mistakes.
    pub(super) mistakes: &'static [Mistake],
}

/// Relation of a quantity to its formulas. In symbols, the formula itself is the question: its name
/// in the answer file is stated here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// The quantity itself.
    Plain,
    /// Square of the quantity.
    Square(&'static str),
    /// Tangent of the quantity, an angle from 0 to 90°.
    Tangent(&'static str),
    /// Square of the tangent.
    SquaredTangent(&'static str),
    /// Vector along an axis, of any length and either sign.
    Axis,
}

/// Mistake, and what a student who makes it should read.
#[derive(Debug)]
pub(super) struct Mistake(pub(super) Wrong, pub(super) &'static str);

/// Formula of a mistake.
#[derive(Debug)]
pub(super) enum Wrong {
    /// Other formulas.
    Is(&'static [&'static str]),
    /// Right formulas times a factor.
    Times(&'static str),
    /// Right formulas with other values of some symbols.
    With(&'static [(&'static str, &'static str)]),
    /// Right tensor with the sign of its products of inertia reversed.
    Products,
}

const fn range(from: u64, to: u64, decimals: usize, is_signed: bool) -> Range {
    Range { from, to, decimals, is_signed }
}

/// Returns a positive random quantity: an integer from `from` to `to`, divided by 10^`decimals`.
pub(super) const fn drawn(
    symbol: &'static str,
    unit: &'static str,
    from: u64,
    to: u64,
    decimals: usize,
) -> Datum {
    Datum { symbol, unit, origin: Origin::Drawn(range(from, to, decimals, false)) }
}

/// Returns a random quantity of either sign.
pub(super) const fn signed(
    symbol: &'static str,
    unit: &'static str,
    from: u64,
    to: u64,
    decimals: usize,
) -> Datum {
    Datum { symbol, unit, origin: Origin::Drawn(range(from, to, decimals, true)) }
}

/// Returns a random number for formulas of other data.
pub(super) const fn hidden(symbol: &'static str, from: u64, to: u64, decimals: usize) -> Datum {
    Datum { symbol, unit: "", origin: Origin::Hidden(range(from, to, decimals, false)) }
}

/// Returns a random sign for formulas of other data.
pub(super) const fn sign(symbol: &'static str) -> Datum {
    Datum { symbol, unit: "", origin: Origin::Sign }
}

/// Returns a random angle with rational sine and cosine.
pub(super) const fn triple(symbol: &'static str) -> Datum {
    Datum { symbol, unit: "", origin: Origin::Triple }
}

/// Returns a quantity that is computed from others.
pub(super) const fn computed(symbol: &'static str, unit: &'static str, formula: &'static str) -> Datum {
    Datum { symbol, unit, origin: Origin::Formula(formula) }
}

/// Standard gravity with three digits, as textbooks have it.
pub(super) const GRAVITY: Datum = Datum { symbol: "g", unit: "m/s^2", origin: Origin::Fixed("9.81") };
