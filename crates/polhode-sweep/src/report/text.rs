//! Summary of a sweep as text and as a document.

use polhode::body::Finding;
use polhode_document::layout::{columns, labelled, plain_spaces, printable};
use polhode_document::number::{count, error, number};
use polhode_document::{Document, Section};

use super::{SweepCorrelation, SweepIntervals, SweepQuestion, SweepShare, SweepStatistic, SweepSummary};

/// Smallest correlation that is shown.
const LEAST_CORRELATION: f64 = 0.1;
/// Correlation from which an outcome is a function of the input alone, up to sampling.
const TRIVIAL_CORRELATION: f64 = 0.995;
const MOST_CORRELATIONS: usize = 6;

/// Outcomes for which only the worst value is shown.
const DRIFT: [&str; 2] = ["energy_drift", "momentum_drift"];
const ERROR: [&str; 2] = ["error_attitude_rad", "error_omega"];

/// Words of inputs, and of outcomes that are the same quantity.
const SAME_QUANTITY: [(&str, &str); 2] = [("spin", "omega"), ("attitude", "attitude")];

/// Headers of a table, after its name.
const HEAD: [&str; 7] = ["mean", "", "min", "5 %", "median", "95 %", "max"];

/// Line with a label; an empty label continues the line before.
type Labelled = (String, String);

/// Returns the summary as text.
pub(crate) fn write(summary: &SweepSummary) -> String {
    let lines = |lines: Vec<Labelled>| -> String {
        lines.iter().map(|(label, line)| labelled(label, line)).collect()
    };
    let mut text = format!("{}   {}\n{}", title(summary), drawn(summary), lines(answers(summary)));
    for Table { name, constant, rows, same } in tables(summary) {
        if !rows.is_empty() {
            let head = std::iter::once(name).chain(HEAD).map(str::to_owned).collect();
            let rows: Vec<Vec<String>> = std::iter::once(head).chain(rows).collect();
            text.push_str(&(columns(&rows).join("\n") + "\n"));
        }
        if !same.is_empty() {
            text.push_str(&labelled(constant, &same));
        }
    }
    text.push_str(&lines(notes(summary)));
    plain_spaces(&text)
}

/// Returns the summary as a document.
pub(crate) fn document(summary: &SweepSummary, findings: Vec<Finding>) -> Document {
    let joined = |(label, line): Labelled| {
        if label.is_empty() { line } else { format!("{label}: {line}") }
    };
    let answer = answers(summary).into_iter().map(joined).chain(std::iter::once(drawn(summary))).collect();
    let mut sections: Vec<Section> = questions(summary).into_iter().collect();
    sections.extend(tables(summary).map(Table::section));
    let mut last = Section::new(0, "Errors and correlations");
    notes(summary).into_iter().map(joined).for_each(|line| last.line(line));
    sections.push(last);
    (1..).zip(&mut sections).for_each(|(k, section)| section.number = k);
    Document { title: title(summary), verdict: None, answer, sections, findings }
}

/// Returns the questions with their conditions and shares; `None` without questions.
fn questions(summary: &SweepSummary) -> Option<Section> {
    let row = |question: &SweepQuestion| {
        let percent = |x: f64| format!("{} %", number(100.0 * x, 4));
        let interval = question.interval.map(|ends| ends.map(percent).join(" … "));
        vec![
            printable(&question.name),
            printable(&question.condition),
            question.share.map_or_else(|| "unknown".to_owned(), percent),
            interval.unwrap_or_default(),
            format!("{} of {}", count(question.count), count(question.of)),
        ]
    };
    let mut section = Section::new(0, "Questions");
    let headers = ["question", "condition", "probability", "confidence interval", "members"];
    section.table(&headers, summary.questions.iter().map(row).collect());
    (!summary.questions.is_empty()).then_some(section)
}

fn title(summary: &SweepSummary) -> String {
    printable(summary.title.as_deref().unwrap_or("sweep"))
}

