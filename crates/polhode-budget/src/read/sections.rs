//! Sheets other than the parts, as TOML. They are read like the keys of a plan.

use std::ops::Range;

use super::cell::{Cell, Content};
use super::plan;
use super::shape::quoted;
use super::sheet::Sheet;
use polhode_source::FormatError;

/// TOML made of sheets, with the source cell of each part of it.
#[derive(Default)]
pub(crate) struct Sections<'s, 'a> {
    pub(crate) toml: String,
    cells: Vec<(Range<usize>, &'s Sheet<'a>, Cell<'a>)>,
}

/// Name of the sheet with the keys that are not in a table.
const PLAN: &str = "plan";

/// Returns true if a sheet with this name is a section of a plan.
pub(crate) fn is_section(name: &str) -> bool {
    name == PLAN || plan::TABLES.contains(&name) || plan::LISTS.contains(&name)
}

impl<'s, 'a> Sections<'s, 'a> {
    /// Adds a sheet. The sheet of the plan must be the first.
    pub(crate) fn add(&mut self, name: &str, sheet: &'s Sheet<'a>) -> Result<(), FormatError> {
        if plan::LISTS.contains(&name) {
            return self.list(name, sheet);
        }
        if name != PLAN {
            let start = self.toml.len();
            self.toml += &format!("[{name}]\n");
            let first = sheet.rows.first().and_then(|row| sheet.row(row).into_iter().next());
            self.cells.extend(first.map(|cell| (start..self.toml.len(), sheet, cell)));
        }
        for (k, row) in sheet.rows.iter().enumerate() {
            let cells = sheet.row(row);
            let [key, value] = &cells[..] else {
                let cell = cells.get(2).or(cells.first());
                let Some(cell) = cell else { continue };
                let error = sheet.invalid(cell, "the row", "a key and its value, in two cells");
                return Err(error.with_hint("a list in one cell is written as [\"a\", \"b\"]"));
            };
            // Row of headings.
            if k == 0 && ["key", "code"].contains(&key.text.to_lowercase().as_str()) {
                continue;
            }
            let written = if name == PLAN { key_of(&key.text) } else { quoted(&key.text) };
            self.put(&written, sheet, key, value)?;
        }
        Ok(())
    }

    /// Adds a sheet of a list. The first row has the keys, and each other row is an item of the
    /// list.
    fn list(&mut self, name: &str, sheet: &'s Sheet<'a>) -> Result<(), FormatError> {
        let Some((headings, rows)) = sheet.rows.split_first() else { return Ok(()) };
        let keys = sheet.row(headings);
        for row in rows {
            let cells = sheet.row(row);
            let start = self.toml.len();
            self.toml += &format!("[[{name}]]\n");
            self.cells.extend(cells.first().map(|cell| (start..self.toml.len(), sheet, cell.clone())));
            for cell in &cells {
                let Some(key) = keys.iter().find(|key| key.column == cell.column) else {
                    return Err(sheet.invalid(cell, "a cell outside the columns", "under a heading"));
                };
                self.put(&key_of(&key.text), sheet, key, cell)?;
            }
        }
        Ok(())
    }

    fn put(
        &mut self,
        written: &str,
        sheet: &'s Sheet<'a>,
        key: &Cell<'a>,
        value: &Cell<'a>,
    ) -> Result<(), FormatError> {
        for cell in [key, value] {
            if let Content::Broken(broken) = cell.content {
                return Err(sheet.invalid(cell, &key.text, broken.rule()));
            }
        }
        let start = self.toml.len();
        self.toml += written;
        self.cells.push((start..self.toml.len(), sheet, key.clone()));
        self.toml += " = ";
        let start = self.toml.len();
        self.toml += &toml(value);
        self.cells.push((start..self.toml.len(), sheet, value.clone()));
        self.toml.push('\n');
        Ok(())
    }

    /// Moves an error in the TOML to the cell that it is about.
    pub(crate) fn moved(&self, error: FormatError) -> FormatError {
        let Some((_, sheet, _)) = self.cells.first() else { return error };
        error.moved(sheet.path(), |place| {
            let at = |range: &Range<usize>| range.contains(&place.span.start);
            self.cells.iter().find(|(range, ..)| at(range)).map(|(_, sheet, cell)| sheet.spot(cell))
        })
    }
}

/// Returns a key, which may have dots. It is quoted if necessary.
fn key_of(text: &str) -> String {
    let is_bare = text.chars().all(|c| c.is_ascii_alphanumeric() || "_-.".contains(c));
    if is_bare { text.to_owned() } else { quoted(text) }
}

/// Returns the content of a cell as TOML: a number, a truth value, TOML in brackets, or a string.
fn toml(cell: &Cell<'_>) -> String {
    let text = cell.text.as_ref();
    match cell.content {
        Content::Number { .. } if text.ends_with('%') || text.contains(' ') => quoted(text),
        Content::Number { .. } => text.to_owned(),
        _ if ["true", "false"].contains(&text) => text.to_owned(),
        _ if text.starts_with(['[', '{']) => text.replace(['\n', '\r'], " "),
        _ => quoted(text),
    }
}
