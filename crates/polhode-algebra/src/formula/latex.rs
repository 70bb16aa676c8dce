//! Writer of formulas as LaTeX with amsmath.
//!
//! Rows end with `\cr` and not with `\\`, which Markdown would read as one backslash.

use super::level::Quotients;
use super::writer::{Table, Writer, write};
use super::{Accent, Fence, Formula, Large, Relation, Style, letter};

/// Names of functions that have commands.
const FUNCTIONS: [&str; 10] = ["arctan", "cos", "det", "exp", "lim", "ln", "max", "min", "sin", "tan"];

struct Latex;

impl Formula {
    /// Returns the formula as LaTeX for a place in mathematics mode: `-\frac{1}{4} M b^2`.
    pub fn to_latex(&self) -> String {
        write::<Latex>(self).trim().to_owned()
    }
}

impl Writer for Latex {
    type Piece = String;

    const QUOTIENTS: Quotients = Quotients::Stacked;

    fn number(digits: &str) -> String {
        digits.to_owned()
    }

    fn letter(text: &str, style: Style) -> String {
        let commands: String = text.chars().map(command).collect();
        let commands = commands.trim_end();
        let is_greek = text.chars().any(|c| letter::name(c).is_some());
        match style {
            Style::Italic => commands.to_owned(),
            Style::Upright if FUNCTIONS.contains(&text) => format!(r"\{text}"),
            Style::Upright => format!(r"\mathrm{{{commands}}}"),
            Style::Bold if is_greek => format!(r"\boldsymbol{{{commands}}}"),
            Style::Bold => format!(r"\mathbf{{{commands}}}"),
        }
    }

    fn words(text: &str) -> String {
        if text.is_empty() { String::new() } else { format!(r"\text{{{}}}", escaped(text)) }
    }

    fn prefix(sign: &str) -> String {
        match sign {
            "∂" => r"\partial ".to_owned(),
            "±" => r"\pm ".to_owned(),
            "−" => "-".to_owned(),
            sign => sign.to_owned(),
        }
    }

    fn infix(sign: &str) -> String {
        let command = match sign {
            "," => return ", ".to_owned(),
            "−" => "-",
            "·" => r"\cdot",
            "×" => r"\times",
            "±" => r"\pm",
            sign => sign,
        };
        format!(" {command} ")
    }

    fn juxtaposed(is_wide: bool, _: bool) -> String {
        if is_wide { r" \, " } else { " " }.to_owned()
    }

    fn application(is_bare: bool, is_operator: bool) -> String {
        if is_bare || is_operator { " " } else { "" }.to_owned()
    }

    fn relation(sign: Relation, is_first: bool) -> String {
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
        format!("{}{command} ", if is_first { "" } else { " " })
    }

    fn row(pieces: Vec<String>) -> String {
        pieces.concat()
    }

    fn fraction(above: String, below: String) -> String {
        format!(r"\frac{{{above}}}{{{below}}}")
    }

    fn scripts(base: String, index: Option<&Formula>, exponent: Option<&Formula>) -> String {
        let script = |mark: char, formula: &Formula| match formula {
            Formula::Letter(text, Style::Italic) | Formula::Number(text) if text.chars().count() == 1 => {
                format!("{mark}{}", formula.to_latex())
            }
            _ => format!("{mark}{{{}}}", formula.to_latex()),
        };
        let index = index.map_or_else(String::new, |index| script('_', index));
        base + &index + &exponent.map_or_else(String::new, |exponent| script('^', exponent))
    }

    fn root(value: &Formula) -> String {
        format!(r"\sqrt{{{}}}", value.to_latex())
    }

    fn accent(accent: Accent, base: &Formula) -> String {
        let command = match accent {
            Accent::Dot => "dot",
            Accent::DoubleDot => "ddot",
            Accent::TripleDot => "dddot",
            Accent::Hat => "hat",
            Accent::Bar => "bar",
        };
        format!(r"\{command}{{{}}}", base.to_latex())
    }

    fn limits(operator: Large, below: Option<&Formula>, above: Option<&Formula>) -> String {
        let sign = match operator {
            Large::Sum => r"\sum",
            Large::Integral => r"\int",
        };
        Self::scripts(sign.to_owned(), below, above) + " "
    }

    fn fenced(fence: Fence, inside: String, is_tall: bool) -> String {
        let [open, close] = match fence {
            Fence::Parentheses => ["(", ")"],
            Fence::Brackets => ["[", "]"],
            Fence::Braces => [r"\lbrace", r"\rbrace"],
            Fence::Bars => [r"\lvert", r"\rvert"],
        };
        match (is_tall, fence) {
            (true, _) => format!(r"\left{open} {inside} \right{close}"),
            (false, Fence::Parentheses | Fence::Brackets) => format!("{open}{inside}{close}"),
            (false, _) => format!("{open} {inside} {close}"),
        }
    }

    fn table(table: Table, rows: Vec<Vec<String>>) -> String {
        let (environment, separator) = match table {
            Table::Matrix { fence: Fence::Parentheses, .. } => ("pmatrix", " & "),
            Table::Matrix { fence: Fence::Brackets, .. } => ("bmatrix", " & "),
            Table::Matrix { fence: Fence::Braces, .. } => ("Bmatrix", " & "),
            Table::Matrix { fence: Fence::Bars, .. } => ("vmatrix", " & "),
            Table::Cases => ("cases", r" & \text{if } "),
            Table::Rows => ("aligned", " &"),
        };
        let rows: Vec<String> = rows.iter().map(|row| row.join(separator).trim_start().to_owned()).collect();
        format!("\\begin{{{environment}}}\n{}\n\\end{{{environment}}}", rows.join(" \\cr\n"))
    }
}

/// Returns a letter, or its command with a space after it.
fn command(c: char) -> String {
    match c {
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
