//! Plans, TOML, that name the file of their parts.

use std::collections::BTreeSet;
use std::path::Path;

use super::{BudgetFile, bytes_of, head, of_csv, plan, text, workbook, xlsx};
use crate::error::{FormatError, FormatErrorKind};
use crate::scenario::document;
use crate::scenario::reader::Table;
use crate::scenario::source::Source;

/// Reads a plan from its text, and the parts that it names.
pub(super) fn of_plan(path: &Path, plan_text: &str, is_alone: bool) -> Result<BudgetFile, FormatError> {
    let nothing = BTreeSet::new();
    let files = is_alone.then_some(&nothing);
    let source = Source { files, ..Source::new(path, plan_text) };
    let entries = document(source)?;
    let root = Table::root(source, &entries);
    let plan = plan::plan(&root, &["parts"], None)?;
    let value = root.require("parts", "parts = \"parts.csv\"")?;
    if value.string()?.is_empty() || value.string()?.to_ascii_lowercase().ends_with(".toml") {
        return Err(value.invalid("a file of parts, CSV or XLSX"));
    }
    let file = value.path()?;
    let bytes = bytes_of(&file).map_err(|error| match error.kind() {
        kind @ FormatErrorKind::Io { .. } => value
            .error(kind.clone())
            .with_hint(format!("paths are relative to the plan: this one is {file:?}")),
        _ => error,
    })?;
    let read = || {
        if xlsx::is_archive(&bytes) {
            return workbook::read(&file, &bytes, Some(plan), is_alone);
        }
        let parts = Source::new(&file, text(&file, &bytes)?);
        let (toml, from) = head::toml(parts)?;
        if !toml.trim().is_empty() {
            let start = toml.len() - toml.trim_start().len();
            let kind = FormatErrorKind::Value {
                key: "the head".to_owned(),
                value: toml.trim_start().lines().next().unwrap_or_default().trim().to_owned(),
                rule: "left out where a plan names the file: the plan says it".to_owned(),
            };
            return Err(parts.error(start..start, kind));
        }
        of_csv(parts, from, plan)
    };
    read().map_err(|error| if error.path() == file { error.named_in(path, value.place()) } else { error })
}
