//! XLSX workbooks: sheets of cells with their positions, as spreadsheet programs show them.
//!
//! Nothing is computed. A formula has the result that is stored with it; without a result, it is an
//! error where its value is needed.
//!
//! Source: ECMA-376, Office Open XML, part 1, SpreadsheetML.

pub(crate) mod cells;
mod format;
mod plain;
mod strings;
mod value;

use polhode_source::ContentError;
use polhode_source::package::archive::Archive;
use polhode_source::package::relation::{Relation, relations};
use polhode_source::package::xml::{Token, Xml};

use super::cell::SheetRow;
use cells::RawSheet;
use strings::Strings;

pub(crate) use cells::Cells;

/// Contents of a workbook.
#[derive(Debug)]
pub(crate) struct Workbook {
    strings: Strings,
    sheets: Vec<NamedSheet>,
}

#[derive(Debug)]
struct NamedSheet {
    name: String,
    is_hidden: bool,
    raw: RawSheet,
}

/// Returns true if the bytes are an archive, such as an XLSX workbook.
pub(crate) fn is_archive(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04")
}

/// Returns true if the bytes are a workbook from before 2007, or one with a password.
pub(crate) fn is_compound(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\xd0\xcf\x11\xe0")
}

impl Workbook {
    /// Reads the bytes of a workbook.
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, ContentError> {
        let mut archive = Archive::open(bytes)?;
        let root = of_kind(&relations(&mut archive, "_rels/.rels")?, "officeDocument", "");
        let path = root.filter(|path| archive.has(path)).ok_or_else(|| {
            ContentError::missing("workbook")
                .hint("it is a ZIP archive without sheets: polhode budget reads CSV, XLSX and TOML")
        })?;
        let (folder, file) = path.rsplit_once('/').unwrap_or(("", &path));
        let related = relations(&mut archive, &joined(folder, &format!("_rels/{file}.rels")))?;
        let strings = match of_kind(&related, "sharedStrings", folder) {
            Some(path) => strings::read(Xml::new(archive.stream(&path)?, &path))?,
            None => Strings::default(),
        };
        let formats = match of_kind(&related, "styles", folder) {
            Some(path) => format::read(Xml::new(archive.stream(&path)?, &path))?,
            None => Vec::new(),
        };
        let listed = sheets(Xml::new(archive.stream(&path)?, &path))?;
        let mut sheets = Vec::new();
        for Listed { name, id, is_hidden } in listed {
            let relation = related.iter().find(|relation| relation.id == id);
            let Some(relation) = relation.filter(|relation| relation.kind.ends_with("/worksheet")) else {
                // A chart sheet has no cells.
                continue;
            };
            let path = joined(folder, &relation.target);
            let raw = RawSheet::read(Xml::new(archive.stream(&path)?, &path), &formats, &strings)?;
            sheets.push(NamedSheet { name, is_hidden, raw });
        }
        Ok(Self { strings, sheets })
    }

    /// Returns the names of the sheets that are not empty.
    pub(crate) fn names(&self) -> Vec<&str> {
        self.sheets.iter().filter(|sheet| !sheet.raw.is_empty()).map(|sheet| sheet.name.as_str()).collect()
    }

    /// Returns the rows and the cells of a sheet, with statements for the report.
    pub(crate) fn sheet(&self, name: &str) -> Option<(&[SheetRow], Cells<'_>, Vec<String>)> {
        let named = self.sheets.iter().find(|sheet| sheet.name == name)?;
        let mut lines = Vec::new();
        if named.is_hidden {
            lines.push(format!("hidden sheet that was read: {name}"));
        }
        lines.extend(named.raw.hidden_columns());
        Some((named.raw.rows(), Cells::of(&named.raw, &self.strings), lines))
    }
}

/// Sheet in the list of a workbook.
struct Listed {
    name: String,
    id: String,
    is_hidden: bool,
}

fn sheets(mut xml: Xml<'_, '_>) -> Result<Vec<Listed>, ContentError> {
    let mut all = Vec::new();
    let mut buffer = Vec::new();
    loop {
        match xml.next(&mut buffer)? {
            Token::Start(element) if element.local_name().into_inner() == "sheet" => {
                let mut sheet = Listed { name: String::new(), id: String::new(), is_hidden: false };
                for attribute in xml.attributes(&element) {
                    let attribute = attribute?;
                    let value = xml.value(&attribute)?.into_owned();
                    match attribute.key.local_name().into_inner() {
                        "name" => sheet.name = value,
                        "id" => sheet.id = value,
                        "state" => sheet.is_hidden = value != "visible",
                        _ => {}
                    }
                }
                all.push(sheet);
            }
            Token::Eof => return Ok(all),
            Token::Start(_) | Token::Text(_) | Token::End | Token::Other => {}
        }
    }
}

/// Returns the path of the entry of a kind, which is the last word of the relation's address.
fn of_kind(relations: &[Relation], kind: &str, folder: &str) -> Option<String> {
    let is_kind = |relation: &&Relation| relation.kind.rsplit('/').next() == Some(kind);
    relations.iter().find(is_kind).map(|relation| joined(folder, &relation.target))
}

/// Joins a folder and a name. A name that begins at the root stays as it is.
fn joined(folder: &str, name: &str) -> String {
    match name.strip_prefix('/') {
        Some(name) => name.to_owned(),
        None if folder.is_empty() => name.to_owned(),
        None => format!("{folder}/{name}"),
    }
}
