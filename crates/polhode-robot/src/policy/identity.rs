//! Identifiers of findings. An identifier contains the rule, its default severity, the file, the
//! links, and a counter of equal findings. Line numbers and values are not part of it.

use std::collections::BTreeMap;

use crate::finding::Finding;

/// Returns the identifiers of the findings of a file, in order.
pub(super) fn ids<'a>(file: &str, findings: impl Iterator<Item = &'a Finding>) -> Vec<String> {
    let mut seen: BTreeMap<Vec<&str>, usize> = BTreeMap::new();
    let id = |finding: &'a Finding| {
        let links = std::iter::once(&finding.subject).chain(&finding.others).map(String::as_str);
        let about: Vec<&str> = [finding.code, finding.severity.name()].into_iter().chain(links).collect();
        let count = seen.entry(about.clone()).or_default();
        *count += 1;
        hash([file, &count.to_string()].into_iter().chain(about))
    };
    findings.map(id).collect()
}

/// Returns the 64-bit FNV-1a hash, which is the same on every machine and in every version.
pub(super) fn hash<'a>(parts: impl IntoIterator<Item = &'a str>) -> String {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
    // The byte 0xff separates the parts; it does not occur in UTF-8.
    let bytes = |part: &'a str| part.bytes().chain([0xff]);
    let hash = parts.into_iter().flat_map(bytes).fold(0xcbf2_9ce4_8422_2325, |hash, byte| step(hash, &byte));
    format!("{hash:016x}")
}
