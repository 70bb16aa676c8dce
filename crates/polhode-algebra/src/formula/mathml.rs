//! Writer of formulas as MathML Core.
//!
//! Only elements and attributes of MathML Core are used, and `columnalign`, which a style sheet may
//! select. Bold letters are characters of their own, because the core has no bold variant.

use super::level::{Place, Quotients};
use super::{Accent, Fence, Formula, Large, Operator, Relation, Style, letter};

/// Space after the name of a function.
const THIN_SPACE: &str = "<mspace width=\"0.1667em\"></mspace>";
/// Invisible times sign, as an entity because printed text has no invisible characters.
const TIMES: &str = "<mo>&#x2062;</mo>";

impl Formula {
    /// Returns the formula as a `math` element on a line of its own.
    pub fn to_mathml(&self) -> String {
        format!("<math display=\"block\">{}</math>", element(self))
    }
}

/// Returns one element.
fn element(formula: &Formula) -> String {
    match formula {
        Formula::Number(digits) => format!("<mn>{}</mn>", escaped(digits)),
        Formula::Letter(text, style) => letters(text, *style),
        Formula::Text(text) => format!("<mtext>{}</mtext>", escaped(text).replace(' ', "&#xa0;")),
        Formula::Negative(value) => row(&[operator("−"), at(value, Place::Term)]),
        Formula::Sum(terms) => {
            row(&terms.iter().enumerate().map(|(k, term)| summand(term, k > 0)).collect::<Vec<_>>())
        }
        Formula::Product(factors) => product(factors),
        Formula::Operation(sign, operands) => operation(*sign, operands),
        Formula::Fraction(above, below) => {
            format!("<mfrac>{}{}</mfrac>", element(above), element(below))
        }
        Formula::Power(base, exponent) => power(base, exponent),
        Formula::Subscript(base, index) => {
            format!("<msub>{}{}</msub>", at(base, Place::Base), element(index))
        }
        Formula::Root(value) => format!("<msqrt>{}</msqrt>", element(value)),
        Formula::Function(name, argument) => row(&[element(name), applied(name, argument)]),
        Formula::Differential { is_partial, of } => {
            let sign = if *is_partial { "∂" } else { "d" };
            row(&[format!("<mi>{sign}</mi>"), at(of, Place::Denominator)])
        }
        Formula::Accent(accent, base) => {
            let mark = match accent {
                Accent::Dot => "˙",
                Accent::DoubleDot => "¨",
                Accent::TripleDot => "⃛",
                Accent::Hat => "ˆ",
                Accent::Bar => "¯",
            };
            format!("<mover accent=\"true\">{}<mo stretchy=\"false\">{mark}</mo></mover>", element(base))
        }
        Formula::Limits { operator, below, above, body } => {
            let limits = limits(*operator, below.as_deref(), above.as_deref());
            row(&[limits, at(body, Place::Operand)])
        }
        Formula::Matrix(fence, rows) => {
            let row = |row: &Vec<Formula>| table_row(&row.iter().map(element).collect::<Vec<_>>());
            let rows: String = rows.iter().map(row).collect();
            fenced(*fence, &format!("<mtable>{rows}</mtable>"), true)
        }
        Formula::Group(fence, inside) => fenced(*fence, &element(inside), inside.is_tall()),
        Formula::List(parts) => row(&parts
            .iter()
            .enumerate()
            .flat_map(|(k, part)| (k > 0).then(|| operator(",")).into_iter().chain([element(part)]))
            .collect::<Vec<_>>()),
        Formula::Relation(first, others) => row(&[element(first), relations(others)]),
        Formula::Cases(cases) => {
            let row = |(value, condition): &(Formula, Formula)| {
                table_row(&[element(value), format!("<mtext>if&#xa0;</mtext>{}", element(condition))])
            };
            let rows: String = cases.iter().map(row).collect();
            format!("<mrow><mo>{{</mo><mtable>{rows}</mtable></mrow>")
        }
        Formula::Rows(rows) => {
            let row = |row: &Formula| match row {
                Formula::Relation(first, others) => table_row(&[element(first), relations(others)]),
                other => table_row(&[String::new(), element(other)]),
            };
            let rows: String = rows.iter().map(row).collect();
            format!("<mtable columnalign=\"right left\">{rows}</mtable>")
        }
    }
}

/// Returns a formula at a place, in parentheses if necessary.
fn at(formula: &Formula, place: Place) -> String {
    let inside = element(formula);
    match formula.needs_parentheses(place, Quotients::Stacked) {
        true => fenced(Fence::Parentheses, &inside, formula.is_tall()),
        false => inside,
    }
}

fn row(parts: &[String]) -> String {
    format!("<mrow>{}</mrow>", parts.concat())
}

fn operator(sign: &str) -> String {
    format!("<mo>{}</mo>", escaped(sign))
}

