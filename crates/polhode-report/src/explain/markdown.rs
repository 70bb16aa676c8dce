//! A document as Markdown.

use super::document::{Block, Document};
use super::text::DIGITS;
use crate::finding;
use crate::layout::{broken, plain_spaces, printable};
use crate::number::{alike, tidy_matrix};

/// Columns of a line of numbers.
const LONGEST: usize = 96;

impl Document {
    /// Markdown with LaTeX between `$$`, as GitHub, Jupyter and pandoc render it.
    pub fn to_markdown(&self) -> String {
        let mut text = format!("# {}\n", escaped(&self.title));
        if !self.answer.is_empty() {
            text.push('\n');
        }
        for answer in &self.answer {
            text.push_str(&format!("- **{}**\n", escaped(answer)));
        }
        for section in &self.sections {
            text.push_str(&format!("\n## {}. {}\n", section.number, escaped(&section.title)));
            for block in &section.blocks {
                text.push('\n');
                text.push_str(&render_block(block));
                text.push('\n');
            }
        }
        for found in &self.findings {
            text.push_str(&format!("\n> {}\n", escaped(&finding::sentence(found))));
        }
        text
    }
}

fn render_block(block: &Block) -> String {
    match block {
        Block::Paragraph(text) => escaped(text),
        Block::Formula { latex, .. } => format!("$$\n{latex}\n$$"),
        Block::Lines(lines) => {
            let lines: Vec<String> = lines.iter().flat_map(|line| broken(line, "", LONGEST)).collect();
            format!("```text\n{}\n```", plain_spaces(&lines.join("\n")))
        }
        Block::Matrix { name, rows, unit } => matrix(name, rows, unit),
        Block::Graph(graph) => {
            format!("```text\n{}\n```", plain_spaces(&super::graph::lines(graph).join("\n")))
        }
        Block::Table { headers, rows } => {
            let row = |cells: &[String]| {
                let cells: Vec<String> = cells.iter().map(|c| escaped(c).replace('|', "\\|")).collect();
                format!("| {} |", cells.join(" | "))
            };
            let mut lines = vec![row(headers), format!("|{}", " --- |".repeat(headers.len()))];
            lines.extend(rows.iter().map(|cells| row(cells)));
            lines.join("\n")
        }
    }
}

pub(super) fn matrix(name: &str, rows: &[[f64; 3]; 3], unit: &str) -> String {
    let cells = alike(tidy_matrix(*rows).as_flattened(), DIGITS);
    let rows: Vec<String> =
        cells.chunks(3).map(|row| row.iter().map(|x| power(x)).collect::<Vec<_>>().join(" & ")).collect();
    let name = match name {
        "{I}" => r"\lbrace \mathbf I \rbrace",
        other => &format!(r"\text{{{other}}}"),
    };
    let unit = if unit.is_empty() { String::new() } else { format!(r"\ \text{{{unit}}}") };
    // Row ends as \cr: Markdown would eat one of the two backslashes.
    format!("$$\n{name} = \\begin{{pmatrix}}\n{}\n\\end{{pmatrix}}{unit}\n$$", rows.join(" \\cr\n"))
}

/// `3.3248e-5` as LaTeX has it.
pub(super) fn power(x: &str) -> String {
    match x.split_once('e') {
        Some((mantissa, power)) => format!(r"{mantissa}\times 10^{{{power}}}"),
        None => x.to_owned(),
    }
}

/// The text on one line, without characters that Markdown would take for markup.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in printable(text).chars() {
        if matches!(c, '*' | '_' | '`' | '<' | '>' | '[' | ']' | '\\' | '$' | '#' | '~') {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
