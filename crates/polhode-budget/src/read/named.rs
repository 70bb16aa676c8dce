//! TOML plans that refer to a file of parts.

use std::path::Path;

use polhode_source::toml::document;
use polhode_source::toml::reader::Table;
use polhode_source::toml::source::Source;
use polhode_source::{FormatError, FormatErrorKind, Spot};

use super::access::Access;
use super::joined::Naming;
use super::plan;
use super::{BudgetFile, bytes_of, head, of_csv, text, workbook, xlsx};

/// Reads a plan from its text, and the parts that it refers to.
pub(crate) fn of_plan(path: &Path, plan_text: &str, access: Access<'_>) -> Result<BudgetFile, FormatError> {
    let source = Source::new(access.files, path, plan_text);
    let entries = document(source)?;
    let root = Table::root(source, &entries);
    let value = root.require("parts", "parts = \"parts.csv\"")?;
    if value.string()?.is_empty() || value.string()?.to_ascii_lowercase().ends_with(".toml") {
        return Err(value.invalid("a file of parts, CSV or XLSX"));
    }
    let naming = Naming { source, entries: &entries };
    // Errors in the plan itself are reported before errors in the file of parts.
    root.allow(&[&plan::KEYS[..], &["parts"]].concat())?;
    let file = value.path()?;
    let bytes = bytes_of(access.files, &file).map_err(|error| match error.kind() {
        kind @ FormatErrorKind::Io { .. } => value
            .error(kind.clone())
            .with_hint(format!("paths are relative to the plan: this one is {file:?}")),
        _ => error,
    })?;
    let read = || {
        if xlsx::is_archive(&bytes) {
            return workbook::read(&file, &bytes, Some(&naming), access);
        }
        let files = access.of(&file);
        let parts = Source::new(&files, &file, text(&file, &bytes)?);
        let (toml, from) = head::toml(parts)?;
        // The TOML keeps the positions of the head in the file, and errors show the file's own
        // lines.
        let shown = |error: FormatError| {
            let is_syntax = matches!(error.kind(), FormatErrorKind::Toml { .. });
            let error = error.moved(&file, |place| Some(Spot::Text(parts.place(place.span.clone()))));
            if is_syntax { error.with_hint(head::SYNTAX) } else { error }
        };
        let plan = naming.plan(Source { text: &toml, ..parts }, None, &shown)?;
        of_csv(parts, from, plan, access)
    };
    // The error of a key that is in both already has its place in the plan.
    let is_open = |error: &FormatError| error.path() == file && error.origin().is_none();
    read().map_err(|error| if is_open(&error) { error.named_in(path, value.place()) } else { error })
}
