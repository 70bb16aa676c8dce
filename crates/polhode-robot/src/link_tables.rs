//! Tables of the links of several robots, as text, JSON and CSV.

use std::path::{Path, PathBuf};

use polhode_document::layout::printable;
use polhode_document::{Document, Report};
use polhode_shape::{failed, noticed};
use polhode_source::{Failure, shown};
use serde_json::Value;

use crate::link_table::LinkTable;

/// Tables of links, in the order of the files.
#[derive(Debug)]
pub struct LinkTables(pub Vec<(PathBuf, Result<LinkTable, Failure>)>);

impl LinkTables {
    fn tables(&self) -> impl Iterator<Item = (&Path, &LinkTable)> {
        self.0.iter().filter_map(|(file, table)| Some((file.as_path(), table.as_ref().ok()?)))
    }

    /// Returns one CSV table of all links; empty if there are none.
    pub fn to_csv(&self) -> String {
        let rows: String = self.tables().map(|(_, table)| table.to_csv()).collect();
        if rows.is_empty() { rows } else { LinkTable::csv_head() + &rows }
    }

    /// Returns the notes as text lines; [`LinkTables::to_csv`] has no column for them.
    pub fn noticed(&self) -> String {
        let of = |(file, table): (&Path, &LinkTable)| {
            let description = printable(&table.whole.source.description);
            let findings: String = table.findings().iter().map(|finding| noticed(file, finding)).collect();
            format!("info: {}: {description}\n{findings}", shown(file))
        };
        self.tables().map(of).collect()
    }
}

impl Report for LinkTables {
    /// Returns an object for one file, and a list for several. A file that failed has an object
    /// with its error.
    fn to_json(&self) -> Value {
        let value = |(file, table): &(PathBuf, Result<LinkTable, Failure>)| match table {
            Ok(table) => table.to_json(),
            Err(failure) => failed(file, failure),
        };
        match self.0.as_slice() {
            [one] => value(one),
            several => several.iter().map(value).collect(),
        }
    }

    fn to_document(&self) -> Document {
        Document::of_text("Links of robots", &self.to_text(None))
    }

    fn to_text(&self, _columns: Option<usize>) -> String {
        self.tables().map(|(_, table)| table.to_text()).collect::<Vec<_>>().join("\n")
    }
}
