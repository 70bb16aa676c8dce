//! LaTeX writer: an article with `amsmath` for formulas and TikZ for graphs. Compiles with
//! pdfLaTeX, XeLaTeX and LuaLaTeX.

use super::super::graph::Graph;
use super::formula;
use super::{Block, Document};
use crate::finding;
use crate::layout::{broken, plain_spaces, printable};
use crate::number::{DIGITS, alike, tidy_matrix};

/// End of a line. The braces keep a following `[` or `*` from being its argument.
const END: &str = "\\\\{}\n";

/// Largest width of a line of numbers, columns.
const LONGEST: usize = 84;

const HEAD: &str = r"\documentclass[11pt]{article}
\usepackage{iftex}
\ifPDFTeX\usepackage[utf8]{inputenc}\usepackage[T1]{fontenc}\fi
\usepackage[a4paper,margin=25mm]{geometry}
\usepackage{amsmath,amssymb,tikz}
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.6em}
\setcounter{secnumdepth}{0}
\newcommand{\letter}[2]{\ifPDFTeX\texttt{U+#1}\else#2\fi}
";

impl Document {
    /// Returns an article that compiles with any LaTeX engine.
    pub fn to_latex(&self) -> String {
        let mut out = format!(
            "{HEAD}\\title{{{}}}\n\\date{{}}\n\\begin{{document}}\n\\maketitle\n",
            words(&self.title)
        );
        if !self.answer.is_empty() {
            let items: String = self.answer.iter().map(|line| format!("\\item {}\n", words(line))).collect();
            out.push_str(&format!("\\begin{{itemize}}\n{items}\\end{{itemize}}\n"));
        }
        for section in &self.sections {
            out.push_str(&format!("\n\\section{{{}. {}}}\n", section.number, words(&section.title)));
            for block in &section.blocks {
                out.push('\n');
                out.push_str(&render(block));
                out.push('\n');
            }
        }
        for found in &self.findings {
            out.push_str(&format!("\n\\begin{{quote}}{}\\end{{quote}}\n", words(&finding::sentence(found))));
        }
        out + "\n\\end{document}\n"
    }
}

fn render(block: &Block) -> String {
    match block {
        Block::Paragraph(text) => words(text),
        Block::Formula { text, latex } => match formula::rows(text, latex) {
            Some(rows) => format!("\\begin{{gather*}}\n{}\n\\end{{gather*}}", rows.join(" \\\\\n")),
            None => format!("\\[\n{}\n\\]", latex.replace(r"\cr", r"\\")),
        },
        Block::Lines(lines) => typed(lines),
        Block::Matrix { name, rows, unit } => matrix(name, rows, unit),
        Block::Graph(graph) => drawn(graph),
        Block::Drawing(drawing) => typed(&drawing.lines()),
        Block::Picture(_) => String::new(),
        Block::Table { headers, rows } => {
            let row = |cells: &[String]| cells.iter().map(|cell| words(cell)).collect::<Vec<_>>().join(" & ");
            let body = rows.iter().map(|cells| row(cells)).collect::<Vec<_>>().join(END);
            let columns = "r".repeat(headers.len());
            format!(
                "{{\\footnotesize\\setlength{{\\tabcolsep}}{{3pt}}\\begin{{tabular}}{{{columns}}}\n{} \\\\ \\hline\n{body}\n\\end{{tabular}}\\par}}",
                row(headers)
            )
        }
    }
}

/// Returns lines in typewriter font with their spaces.
fn typed(lines: &[String]) -> String {
    let lines = lines.iter().flat_map(|line| broken(line, "", LONGEST));
    let lines: Vec<String> = lines.map(|line| words(&line).replace(' ', "~")).collect();
    format!("{{\\small\\ttfamily\\raggedright\n{}\\par}}", lines.join(END))
}

/// Returns a graph in TikZ, 10 cm by 5 cm.
fn drawn(graph: &Graph) -> String {
    let ends = |values: &mut dyn Iterator<Item = f64>| {
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
    };
    let ([from, to, height], name) = graph.level;
    let [left, right] = ends(&mut graph.points.iter().map(|p| p[0]));
    let [low, high] = ends(&mut graph.points.iter().map(|p| p[1]).chain([height]));
    let part = |value: f64, [a, b]: [f64; 2]| if b > a { (value - a) / (b - a) } else { 0.5 };
    let at =
        |x: f64, y: f64| format!("({:.3},{:.3})", 10.0 * part(x, [left, right]), 5.0 * part(y, [low, high]));
    let curve: String = graph.points.iter().map(|&[x, y]| at(x, y)).collect();
    let shown = |x: f64| format!("${}$", power(&crate::number::number(x, 3)));
    let lines = [
        format!("\\draw[gray] (0,0) rectangle (10,5);\n\\draw[thick] plot coordinates {{{curve}}};"),
        format!(
            "\\draw[dashed] {} -- {} node[midway,above] {{{}}};",
            at(from, height),
            at(to, height),
            words(name)
        ),
        format!(
            "\\node[below right] at (0,0) {{{}}};\n\\node[below left] at (10,0) {{{}}};",
            shown(left),
            shown(right)
        ),
        format!("\\node[left] at (0,0.1) {{{}}};\n\\node[left] at (0,4.9) {{{}}};", shown(low), shown(high)),
        format!("\\node[below] at (5,-0.1) {{{} ({})}};", words(graph.across[0]), words(graph.across[1])),
        format!(
            "\\node[above] at (5,5) {{{}: {} ({})}};",
            words(&graph.title),
            words(graph.up[0]),
            words(graph.up[1])
        ),
    ];
    format!(
        "\\begin{{center}}\\begin{{tikzpicture}}\n{}\n\\end{{tikzpicture}}\\end{{center}}",
        lines.join("\n")
    )
}

/// Returns a formula of the form `name = matrix unit`.
fn matrix(name: &str, rows: &[[f64; 3]; 3], unit: &str) -> String {
    let cells = alike(tidy_matrix(*rows).as_flattened(), DIGITS);
    let rows: Vec<String> =
        cells.chunks(3).map(|row| row.iter().map(|x| power(x)).collect::<Vec<_>>().join(" & ")).collect();
    let name = match name {
        "{I}" => r"\lbrace \mathbf I \rbrace".to_owned(),
        other => format!(r"\text{{{}}}", words(other)),
    };
    let unit = if unit.is_empty() { String::new() } else { format!(r"\ \text{{{}}}", words(unit)) };
    format!("\\[\n{name} = \\begin{{pmatrix}}\n{}\n\\end{{pmatrix}}{unit}\n\\]", rows.join(" \\\\\n"))
}

/// Returns a number such as `3.3248e-5` in LaTeX notation.
fn power(x: &str) -> String {
    match x.split_once('e') {
        Some((mantissa, power)) => format!(r"{mantissa}\times 10^{{{power}}}"),
        None => x.to_owned(),
    }
}

/// Escapes a text for LaTeX; Greek letters, operators and accents become commands.
fn words(text: &str) -> String {
    let mut out = String::new();
    for c in plain_spaces(&printable(text)).chars() {
        // A combining accent follows its letter.
        if let Some(accent) = accent(c) {
            let letter = last_atom(&mut out);
            out.push_str(&format!("$\\{accent}{{{letter}}}$"));
            continue;
        }
        match sign(c) {
            Some(command) => out.push_str(&format!("${command}$")),
            None => out.push_str(&plain(c).map_or_else(|| other(c), str::to_owned)),
        }
    }
    out
}

/// Removes and returns the base of an accent: the last `$…$` or letter of the output.
fn last_atom(out: &mut String) -> String {
    if out.ends_with('$')
        && let Some(start) = out.trim_end_matches('$').rfind('$')
    {
        return out.split_off(start).trim_matches('$').to_owned();
    }
    out.pop().map_or_else(String::new, |c| c.to_string())
}

const fn accent(c: char) -> Option<&'static str> {
    Some(match c {
        '\u{302}' => "hat",
        '\u{307}' => "dot",
        '\u{308}' => "ddot",
        _ => return None,
    })
}

/// Returns a character. Beyond Latin it also gets its code point, because pdfLaTeX has no font for
/// it.
fn other(c: char) -> String {
    if c <= '\u{17f}' { c.to_string() } else { format!("\\letter{{{:04X}}}{{{c}}}", u32::from(c)) }
}

/// Returns the escape sequence of a character with a special meaning in LaTeX.
const fn plain(c: char) -> Option<&'static str> {
    Some(match c {
        '\\' => r"\textbackslash{}",
        '{' => r"\{",
        '}' => r"\}",
        '$' => r"\$",
        '&' => r"\&",
        '#' => r"\#",
        '%' => r"\%",
        '_' => r"\_",
        '^' => r"\textasciicircum{}",
        '~' => r"\textasciitilde{}",
        '<' => "$<$",
        '>' => "$>$",
        '|' => "$|$",
        _ => return None,
    })
}

