//! The LaTeX of the worked solutions as MathML: letters, scripts, fractions, roots, accents, sums, matrices.
//!
//! A reader of this house's own formulas, not of LaTeX: what it does not know makes the whole formula unreadable.

use super::{cell, element, space};

/// The elements of a formula; `None` if something in it is unknown.
pub(super) fn to_mathml(latex: &str) -> Option<String> {
    let mut reader = Reader { rest: latex };
    let row = reader.row()?;
    reader.rest.is_empty().then_some(row)
}

/// What is left to read.
struct Reader<'a> {
    rest: &'a str,
}

/// How scripts stand at an element.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Scripts {
    Beside,
    /// Below and above a sum.
    Under,
    /// Beside the name of a function, which then is applied.
    Applied,
}

/// em
const THIN: f64 = 0.17;

const SYMBOLS: [(&str, &str); 18] = [
    ("alpha", "α"),
    ("delta", "δ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("lambda", "λ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("varphi", "φ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Omega", "Ω"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("tau", "τ"),
    ("mu", "µ"),
    ("kappa", "κ"),
    ("varpi", "ϖ"),
];

const OPERATORS: [(&str, &str); 11] = [
    ("times", "×"),
    ("cdot", "·"),
    ("Rightarrow", "⇒"),
    ("simeq", "≃"),
    ("angle", "∠"),
    ("lbrace", "{"),
    ("rbrace", "}"),
    ("approx", "≈"),
    ("partial", "∂"),
    ("le", "≤"),
    ("ne", "≠"),
];

const FUNCTIONS: [&str; 7] = ["sin", "cos", "tan", "tanh", "ln", "max", "det"];

impl<'a> Reader<'a> {
    /// Elements up to the end of a group, of a cell or of the formula.
    fn row(&mut self) -> Option<String> {
        let mut row = String::new();
        loop {
            self.skip_space();
            let ends = ["}", "&", r"\cr", r"\end"];
            if self.rest.is_empty() || ends.iter().any(|end| self.rest.starts_with(end)) {
                return Some(row);
            }
            let (base, scripts) = self.atom()?;
            // As in TeX there is a thin space before the name of a function, too, but not after an operator or at the beginning.
            if scripts == Scripts::Applied && !row.is_empty() && !row.ends_with("</mo>") {
                row.push_str(&space(THIN));
            }
            row.push_str(&self.scripted(base, scripts)?);
        }
    }

    /// The element with the scripts that follow it.
    fn scripted(&mut self, base: String, scripts: Scripts) -> Option<String> {
        let (mut below, mut above) = (None, None);
        loop {
            self.skip_space();
            if self.skip("_") {
                below = Some(self.argument()?);
            } else if self.skip("^") {
                above = Some(self.argument()?);
            } else {
                break;
            }
        }
        let tag = |beside: &str, under: &str| match scripts {
            Scripts::Under => under.to_owned(),
            _ => beside.to_owned(),
        };
        let (name, inside) = match (below, above) {
            (None, None) => (String::new(), base),
            (Some(b), None) => (tag("msub", "munder"), format!("{base}{b}")),
            (None, Some(a)) => (tag("msup", "mover"), format!("{base}{a}")),
            (Some(b), Some(a)) => (tag("msubsup", "munderover"), format!("{base}{b}{a}")),
        };
        let whole = if name.is_empty() { inside } else { format!("<{name}>{inside}</{name}>") };
        if scripts != Scripts::Applied {
            return Some(whole);
        }
        // U+2061 applies the function, as an entity: terminals are not shown characters that have no width. A thin space is between sin and θ, none before a bracket.
        self.skip_space();
        let is_bracketed = self.rest.starts_with(['(', '[', '}', '&']) || self.rest.is_empty();
        let gap = if is_bracketed { String::new() } else { space(THIN) };
        Some(format!("{whole}<mo>&#x2061;</mo>{gap}"))
    }

    /// A group, or one element, as one element.
    fn argument(&mut self) -> Option<String> {
        self.skip_space();
        if self.skip("{") {
            let row = self.row()?;
            return self.skip("}").then(|| format!("<mrow>{row}</mrow>"));
        }
        // `\frac12` is one half: a digit alone is an argument.
        if let Some(digit) = self.rest.chars().next().filter(char::is_ascii_digit) {
            self.rest = self.rest.get(1..)?;
            return Some(element("mn", &digit.to_string()));
        }
        self.atom().map(|(atom, _)| atom)
    }

    fn atom(&mut self) -> Option<(String, Scripts)> {
        let first = self.rest.chars().next()?;
        if first == '\\' {
            return self.command();
        }
        if first == '{' {
            return self.argument().map(|group| (group, Scripts::Beside));
        }
        if first.is_ascii_digit() {
            let end = self.rest.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(self.rest.len());
            let (number, rest) = self.rest.split_at(end);
            self.rest = rest;
            return Some((element("mn", number), Scripts::Beside));
        }
        self.rest = self.rest.get(first.len_utf8()..)?;
        let shown = match first {
            '-' => element("mo", "−"),
            '(' | ')' | '[' | ']' | '|' => format!("<mo stretchy=\"false\">{first}</mo>"),
            '\'' => element("mo", "′"),
            '+' | '=' | '<' | '>' | ',' | ':' | '/' | ';' => element("mo", &first.to_string()),
            c if c.is_alphabetic() => element("mi", &c.to_string()),
            _ => return None,
        };
        Some((shown, Scripts::Beside))
    }

    fn command(&mut self) -> Option<(String, Scripts)> {
        let name = self.name()?;
        let find =
            |table: &[(&str, &'static str)]| table.iter().find(|(key, _)| *key == name).map(|(_, c)| *c);
        if let Some(symbol) = find(&SYMBOLS) {
            return Some((element("mi", symbol), Scripts::Beside));
        }
        if let Some(operator) = find(&OPERATORS) {
            return Some((format!("<mo stretchy=\"false\">{operator}</mo>"), Scripts::Beside));
        }
        if FUNCTIONS.contains(&name) {
            return Some((element("mi", name), Scripts::Applied));
        }
        let shown = match name {
            "mathbf" | "boldsymbol" => self.bold()?,
            "hat" => self.accented("^")?,
            "dot" => self.accented("˙")?,
            "ddot" => self.accented("¨")?,
            "frac" | "tfrac" => {
                let (top, bottom) = (self.argument()?, self.argument()?);
                format!("<mfrac>{top}{bottom}</mfrac>")
            }
            "sqrt" => format!("<msqrt>{}</msqrt>", self.argument()?),
            "sum" => return Some((element("mo", "∑"), Scripts::Under)),
            "int" => element("mo", "∫"),
            "operatorname" => return Some((element("mi", self.braced()?), Scripts::Applied)),
            "text" => element("mtext", &self.braced()?.replace(' ', "\u{a0}")),
            "quad" => space(1.0),
            "qquad" => space(2.0),
            "ldots" => element("mo", "…"),
            "left" | "right" => {
                let bracket = self.rest.chars().next().filter(|c| "()[]".contains(*c))?;
                self.rest = self.rest.get(1..)?;
                element("mo", &bracket.to_string())
            }
            "begin" => self.environment()?,
            _ => return None,
        };
        Some((shown, Scripts::Beside))
    }

    /// Vectors and tensors are upright and bold: characters of their own, as MathML Core has no bold variant.
    fn bold(&mut self) -> Option<String> {
        let letter = self.argument()?;
        let inside = letter.strip_prefix("<mi>").and_then(|rest| rest.strip_suffix("</mi>"))?;
        let bold: Option<String> = inside.chars().map(super::bold).collect();
        bold.map(|letters| element("mi", &letters))
    }

    fn accented(&mut self, accent: &str) -> Option<String> {
        let below = self.argument()?;
        Some(format!("<mover accent=\"true\">{below}<mo stretchy=\"false\">{accent}</mo></mover>"))
    }

    /// `\begin{name} cell & cell \cr … \end{name}`
    fn environment(&mut self) -> Option<String> {
        let name = self.braced()?;
        let fence = match name {
            "vmatrix" => Some("|"),
            "aligned" => None,
            _ => return None,
        };
        let (mut rows, mut cells) = (String::new(), String::new());
        loop {
            cells.push_str(&cell(&self.row()?));
            if self.skip("&") {
                continue;
            }
            rows.push_str(&format!("<mtr>{}</mtr>", std::mem::take(&mut cells)));
            if self.skip(r"\cr") {
                continue;
            }
            let closed = self.skip(r"\end") && self.braced()? == name;
            let table = format!("<mtable>{rows}</mtable>");
            return closed.then(|| match fence {
                Some(fence) => format!("<mrow><mo>{fence}</mo>{table}<mo>{fence}</mo></mrow>"),
                None => table,
            });
        }
    }

    /// The letters of a command.
    fn name(&mut self) -> Option<&'a str> {
        let rest = self.rest.strip_prefix('\\')?;
        let end = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let (name, rest) = rest.split_at(end);
        self.rest = rest;
        Some(name)
    }

    /// `{words}`, as they are.
    fn braced(&mut self) -> Option<&'a str> {
        let (inside, rest) = self.rest.strip_prefix('{')?.split_once('}')?;
        self.rest = rest;
        Some(inside)
    }

    fn skip_space(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn skip(&mut self, text: &str) -> bool {
        let after = self.rest.strip_prefix(text);
        self.rest = after.unwrap_or(self.rest);
        after.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scripts_fractions_and_accents() {
        assert_eq!(
            to_mathml(r"\dot\omega_1 = \frac{L^2}{2T}").as_deref(),
            Some(
                "<msub><mover accent=\"true\"><mi>ω</mi><mo stretchy=\"false\">˙</mo></mover><mn>1</mn></msub><mo>=</mo>\
                 <mfrac><mrow><msup><mi>L</mi><mn>2</mn></msup></mrow><mrow><mn>2</mn><mi>T</mi></mrow></mfrac>"
            )
        );
        assert_eq!(
            to_mathml(r"\tfrac12 M").as_deref(),
            Some("<mfrac><mn>1</mn><mn>2</mn></mfrac><mi>M</mi>")
        );
        assert_eq!(
            to_mathml(r"\sin^2 x").as_deref(),
            Some(
                "<msup><mi>sin</mi><mn>2</mn></msup><mo>&#x2061;</mo><mspace width=\"0.17em\"></mspace><mi>x</mi>"
            )
        );
        assert_eq!(
            to_mathml(r"A\sin(x)").as_deref(),
            Some(
                "<mi>A</mi><mspace width=\"0.17em\"></mspace><mi>sin</mi><mo>&#x2061;</mo>\
                 <mo stretchy=\"false\">(</mo><mi>x</mi><mo stretchy=\"false\">)</mo>"
            )
        );
    }

    #[test]
    fn sums_have_limits_and_vectors_are_bold() {
        assert_eq!(
            to_mathml(r"\sum_{\text{parts}} \mathbf r_\alpha").as_deref(),
            Some(
                "<munder><mo>∑</mo><mrow><mtext>parts</mtext></mrow></munder>\
                 <msub><mi>𝐫</mi><mi>α</mi></msub>"
            )
        );
    }

    #[test]
    fn determinants_are_tables() {
        let latex = "\\begin{vmatrix}\na & b \\cr\nc & d\n\\end{vmatrix} = 0";
        assert_eq!(
            to_mathml(latex).as_deref(),
            Some(
                "<mrow><mo>|</mo><mtable><mtr><mtd><mi>a</mi></mtd><mtd><mi>b</mi></mtd></mtr>\
                 <mtr><mtd><mi>c</mi></mtd><mtd><mi>d</mi></mtd></mtr></mtable><mo>|</mo></mrow><mo>=</mo><mn>0</mn>"
            )
        );
    }

    #[test]
    fn the_unknown_and_the_broken_are_refused() {
        for latex in [r"\unknown", "x }", r"\frac{1}", r"\begin{vmatrix} a", "{x", "x ? y"] {
            assert_eq!(to_mathml(latex), None, "{latex}");
        }
    }
}
