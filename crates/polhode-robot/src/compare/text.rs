//! Text of a comparison: the answer, then each difference with both places, then the notes.

use std::fmt::Write as _;

use polhode_document::layout::{plain_spaces, printable};
use polhode_document::number::number;
use polhode_source::text::counted;

use super::comparison::{Comparison, Summary};
use crate::finding::{Finding, Related, Severity};
use crate::line_index::{FilePlace, Places};
use crate::text::{mark, paragraph, subject};

impl Comparison {
    pub(super) fn text(&self) -> String {
        let mut text = self.answer() + "\n";
        let places = self.model().map(Places::of);
        let findings: Vec<&Finding> = self.differences().chain(self.notes()).collect();
        let subjects = || findings.iter().map(|found| subject(found).chars().count());
        let longest = subjects().filter(|&width| width <= 24).max().unwrap_or(0);
        for (k, found) in findings.iter().enumerate() {
            let is_first_note = found.severity == Severity::Note
                && k.checked_sub(1)
                    .and_then(|k| findings.get(k))
                    .is_some_and(|other| other.severity > Severity::Note);
            let gap = if k == 0 || is_first_note { "\n" } else { "" };
            let of_b =
                places.as_ref().filter(|_| found.span != (0..0)).map(|places| places.place(&found.span));
            let of_b = of_b
                .map(|FilePlace { file, line, column, .. }| format!("{}:{line}:{column}", file.display()));
            let of_a = found
                .related
                .as_ref()
                .map(|Related { file, line, column }| format!("{file}:{line}:{column}"));
            let at: Vec<String> = of_b.into_iter().chain(of_a).map(|place| printable(&place)).collect();
            let (sign, name) = (mark(found.severity), subject(found));
            let _ = writeln!(text, "{gap}{sign} {name:longest$}   {}   [{}]", at.join("   "), found.code);
            paragraph(&mut text, "", &found.message);
        }
        plain_spaces(&text)
    }

    /// Returns the answer to "Are the models equal?", one line.
    fn answer(&self) -> String {
        let [a, b] = &self.summaries;
        let [name_a, name_b] = [a, b].map(|summary| printable(&summary.path));
        let tolerance = number(self.tolerance, 6);
        let sizes = self.sizes();
        match self.differences().count() {
            0 => format!("{name_a} and {name_b} agree within {tolerance}: {sizes}"),
            count => format!("{}: {name_a} and {name_b}, {sizes}", counted(count, "difference")),
        }
    }

    /// Returns the numbers of links and joints, and the mass, of both models where they differ.
    fn sizes(&self) -> String {
        let [a, b] = &self.summaries;
        let count = |of: fn(&Summary) -> usize, noun: &str| match (of(a), of(b)) {
            (one, other) if one == other => counted(one, noun),
            (one, other) => format!("{one} and {}", counted(other, noun)),
        };
        let [of_a, of_b] = [a, b].map(|summary| number(summary.mass, 4));
        let mass = if of_a == of_b { of_a } else { format!("{of_a} and {of_b}") };
        format!("{}, {}, {mass} kg", count(|s| s.links, "link"), count(|s| s.joints, "joint"))
    }
}
