//! HTML writer: formulas as MathML, pictures as SVG, no script and no external resource.

use polhode::body::Severity;

use super::verdict::Level;
use super::{Block, Document};
use crate::figure::font::FAMILY;
use crate::finding;
use crate::layout::{plain_spaces, printable, width};
use crate::mathml::{self, escaped};
use crate::number::{DIGITS, alike, tidy_matrix};
use crate::{Picture, VERSION};

const STYLE: &str = include_str!("document.css");
/// Smallest number of sections with a table of contents.
const SEVERAL: usize = 3;
/// Width of a picture that fits on a phone, px.
const NARROW: f64 = 360.0;
/// Width of a picture that needs the whole column, px.
const WIDE: f64 = 600.0;
/// Length of a cell whose text is broken into lines, columns.
const LONG: usize = 36;

impl Document {
    /// Returns a self-contained HTML page; it needs no other file and no network.
    pub fn to_html(&self) -> String {
        let title = shown(&self.title);
        let sections: String = self
            .sections
            .iter()
            .enumerate()
            .map(|(k, section)| {
                let (title, blocks) = (shown(&section.title), laid_out(&section.blocks));
                format!("<section id=\"s{k}\">\n<h2>{}. {title}</h2>\n{blocks}</section>\n", section.number)
            })
            .collect();
        // The font of formulas is larger than most pages.
        let math = if sections.contains("<math") { mathml::style() } else { String::new() };
        format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
             <style>\n{math}body {{ font-family: {FAMILY}; }}\n{STYLE}</style>\n</head>\n<body>\n<header>\n<h1>{title}</h1>\n{}</header>\n{}\
             <main>\n{sections}</main>\n<footer>polhode {VERSION}</footer>\n</body>\n</html>\n",
            self.summary(),
            self.contents()
        )
    }

    /// Returns the verdict, the answer and the findings.
    fn summary(&self) -> String {
        let class = self.verdict.as_ref().map_or("", |verdict| verdict.level.shown()[2]);
        let mut html = format!("<div class=\"summary {class}\">\n");
        if let Some(verdict) = &self.verdict {
            let [sign, word, _] = verdict.level.shown();
            let reason = shown(&verdict.reason);
            html.push_str(&format!("<p class=\"verdict\"><b>{sign} {word}</b> {reason}</p>\n"));
        }
        if !self.answer.is_empty() {
            let lines: String =
                self.answer.iter().map(|line| format!("<li>{}</li>\n", shown(line))).collect();
            html.push_str(&format!("<ul class=\"answer\">\n{lines}</ul>\n"));
        }
        for found in &self.findings {
            let class = if found.severity == Severity::Info { "note" } else { Level::Warning.shown()[2] };
            let sentence = shown(&finding::sentence(found));
            html.push_str(&format!("<p class=\"finding {class}\">{sentence}</p>\n"));
        }
        html + "</div>\n"
    }

    /// Returns links to the sections; empty for a short document.
    fn contents(&self) -> String {
        if self.sections.len() < SEVERAL {
            return String::new();
        }
        let links: String = self
            .sections
            .iter()
            .enumerate()
            .map(|(k, section)| {
                format!("<li><a href=\"#s{k}\">{}. {}</a></li>\n", section.number, shown(&section.title))
            })
            .collect();
        format!("<nav aria-label=\"Contents\">\n<p>Contents</p>\n<ul>\n{links}</ul>\n</nav>\n")
    }
}

/// Returns blocks in their order. Pictures are next to the numbers before them if both fit.
fn laid_out(blocks: &[Block]) -> String {
    let is_text = |block: &Block| matches!(block, Block::Paragraph(_) | Block::Formula { .. });
    let together = |a: &Block, b: &Block| !is_text(a) && !is_text(b) && (!a.is_picture() || b.is_picture());
    let html = |blocks: &[Block]| blocks.iter().map(|block| render(block) + "\n").collect::<String>();
    let group = |blocks: &[Block]| {
        let (numbers, pictures) = blocks.split_at(blocks.partition_point(|block| !block.is_picture()));
        let [numbers, pictures] = [numbers, pictures].map(html);
        match (numbers.is_empty(), pictures.is_empty()) {
            (_, true) => numbers,
            (true, false) => format!("<div class=\"figures\">\n{pictures}</div>\n"),
            (false, false) => format!(
                "<div class=\"pair\">\n<div>\n{numbers}</div>\n<div class=\"figures\">\n{pictures}</div>\n</div>\n"
            ),
        }
    };
    blocks.chunk_by(together).map(group).collect()
}

fn render(block: &Block) -> String {
    match block {
        Block::Paragraph(text) => format!("<p>{}</p>", shown(text)),
        Block::Formula { text, latex } => mathml::formula(latex, text),
        Block::Lines(lines) => {
            let lines = lines.iter().map(|line| shown(line)).collect::<Vec<_>>().join("\n");
            format!("<pre class=\"scroll\" tabindex=\"0\">{lines}</pre>")
        }
        Block::Matrix { name, rows, unit } => {
            let cells = alike(tidy_matrix(*rows).as_flattened(), DIGITS);
            mathml::matrix(name, &cells.chunks(3).map(<[String]>::to_vec).collect::<Vec<_>>(), unit)
        }
        Block::Graph(graph) => figure(&Picture::of_graph(graph), None),
        Block::Drawing(drawing) => figure(&Picture::of_drawing(drawing), drawing.caption()),
        Block::Picture(picture) => figure(picture, None),
        Block::Table { headers, rows } => table(headers, rows),
    }
}