fn table_row(cells: &[String]) -> String {
    let cells: String = cells.iter().map(|cell| format!("<mtd>{cell}</mtd>")).collect();
    format!("<mtr>{cells}</mtr>")
}

fn fenced(fence: Fence, inside: &str, is_tall: bool) -> String {
    let [open, close] = match fence {
        Fence::Parentheses => ["(", ")"],
        Fence::Brackets => ["[", "]"],
        Fence::Braces => ["{", "}"],
        Fence::Bars => ["|", "|"],
    };
    let bracket = |form: &str, sign: &str| format!("<mo form=\"{form}\" stretchy=\"{is_tall}\">{sign}</mo>");
    row(&[bracket("prefix", open), inside.to_owned(), bracket("postfix", close)])
}

fn summand(term: &Formula, has_sign: bool) -> String {
    match term {
        Formula::Negative(value) if has_sign => operator("−") + &at(value, Place::Term),
        _ if has_sign => operator("+") + &at(term, Place::Term),
        _ => at(term, Place::FirstTerm),
    }
}

fn product(factors: &[Formula]) -> String {
    let mut parts = Vec::new();
    for (k, factor) in factors.iter().enumerate() {
        if k > 0 {
            let is_dotted = factors[k - 1].needs_dot_before(factor, Quotients::Stacked);
            let is_spaced = factor.is_function() || factors[k - 1].needs_space_before(factor);
            parts.push(if is_dotted { operator("⋅") } else { TIMES.to_owned() });
            if is_spaced {
                parts.push(THIN_SPACE.to_owned());
            }
        }
        parts.push(at(factor, if k + 1 == factors.len() { Place::LastFactor } else { Place::Factor }));
    }
    row(&parts)
}

fn operation(sign: Operator, operands: &[Formula]) -> String {
    let (sign, place) = match sign {
        Operator::Cross => ("×", Place::Operand),
        Operator::Dot => ("⋅", Place::Operand),
        Operator::PlusMinus => ("±", Place::Term),
    };
    let operand = |(k, operand): (usize, &Formula)| {
        let place = if k == 0 && place == Place::Term { Place::FirstTerm } else { place };
        let sign = (k > 0 || operands.len() == 1).then(|| operator(sign));
        sign.unwrap_or_default() + &at(operand, place)
    };
    row(&operands.iter().enumerate().map(operand).collect::<Vec<_>>())
}

fn power(base: &Formula, exponent: &Formula) -> String {
    let raised = element(exponent);
    match base {
        // sin² θ
        Formula::Function(name, argument) if matches!(**name, Formula::Letter(_, Style::Upright)) => {
            row(&[format!("<msup>{}{raised}</msup>", element(name)), applied(name, argument)])
        }
        Formula::Subscript(base, index) => {
            format!("<msubsup>{}{}{raised}</msubsup>", at(base, Place::Base), element(index))
        }
        _ => format!("<msup>{}{raised}</msup>", at(base, Place::Base)),
    }
}

/// Returns function application and the argument.
fn applied(name: &Formula, argument: &Formula) -> String {
    let inside = element(argument);
    match argument.is_bare_argument_of(name) {
        true => format!("<mo>&#x2061;</mo>{THIN_SPACE}{inside}"),
        false => format!("<mo>&#x2061;</mo>{}", fenced(Fence::Parentheses, &inside, argument.is_tall())),
    }
}

/// Returns Σ with its limits below and above, or ∫ with its limits next to it.
fn limits(sign: Large, below: Option<&Formula>, above: Option<&Formula>) -> String {
    let (sign, [both, only_below, only_above]) = match sign {
        Large::Sum => ("<mo>∑</mo>", ["munderover", "munder", "mover"]),
        Large::Integral => ("<mo>∫</mo>", ["msubsup", "msub", "msup"]),
    };
    let name = match (below, above) {
        (Some(_), Some(_)) => both,
        (Some(_), None) => only_below,
        (None, Some(_)) => only_above,
        (None, None) => return sign.to_owned(),
    };
    let limits: String = [below, above].into_iter().flatten().map(element).collect();
    format!("<{name}>{sign}{limits}</{name}>")
}

fn relations(others: &[(Relation, Formula)]) -> String {
    row(&others.iter().map(|(sign, side)| operator(sign.sign()) + &element(side)).collect::<Vec<_>>())
}

fn letters(text: &str, style: Style) -> String {
    match style {
        Style::Italic if text.chars().count() > 1 => {
            row(&text.chars().map(|c| format!("<mi>{}</mi>", escaped(&c.to_string()))).collect::<Vec<_>>())
        }
        Style::Upright if text.chars().count() == 1 => {
            format!("<mi mathvariant=\"normal\">{}</mi>", escaped(text))
        }
        Style::Italic | Style::Upright => format!("<mi>{}</mi>", escaped(text)),
        Style::Bold => format!("<mi>{}</mi>", escaped(&text.chars().map(letter::bold).collect::<String>())),
    }
}

/// Escapes the special characters of markup.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
