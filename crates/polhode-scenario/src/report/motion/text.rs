//! Text of a motion: the answer first, then the facts.

use polhode_document::fact::Facts;
use polhode_document::finding;
use polhode_document::layout::{WIDTH, labelled, plain_spaces, printable, wrap};
use polhode_document::number::{count, number};
use polhode_document::sparkline::Sparkline;
use polhode_document::unit::duration;

use super::MotionReport;
use crate::report::answer;
use crate::report::facts::{self, Known, solved_by, state_at};

/// Returns the text of the motion, with a picture of ω that is `picture` columns wide.
pub(crate) fn write(report: &MotionReport<'_>, picture: usize) -> String {
    let known = Known::of(report.scenario, report.trajectory);
    let mut lines = vec![heading(report, &known)];
    lines.extend(answer::lines(&known).iter().flat_map(|line| wrap(line, "", WIDTH)));
    let mut text = lines.join("\n") + "\n\n" + &curve(&known, picture);
    text.extend(facts::of(&known).iter().map(|facts| facts.to_text(report.is_verbose)));
    text.extend(report.at.iter().map(|sample| {
        let title = format!("t = {} s", number(sample.state.time, 9));
        Facts::new(title, state_at(&known, sample)).to_text(true)
    }));
    plain_spaces(&(text + &finding::to_text(&report.findings())))
}

/// Returns the heading, such as `T-handle in free fall   0 … 20 s, 2,001 samples, closed form`.
fn heading(report: &MotionReport<'_>, known: &Known<'_>) -> String {
    let title = printable(report.scenario.title().unwrap_or(&report.source.path));
    let how = solved_by(known);
    let Some([first, last]) = known.ends() else { return format!("{title}   no samples, {how}") };
    let (from, to) = (number(first.state.time, 6), duration(last.state.time, 6));
    let samples = report.trajectory.samples().len();
    let noun = if samples == 1 { "sample" } else { "samples" };
    format!("{title}   {from} … {to}, {} {noun}, {how}", count(samples as u64))
}

/// Returns the curve of the component of ω along a principal axis that varies most.
fn curve(known: &Known<'_>, columns: usize) -> String {
    let samples = known.trajectory.samples();
    let to_principal = known.principal.rotation().inverse();
    let omega: Vec<[f64; 3]> = samples.iter().map(|s| (to_principal * s.state.omega).to_array()).collect();
    let Some(spark) = Sparkline::of_omega(&omega, columns) else { return String::new() };
    let until = match samples.get(spark.values) {
        Some(sample) => format!("  to {} s", number(sample.state.time, 3)),
        None => String::new(),
    };
    labelled(&spark.label(&known.principal), &format!("{}{until}", spark.line)) + "\n"
}
