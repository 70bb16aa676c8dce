//! Findings as Python tuples.

use polhode::body::Finding;

/// Finding: code, severity, message, place.
pub(crate) type Remark = (String, String, String, Option<String>);

/// Converts findings in their order.
pub(crate) fn remarks(findings: &[Finding]) -> Vec<Remark> {
    let one = |Finding { code, severity, message, place }: &Finding| {
        ((*code).to_owned(), severity.name().to_owned(), message.clone(), place.clone())
    };
    findings.iter().map(one).collect()
}
