//! Findings, for people and for programs.

use polhode::body::Finding;
use serde_json::{Value, json};

use crate::layout::{WIDTH, printable, wrap};

/// `[{"code": …, "severity": …, "message": …, "where": …}, …]`
pub fn to_json(findings: &[Finding]) -> Value {
    let one = |f: &Finding| json!({ "code": f.code, "severity": f.severity.name(), "message": f.message, "where": f.place });
    findings.iter().map(one).collect()
}

/// One paragraph each: `warning: … (where) [code]`; nothing at all where nothing was found.
pub fn to_text(findings: &[Finding]) -> String {
    within(findings, WIDTH)
}

/// The same in so many columns.
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

/// `warning: … (where) [code]` on one line.
pub fn sentence(found: &Finding) -> String {
    let place = found.place.as_ref().map_or_else(String::new, |place| format!(" ({place})"));
    printable(&format!("{}: {}{place} [{}]", found.severity.name(), found.message, found.code))
}
