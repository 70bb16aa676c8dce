//! Markdown writer.

use super::formula;
use super::text::matrix;
use super::{Block, Document};
use crate::finding;
use crate::layout::{broken, plain_spaces, printable};

/// Largest width of a line of numbers, columns.
const LONGEST: usize = 96;

impl Document {
    /// Returns Markdown with LaTeX between `$$`, as GitHub, Jupyter and pandoc render it.
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
                let shown = render_block(block);
                if !shown.is_empty() {
                    text.push_str(&format!("\n{shown}\n"));
                }
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
        Block::Formula { text, latex } => match formula::rows(text, latex) {
            Some(rows) => rows.iter().map(|row| format!("$$\n{row}\n$$")).collect::<Vec<_>>().join("\n\n"),
            None => fenced(text.lines().map(str::to_owned)),
        },
        Block::Lines(lines) => fenced(lines.iter().flat_map(|line| broken(line, "", LONGEST))),
        // No notation for matrix rows works everywhere: GitHub halves a double backslash, and
        // pandoc does not know `\cr`.
        Block::Matrix { name, rows, unit } => fenced(matrix(name, rows, unit).into_iter()),
        Block::Graph(graph) => fenced(super::super::graph::lines(graph).into_iter()),
        Block::Drawing(drawing) => match drawing.lines() {
            lines if lines.is_empty() => String::new(),
            lines => fenced(lines.into_iter()),
        },
        Block::Picture(_) => String::new(),
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

/// Returns lines as a code block.
fn fenced(lines: impl Iterator<Item = String>) -> String {
    format!("```text\n{}\n```", plain_spaces(&lines.collect::<Vec<_>>().join("\n")))
}

/// Returns the text on one line with the special characters of Markdown escaped.
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
