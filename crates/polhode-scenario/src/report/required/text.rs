//! Report as text: the answer first, then the facts.

use polhode::motion::Required;
use polhode_document::finding;
use polhode_document::layout::{WIDTH, columns, plain_spaces, printable, wrap};
use polhode_document::number::{count, exact, number};

use super::{DIGITS, RequiredReport, answer, facts};

pub(super) fn write(report: &RequiredReport) -> String {
    let mut lines = vec![heading(report)];
    lines.extend(answer::lines(report).iter().flat_map(|line| wrap(line, "", WIDTH)));
    let facts: String = facts::of(report).iter().map(|facts| facts.to_text(report.is_verbose)).collect();
    let text = format!("{}\n\n{facts}", lines.join("\n"));
    plain_spaces(&text) + &at(report) + &finding::to_text(report.scenario.findings())
}

fn heading(report: &RequiredReport) -> String {
    let time = |s: &Required| number(s.state.time, DIGITS);
    let what = match report.is_run() {
        true => {
            let samples = count(report.samples().len() as u64);
            format!("{} … {} s, {samples} samples", time(report.first()), time(report.last()))
        }
        false => "at the start".to_owned(),
    };
    let title = report.scenario.title().unwrap_or("Torque of a prescribed motion");
    format!("{}   {what}, prescribed motion", printable(title))
}

/// Returns the requested times with all digits, so that each number reads back bit for bit.
fn at(report: &RequiredReport) -> String {
    if report.at.is_empty() {
        return String::new();
    }
    let table = |numbers: &dyn Fn(&Required) -> Vec<f64>| {
        let row = |s: &Required| [s.state.time].into_iter().chain(numbers(s)).map(exact).collect();
        let rows: Vec<Vec<String>> = report.at.iter().map(row).collect();
        columns(&rows).into_iter().map(|line| format!("    {line}\n")).collect::<String>()
    };
    let body = table(&|s| s.torque.to_array().to_vec());
    let space = table(&|s| s.torque_space().to_array().to_vec());
    let power = table(&|s| vec![s.power, s.work_since(&report.start)]);
    format!(
        "\nt in s, N in body axes in N·m: t, x, y, z\n{body}\nt in s, N in space axes in N·m: t, x, y, z\n{space}\n\
         t in s, power in W and work since the start in J: t, N · ω, ∫ N · ω dt\n{power}"
    )
}
