//! Writer of formulas as MathML Core.
//!
//! Only elements and attributes of MathML Core are used, and `columnalign`, which a style sheet may
//! select. Bold letters are characters of their own, because the core has no bold variant.

use super::level::Quotients;
use super::writer::{Table, Writer, write};
use super::{Accent, Fence, Formula, Large, Relation, Style, letter};

/// Space before and after the names of functions.
const THIN_SPACE: &str = "<mspace width=\"0.1667em\"></mspace>";
/// Invisible signs, as entities because printed text has no invisible characters.
const TIMES: &str = "<mo>&#x2062;</mo>";
const APPLICATION: &str = "<mo>&#x2061;</mo>";

struct MathMl;

impl Formula {
    /// Returns the formula as a `math` element on a line of its own.
    pub fn to_mathml(&self) -> String {
        format!("<math display=\"block\">{}</math>", element(self))
    }
}

/// Returns one element.
fn element(formula: &Formula) -> String {
    write::<MathMl>(formula)
}

impl Writer for MathMl {
    type Piece = String;

    const QUOTIENTS: Quotients = Quotients::Stacked;

    fn number(digits: &str) -> String {
        format!("<mn>{}</mn>", escaped(digits))
    }

    fn letter(text: &str, style: Style) -> String {
        let is_single = text.chars().count() == 1;
        match style {
            // A word in italics is a product of letters; a single letter is italic by itself.
            Style::Italic if !is_single => {
                Self::row(text.chars().map(|c| format!("<mi>{}</mi>", escaped(&c.to_string()))).collect())
            }
            Style::Upright if is_single => format!("<mi mathvariant=\"normal\">{}</mi>", escaped(text)),
            Style::Italic | Style::Upright => format!("<mi>{}</mi>", escaped(text)),
            Style::Bold => {
                format!("<mi>{}</mi>", escaped(&text.chars().map(letter::bold).collect::<String>()))
            }
        }
    }

    fn words(text: &str) -> String {
        format!("<mtext>{}</mtext>", escaped(text).replace(' ', "&#xa0;"))
    }

    fn prefix(sign: &str) -> String {
        if matches!(sign, "d" | "∂") { format!("<mi>{sign}</mi>") } else { Self::infix(sign) }
    }

    fn infix(sign: &str) -> String {
        format!("<mo>{}</mo>", escaped(sign).replace('·', "⋅"))
    }

    fn juxtaposed(is_wide: bool, is_function: bool) -> String {
        format!("{TIMES}{}", if is_wide || is_function { THIN_SPACE } else { "" })
    }

    fn application(is_bare: bool, _: bool) -> String {
        format!("{APPLICATION}{}", if is_bare { THIN_SPACE } else { "" })
    }

    fn relation(sign: Relation, _: bool) -> String {
        Self::infix(sign.sign())
    }

    fn row(pieces: Vec<String>) -> String {
        format!("<mrow>{}</mrow>", pieces.concat())
    }

    fn fraction(above: String, below: String) -> String {
        format!("<mfrac>{above}{below}</mfrac>")
    }

    fn scripts(base: String, index: Option<&Formula>, exponent: Option<&Formula>) -> String {
        scripted(["msub", "msup", "msubsup"], &base, index, exponent)
    }

    fn root(value: &Formula) -> String {
        format!("<msqrt>{}</msqrt>", element(value))
    }

    fn accent(accent: Accent, base: &Formula) -> String {
        let mark = match accent {
            Accent::Dot => "˙",
            Accent::DoubleDot => "¨",
            Accent::TripleDot => "⃛",
            Accent::Hat => "ˆ",
            Accent::Bar => "¯",
        };
        format!("<mover accent=\"true\">{}<mo stretchy=\"false\">{mark}</mo></mover>", element(base))
    }

    fn limits(operator: Large, below: Option<&Formula>, above: Option<&Formula>) -> String {
        match operator {
            Large::Sum => scripted(["munder", "mover", "munderover"], "<mo>∑</mo>", below, above),
            Large::Integral => scripted(["msub", "msup", "msubsup"], "<mo>∫</mo>", below, above),
        }
    }

    fn fenced(fence: Fence, inside: String, is_tall: bool) -> String {
        let [open, close] = match fence {
            Fence::Parentheses => ["(", ")"],
            Fence::Brackets => ["[", "]"],
            Fence::Braces => ["{", "}"],
            Fence::Bars => ["|", "|"],
        };
        let bracket = |form, sign| format!("<mo form=\"{form}\" stretchy=\"{is_tall}\">{sign}</mo>");
        Self::row(vec![bracket("prefix", open), inside, bracket("postfix", close)])
    }

    fn table(table: Table, mut rows: Vec<Vec<String>>) -> String {
        if table == Table::Cases {
            rows.iter_mut().for_each(|row| row[1].insert_str(0, "<mtext>if&#xa0;</mtext>"));
        }
        let cell = |cell: &String| format!("<mtd>{cell}</mtd>");
        let row = |row: &Vec<String>| format!("<mtr>{}</mtr>", row.iter().map(cell).collect::<String>());
        let rows: String = rows.iter().map(row).collect();
        match table {
            Table::Matrix { fence, .. } => Self::fenced(fence, format!("<mtable>{rows}</mtable>"), true),
            Table::Cases => Self::row(vec!["<mo>{</mo>".to_owned(), format!("<mtable>{rows}</mtable>")]),
            Table::Rows => format!("<mtable columnalign=\"right left\">{rows}</mtable>"),
        }
    }
}

/// Returns a base with scripts; `names` are those of the elements with the first, the second and both.
fn scripted(names: [&str; 3], base: &str, first: Option<&Formula>, second: Option<&Formula>) -> String {
    let name = match (first, second) {
        (Some(_), None) => names[0],
        (None, Some(_)) => names[1],
        (Some(_), Some(_)) => names[2],
        (None, None) => return base.to_owned(),
    };
    let scripts: String = [first, second].into_iter().flatten().map(element).collect();
    format!("<{name}>{base}{scripts}</{name}>")
}

/// Escapes the special characters of markup.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