/// Returns the sampling in words: `1,000 members, Monte Carlo sampling, seed 7`.
fn drawn(summary: &SweepSummary) -> String {
    let noun = if summary.members == 1 { "member" } else { "members" };
    let drawn = match summary.sampling {
        "grid" => " on a grid",
        "monte_carlo" => ", Monte Carlo sampling",
        "latin_hypercube" => ", Latin hypercube sampling",
        _ => ", Sobol sampling",
    };
    let seed = summary.seed.map_or_else(String::new, |seed| format!(", seed {seed}"));
    format!("{} {noun}{drawn}{seed}", count(summary.members))
}

/// Returns the answers to questions, the status of the members, and regimes.
fn answers(summary: &SweepSummary) -> Vec<Labelled> {
    let shares = |shares: &[SweepShare]| shares_of(shares, summary.members);
    let answered = |question: &SweepQuestion| (printable(&question.name), answer(question, summary.members));
    let mut lines: Vec<Labelled> = summary.questions.iter().map(answered).collect();
    lines.push(("status".to_owned(), shares(&summary.statuses)));
    let failed = |(member, cause): &(u64, String)| format!("member {member}: {}", printable(cause));
    lines.extend(summary.failures.iter().map(|failure| (String::new(), failed(failure))));
    if !summary.regimes.is_empty() {
        lines.push(("regime at start".to_owned(), shares(&summary.regimes)));
    }
    if !summary.end_regimes.is_empty() && summary.end_regimes != summary.regimes {
        lines.push(("regime at end".to_owned(), shares(&summary.end_regimes)));
    }
    lines
}

/// Returns the largest errors, the strongest dependencies, and the meaning of the intervals.
fn notes(summary: &SweepSummary) -> Vec<Labelled> {
    let mut lines = Vec::new();
    let mut say = |label: &str, line: String| lines.push((label.to_owned(), line));
    let worst = |name: &str| summary.outcomes.iter().find(|s| s.name == name).and_then(|s| s.max);
    if let [Some(energy), Some(momentum)] = DRIFT.map(worst) {
        let line = format!(
            "energy {}   momentum {}   (relative, largest of all members)",
            error(energy),
            error(momentum)
        );
        say("drift", line.replace("   ", "\u{a0}\u{a0} "));
    }
    if let [Some(attitude), omega] = ERROR.map(worst) {
        let omega = omega.map_or_else(String::new, |omega| format!("   ω {} (relative)", error(omega)));
        let line = format!(
            "attitude {} rad{omega}   (estimated, final state, largest of all members)",
            error(attitude)
        );
        say("error", line.replace("   ", "\u{a0}\u{a0} "));
    }
    let strong = summary.correlations.iter().filter(|c| c.value.abs() >= LEAST_CORRELATION && !is_trivial(c));
    for (k, pair) in strong.take(MOST_CORRELATIONS).enumerate() {
        let (outcome, input) = (printable(&pair.outcome), printable(&pair.input));
        let line = format!("{:+.2}  {outcome} with {input}", pair.value).replacen("  ", "\u{a0} ", 1);
        say(if k == 0 { "rank correlation" } else { "" }, line);
    }
    let note = match summary.intervals {
        SweepIntervals::Given { confidence } => format!(
            "{} % confidence: Student's t for means, Wilson for shares; intervals of quantiles are in summary.json",
            number(100.0 * confidence, 3)
        ),
        SweepIntervals::OfSets { confidence, sets } => format!(
            "{} % confidence, from the differences between {sets} independent sets of members; none for quantiles",
            number(100.0 * confidence, 3)
        ),
        SweepIntervals::None { why } => format!("no confidence intervals: {why}"),
    };
    say("intervals", note);
    lines
}

/// Returns true if the outcome is the same quantity as the input, and follows it throughout.
fn is_trivial(pair: &SweepCorrelation) -> bool {
    let has = |name: &str, word: &str| name.split('_').any(|part| part == word);
    pair.value.abs() >= TRIVIAL_CORRELATION
        && SAME_QUANTITY.iter().any(|(input, outcome)| has(&pair.input, input) && has(&pair.outcome, outcome))
}

