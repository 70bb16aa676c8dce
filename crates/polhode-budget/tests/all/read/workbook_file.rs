//! Workbooks that are as small as possible.

use std::io::{Cursor, Write as _};

use zip::write::{SimpleFileOptions, ZipWriter};

/// Workbook made of sheets.
#[derive(Default)]
pub(super) struct Book {
    sheets: Vec<(String, String)>,
    strings: Vec<String>,
}

const MAIN: &str = "xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\"";
const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";

impl Book {
    pub(super) fn new() -> Self {
        Self::default()
    }

    /// Adds a sheet of these rows. The prefix of a cell is its type.
    pub(super) fn sheet(self, name: &str, rows: &[&[&str]]) -> Self {
        self.sheet_with(name, rows, "", "", &[])
    }

    /// Adds a sheet with XML before and after its rows, and with hidden rows.
    pub(super) fn sheet_with(
        mut self,
        name: &str,
        rows: &[&[&str]],
        front: &str,
        behind: &str,
        hidden: &[usize],
    ) -> Self {
        let mut xml = format!("<worksheet {MAIN}>{front}<sheetData>");
        for (k, row) in rows.iter().enumerate() {
            let is_hidden = if hidden.contains(&(k + 1)) { " hidden=\"1\"" } else { "" };
            xml += &format!("<row r=\"{}\"{is_hidden}>", k + 1);
            for (column, cell) in row.iter().enumerate() {
                let place = format!("{}{}", char::from(b'A' + u8::try_from(column).unwrap()), k + 1);
                xml += &self.cell(&place, cell);
            }
            xml += "</row>";
        }
        xml += &format!("</sheetData>{behind}</worksheet>");
        self.sheets.push((name.to_owned(), xml));
        self
    }

    /// Changes the XML of all sheets.
    pub(super) fn change(&mut self, change: impl Fn(&str) -> String) {
        self.sheets.iter_mut().for_each(|(_, xml)| *xml = change(xml));
    }

    fn cell(&mut self, place: &str, cell: &str) -> String {
        let number = |style: usize, value: &str| format!("<c r=\"{place}\" s=\"{style}\"><v>{value}</v></c>");
        let escaped = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;");
        match cell.split_once(':') {
            _ if cell.is_empty() => String::new(),
            Some(("date", value)) => number(1, value),
            Some(("percent", value)) => number(2, value),
            Some(("two", value)) => number(3, value),
            Some(("inline", text)) => {
                format!("<c r=\"{place}\" t=\"inlineStr\"><is><t>{}</t></is></c>", escaped(text))
            }
            Some(("rich", text)) => {
                let (a, b) = text.split_at(text.len() / 2);
                self.strings.push(format!(
                    "<si><r><t>{}</t></r><rPh sb=\"0\" eb=\"1\"><t>x</t></rPh><r><t>{}</t></r></si>",
                    escaped(a),
                    escaped(b)
                ));
                format!("<c r=\"{place}\" t=\"s\"><v>{}</v></c>", self.strings.len() - 1)
            }
            Some(("result", value)) => format!("<c r=\"{place}\"><f>SUM(A1:A2)</f><v>{value}</v></c>"),
            _ if cell.starts_with('=') => format!("<c r=\"{place}\"><f>{}</f></c>", &cell[1..]),
            _ if cell.starts_with('#') => format!("<c r=\"{place}\" t=\"e\"><v>{cell}</v></c>"),
            _ if ["TRUE", "FALSE"].contains(&cell) => {
                format!("<c r=\"{place}\" t=\"b\"><v>{}</v></c>", u8::from(cell == "TRUE"))
            }
            _ if cell.parse::<f64>().is_ok() => format!("<c r=\"{place}\"><v>{cell}</v></c>"),
            _ => {
                self.strings.push(format!("<si><t xml:space=\"preserve\">{}</t></si>", escaped(cell)));
                format!("<c r=\"{place}\" t=\"s\"><v>{}</v></c>", self.strings.len() - 1)
            }
        }
    }

    pub(super) fn bytes(&self) -> Vec<u8> {
        let mut entries = vec![(
            "_rels/.rels".to_owned(),
            format!(
                "<Relationships><Relationship Id=\"r1\" Type=\"{OFFICE}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
            ),
        )];
        let mut list = format!("<workbook {MAIN} xmlns:r=\"{OFFICE}\"><sheets>");
        let mut relations = format!(
            "<Relationships><Relationship Id=\"s\" Type=\"{OFFICE}/sharedStrings\" Target=\"sharedStrings.xml\"/>\
             <Relationship Id=\"t\" Type=\"{OFFICE}/styles\" Target=\"/xl/styles.xml\"/>"
        );
        for (k, (name, xml)) in self.sheets.iter().enumerate() {
            let state = if name.starts_with('_') { " state=\"hidden\"" } else { "" };
            list += &format!("<sheet name=\"{name}\" sheetId=\"{}\"{state} r:id=\"r{k}\"/>", k + 1);
            relations += &format!(
                "<Relationship Id=\"r{k}\" Type=\"{OFFICE}/worksheet\" Target=\"worksheets/sheet{k}.xml\"/>"
            );
            entries.push((format!("xl/worksheets/sheet{k}.xml"), xml.clone()));
        }
        entries.push(("xl/workbook.xml".to_owned(), list + "</sheets></workbook>"));
        entries.push(("xl/_rels/workbook.xml.rels".to_owned(), relations + "</Relationships>"));
        entries.push((
            "xl/sharedStrings.xml".to_owned(),
            format!("<sst {MAIN}>{}</sst>", self.strings.concat()),
        ));
        let styles = "<numFmts><numFmt numFmtId=\"164\" formatCode=\"#,##0.00&quot; g&quot;\"/></numFmts>\
                      <cellStyleXfs><xf numFmtId=\"9\"/></cellStyleXfs>\
                      <cellXfs><xf numFmtId=\"0\"/><xf numFmtId=\"14\"/><xf numFmtId=\"10\"/><xf numFmtId=\"164\"/></cellXfs>";
        entries.push(("xl/styles.xml".to_owned(), format!("<styleSheet {MAIN}>{styles}</styleSheet>")));
        zipped(&entries)
    }
}

pub(super) fn zipped(entries: &[(String, String)]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, text) in entries {
        zip.start_file(name.as_str(), SimpleFileOptions::default()).unwrap();
        zip.write_all(text.as_bytes()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}
