//! SARIF 2.1.0 (OASIS) for GitHub code scanning, Azure DevOps and editors.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use super::{Item, about};
use crate::checked::{Checked, FileChecked};
use crate::finding::{Related, Severity};
use crate::policy::Reason;
use crate::rule::{Rule, rules};

impl Checked {
    /// Returns a log with one run. Columns count characters; allowed and known findings are
    /// suppressed results.
    pub fn to_sarif(&self) -> Value {
        let items: Vec<Item<'_>> = self.items().collect();
        let unreadable: Vec<Value> = self.files.iter().filter_map(notification).collect();
        let left_out = self.left_out().into_iter();
        let left_out = left_out.map(|line| json!({ "level": "note", "message": { "text": line } }));
        json!({
            "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
            "version": "2.1.0",
            "runs": [{
                "tool": { "driver": {
                    "name": "polhode",
                    "semanticVersion": polhode_document::VERSION,
                    "rules": rules().map(descriptor).collect::<Vec<_>>(),
                } },
                "columnKind": "unicodeCodePoints",
                "invocations": [{
                    "executionSuccessful": unreadable.is_empty(),
                    "toolExecutionNotifications": unreadable.iter().cloned().chain(left_out).collect::<Vec<_>>(),
                }],
                "results": items.iter().map(result).collect::<Vec<_>>(),
            }],
        })
    }
}

fn descriptor(rule: &Rule) -> Value {
    json!({
        "id": rule.code,
        "shortDescription": { "text": rule.title },
        "fullDescription": { "text": rule.why },
        "help": { "text": format!("{}\n{}", rule.why, rule.mend), "markdown": rule.to_markdown() },
        "defaultConfiguration": { "level": level(rule.severity) },
    })
}

const fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Impossible => "error",
        Severity::Suspect => "warning",
        Severity::Note => "note",
    }
}

fn result(item: &Item<'_>) -> Value {
    let mut location = json!({
        "physicalLocation": {
            "artifactLocation": { "uri": uri(&item.file) },
            "region": region(item.start, item.end),
        },
    });
    if !item.subject.is_empty() {
        location["logicalLocations"] = json!([{ "name": item.subject, "kind": "element" }]);
    }
    let mut result = json!({
        "ruleId": item.code,
        "level": level(item.severity),
        "message": { "text": about(item) },
        "locations": [location],
        "partialFingerprints": { "polhode/v1": item.id },
    });
    if let Some(index) = rules().position(|rule| rule.code == item.code) {
        result["ruleIndex"] = index.into();
    }
    if let Some(why) = item.settled {
        let justification = match why {
            Reason::Allowed(reason) => reason.as_str(),
            Reason::Known => "known: listed in the baseline",
        };
        result["suppressions"] = json!([{ "kind": "external", "justification": justification }]);
    }
    if let Some(Related { file, line, column }) = item.related {
        result["relatedLocations"] = json!([{
            "message": { "text": "in the first model" },
            "physicalLocation": {
                "artifactLocation": { "uri": uri(file) },
                "region": { "startLine": line, "startColumn": column },
            },
        }]);
    }
    if let Some((description, edits)) = &item.repair {
        let mut changes: BTreeMap<&str, Vec<Value>> = BTreeMap::new();
        for edit in edits {
            let replacement = json!({ "deletedRegion": region(edit.start, edit.end), "insertedContent": { "text": edit.new } });
            changes.entry(&edit.file).or_default().push(replacement);
        }
        let change = |(file, replacements): (&str, Vec<Value>)| json!({ "artifactLocation": { "uri": uri(file) }, "replacements": replacements });
        result["fixes"] = json!([{
            "description": { "text": description },
            "artifactChanges": changes.into_iter().map(change).collect::<Vec<_>>(),
        }]);
    }
    result
}

fn region(start: (usize, usize), end: (usize, usize)) -> Value {
    json!({ "startLine": start.0, "startColumn": start.1, "endLine": end.0, "endColumn": end.1 })
}

/// Returns the notification for a file that could not be read.
fn notification(file: &FileChecked) -> Option<Value> {
    let (message, place) = file.unreadable()?;
    let mut physical = Map::new();
    physical.insert("artifactLocation".to_owned(), json!({ "uri": uri(&file.name) }));
    if let Some([line, column]) = place {
        physical.insert("region".to_owned(), json!({ "startLine": line, "startColumn": column }));
    }
    Some(json!({
        "level": "error",
        "message": { "text": message },
        "locations": [{ "physicalLocation": physical }],
    }))
}

/// Returns a file name as a URI reference. Relative names stay relative.
fn uri(file: &str) -> String {
    let mut uri = String::new();
    if file.starts_with('/') {
        uri.push_str("file://");
    } else if file.split('/').next().is_some_and(|first| first.contains(':')) {
        // Drive letters (C:/robots) need a scheme. Otherwise a first component with a colon would
        // be read as a scheme.
        uri.push_str(if file.get(1..3) == Some(":/") { "file:///" } else { "./" });
    }
    for byte in file.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~/:@!$&'()*+,;=".contains(&byte) {
            uri.push(char::from(byte));
        } else {
            uri.push_str(&format!("%{byte:02X}"));
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_are_references() {
        assert_eq!(uri("src/a b#1.urdf"), "src/a%20b%231.urdf");
        assert_eq!(uri("/src/ä.urdf"), "file:///src/%C3%A4.urdf");
        assert_eq!(uri("C:/arm.urdf"), "file:///C:/arm.urdf");
        assert_eq!(uri("a:b/arm.urdf"), "./a:b/arm.urdf");
    }
}
