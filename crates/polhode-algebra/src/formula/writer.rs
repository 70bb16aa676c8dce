//! Order and parentheses of formulas, which are the same for all writers.

use super::level::{Place, Quotients};
use super::{Accent, Fence, Formula, Large, Operator, Relation, Style};

/// Form of output, as the pieces that formulas consist of.
pub(super) trait Writer {
    /// Piece of output.
    type Piece;

    /// Form of quotients.
    const QUOTIENTS: Quotients;

    /// Returns a number in digits.
    fn number(digits: &str) -> Self::Piece;
    /// Returns a letter or the name of a function.
    fn letter(text: &str, style: Style) -> Self::Piece;
    /// Returns words or units.
    fn words(text: &str) -> Self::Piece;
    /// Returns the sign −, ±, d or ∂ before its operand.
    fn prefix(sign: &str) -> Self::Piece;
    /// Returns a sign between operands.
    fn infix(sign: &str) -> Self::Piece;
    /// Returns the sign between two factors that have no dot; `is_wide` for x dx, `is_function` for x
    /// sin θ.
    fn juxtaposed(is_wide: bool, is_function: bool) -> Self::Piece;
    /// Returns the space between the name of a function and its argument; `is_bare` if no
    /// parentheses follow, `is_operator` for d/dt.
    fn application(is_bare: bool, is_operator: bool) -> Self::Piece;
    /// Returns the sign of a relation; `is_first` in a cell of its own.
    fn relation(sign: Relation, is_first: bool) -> Self::Piece;
    /// Returns pieces side by side.
    fn row(pieces: Vec<Self::Piece>) -> Self::Piece;
    /// Returns a quotient.
    fn fraction(above: Self::Piece, below: Self::Piece) -> Self::Piece;
    /// Returns a base with an index, an exponent or both.
    fn scripts(base: Self::Piece, index: Option<&Formula>, exponent: Option<&Formula>) -> Self::Piece;
    /// Returns a square root.
    fn root(value: &Formula) -> Self::Piece;
    /// Returns a base with a mark above it.
    fn accent(accent: Accent, base: &Formula) -> Self::Piece;
    /// Returns Σ or ∫ with its limits.
    fn limits(operator: Large, below: Option<&Formula>, above: Option<&Formula>) -> Self::Piece;
    /// Returns a piece in brackets; `is_tall` if they are larger than a line.
    fn fenced(fence: Fence, inside: Self::Piece, is_tall: bool) -> Self::Piece;
    /// Returns cells in rows and columns.
    fn table(table: Table, rows: Vec<Vec<Self::Piece>>) -> Self::Piece;
}

/// Kind of table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Table {
    /// Matrix in brackets.
    Matrix {
        /// Brackets of the matrix.
        fence: Fence,
        /// True if all elements are numbers.
        is_numeric: bool,
    },
    /// Values and their conditions after a brace.
    Cases,
    /// Left sides, and right sides with their signs.
    Rows,
}

/// Writes a formula.
pub(super) fn write<W: Writer>(formula: &Formula) -> W::Piece {
    match formula {
        Formula::Number(digits) => W::number(digits),
        Formula::Letter(text, style) => W::letter(text, *style),
        Formula::Text(text) => W::words(text),
        Formula::Negative(value) => W::row(vec![W::prefix("−"), at::<W>(value, Place::Term)]),
        Formula::Sum(terms) => {
            W::row(terms.iter().enumerate().flat_map(|(k, f)| term::<W>(f, k > 0)).collect())
        }
        Formula::Product(factors) => product::<W>(factors),
        Formula::Operation(operator, operands) => operation::<W>(*operator, operands),
        Formula::Fraction(above, below) => {
            W::fraction(at::<W>(above, Place::Numerator), at::<W>(below, Place::Denominator))
        }
        Formula::Power(base, exponent) => match &**base {
            // sin² θ
            Formula::Function(name, argument) if matches!(**name, Formula::Letter(_, Style::Upright)) => {
                applied::<W>(W::scripts(write::<W>(name), None, Some(exponent)), name, argument)
            }
            Formula::Subscript(base, index) => {
                W::scripts(at::<W>(base, Place::Base), Some(index), Some(exponent))
            }
            _ => W::scripts(at::<W>(base, Place::Base), None, Some(exponent)),
        },
        Formula::Subscript(base, index) => W::scripts(at::<W>(base, Place::Base), Some(index), None),
        Formula::Root(value) => W::root(value),
        Formula::Function(name, argument) => applied::<W>(write::<W>(name), name, argument),
        Formula::Differential { is_partial, of } => {
            W::row(vec![W::prefix(if *is_partial { "∂" } else { "d" }), at::<W>(of, Place::Differential)])
        }
        Formula::Accent(accent, base) => W::accent(*accent, base),
        Formula::Limits { operator, below, above, body } => {
            let limits = W::limits(*operator, below.as_deref(), above.as_deref());
            W::row(vec![limits, at::<W>(body, Place::Operand)])
        }
        Formula::Matrix(fence, rows) => {
            let is_numeric = rows.iter().flatten().all(Formula::is_numeric);
            let rows = rows.iter().map(|row| row.iter().map(write::<W>).collect());
            W::table(Table::Matrix { fence: *fence, is_numeric }, rows.collect())
        }
        Formula::Group(fence, inside) => W::fenced(*fence, write::<W>(inside), inside.is_tall()),
        Formula::List(parts) => separated::<W>(parts.iter().map(write::<W>), ","),
        Formula::Relation(first, others) => {
            let is_alone = matches!(&**first, Formula::Text(text) if text.is_empty());
            W::row(vec![write::<W>(first), relations::<W>(others, is_alone)])
        }
        Formula::Cases(cases) => {
            let row =
                |(value, condition): &(Formula, Formula)| vec![write::<W>(value), write::<W>(condition)];
            W::table(Table::Cases, cases.iter().map(row).collect())
        }
        Formula::Rows(rows) => {
            let row = |row: &Formula| match row {
                Formula::Relation(first, others) => vec![write::<W>(first), relations::<W>(others, true)],
                other => vec![W::row(Vec::new()), write::<W>(other)],
            };
            W::table(Table::Rows, rows.iter().map(row).collect())
        }
    }
}

