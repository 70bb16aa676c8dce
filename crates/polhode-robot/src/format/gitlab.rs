//! Code quality report of GitLab, a subset of the Code Climate format.

use serde_json::{Value, json};

use super::{Item, about};
use crate::checked::Checked;
use crate::finding::Severity;

impl Checked {
    /// Returns the list of findings that count. GitLab shows those that are new compared with the
    /// target branch.
    pub fn to_gitlab(&self) -> Value {
        let unreadable = self.files.iter().filter_map(|file| {
            let (message, place) = file.unreadable()?;
            let id = format!("unreadable:{}", file.name);
            let line = place.map_or(1, |[line, _]| line);
            Some(issue(&message, "unreadable", &id, "blocker", &file.name, line))
        });
        let items: Vec<Item<'_>> = self.items().collect();
        let open = items.iter().filter(|item| item.settled.is_none()).map(|item| {
            let severity = match item.severity {
                Severity::Impossible => "critical",
                Severity::Suspect => "major",
                Severity::Note => "info",
            };
            issue(&about(item), item.code, &item.id, severity, &item.file, item.start.0)
        });
        unreadable.chain(open).collect()
    }
}

fn issue(
    description: &str,
    check: &str,
    fingerprint: &str,
    severity: &str,
    path: &str,
    line: usize,
) -> Value {
    json!({
        "description": description,
        "check_name": check,
        "fingerprint": fingerprint,
        "severity": severity,
        "location": { "path": path, "lines": { "begin": line } },
    })
}
