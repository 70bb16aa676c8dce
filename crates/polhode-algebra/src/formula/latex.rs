//! Writer of formulas as LaTeX with amsmath.
//!
//! Rows end with `\cr` and not with `\\`, which Markdown would read as one backslash.

use super::level::{Place, Quotients};
use super::{Accent, Fence, Formula, Large, Operator, Relation, Style, letter};

impl Formula {
    /// Returns the formula as LaTeX for a place in mathematics mode: `-\frac{1}{4} M b^2`.
    pub fn to_latex(&self) -> String {
        match self {
            Self::Number(digits) => digits.clone(),
            Self::Letter(text, style) => styled(text, *style),
            Self::Text(text) if text.is_empty() => String::new(),
            Self::Text(text) => format!(r"\text{{{}}}", escaped(text)),
            Self::Negative(value) => format!("-{}", at(value, Place::Term)),
            Self::Sum(terms) => terms.iter().enumerate().map(|(k, term)| summand(term, k > 0)).collect(),
            Self::Product(factors) => product(factors),
            Self::Operation(operator, operands) => operation(*operator, operands),
            Self::Fraction(above, below) => format!(r"\frac{{{}}}{{{}}}", above.to_latex(), below.to_latex()),
            Self::Power(base, exponent) => power(base, exponent),
            Self::Subscript(base, index) => format!("{}_{}", at(base, Place::Base), script(index)),
            Self::Root(value) => format!(r"\sqrt{{{}}}", value.to_latex()),
            Self::Function(name, argument) => applied(&name.to_latex(), name, argument),
            Self::Differential { is_partial, of } => {
                format!("{}{}", if *is_partial { r"\partial " } else { "d" }, at(of, Place::Denominator))
            }
            Self::Accent(accent, base) => {
                let command = match accent {
                    Accent::Dot => r"\dot",
                    Accent::DoubleDot => r"\ddot",
                    Accent::TripleDot => r"\dddot",
                    Accent::Hat => r"\hat",
                    Accent::Bar => r"\bar",
                };
                format!("{command}{{{}}}", base.to_latex())
            }
            Self::Limits { operator, below, above, body } => {
                let sign = match operator {
                    Large::Sum => r"\sum",
                    Large::Integral => r"\int",
                };
                let below = below.as_ref().map_or_else(String::new, |f| format!("_{}", script(f)));
                let above = above.as_ref().map_or_else(String::new, |f| format!("^{}", script(f)));
                format!("{sign}{below}{above} {}", at(body, Place::Operand))
            }
            Self::Matrix(fence, rows) => {
                let environment = match fence {
                    Fence::Parentheses => "pmatrix",
                    Fence::Brackets => "bmatrix",
                    Fence::Braces => "Bmatrix",
                    Fence::Bars => "vmatrix",
                };
                let row = |row: &Vec<Self>| row.iter().map(Self::to_latex).collect::<Vec<_>>().join(" & ");
                surrounded(environment, rows.iter().map(row))
            }
            Self::Group(fence, inside) => fenced(*fence, inside),
            Self::List(parts) => parts.iter().map(Self::to_latex).collect::<Vec<_>>().join(", "),
            Self::Relation(first, others) => {
                format!("{} {}", first.to_latex(), relations(others)).trim_start().to_owned()
            }
            Self::Cases(cases) => {
                let row = |(value, condition): &(Self, Self)| {
                    format!(r"{} & \text{{if }} {}", value.to_latex(), condition.to_latex())
                };
                surrounded("cases", cases.iter().map(row))
            }
            Self::Rows(rows) => {
                let row = |row: &Self| match row {
                    Self::Relation(first, others) => {
                        format!("{} &{}", first.to_latex(), relations(others)).trim_start().to_owned()
                    }
                    other => format!("&{}", other.to_latex()),
                };
                surrounded("aligned", rows.iter().map(row))
            }
        }
    }
}

/// Returns a formula at a place, in parentheses if necessary.
fn at(formula: &Formula, place: Place) -> String {
    match formula.needs_parentheses(place, Quotients::Stacked) {
        true => fenced(Fence::Parentheses, formula),
        false => formula.to_latex(),
    }
}

fn fenced(fence: Fence, inside: &Formula) -> String {
    let [open, close] = match fence {
        Fence::Parentheses => ["(", ")"],
        Fence::Brackets => ["[", "]"],
        Fence::Braces => [r"\lbrace", r"\rbrace"],
        Fence::Bars => [r"\lvert", r"\rvert"],
    };
    match (inside.is_tall(), fence) {
        (true, _) => format!(r"\left{open} {} \right{close}", inside.to_latex()),
        (false, Fence::Parentheses | Fence::Brackets) => format!("{open}{}{close}", inside.to_latex()),
        (false, _) => format!("{open} {} {close}", inside.to_latex()),
    }
}

