//! HTML writer: formulas as MathML, graphs as SVG, no external resources.

use super::{Block, Document};
use crate::Picture;
use crate::finding;
use crate::layout::{plain_spaces, printable};
use crate::mathml::{self, escaped};
use crate::number::{DIGITS, alike, tidy_matrix};

const STYLE: &str = include_str!("document.css");

impl Document {
    /// Returns a self-contained HTML page; it needs no other file and no network.
    pub fn to_html(&self) -> String {
        let (title, math) = (shown(&self.title), mathml::style());
        let mut html = format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
             <style>\n{math}{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n"
        );
        if !self.answer.is_empty() {
            let lines: String =
                self.answer.iter().map(|line| format!("<li>{}</li>\n", shown(line))).collect();
            html.push_str(&format!("<ul class=\"answer\">\n{lines}</ul>\n"));
        }
        for section in &self.sections {
            html.push_str(&format!("<h2>{}. {}</h2>\n", section.number, shown(&section.title)));
            for block in &section.blocks {
                html.push_str(&render(block));
                html.push('\n');
            }
        }
        for found in &self.findings {
            html.push_str(&format!("<p class=\"finding\">{}</p>\n", shown(&finding::sentence(found))));
        }
        html + "</main>\n</body>\n</html>\n"
    }
}

fn render(block: &Block) -> String {
    match block {
        Block::Paragraph(text) => format!("<p>{}</p>", shown(text)),
        Block::Formula { text, latex } => mathml::formula(latex, text),
        Block::Lines(lines) => {
            format!("<pre>{}</pre>", lines.iter().map(|line| shown(line)).collect::<Vec<_>>().join("\n"))
        }
        Block::Matrix { name, rows, unit } => {
            let cells = alike(tidy_matrix(*rows).as_flattened(), DIGITS);
            mathml::matrix(name, &cells.chunks(3).map(<[String]>::to_vec).collect::<Vec<_>>(), unit)
        }
        Block::Graph(graph) => format!("<figure>\n{}</figure>", Picture::of_graph(graph).to_svg()),
        Block::Drawing(drawing) => {
            let caption =
                drawing.caption().map(|words| format!("<figcaption>{}</figcaption>\n", shown(&words)));
            let svg = Picture::of_drawing(drawing).to_svg();
            format!("<figure>\n{svg}{}</figure>", caption.unwrap_or_default())
        }
        Block::Table { headers, rows } => {
            let row = |cells: &[String], tag: &str| {
                let cells: String =
                    cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", shown(cell))).collect();
                format!("<tr>{cells}</tr>\n")
            };
            let body: String = rows.iter().map(|cells| row(cells, "td")).collect();
            format!("<table>\n<thead>\n{}</thead>\n<tbody>\n{body}</tbody>\n</table>", row(headers, "th"))
        }
    }
}

fn shown(text: &str) -> String {
    escaped(&plain_spaces(&printable(text)))
}
