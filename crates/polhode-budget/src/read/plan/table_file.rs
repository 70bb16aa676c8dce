//! Source of the table of a liquid: the plan, a CSV that it refers to, or a sheet of its workbook.

use std::path::PathBuf;

use polhode_source::text::counted;
use polhode_source::toml::reader::Value;
use polhode_source::toml::source::Source;
use polhode_source::{FormatError, FormatErrorKind};

use super::states::{is_of_mass, of_sheet, of_tables};
use crate::read::sheet::Sheet;
use crate::read::{bytes_of, csv, text};
use crate::{LiquidTable, ProductSign};

/// Function that returns a sheet of a workbook by its name, with statements for the report.
pub(crate) type Sheets<'a> = dyn Fn(&str) -> Option<(Sheet<'a>, Vec<String>)> + 'a;

/// File or sheet that was read.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ReadTable {
    pub from: TableOrigin,
    /// Statements for the report, one sentence each.
    pub lines: Vec<String>,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum TableOrigin {
    File(PathBuf),
    Sheet(String),
}

pub(crate) fn table_of(
    value: &Value<'_>,
    sign: Option<ProductSign>,
    decimal_comma: Option<bool>,
    sheets: Option<&Sheets<'_>>,
) -> Result<(LiquidTable, Option<ReadTable>), FormatError> {
    let Ok(name) = value.string().map(str::trim) else { return Ok((of_tables(value, sign)?, None)) };
    let said = |sheet: &Sheet<'_>| counted(sheet.rows.len().saturating_sub(1), "row");
    if name.to_ascii_lowercase().ends_with(".csv") {
        let path = value.path()?;
        let bytes = bytes_of(value.files(), &path).map_err(|error| match error.kind() {
            kind @ FormatErrorKind::Io { .. } => value
                .error(kind.clone())
                .with_hint(format!("paths are relative to the file that names them: this one is {path:?}")),
            _ => error,
        })?;
        let read = || {
            let (mut sheet, _) =
                csv::sheet(Source::new(value.files(), &path, text(&path, &bytes)?), 0, is_of_mass)?;
            sheet.decimal_comma = decimal_comma.unwrap_or(false);
            Ok((of_sheet(&sheet, sign)?, vec![format!("{} of tank contents", said(&sheet))]))
        };
        let named = |error: FormatError| error.named_in(value.source().path, value.place());
        let (table, lines) = read().map_err(named)?;
        return Ok((table, Some(ReadTable { from: TableOrigin::File(path), lines })));
    }
    let rule = if sheets.is_some() { "a file of CSV, or the name of a sheet" } else { "a file of CSV" };
    let Some((mut sheet, mut lines)) = sheets.and_then(|sheets| sheets(name)) else {
        return Err(value
            .invalid(rule)
            .with_hint("or write its rows here: [[tank.table]], with mass and center"));
    };
    sheet.decimal_comma = decimal_comma.unwrap_or(false);
    let table = of_sheet(&sheet, sign)?;
    lines.push(format!("the sheet {name}: {} of tank contents", said(&sheet)));
    Ok((table, Some(ReadTable { from: TableOrigin::Sheet(name.to_owned()), lines })))
}
