//! Findings as JSON and as text.

use polhode::body::Finding;
use serde_json::{Value, json};

use crate::layout::{WIDTH, printable, wrap};

/// Returns `[{"code": …, "severity": …, "message": …, "where": …}, …]`.
pub fn to_json(findings: &[Finding]) -> Value {
    let one = |f: &Finding| json!({ "code": f.code, "severity": f.severity.name(), "message": f.message, "where": f.place });
    findings.iter().map(one).collect()
}

/// Returns one paragraph per finding, `warning: … (where) [code]`; empty without findings.
pub fn to_text(findings: &[Finding]) -> String {
    within(findings, WIDTH)
}

/// Returns the findings as [`to_text`] does, wrapped at `columns` columns.
pub fn within(findings: &[Finding], columns: usize) -> String {
    let mut text = String::new();
    for f in findings {
        for (k, line) in wrap(&sentence(f), "", columns.saturating_sub(2)).into_iter().enumerate() {
            text.push_str(if k == 0 { "" } else { "  " });
            text.push_str(&line);
            text.push('\n');
        }
    }
    text
}

/// Returns a finding on one line: `warning: … (where) [code]`.
pub fn sentence(found: &Finding) -> String {
    let place = found.place.as_ref().map_or_else(String::new, |place| format!(" ({place})"));
    printable(&format!("{}: {}{place} [{}]", found.severity.name(), found.message, found.code))
}
