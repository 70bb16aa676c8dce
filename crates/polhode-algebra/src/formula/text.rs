//! Writer of formulas as Unicode text.
//!
//! Quotients are written a/b, also those of numbers: 2/3 next to 11/12 in one matrix reads better
//! than ⅔ next to 11/12, can be searched for, and is read back by [`crate::parse`]. Matrices, cases
//! and rows take several lines.

use super::block::{Align, Block};
use super::letter::{subscript, superscript};
use super::level::{Place, Quotients};
use super::{Accent, Fence, Formula, Large, Operator, Relation, Style};

impl Formula {
    /// Returns the formula as Unicode text of one or several lines: `−1/4 M b²`.
    pub fn to_text(&self) -> String {
        block(self).into_text()
    }
}

fn block(formula: &Formula) -> Block {
    match formula {
        Formula::Number(text) | Formula::Letter(text, _) | Formula::Text(text) => Block::line(text),
        Formula::Negative(value) => Block::row([Block::line("−"), at(value, Place::Term)]),
        Formula::Sum(terms) => Block::row(terms.iter().enumerate().map(|(k, term)| match term {
            Formula::Negative(value) if k > 0 => Block::row([Block::line(" − "), at(value, Place::Term)]),
            _ if k > 0 => Block::row([Block::line(" + "), at(term, Place::Term)]),
            _ => at(term, Place::FirstTerm),
        })),
        Formula::Product(factors) => product(factors),
        Formula::Operation(operator, operands) => operation(*operator, operands),
        Formula::Fraction(above, below) => {
            Block::row([at(above, Place::Numerator), Block::line("/"), at(below, Place::Denominator)])
        }
        Formula::Power(base, exponent) => power(base, exponent),
        Formula::Subscript(base, index) => {
            Block::row([at(base, Place::Base), Block::line(subscript(&index.to_text()))])
        }
        Formula::Root(value) => match **value {
            Formula::Number(_) | Formula::Letter(..) | Formula::Subscript(..) | Formula::Accent(..) => {
                Block::row([Block::line("√"), block(value)])
            }
            _ => Block::row([Block::line("√"), block(value).fenced(Fence::Parentheses)]),
        },
        Formula::Function(name, argument) => Block::row([block(name), applied(name, argument)]),
        Formula::Differential { is_partial, of } => {
            Block::row([Block::line(if *is_partial { "∂" } else { "d" }), at(of, Place::Denominator)])
        }
        Formula::Accent(accent, base) => accented(*accent, base),
        Formula::Limits { operator, below, above, body } => {
            let sign = match operator {
                Large::Sum => "Σ",
                Large::Integral => "∫",
            };
            let below = below.as_ref().map_or_else(String::new, |f| subscript(&f.to_text()));
            let above = above.as_ref().map_or_else(String::new, |f| superscript(&f.to_text()));
            Block::row([Block::line(format!("{sign}{below}{above} ")), at(body, Place::Operand)])
        }
        Formula::Matrix(fence, rows) => matrix(*fence, rows),
        Formula::Group(fence, inside) => block(inside).fenced(*fence),
        Formula::List(parts) => separated(parts.iter().map(block), ", "),
        Formula::Relation(first, others) => Block::row([
            block(first),
            relations(others, !matches!(**first, Formula::Text(ref t) if t.is_empty())),
        ]),
        Formula::Cases(cases) => {
            let row = |(value, condition): &(Formula, Formula)| {
                vec![block(value), Block::line("if"), block(condition)]
            };
            Block::grid(cases.iter().map(row).collect(), |_| Align::Left, " ").braced()
        }
        Formula::Rows(rows) => {
            let row = |row: &Formula| match row {
                Formula::Relation(first, others) => vec![block(first), relations(others, false)],
                other => vec![Block::line(""), block(other)],
            };
            let align = |k| if k == 0 { Align::Right } else { Align::Left };
            Block::grid(rows.iter().map(row).collect(), align, " ")
        }
    }
}

