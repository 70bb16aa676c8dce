//! Sheets of texts and numbers as an XLSX workbook: ISO/IEC 29500, with inline texts and without
//! styles.

use std::fmt::Write as _;
use std::io::{self, Seek, Write};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::read::column_name;

/// Sheet of a workbook.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Name on the tab, at most 31 characters.
    pub name: &'static str,
    /// Rows from the top, each with its cells from the left.
    pub rows: Vec<Vec<Cell>>,
}

/// Content of a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Cell without content.
    Empty,
    /// Text, which no program takes for a formula.
    Text(String),
    /// Number; the cell is empty if it is not finite.
    Number(f64),
}

const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
const PACKAGE: &str = "http://schemas.openxmlformats.org/package/2006";
const HEAD: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
const KIND: &str = "application/vnd.openxmlformats-officedocument.spreadsheetml";

/// Writes a workbook. The same sheets give the same bytes.
///
/// # Errors
/// Errors of `out`.
pub fn write(sheets: &[Sheet], out: impl Write + Seek) -> io::Result<()> {
    let mut zip = ZipWriter::new(out);
    let mut file = |name: &str, text: String| -> io::Result<()> {
        zip.start_file(name, SimpleFileOptions::default()).map_err(io::Error::other)?;
        zip.write_all(HEAD.as_bytes())?;
        zip.write_all(text.as_bytes())
    };
    let each = |of: &dyn Fn(usize, &Sheet) -> String| -> String {
        sheets.iter().enumerate().map(|(k, sheet)| of(k + 1, sheet)).collect()
    };
    let parts = each(&|k, _| {
        format!("<Override PartName=\"/xl/worksheets/sheet{k}.xml\" ContentType=\"{KIND}.worksheet+xml\"/>")
    });
    file(
        "[Content_Types].xml",
        format!(
            "<Types xmlns=\"{PACKAGE}/content-types\"><Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\
             <Override PartName=\"/xl/workbook.xml\" ContentType=\"{KIND}.sheet.main+xml\"/>{parts}</Types>"
        ),
    )?;
    file(
        "_rels/.rels",
        format!(
            "<Relationships xmlns=\"{PACKAGE}/relationships\"><Relationship Id=\"rId1\" Type=\"{OFFICE}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
        ),
    )?;
    let tabs = each(&|k, sheet| {
        format!("<sheet name=\"{}\" sheetId=\"{k}\" r:id=\"rId{k}\"/>", escaped(sheet.name))
    });
    file(
        "xl/workbook.xml",
        format!("<workbook xmlns=\"{MAIN}\" xmlns:r=\"{OFFICE}\"><sheets>{tabs}</sheets></workbook>"),
    )?;
    let targets = each(&|k, _| {
        format!(
            "<Relationship Id=\"rId{k}\" Type=\"{OFFICE}/worksheet\" Target=\"worksheets/sheet{k}.xml\"/>"
        )
    });
    file(
        "xl/_rels/workbook.xml.rels",
        format!("<Relationships xmlns=\"{PACKAGE}/relationships\">{targets}</Relationships>"),
    )?;
    for (k, sheet) in sheets.iter().enumerate() {
        file(&format!("xl/worksheets/sheet{}.xml", k + 1), content(sheet))?;
    }
    zip.finish().map_err(io::Error::other)?.flush()
}

fn content(sheet: &Sheet) -> String {
    let mut text = format!("<worksheet xmlns=\"{MAIN}\"><sheetData>");
    for (row, cells) in sheet.rows.iter().enumerate() {
        let row = row + 1;
        let _ = write!(text, "<row r=\"{row}\">");
        for (column, cell) in cells.iter().enumerate() {
            let column = column_name(column);
            let _ = match cell {
                Cell::Number(number) if number.is_finite() => {
                    write!(text, "<c r=\"{column}{row}\"><v>{number:?}</v></c>")
                }
                Cell::Text(words) => write!(
                    text,
                    "<c r=\"{column}{row}\" t=\"inlineStr\"><is><t xml:space=\"preserve\">{}</t></is></c>",
                    escaped(words)
                ),
                _ => Ok(()),
            };
        }
        text.push_str("</row>");
    }
    text + "</sheetData></worksheet>"
}

/// Escapes text for XML. Characters that XML does not allow are left out.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' | '\n' => out.push(c),
            c if c < ' ' || matches!(c, '\u{fffe}' | '\u{ffff}') => {}
            c => out.push(c),
        }
    }
    out
}
