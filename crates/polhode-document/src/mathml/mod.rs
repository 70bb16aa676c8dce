//! Formulas as MathML Core, which browsers set without help.
//!
//! A formula comes from its LaTeX; one with something unknown in it is shown as text. Only attributes
//! of MathML are used, no styles: the viewer lets nothing else into the page.

mod latex;

use base64::prelude::{BASE64_STANDARD, Engine as _};

/// The rule of formulas in a style sheet, with the name of the font's file.
const FONT_RULE: &str = include_str!("../../assets/math.css");

const FONT_FILE: &str = "./stix-two-math.woff2";

const FONT: &[u8] = include_bytes!("../../assets/stix-two-math.woff2");

/// The style of formulas, the font in it.
pub fn style() -> String {
    let font = format!("data:font/woff2;base64,{}", BASE64_STANDARD.encode(FONT));
    FONT_RULE.replace(FONT_FILE, &font)
}

/// A formula in symbols, on a line of its own; `text` is shown if the LaTeX has something unknown.
pub fn formula(latex: &str, text: &str) -> String {
    display(&latex::to_mathml(latex).unwrap_or_else(|| element("mtext", text)))
}

/// `name = matrix unit`
pub fn matrix(name: &str, rows: &[Vec<String>], unit: &str) -> String {
    let cells = |row: &Vec<String>| row.iter().map(|x| cell(&number(x))).collect::<String>();
    let rows: String = rows.iter().map(|row| format!("<mtr>{}</mtr>", cells(row))).collect();
    let unit =
        if unit.is_empty() { String::new() } else { format!("{}{}", space(0.5), element("mtext", unit)) };
    let name = match name {
        "{I}" => latex::to_mathml(r"\lbrace \mathbf I \rbrace").unwrap_or_default(),
        other => element("mtext", other),
    };
    display(&format!("{name}<mo>=</mo><mrow><mo>(</mo><mtable>{rows}</mtable><mo>)</mo></mrow>{unit}"))
}

fn display(inside: &str) -> String {
    format!("<math display=\"block\"><mrow>{inside}</mrow></math>")
}

/// The bold letter of a Latin or Greek one, as a character (Unicode, Mathematical Alphanumeric Symbols).
fn bold(letter: char) -> Option<char> {
    let (first, place) = match letter {
        'A'..='Z' => ('A', 0x1D400),
        'a'..='z' => ('a', 0x1D41A),
        'Α'..='Ω' => ('Α', 0x1D6A8),
        'α'..='ω' => ('α', 0x1D6C2),
        _ => return None,
    };
    char::from_u32(place + u32::from(letter) - u32::from(first))
}

/// `<name>text</name>`, the text inert.
fn element(name: &str, text: &str) -> String {
    format!("<{name}>{}</{name}>", escaped(text))
}

fn space(em: f64) -> String {
    format!("<mspace width=\"{em}em\"></mspace>")
}

fn cell(inside: &str) -> String {
    format!("<mtd>{inside}</mtd>")
}

/// `-3.3e-5` as −3.3×10⁻⁵.
fn number(text: &str) -> String {
    let signed = |text: &str| text.replace('-', "−");
    match text.split_once('e') {
        Some((mantissa, power)) => format!(
            "<mrow>{}<mo>×</mo><msup><mn>10</mn>{}</msup></mrow>",
            element("mn", &signed(mantissa)),
            element("mn", &signed(power))
        ),
        None => element("mn", &signed(text)),
    }
}

/// Text that markup cannot hide in.
pub fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_read_is_text() {
        let shown = formula(r"\unheard{x}", "x < y & z");
        assert_eq!(shown, "<math display=\"block\"><mrow><mtext>x &lt; y &amp; z</mtext></mrow></math>");
    }

    #[test]
    fn bold_letters_are_characters() {
        for (letter, wanted) in [('I', '𝐈'), ('r', '𝐫'), ('ω', '𝛚'), ('Ω', '𝛀'), ('Σ', '𝚺')]
        {
            assert_eq!(bold(letter), Some(wanted));
        }
        assert_eq!(bold('1'), None);
    }

    #[test]
    fn the_style_holds_the_font() {
        let style = style();
        assert!(style.contains("url(\"data:font/woff2;base64,d09GMg") && !style.contains(FONT_FILE));
    }

    #[test]
    fn a_matrix_is_a_table() {
        let rows = vec![vec!["1".to_owned(), "-2e-7".to_owned()]];
        let shown = matrix("{I}", &rows, "kg·m²");
        assert!(shown.contains(
            "<mtr><mtd><mn>1</mn></mtd><mtd><mrow><mn>−2</mn><mo>×</mo><msup><mn>10</mn><mn>−7</mn></msup></mrow></mtd></mtr>"
        ));
        assert!(shown.contains("<mtext>kg·m²</mtext>"), "{shown}");
    }
}