/// Returns an answer in words: `12.3 % (10.9 … 13.8 %) have largest_angle > 90 deg: 123 of 1,000`.
fn answer(question: &SweepQuestion, members: u64) -> String {
    let condition = printable(&question.condition);
    let Some(share) = question.share else {
        return format!("unknown: no member has a value in every column of {condition}");
    };
    let percent = |x: f64| number(100.0 * x, 4);
    let interval = question
        .interval
        .map_or_else(String::new, |[low, high]| format!(" ({} … {} %)", percent(low), percent(high)));
    let lacking = match members.saturating_sub(question.of) {
        0 => String::new(),
        1 => "; 1 member lacks a value".to_owned(),
        without => format!("; {} members lack a value", count(without)),
    };
    let (yes, of) = (count(question.count), count(question.of));
    format!("{} %{interval} have {condition}: {yes} of {of}{lacking}", percent(share))
}

/// Returns shares in words: `complete 998 (99.8 %, 99.3 … 99.9 %), failed 2 (0.2 %)`.
fn shares_of(shares: &[SweepShare], members: u64) -> String {
    let one = |share: &SweepShare| {
        let percent = |x: f64| number(100.0 * x, 5);
        let part = percent(share.count as f64 / members.max(1) as f64);
        let interval = share
            .interval
            .map_or_else(String::new, |[low, high]| format!(", {} … {} %", percent(low), percent(high)));
        format!("{} {} ({part} %{interval})", printable(&share.name), count(share.count))
    };
    shares.iter().map(one).collect::<Vec<_>>().join("; ")
}

/// Table of statistics of inputs, or of outcomes.
struct Table {
    name: &'static str,
    /// Label of the columns that do not vary.
    constant: &'static str,
    /// One row for each column that varies.
    rows: Vec<Vec<String>>,
    /// Columns that do not vary, with their values.
    same: String,
}

impl Table {
    fn section(self) -> Section {
        let title = if self.name == "inputs" { "Inputs" } else { "Outcomes" };
        let mut section = Section::new(0, title);
        let rows: Vec<Vec<String>> =
            self.rows.iter().map(|row| row.iter().map(|cell| cell.trim().to_owned()).collect()).collect();
        if !rows.is_empty() {
            section.table(&[&[self.name][..], &HEAD].concat(), rows);
        }
        if !self.same.is_empty() {
            section.line(format!("{}: {}", self.constant, self.same));
        }
        section
    }
}

fn tables(summary: &SweepSummary) -> [Table; 2] {
    let outcomes = ("outcomes", "constant", &summary.outcomes);
    let inputs = ("inputs", "constant inputs", &summary.inputs);
    [outcomes, inputs].map(|(name, constant, statistics)| {
        let (varying, same): (Vec<_>, Vec<_>) = statistics
            .iter()
            .filter(|s| s.count > 0 && !DRIFT.contains(&s.name.as_str()))
            .partition(|s| s.varies());
        let rows = varying.into_iter().map(|statistic| row(statistic, summary.members)).collect();
        let one = |s: &&SweepStatistic| Some(format!("{}\u{a0}{}", printable(&s.name), number(s.min?, 6)));
        Table { name, constant, rows, same: same.iter().filter_map(one).collect::<Vec<_>>().join(", ") }
    })
}

fn row(statistic: &SweepStatistic, members: u64) -> Vec<String> {
    let shown = |x: Option<f64>| x.map_or_else(String::new, |x| number(x, 4));
    let of = if statistic.count < members { format!(" ({})", count(statistic.count)) } else { String::new() };
    let half = statistic.mean_interval.map(|[low, high]| format!("± {}", number(0.5 * (high - low), 2)));
    let [low, median, high] = [0.05, 0.5, 0.95].map(|p| shown(statistic.quantile(p)));
    vec![
        format!("  {}{of}", printable(&statistic.name)),
        shown(statistic.mean),
        half.unwrap_or_default(),
        shown(statistic.min),
        low,
        median,
        high,
        shown(statistic.max),
    ]
}