/// Returns the command of a mathematical sign in text.
fn sign(c: char) -> Option<String> {
    let command = match c {
        'α' => r"\alpha",
        'β' => r"\beta",
        'γ' => r"\gamma",
        'δ' => r"\delta",
        'ε' => r"\varepsilon",
        'ζ' => r"\zeta",
        'η' => r"\eta",
        'θ' => r"\theta",
        'λ' => r"\lambda",
        'µ' | 'μ' => r"\mu",
        'π' => r"\pi",
        'ρ' => r"\rho",
        'σ' => r"\sigma",
        'τ' => r"\tau",
        'φ' => r"\varphi",
        'χ' => r"\chi",
        'ψ' => r"\psi",
        'ω' => r"\omega",
        'ϖ' => r"\varpi",
        'Δ' => r"\Delta",
        'Σ' => r"\textstyle\sum",
        'Φ' => r"\Phi",
        'Ω' => r"\Omega",
        '∫' => r"\textstyle\int",
        '∞' => r"\infty",
        '√' => r"\sqrt{}",
        '·' => r"\cdot",
        '×' => r"\times",
        '±' => r"\pm",
        '−' => "-",
        '≤' => r"\le",
        '≥' => r"\ge",
        '≠' => r"\ne",
        '≃' => r"\simeq",
        '≈' => r"\approx",
        '≫' => r"\gg",
        '≪' => r"\ll",
        '∂' => r"\partial",
        '′' => "'",
        '∓' => r"\mp",
        '⟂' => r"\perp",
        'Θ' => r"\Theta",
        'Γ' => r"\Gamma",
        'Λ' => r"\Lambda",
        'Ψ' => r"\Psi",
        'ν' => r"\nu",
        'ξ' => r"\xi",
        'κ' => r"\kappa",
        '→' => r"\to",
        '⊥' => r"\perp",
        '°' => r"{}^\circ",
        '²' => "{}^2",
        '³' => "{}^3",
        '⁴' => "{}^4",
        '⁵' => "{}^5",
        '⁶' => "{}^6",
        '⁷' => "{}^7",
        '⁸' => "{}^8",
        '⁹' => "{}^9",
        '⁰' => "{}^0",
        '⁻' => "{}^-",
        '¹' => "{}^1",
        '₀' => "{}_0",
        '₁' => "{}_1",
        '₂' => "{}_2",
        '₃' => "{}_3",
        '₄' => "{}_4",
        'ₛ' => "{}_s",
        '∝' => r"\propto",
        'ᵀ' => r"{}^{\mathsf T}",
        '½' => r"\tfrac12",
        '¼' => r"\tfrac14",
        'ẑ' => r"\hat z",
        'ŷ' => r"\hat y",
        'û' => r"\hat u",
        'ê' => r"\hat e",
        'ẋ' => r"\dot x",
        '⟨' => r"\langle",
        '⟩' => r"\rangle",
        '…' => r"\ldots",
        _ => return None,
    };
    Some(command.to_owned())
}
