//! Documents as blocks of the page, with formulas as MathML.

use polhode_document::Picture;
use polhode_document::layout::plain_spaces;
use polhode_document::mathml;
use polhode_document::number::{DIGITS, alike, tidy_matrix};
use polhode_document::{Block, Document, Section};
use serde_json::{Value, json};

/// Returns the blocks of a document: `ExplanationBlock[]` of `viewer/src/data.ts`.
pub fn page_blocks(document: &Document) -> Value {
    let mut blocks = vec![heading(1, &document.title)];
    blocks.extend(document.answer.iter().map(|line| text(line)));
    for section in &document.sections {
        blocks.extend(of_section(section));
    }
    blocks.into()
}

fn of_section(section: &Section) -> Vec<Value> {
    let mut blocks = vec![heading(2, &format!("{}. {}", section.number, section.title))];
    for block in &section.blocks {
        match block {
            Block::Paragraph(words) => blocks.push(text(words)),
            Block::Formula { text, latex } => blocks.push(formula(&mathml::formula(latex, text), text)),
            Block::Lines(lines) => {
                let lines: Vec<String> = lines.iter().map(|line| plain_spaces(line)).collect();
                blocks.push(json!({ "kind": "lines", "lines": lines }));
            }
            Block::Matrix { name, rows, unit } => blocks.push(matrix(name, rows, unit)),
            Block::Graph(graph) => {
                let svg = Picture::of_graph(graph).to_svg();
                blocks.push(json!({ "kind": "picture", "svg": svg, "text": plain_spaces(&graph.title) }));
            }
            Block::Drawing(drawing) => {
                let svg = Picture::of_drawing(drawing).to_svg();
                let words = drawing.caption().unwrap_or_default();
                blocks.push(json!({ "kind": "picture", "svg": svg, "text": plain_spaces(&words) }));
            }
            Block::Picture(picture) => {
                let words = plain_spaces(&picture.sheet.title);
                blocks.push(json!({ "kind": "picture", "svg": picture.to_svg(), "text": words }));
            }
            Block::Table { headers, rows } => blocks.push(table(headers, rows)),
        }
    }
    blocks
}

fn heading(level: u8, words: &str) -> Value {
    json!({ "kind": "heading", "level": level, "text": plain_spaces(words) })
}

fn text(words: &str) -> Value {
    json!({ "kind": "text", "text": plain_spaces(words) })
}

fn formula(mathml: &str, text: &str) -> Value {
    json!({ "kind": "formula", "mathml": mathml, "text": plain_spaces(text) })
}

fn matrix(name: &str, rows: &[[f64; 3]; 3], unit: &str) -> Value {
    let cells = alike(tidy_matrix(*rows).as_flattened(), DIGITS);
    let rows: Vec<Vec<String>> = cells.chunks(3).map(<[String]>::to_vec).collect();
    let lines: Vec<String> = rows.iter().map(|row| row.join(", ")).collect();
    formula(&mathml::matrix(name, &rows, unit), &format!("{name} = ({}) {unit}", lines.join("; ")))
}

fn table(headers: &[String], rows: &[Vec<String>]) -> Value {
    let plain = |cells: &[String]| cells.iter().map(|cell| plain_spaces(cell)).collect::<Vec<_>>();
    json!({
        "kind": "table",
        "header": plain(headers),
        "rows": rows.iter().map(|row| plain(row)).collect::<Vec<_>>(),
    })
}