fn figure(picture: &Picture, caption: Option<String>) -> String {
    let class = match picture.sheet.width {
        ..NARROW => " class=\"narrow\"",
        WIDE.. => " class=\"wide\"",
        _ => "",
    };
    let caption = caption.map(|words| format!("<figcaption>{}</figcaption>\n", shown(&words)));
    let (svg, caption) = (picture.to_page_svg(), caption.unwrap_or_default());
    format!("<figure{class}>\n<div class=\"scroll\" tabindex=\"0\">\n{svg}</div>\n{caption}</figure>")
}

/// Returns a table that scrolls if it is wider than the page.
fn table(headers: &[String], rows: &[Vec<String>]) -> String {
    let numeric: Vec<bool> = (0..headers.len()).map(|k| is_numeric(rows, k)).collect();
    let row = |cells: &[String], tag: &str| {
        let cell = |(k, cell): (usize, &String)| {
            let class = match Level::of_cell(cell) {
                Some(level) if tag == "td" => level.shown()[2],
                _ if numeric.get(k) == Some(&true) => "number",
                _ if width(cell) > LONG => "long",
                _ => return format!("<{tag}>{}</{tag}>", shown(cell)),
            };
            format!("<{tag} class=\"{class}\">{}</{tag}>", shown(cell))
        };
        format!("<tr>{}</tr>\n", cells.iter().enumerate().map(cell).collect::<String>())
    };
    let body: String = rows.iter().map(|cells| row(cells, "td")).collect();
    let head = row(headers, "th");
    format!(
        "<div class=\"scroll\" tabindex=\"0\">\n<table>\n<thead>\n{head}</thead>\n<tbody>\n{body}</tbody>\n</table>\n</div>"
    )
}

/// Returns true if most cells of a column begin with a number, and none is a long text.
fn is_numeric(rows: &[Vec<String>], column: usize) -> bool {
    let is_number = |cell: &&str| {
        let digits = cell.trim_start_matches(['-', '−', '+', '±', '<', '>', '≤', '≥', '≈', ' ']);
        digits.starts_with(|c: char| c.is_ascii_digit())
    };
    let cells = rows.iter().filter_map(|row| row.get(column)).map(String::as_str);
    let cells: Vec<&str> = cells.filter(|cell| !matches!(*cell, "" | "—" | "unobservable")).collect();
    cells.iter().all(|cell| width(cell) <= LONG)
        && 2 * cells.iter().filter(|cell| is_number(cell)).count() > cells.len()
}

fn shown(text: &str) -> String {
    escaped(&plain_spaces(&printable(text)))
}

#[cfg(test)]
mod tests {
    use super::super::{Section, Verdict};
    use super::*;
    use crate::figure::sheet::Sheet;

    fn document(level: Level) -> Document {
        let mut section = Section::new(1, "Limits & more");
        let rows = [["mass", "-1.2 ± 0.1", "met"], ["spin", "3.4", "not met"], ["tilt", "—", "suspect"]];
        section.table(&["limit", "value", ""], rows.map(|row| row.map(str::to_owned).to_vec()).to_vec());
        let sections = vec![section.clone(), Section { number: 2, ..section.clone() }, section];
        let verdict = Some(Verdict::new(level, "Because"));
        Document { verdict, answer: vec!["Yes".to_owned()], sections, ..Document::of_text("A <b>", "") }
    }

    #[test]
    fn a_verdict_has_a_class_a_sign_and_a_word() {
        for (level, [sign, word, class]) in
            [Level::Ok, Level::Warning, Level::Failure].map(|level| (level, level.shown()))
        {
            let page = document(level).to_html();
            assert!(page.contains(&format!(
                "<div class=\"summary {class}\">\n<p class=\"verdict\"><b>{sign} {word}</b> Because</p>\n<ul class=\"answer\">"
            )));
        }
        let page = document(Level::Ok).to_html();
        assert!(page.contains("<title>A &lt;b&gt;</title>") && page.contains("Limits &amp; more"));
        for cell in
            ["number\">-1.2 ± 0.1<", "number\">—<", "ok\">met<", "fail\">not met<", "warning\">suspect<"]
        {
            assert!(page.contains(&format!("<td class=\"{cell}")), "{cell}");
        }
        assert!(page.contains("<td>mass</td>") && page.contains("<a href=\"#s2\">1. Limits"));
        // A page without formulas does not embed their font.
        assert!(!page.contains("@font-face"));
    }

    #[test]
    fn pictures_are_next_to_the_numbers_before_them() {
        let picture = Picture { sheet: Sheet::new(300.0, 100.0, "p".to_owned()) };
        let [line, text] = [Block::Lines(vec!["a = 1".to_owned()]), Block::Paragraph("b".to_owned())];
        let picture = Block::Picture(picture);
        let page = laid_out(&[line.clone(), picture.clone(), picture.clone(), line, text, picture]);
        let marks =
            ["<div class=\"pair\">", "a = 1", "<svg", "<svg", "a = 1", "<p>b", "<div class=\"figures\">"];
        let mut rest = page.as_str();
        for mark in marks {
            rest = rest.split_once(mark).unwrap_or_else(|| panic!("{mark}: {page}")).1;
        }
        assert_eq!(page.matches("class=\"pair\"").count(), 1);
        assert!(page.contains("width=\"345\"") && page.contains("<figure class=\"narrow\">"));
    }
}
