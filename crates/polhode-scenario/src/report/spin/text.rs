//! Text of a free motion: the answer first, then the facts.

use polhode::motion::FreeMotion;
use polhode_document::SourceInfo;
use polhode_document::finding;
use polhode_document::layout::{WIDTH, labelled, plain_spaces, wrap};
use polhode_document::sparkline::Sparkline;

use super::{SpinReport, facts, states};
use crate::report::answer;
use crate::report::free_facts::FreeFacts;

/// Returns the text of the motion, with a picture of ω that is `picture` columns wide if it is
/// `Some`.
pub(super) fn write(report: &SpinReport, picture: Option<usize>) -> String {
    let free = FreeFacts::of(report.motion);
    let mut text = head(report.source.as_ref(), "Free motion", &answer::free_motion(&free));
    text.extend(picture.map(|columns| curve(&free.motion, columns)));
    text.extend(facts::of(report, &free).iter().map(|facts| facts.to_text(report.is_verbose)));
    plain_spaces(&text) + &states::to_text(&report.states) + &finding::to_text(&report.findings)
}

/// Returns the source with its title, or else this title, and the answer.
pub(super) fn head(source: Option<&SourceInfo>, title: &str, answer: &str) -> String {
    let title = source.map_or_else(|| title.to_owned(), SourceInfo::heading);
    [vec![title], wrap(answer, "", WIDTH), vec![String::new()]].concat().join("\n") + "\n"
}

/// Returns two periods of the component of ω along a principal axis that varies most.
fn curve(motion: &FreeMotion, columns: usize) -> String {
    const PERIODS: f64 = 2.0;
    let Some(period) = motion.period() else { return String::new() };
    let into = motion.principal().rotation().inverse();
    let at = |k: usize| motion.start().time + PERIODS * period * (k as f64 / (columns - 1) as f64);
    let omega: Vec<[f64; 3]> = (0..columns).map(|k| (into * motion.at(at(k)).omega).to_array()).collect();
    let line = Sparkline::of_omega(&omega, columns);
    line.map_or_else(String::new, |spark| {
        labelled(&spark.label(motion.principal()), &format!("{}  2 periods", spark.line)) + "\n"
    })
}
