//! Parts lists in workbooks: a sheet of parts, and a sheet for each section of a plan.

use std::path::Path;

use polhode_source::FormatError;
use polhode_source::toml::document;
use polhode_source::toml::reader::Table;
use polhode_source::toml::source::Source;
use polhode_source::{ContentError, ContentErrorKind};

use super::access::Access;
use super::heading::Columns;
use super::joined::Naming;
use super::plan::table_file::Sheets;
use super::plan::{self, Plan};
use super::sections::{Sections, is_section};
use super::sheet::Sheet;
use super::xlsx::Workbook;
use super::{BudgetFile, of_table, unused};

/// Name of the sheet of parts, if there are other sheets.
const PARTS: &str = "parts";

/// Reads a workbook. If a plan refers to it, its statements are joined with those of the sheets.
pub(crate) fn read(
    path: &Path,
    bytes: &[u8],
    told: Option<&Naming<'_>>,
    access: Access<'_>,
) -> Result<BudgetFile, FormatError> {
    let fail = |error| FormatError::of_content(path, bytes, error);
    let workbook = Workbook::read(bytes).map_err(fail)?;
    let names = workbook.names();
    let sheet = |name: &str| Sheet::of_workbook(&workbook, path, name);
    let (sections, others): (Vec<&str>, Vec<&str>) = names.iter().copied().partition(|name| is_section(name));
    let sheets: Vec<(&str, Sheet<'_>)> =
        sections.iter().filter_map(|name| Some((*name, sheet(name)?.0))).collect();
    let plan = of_sections(path, &sheets, told, access, &sheet)?;
    let wanted: Vec<&str> = others
        .into_iter()
        .filter(|name| !plan.ignore.iter().any(|other| other == name) && !plan.has_sheet(name))
        .collect();
    let name = match wanted[..] {
        [one] => one,
        [] => return Err(fail(ContentError::missing(format!("sheet \"{PARTS}\"")))),
        _ => {
            let others: Vec<&str> = wanted.iter().copied().filter(|name| *name != PARTS).collect();
            let question = format!("which of the sheets {} has the parts?", wanted.join(", "));
            let kind = ContentErrorKind::Unclear { question, found: String::new() };
            let hint = format!(
                "name it \"{PARTS}\", and list the others as ignore = {:?} in the sheet \"plan\"",
                others
            );
            return Err(fail(ContentError::of_file(kind).hint(hint)));
        }
    };
    let Some((mut parts, mut lines)) = sheet(name) else {
        return Err(fail(ContentError::missing(format!("sheet \"{name}\""))));
    };
    let not_read: Vec<&str> =
        names.into_iter().filter(|name| plan.ignore.iter().any(|other| other == name)).collect();
    if !not_read.is_empty() {
        lines.push(format!("ignored sheets: {}", not_read.join(", ")));
    }
    let columns = Columns::of(&parts, &plan.ignore)?;
    unused::ignored(&columns, &plan, &not_read)?;
    parts.decimal_comma = plan.decimal_comma.unwrap_or(false);
    of_table(plan, &parts, &columns, lines, access)
}

fn of_sections(
    path: &Path,
    sheets: &[(&str, Sheet<'_>)],
    told: Option<&Naming<'_>>,
    access: Access<'_>,
    all: &Sheets<'_>,
) -> Result<Plan, FormatError> {
    let mut sections = Sections::default();
    // Keys outside tables come before tables.
    let (first, then): (Vec<_>, Vec<_>) = sheets.iter().partition(|(name, _)| *name == "plan");
    for (name, sheet) in first.into_iter().chain(then) {
        sections.add(name, sheet)?;
    }
    let files = access.of(path);
    let source = Source::new(&files, path, &sections.toml);
    let tables = |name: &str| if is_section(name) { None } else { all(name) };
    if let Some(told) = told {
        return told.plan(source, Some(&tables), &|error| sections.moved(error));
    }
    let read = || {
        let entries = document(source)?;
        plan::plan(&Table::root(source, &entries), &[], Some(&tables))
    };
    match read() {
        Ok(plan) => Ok(plan.moved(|error| sections.moved(error))),
        Err(error) => Err(sections.moved(error)),
    }
}
