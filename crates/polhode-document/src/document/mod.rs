//! Document of a worked solution: sections of paragraphs, formulas, numbers and tables, independent
//! of the output format.

mod formula;
mod html;
mod latex;
mod markdown;
mod text;
mod verdict;

use polhode::body::Finding;
use serde_json::{Value, json};

pub use verdict::{Level, Verdict};

use super::drawing::Drawing;
use super::graph::Graph;
use crate::Picture;
use crate::VERSION;
use crate::finding;
use crate::json::matrix;
use crate::layout::printable;

/// Worked solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// Title of the document.
    pub title: String,
    /// Verdict, shown on a page; `None` if the document answers no yes-or-no question.
    pub verdict: Option<Verdict>,
    /// Lines that answer the question, printed before the working.
    pub answer: Vec<String>,
    /// Steps in order.
    pub sections: Vec<Section>,
    /// Findings about the scenario and its motion.
    pub findings: Vec<Finding>,
}

/// One step of the solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Number of the step; 0 is the body itself.
    pub number: u8,
    /// Title of the step.
    pub title: String,
    /// Contents of the step.
    pub blocks: Vec<Block>,
}

/// Part of a section.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Paragraph of text.
    Paragraph(String),
    /// Formula in symbols, without numbers.
    Formula {
        /// Unicode form.
        text: String,
        /// LaTeX form.
        latex: String,
    },
    /// Lines of working: formulas with numbers and units.
    Lines(Vec<String>),
    /// Matrix of numbers.
    Matrix {
        /// Symbol of the matrix.
        name: String,
        /// Elements by row.
        rows: [[f64; 3]; 3],
        /// Unit of the elements; empty for ratios.
        unit: &'static str,
    },
    /// Curve over an axis.
    Graph(Graph),
    /// Any other picture, as data.
    Drawing(Drawing),
    /// Drawn picture, for pages only; its numbers are in the tables of the report.
    Picture(Picture),
    /// Table with a header.
    Table {
        /// Header of each column, with its unit.
        headers: Vec<String>,
        /// Cells by row.
        rows: Vec<Vec<String>>,
    },
}

impl Document {
    /// Creates a document whose only section has the lines of a text.
    pub fn of_text(title: &str, text: &str) -> Self {
        let mut section = Section::new(0, title);
        text.lines().for_each(|line| section.line(line));
        Self {
            title: title.to_owned(),
            verdict: None,
            answer: Vec::new(),
            sections: vec![section],
            findings: Vec::new(),
        }
    }

    /// Returns the document as `{"polhode": …, "title": …, "answer": […], "sections": [{"number":
    /// …, "title": …, "blocks": […]}], "findings": […]}`.
    pub fn to_json(&self) -> Value {
        let sections: Value = self.sections.iter().map(Section::to_json).collect();
        let plain = |s: &String| crate::layout::plain_spaces(s);
        json!({
            "polhode": VERSION,
            "title": self.title,
            "answer": self.answer.iter().map(plain).collect::<Vec<_>>(),
            "sections": sections,
            "findings": finding::to_json(&self.findings),
        })
    }
}

impl Section {
    /// Creates an empty section.
    pub fn new(number: u8, title: &str) -> Self {
        Self { number, title: title.to_owned(), blocks: Vec::new() }
    }

    /// Adds a paragraph. Control characters in it are escaped, because it may contain names from
    /// files.
    pub fn say(&mut self, text: impl AsRef<str>) {
        self.blocks.push(Block::Paragraph(printable(text.as_ref())));
    }

    /// Adds a formula as Unicode text and as LaTeX.
    pub fn formula(&mut self, text: &str, latex: &str) {
        self.blocks.push(Block::Formula { text: text.to_owned(), latex: latex.to_owned() });
    }

    /// Adds a line of numbers; consecutive lines form one block.
    pub fn line(&mut self, line: impl AsRef<str>) {
        let line = printable(line.as_ref());
        if let Some(Block::Lines(lines)) = self.blocks.last_mut() {
            lines.push(line);
        } else {
            self.blocks.push(Block::Lines(vec![line]));
        }
    }

    /// Adds the line `lhs = term + term + … = result`.
    pub fn sum(&mut self, lhs: &str, terms: &[String], result: &str) {
        self.line(format!("{lhs} = {} = {result}", terms.join(" + ")));
    }

    /// Adds a matrix with its symbol and the unit of its elements.
    pub fn matrix(&mut self, name: impl Into<String>, rows: [[f64; 3]; 3], unit: &'static str) {
        self.blocks.push(Block::Matrix { name: name.into(), rows, unit });
    }

    /// Adds a curve.
    pub fn graph(&mut self, graph: Graph) {
        self.blocks.push(Block::Graph(graph));
    }

    /// Adds a picture.
    pub fn draw(&mut self, drawing: Drawing) {
        self.blocks.push(Block::Drawing(drawing));
    }

    /// Adds a drawn picture.
    pub fn picture(&mut self, picture: Picture) {
        self.blocks.push(Block::Picture(picture));
    }

    /// Adds a table: one header per column, and rows of cells.
    pub fn table(&mut self, headers: &[&str], rows: Vec<Vec<String>>) {
        let headers = headers.iter().map(|h| (*h).to_owned()).collect();
        self.blocks.push(Block::Table { headers, rows });
    }

    fn to_json(&self) -> Value {
        json!({
            "number": self.number,
            "title": self.title,
            "blocks": self.blocks.iter().map(Block::to_json).collect::<Value>(),
        })
    }
}

impl Block {
    const fn is_picture(&self) -> bool {
        matches!(self, Self::Graph(_) | Self::Drawing(_) | Self::Picture(_))
    }

    fn to_json(&self) -> Value {
        let plain = |s: &String| crate::layout::plain_spaces(s);
        match self {
            Self::Paragraph(text) => json!({ "kind": "paragraph", "text": plain(text) }),
            Self::Formula { text, latex } => json!({ "kind": "formula", "text": text, "latex": latex }),
            Self::Lines(lines) => {
                json!({ "kind": "lines", "lines": lines.iter().map(plain).collect::<Vec<_>>() })
            }
            Self::Matrix { name, rows, unit } => {
                json!({ "kind": "matrix", "name": name, "rows": matrix(*rows), "unit": unit })
            }
            Self::Graph(graph) => json!({
                "kind": "graph",
                "title": plain(&graph.title),
                "across": graph.across,
                "up": graph.up,
                "points": graph.points,
                "level": { "from": graph.level.0[0], "to": graph.level.0[1], "at": graph.level.0[2], "name": graph.level.1 },
            }),
            Self::Drawing(drawing) => drawing.to_json(),
            Self::Picture(picture) => json!({ "kind": "picture", "title": picture.sheet.title }),
            Self::Table { headers, rows } => {
                let rows: Vec<Vec<String>> = rows.iter().map(|row| row.iter().map(plain).collect()).collect();
                json!({ "kind": "table", "headers": headers, "rows": rows })
            }
        }
    }
}
