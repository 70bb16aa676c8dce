//! Baseline: a file of known findings, so that only new findings fail.

use std::collections::BTreeSet;
use std::path::Path;

use polhode_source::FormatError;
use polhode_source::json_value;
use polhode_source::{ContentError, ContentErrorKind};
use serde_json::{Value, json};

use super::{Judged, Reason};
use crate::finding::Finding;

/// Key that identifies a baseline, and the version of its format.
const KEY: &str = "polhode_baseline";
const VERSION: u64 = 1;

/// Findings that are already known and do not make a check fail.
#[derive(Clone, Debug, Default)]
pub struct Baseline {
    /// Path of the file, for messages.
    pub file: String,
    /// Findings in file order.
    pub findings: Vec<KnownFinding>,
    ids: BTreeSet<String>,
}

/// Entry of a baseline: a finding that is already known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KnownFinding {
    /// Identifier: a hash of the rule, severity, file and links, in hexadecimal digits.
    pub id: String,
    /// Code of the rule, for readers.
    pub rule: String,
    /// Name of the model file, for readers and to detect files that were not checked.
    pub file: String,
    /// Name of the link or joint, for readers.
    pub link: String,
}

impl Baseline {
    /// Parses a baseline; `path` is for messages.
    ///
    /// # Errors
    /// [`FormatError`] if the text is not JSON, or not in the format that [`text`] writes.
    pub fn read(path: &Path, text: &str) -> Result<Self, FormatError> {
        let refused = |error: ContentError| FormatError::of_content(path, text.as_bytes(), error);
        let value: Value = json_value(text.as_bytes()).map_err(|error| {
            let before: usize =
                text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
            let at = before + error.column().saturating_sub(1);
            let what = format!("a baseline's JSON ({error})");
            let found =
                text.get(at..).and_then(|rest| rest.chars().next()).map(String::from).unwrap_or_default();
            refused(ContentErrorKind::expected(what, found).at(at..at + 1))
        })?;
        let whole = |what: &str, found: &Value| {
            let found = if found.is_null() { "none".to_owned() } else { found.to_string() };
            let kind = ContentErrorKind::expected(what, found);
            refused(kind.of_whole().hint("write the baseline again: --write-baseline FILE"))
        };
        if value[KEY] != VERSION {
            return Err(whole(&format!("{KEY:?}: {VERSION}"), &value[KEY]));
        }
        let Some(findings) = value["findings"].as_array() else {
            return Err(whole("\"findings\": […]", &value["findings"]));
        };
        let known = |value: &Value| {
            let text = |key: &str| value[key].as_str().map(str::to_owned);
            let found = (text("id"), text("rule"), text("file"), text("link"));
            let (Some(id), Some(rule), Some(file), Some(link)) = found else {
                return Err(whole("a finding with \"id\", \"rule\", \"file\" and \"link\"", value));
            };
            Ok(KnownFinding { id, rule, file, link })
        };
        let findings: Vec<KnownFinding> = findings.iter().map(known).collect::<Result<_, _>>()?;
        let ids = findings.iter().map(|known| known.id.clone()).collect();
        Ok(Self { file: path.to_string_lossy().into_owned(), findings, ids })
    }

    pub(super) fn has(&self, id: &str) -> bool {
        self.ids.contains(id)
    }
}

/// Returns the text of a baseline with all open and known findings of these files, and their
/// number. Allowed findings are omitted. Each finding is on one line, sorted.
pub fn text<'a>(judged: impl Iterator<Item = (&'a str, &'a Judged)>) -> (String, usize) {
    let mut lines = BTreeSet::new();
    for (file, judged) in judged {
        let known = judged.settled.iter().filter(|settled| settled.why == Reason::Known);
        let known = known.map(|settled| (&settled.finding, &settled.id));
        for (Finding { code, subject, .. }, id) in judged.open.iter().zip(&judged.ids).chain(known) {
            let value = json!({ "file": file, "rule": code, "link": subject, "id": id });
            lines.insert((file.to_owned(), *code, subject.clone(), value.to_string()));
        }
    }
    let lines: Vec<String> = lines.into_iter().map(|(.., line)| format!("    {line}")).collect();
    let list = if lines.is_empty() { "[]".to_owned() } else { format!("[\n{}\n  ]", lines.join(",\n")) };
    (format!("{{\n  {KEY:?}: {VERSION},\n  \"findings\": {list}\n}}\n"), lines.len())
}
