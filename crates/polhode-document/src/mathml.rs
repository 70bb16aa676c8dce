//! Formulas as MathML Core, which browsers render natively.
//!
//! The crate pulldown-latex converts LaTeX to MathML; a formula that it cannot parse is shown as
//! text. Only attributes of MathML are used, no classes and styles, because the viewer's content
//! policy permits nothing else.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

/// CSS rule of formulas; it contains the file name of the font.
const FONT_RULE: &str = include_str!("../assets/math.css");

const FONT_FILE: &str = "./stix-two-math.woff2";

/// Font; none in a browser, where the interactive page has it.
const FONT: &[u8] =
    if cfg!(target_arch = "wasm32") { &[] } else { include_bytes!("../assets/stix-two-math.woff2") };

/// Replacements for output of pulldown-latex 0.8.0 that is not valid MathML Core or XML, is not in
/// the font, or uses a class. `mover` always holds an accent: limits are below, or below and above.
const CORRECTIONS: [(&str, &str); 9] = [
    (r#"<msup><mspace width="0.1667em" />"#, r#"<mspace width="0.1667em" /><msup>"#),
    ("<mover>", r#"<mover accent="true">"#),
    // The circumflex of ASCII is as large as a letter.
    ("<mi>^</mi></mover>", "<mi>ˆ</mi></mover>"),
    ("<mo><</mo>", "<mo>&lt;</mo>"),
    ("‾", "¯"),
    ("&nbsp;", "&#xa0;"),
    // Function application, U+2061, is invisible; printed text has no invisible characters.
    ("\u{2061}", "&#x2061;"),
    (r#" class="menv-alignlike menv-align""#, r#" columnalign="right left""#),
    (r#" class="menv-arraylike""#, ""),
];

/// Returns the CSS of formulas with the font embedded.
pub fn style() -> String {
    let font = format!("data:font/woff2;base64,{}", BASE64_STANDARD.encode(FONT));
    FONT_RULE.replace(FONT_FILE, &font)
}

/// Returns a formula on a line of its own; `text` is the fallback if the LaTeX cannot be parsed.
pub fn formula(latex: &str, text: &str) -> String {
    from_latex(latex).unwrap_or_else(|| display(&element("mtext", text)))
}

/// Returns the MathML of a formula; `None` if it cannot be parsed. Vectors are upright and bold,
/// Greek ones too.
fn from_latex(latex: &str) -> Option<String> {
    let latex = latex.replace(r"\boldsymbol", r"\mathbf");
    let storage = Storage::new();
    let config = RenderConfig { display_mode: DisplayMode::Block, ..RenderConfig::default() };
    let mut out = String::new();
    push_mathml(&mut out, Parser::new(&latex, &storage), config).ok()?;
    let is_read = !out.contains("<merror");
    is_read.then(|| CORRECTIONS.iter().fold(out, |out, (wrong, right)| out.replace(wrong, right)))
}

/// Returns a formula of the form `name = matrix unit`.
pub fn matrix(name: &str, rows: &[Vec<String>], unit: &str) -> String {
    let cells = |row: &Vec<String>| row.iter().map(|x| cell(&number(x))).collect::<String>();
    let rows: String = rows.iter().map(|row| format!("<mtr>{}</mtr>", cells(row))).collect();
    let unit =
        if unit.is_empty() { String::new() } else { format!("{}{}", space(0.5), element("mtext", unit)) };
    let name = match name {
        "{I}" => "<mo stretchy=\"false\">{</mo><mi>𝐈</mi><mo stretchy=\"false\">}</mo>".to_owned(),
        other => element("mtext", other),
    };
    display(&format!("{name}<mo>=</mo><mrow><mo>(</mo><mtable>{rows}</mtable><mo>)</mo></mrow>{unit}"))
}

fn display(inside: &str) -> String {
    format!("<math display=\"block\"><mrow>{inside}</mrow></math>")
}

/// Returns `<name>text</name>` with the text escaped.
fn element(name: &str, text: &str) -> String {
    format!("<{name}>{}</{name}>", escaped(text))
}

fn space(em: f64) -> String {
    format!("<mspace width=\"{em}em\"></mspace>")
}

fn cell(inside: &str) -> String {
    format!("<mtd>{inside}</mtd>")
}

/// Returns a number such as `-3.3e-5` as −3.3×10⁻⁵.
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

/// Escapes the special characters of markup.
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
    fn corrected_markup() {
        let space = "<mspace width=\"0.1667em\" />";
        for (latex, wanted) in [
            (r"a \sin^2 x", &*format!("<mi>a</mi>{space}<msup><mi>sin</mi><mn>2</mn></msup>")),
            (r"\dot x + \bar z", "<mover accent=\"true\"><mi>x</mi><mi>˙</mi></mover>"),
            (r"\dot x + \bar z", "<mover accent=\"true\"><mi>z</mi><mi>¯</mi></mover>"),
            (r"\hat{x}", "<mover accent=\"true\"><mrow><mi>x</mi></mrow><mi>ˆ</mi></mover>"),
            ("x < y", "<mo>&lt;</mo>"),
            (r"x \text{ or } y", "<mtext>&#xa0;or&#xa0;</mtext>"),
            (r"\boldsymbol\omega \times \mathbf r", "<mi>𝛚</mi>"),
            (r"\begin{aligned} a &= b \cr c &= d \end{aligned}", "<mtable columnalign=\"right left\"><mtr>"),
            (r"\begin{vmatrix} a & b \end{vmatrix}", "<mtable><mtr>"),
        ] {
            let markup = from_latex(latex).unwrap();
            assert!(markup.contains(wanted), "{latex}: {markup}");
        }
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