/// Writes a formula at a place, in parentheses if necessary.
fn at<W: Writer>(formula: &Formula, place: Place) -> W::Piece {
    let inside = write::<W>(formula);
    match formula.needs_parentheses(place, W::QUOTIENTS) {
        true => W::fenced(Fence::Parentheses, inside, formula.is_tall()),
        false => inside,
    }
}

fn term<W: Writer>(term: &Formula, has_sign: bool) -> Vec<W::Piece> {
    match term {
        Formula::Negative(value) if has_sign => vec![W::infix("−"), at::<W>(value, Place::Term)],
        _ if has_sign => vec![W::infix("+"), at::<W>(term, Place::Term)],
        _ => vec![at::<W>(term, Place::FirstTerm)],
    }
}

fn product<W: Writer>(factors: &[Formula]) -> W::Piece {
    let mut pieces = Vec::new();
    for (k, factor) in factors.iter().enumerate() {
        if let Some(last) = k.checked_sub(1).map(|k| &factors[k]) {
            pieces.push(match last.needs_dot_before(factor, W::QUOTIENTS) {
                true => W::infix("·"),
                false => W::juxtaposed(last.needs_space_before(factor), factor.is_function()),
            });
        }
        let is_last = k + 1 == factors.len();
        pieces.push(at::<W>(factor, if is_last { Place::LastFactor } else { Place::Factor }));
    }
    W::row(pieces)
}

fn operation<W: Writer>(operator: Operator, operands: &[Formula]) -> W::Piece {
    let (sign, first, others) = match operator {
        Operator::Cross => ("×", Place::Operand, Place::Operand),
        Operator::Dot => ("·", Place::Operand, Place::Operand),
        Operator::PlusMinus => ("±", Place::FirstTerm, Place::Term),
    };
    if let [only] = operands {
        return W::row(vec![W::prefix(sign), at::<W>(only, others)]);
    }
    let place = |k| if k == 0 { first } else { others };
    separated::<W>(operands.iter().enumerate().map(|(k, operand)| at::<W>(operand, place(k))), sign)
}

fn separated<W: Writer>(pieces: impl Iterator<Item = W::Piece>, sign: &str) -> W::Piece {
    let pieces = pieces.enumerate().flat_map(|(k, piece)| {
        let sign = (k > 0).then(|| W::infix(sign));
        sign.into_iter().chain([piece])
    });
    W::row(pieces.collect())
}

/// Writes the argument of a function after its name.
fn applied<W: Writer>(written: W::Piece, name: &Formula, argument: &Formula) -> W::Piece {
    let (inside, is_bare) = (write::<W>(argument), argument.is_bare_argument_of(name));
    let argument = if is_bare { inside } else { W::fenced(Fence::Parentheses, inside, argument.is_tall()) };
    W::row(vec![written, W::application(is_bare, matches!(name, Formula::Fraction(..))), argument])
}

fn relations<W: Writer>(others: &[(Relation, Formula)], is_first: bool) -> W::Piece {
    let pieces = others.iter().enumerate();
    W::row(
        pieces.flat_map(|(k, (sign, f))| [W::relation(*sign, is_first && k == 0), write::<W>(f)]).collect(),
    )
}

impl Relation {
    /// Returns the sign of the relation.
    pub(super) const fn sign(self) -> &'static str {
        match self {
            Self::Equal => "=",
            Self::Unequal => "≠",
            Self::Defined => "≡",
            Self::Approximate => "≃",
            Self::Less => "<",
            Self::AtMost => "≤",
            Self::Greater => ">",
            Self::AtLeast => "≥",
            Self::To => "→",
            Self::Implies => "⇒",
        }
    }
}
