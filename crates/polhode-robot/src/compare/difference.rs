//! Findings of a comparison: at a place in the second model, with the place in the first.

use polhode_document::number::number;

use super::robot::Robot;
use crate::finding::{Finding, Related, Severity};
use crate::line_index::FilePlace;
use crate::model::Span;
use crate::rule::rule;

/// Codes of differences.
pub(super) const MASS: &str = "compare.mass";
pub(super) const CENTER: &str = "compare.center";
pub(super) const TENSOR: &str = "compare.tensor";
pub(super) const JOINT: &str = "compare.joint";
pub(super) const LINK: &str = "compare.link";
/// Codes of notes.
pub(super) const FRAME: &str = "compare.frame";
pub(super) const ZERO: &str = "compare.zero";
pub(super) const NAME: &str = "compare.name";
pub(super) const SKIPPED: &str = "compare.skipped";

/// Both models, with their names in messages.
#[derive(Debug)]
pub(super) struct Sides<'r, 'm> {
    pub(super) a: &'r Robot<'m>,
    pub(super) b: &'r Robot<'m>,
    pub(super) name_a: String,
    pub(super) name_b: String,
}

impl Sides<'_, '_> {
    /// Creates a finding. `span` is in the second model, `related` in the first.
    pub(super) fn finding(
        &self,
        code: &'static str,
        subject: &str,
        [span, related]: [Option<Span>; 2],
        message: String,
    ) -> Finding {
        let rule = rule(code);
        let severity = rule.map_or(Severity::Suspect, |rule| rule.severity);
        let title = rule.map_or("", |rule| rule.title);
        let related = related.map(|span| {
            let FilePlace { file, line, column, .. } = self.a.place(&span);
            Related { file: file.display().to_string(), line, column }
        });
        let found = Finding::new(code, severity, subject, span.unwrap_or(0..0), message, title);
        Finding { related, ..found }
    }
}

/// Formats two numbers with enough digits that different numbers differ.
pub(super) fn two(a: f64, b: f64) -> [String; 2] {
    two_lists(&[a], &[b], "")
}

/// Formats two points with enough digits that they differ.
pub(super) fn two_points(a: [f64; 3], b: [f64; 3]) -> [String; 2] {
    two_lists(&a, &b, ", ").map(|list| format!("({list})"))
}

/// Formats two lists with enough digits that different lists differ.
pub(super) fn two_lists(a: &[f64], b: &[f64], separator: &str) -> [String; 2] {
    let list = |numbers: &[f64], digits: usize| {
        numbers.iter().map(|x| number(*x, digits)).collect::<Vec<_>>().join(separator)
    };
    let with = |digits: usize| [list(a, digits), list(b, digits)];
    [6, 9, 12].into_iter().map(with).find(|[a, b]| a != b).unwrap_or_else(|| with(17))
}

/// Formats a length: m, mm or µm.
pub(super) fn distance(length: f64) -> String {
    match length {
        0.1.. => format!("{} m", number(length, 4)),
        1e-4.. => format!("{} mm", number(1e3 * length, 4)),
        _ => format!("{} µm", number(1e6 * length, 4)),
    }
}

/// Formats an angle in degrees; small ones in rad.
pub(super) fn angle(angle: f64) -> String {
    if angle < 1e-4 {
        format!("{} rad", number(angle, 4))
    } else {
        format!("{}°", number(angle.to_degrees(), 4))
    }
}

/// Joins names: `"a", "b" and "c"`
pub(super) fn listed(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("{name:?}")).collect();
    match quoted.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        _ => quoted.concat(),
    }
}