/// Returns a formula at a place, in parentheses if necessary.
fn at(formula: &Formula, place: Place) -> Block {
    let inside = block(formula);
    if formula.needs_parentheses(place, Quotients::Linear) {
        inside.fenced(Fence::Parentheses)
    } else {
        inside
    }
}

fn separated(blocks: impl Iterator<Item = Block>, separator: &str) -> Block {
    Block::row(blocks.enumerate().flat_map(|(k, block)| {
        let separator = (k > 0).then(|| Block::line(separator));
        separator.into_iter().chain([block])
    }))
}

fn product(factors: &[Formula]) -> Block {
    Block::row(factors.iter().enumerate().flat_map(|(k, factor)| {
        let is_last = k + 1 == factors.len();
        let separator = k.checked_sub(1).map(|k| {
            let is_dotted = factors[k].needs_dot_before(factor, Quotients::Linear);
            Block::line(if is_dotted { " · " } else { " " })
        });
        separator.into_iter().chain([at(factor, if is_last { Place::LastFactor } else { Place::Factor })])
    }))
}

fn operation(operator: Operator, operands: &[Formula]) -> Block {
    let (sign, place) = match operator {
        Operator::Cross => (" × ", Place::Operand),
        Operator::Dot => (" · ", Place::Operand),
        Operator::PlusMinus => (" ± ", Place::Term),
    };
    if let ([only], Operator::PlusMinus) = (operands, operator) {
        return Block::row([Block::line("±"), at(only, place)]);
    }
    let place = |k| if k == 0 && operator == Operator::PlusMinus { Place::FirstTerm } else { place };
    separated(operands.iter().enumerate().map(|(k, operand)| at(operand, place(k))), sign)
}

fn power(base: &Formula, exponent: &Formula) -> Block {
    let raised = superscript(&exponent.to_text());
    match base {
        // sin² θ
        Formula::Function(name, argument) if matches!(**name, Formula::Letter(_, Style::Upright)) => {
            Block::row([block(name), Block::line(raised), applied(name, argument)])
        }
        _ => Block::row([at(base, Place::Base), Block::line(raised)]),
    }
}

/// Returns the argument of a function with the space or the parentheses before it.
fn applied(name: &Formula, argument: &Formula) -> Block {
    if argument.is_bare_argument_of(name) {
        return Block::row([Block::line(" "), block(argument)]);
    }
    let space = if matches!(name, Formula::Fraction(..)) { " " } else { "" };
    Block::row([Block::line(space), block(argument).fenced(Fence::Parentheses)])
}

/// Puts the mark above the first letter: it follows that letter in Unicode.
fn accented(accent: Accent, base: &Formula) -> Block {
    let mark = match accent {
        Accent::Dot => '\u{307}',
        Accent::DoubleDot => '\u{308}',
        Accent::TripleDot => '\u{20db}',
        Accent::Hat => '\u{302}',
        Accent::Bar => '\u{304}',
    };
    let text = base.to_text();
    let letter = text.chars().next().map_or(0, char::len_utf8);
    Block::line(format!("{}{mark}{}", &text[..letter], &text[letter..]))
}

fn matrix(fence: Fence, rows: &[Vec<Formula>]) -> Block {
    let is_numeric = rows.iter().flatten().all(Formula::is_numeric);
    let align = if is_numeric { Align::Right } else { Align::Center };
    let rows = rows.iter().map(|row| row.iter().map(block).collect()).collect();
    let grid = Block::grid(rows, |_| align, "  ");
    Block::row([Block::line(" "), grid, Block::line(" ")]).fenced(fence)
}

/// Returns ` = b = c`, or without the first space.
fn relations(others: &[(Relation, Formula)], is_spaced: bool) -> Block {
    Block::row(others.iter().enumerate().flat_map(|(k, (sign, side))| {
        let space = if k > 0 || is_spaced { " " } else { "" };
        [Block::line(format!("{space}{} ", sign.sign())), block(side)]
    }))
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