fn surrounded(environment: &str, rows: impl Iterator<Item = String>) -> String {
    let rows: Vec<String> = rows.collect();
    format!("\\begin{{{environment}}}\n{}\n\\end{{{environment}}}", rows.join(" \\cr\n"))
}

fn summand(term: &Formula, has_sign: bool) -> String {
    match term {
        Formula::Negative(value) if has_sign => format!(" - {}", at(value, Place::Term)),
        _ if has_sign => format!(" + {}", at(term, Place::Term)),
        _ => at(term, Place::FirstTerm),
    }
}

fn product(factors: &[Formula]) -> String {
    let mut out = String::new();
    for (k, factor) in factors.iter().enumerate() {
        if k > 0 {
            let is_dotted = factors[k - 1].needs_dot_before(factor, Quotients::Stacked);
            let is_spaced = factors[k - 1].needs_space_before(factor);
            out.push_str(if is_dotted {
                r" \cdot "
            } else if is_spaced {
                r" \, "
            } else {
                " "
            });
        }
        out.push_str(&at(factor, if k + 1 == factors.len() { Place::LastFactor } else { Place::Factor }));
    }
    out
}

fn operation(operator: Operator, operands: &[Formula]) -> String {
    let (sign, place) = match operator {
        Operator::Cross => (r" \times ", Place::Operand),
        Operator::Dot => (r" \cdot ", Place::Operand),
        Operator::PlusMinus => (r" \pm ", Place::Term),
    };
    let place = |k| if k == 0 && operator == Operator::PlusMinus { Place::FirstTerm } else { place };
    let operands: Vec<String> = operands.iter().enumerate().map(|(k, f)| at(f, place(k))).collect();
    match &operands[..] {
        [only] if operator == Operator::PlusMinus => format!(r"\pm {only}"),
        operands => operands.join(sign),
    }
}

fn power(base: &Formula, exponent: &Formula) -> String {
    match base {
        // sin² θ
        Formula::Function(name, argument) if matches!(**name, Formula::Letter(_, Style::Upright)) => {
            applied(&format!("{}^{}", name.to_latex(), script(exponent)), name, argument)
        }
        _ => format!("{}^{}", at(base, Place::Base), script(exponent)),
    }
}

fn applied(written: &str, name: &Formula, argument: &Formula) -> String {
    if argument.is_bare_argument_of(name) {
        return format!("{written} {}", argument.to_latex());
    }
    let space = if matches!(name, Formula::Fraction(..)) { " " } else { "" };
    format!("{written}{space}{}", fenced(Fence::Parentheses, argument))
}

/// Returns an index or exponent, in braces if it is more than a letter or a digit.
fn script(formula: &Formula) -> String {
    let latex = formula.to_latex();
    match formula {
        Formula::Letter(text, Style::Italic) | Formula::Number(text) if text.chars().count() == 1 => latex,
        _ => format!("{{{latex}}}"),
    }
}

fn relations(others: &[(Relation, Formula)]) -> String {
    let relation = |(sign, side): &(Relation, Formula)| {
        let command = match sign {
            Relation::Equal | Relation::Less | Relation::Greater => sign.sign(),
            Relation::Unequal => r"\neq",
            Relation::Defined => r"\equiv",
            Relation::Approximate => r"\simeq",
            Relation::AtMost => r"\le",
            Relation::AtLeast => r"\ge",
            Relation::To => r"\to",
            Relation::Implies => r"\Rightarrow",
        };
        format!("{command} {}", side.to_latex())
    };
    others.iter().map(relation).collect::<Vec<_>>().join(" ")
}

fn styled(text: &str, style: Style) -> String {
    let commands: String = text.chars().map(command).collect();
    let commands = commands.trim_end();
    let is_greek = text.chars().any(|c| letter::name(c).is_some());
    match style {
        Style::Italic => commands.to_owned(),
        Style::Upright
            if matches!(
                text,
                "sin" | "cos" | "tan" | "exp" | "ln" | "max" | "min" | "det" | "arctan" | "lim"
            ) =>
        {
            format!(r"\{text}")
        }
        Style::Upright => format!(r"\mathrm{{{commands}}}"),
        Style::Bold if is_greek => format!(r"\boldsymbol{{{commands}}}"),
        Style::Bold => format!(r"\mathbf{{{commands}}}"),
    }
}

/// Returns a letter, or its command with a space after it.
fn command(c: char) -> String {
    match c {
        'φ' => r"\phi ".to_owned(),
        '∞' => r"\infty ".to_owned(),
        '_' => r"\_".to_owned(),
        _ => letter::name(c).map_or_else(|| c.to_string(), |name| format!(r"\{name} ")),
    }
}

/// Returns words for `\text`.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '\\' => out.push_str(r"\backslash"),
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => out.extend(['\\', c]),
            '^' | '~' => out.extend(['\\', c, '{', '}']),
            c => out.push(c),
        }
    }
    out
}
