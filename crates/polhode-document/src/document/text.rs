//! Plain text writer.

use super::{Block, Document};
use crate::finding;
use crate::layout::{self, broken, columns, matrix_rows, plain_spaces, printable, width, wrap};
use crate::number::{DIGITS, tidy_matrix};

const INDENT: &str = "    ";

impl Document {
    /// Returns plain text of at most `columns` columns; tables and matrices may be wider.
    pub fn to_text(&self, columns: usize) -> String {
        let title = wrap(&printable(&self.title), "", columns);
        let longest = title.iter().map(|line| width(line)).max().unwrap_or(0);
        let mut text = format!("{}\n{}\n", title.join("\n"), "═".repeat(longest));
        for answer in &self.answer {
            let lines = wrap(answer, "  ", columns);
            text.push_str(
                &lines.iter().map(|line| format!("{line}\n")).collect::<String>().replacen("  ", "→ ", 1),
            );
        }
        for section in &self.sections {
            let heading = format!("{}. {}", section.number, section.title);
            text.push_str(&format!("\n{heading}\n{}\n", "─".repeat(width(&heading))));
            let blocks = section.blocks.iter().map(|block| lines(block, columns));
            for (k, block) in blocks.filter(|lines| !lines.is_empty()).enumerate() {
                if k > 0 {
                    text.push('\n');
                }
                for line in block {
                    text.push_str(line.trim_end_matches(' '));
                    text.push('\n');
                }
            }
        }
        if !self.findings.is_empty() {
            text.push('\n');
            text.push_str(&finding::within(&self.findings, columns));
        }
        plain_spaces(&text)
    }
}

fn lines(block: &Block, columns: usize) -> Vec<String> {
    match block {
        Block::Paragraph(text) => wrap(text, "", columns),
        Block::Formula { text, .. } => text.lines().flat_map(|line| broken(line, INDENT, columns)).collect(),
        Block::Lines(lines) => lines.iter().flat_map(|line| broken(line, INDENT, columns)).collect(),
        Block::Matrix { name, rows, unit } => {
            matrix(name, rows, unit).iter().map(|line| format!("{INDENT}{line}")).collect()
        }
        Block::Graph(graph) => {
            super::super::graph::lines(graph).iter().map(|line| format!("{INDENT}{line}")).collect()
        }
        Block::Drawing(drawing) => drawing.lines().iter().map(|line| format!("{INDENT}{line}")).collect(),
        Block::Picture(_) => Vec::new(),
        Block::Table { headers, rows } => table(headers, rows),
    }
}

/// Returns `name = ⎡ … ⎤  unit` in three lines.
pub(super) fn matrix(name: &str, rows: &[[f64; 3]; 3], unit: &str) -> Vec<String> {
    let brackets = [["⎡", "⎤"], ["⎢", "⎥"], ["⎣", "⎦"]];
    let rows = matrix_rows(&tidy_matrix(*rows), DIGITS);
    let blank = " ".repeat(width(name) + 3);
    let line = |k: usize, row: &String| {
        let [left, right] = brackets[k.min(2)];
        let (head, tail) = if k == 1 {
            (format!("{name} = "), if unit.is_empty() { String::new() } else { format!("  {unit}") })
        } else {
            (blank.clone(), String::new())
        };
        format!("{head}{left} {row} {right}{tail}")
    };
    rows.iter().enumerate().map(|(k, row)| line(k, row)).collect()
}

fn table(headers: &[String], rows: &[Vec<String>]) -> Vec<String> {
    let mut all = vec![headers.to_vec()];
    all.extend(rows.iter().map(|row| row.iter().map(|cell| printable(cell)).collect()));
    let mut lines: Vec<String> = columns(&all)
        .into_iter()
        .map(|line| format!("{INDENT}{}", line.replace(layout::INDENT, " ")))
        .collect();
    let longest = lines.iter().map(|line| width(line)).max().unwrap_or(0);
    lines.insert(1, format!("{INDENT}{}", "─".repeat(longest.saturating_sub(INDENT.len()))));
    lines
}
