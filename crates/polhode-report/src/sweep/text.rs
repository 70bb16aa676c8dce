//! A sweep on one screen.

use polhode_document::layout::{columns, labelled, plain_spaces, printable};
use polhode_document::number::{count, error, number, ungrouped};

use super::{SweepIntervals, SweepQuestion, SweepShare, SweepStatistic, SweepSummary};

/// Dependencies that are shown: weaker ones say little.
const LEAST_CORRELATION: f64 = 0.1;
const MOST_CORRELATIONS: usize = 6;

/// What only its worst says something of.
const DRIFT: [&str; 2] = ["energy_drift", "momentum_drift"];
const ERROR: [&str; 2] = ["error_attitude_rad", "error_omega"];

pub(super) fn write(summary: &SweepSummary) -> String {
    let title = printable(summary.title.as_deref().unwrap_or("sweep"));
    let noun = if summary.members == 1 { "member" } else { "members" };
    let drawn = match summary.sampling {
        "grid" => "on a grid",
        "monte_carlo" => "drawn independently",
        "latin_hypercube" => "in a Latin hypercube",
        _ => "at Sobol points",
    };
    let seed = summary.seed.map_or_else(String::new, |seed| format!(", seed {seed}"));
    let mut text = format!("{title}   {} {noun} {drawn}{seed}\n", count(summary.members));
    text.push_str(&labelled("status", &shares(&summary.statuses, summary.members)));
    for (member, cause) in &summary.failures {
        text.push_str(&labelled("", &format!("member {member}: {}", printable(cause))));
    }
    for question in &summary.questions {
        text.push_str(&labelled(&printable(&question.name), &answer(question, summary.members)));
    }
    if !summary.regimes.is_empty() {
        text.push_str(&labelled("free motion", &shares(&summary.regimes, summary.members)));
    }
    if !summary.end_regimes.is_empty() && summary.end_regimes != summary.regimes {
        text.push_str(&labelled("at the end", &shares(&summary.end_regimes, summary.members)));
    }
    text.push_str(&table(summary));
    let worst = |name: &str| summary.outcomes.iter().find(|s| s.name == name).and_then(|s| s.max);
    if let [Some(energy), Some(momentum)] = DRIFT.map(worst) {
        let line =
            format!("energy {}   momentum {}   (relative, worst member)", error(energy), error(momentum));
        text.push_str(&labelled("drift", &line.replace("   ", "\u{a0}\u{a0} ")));
    }
    if let [Some(attitude), omega] = ERROR.map(worst) {
        let omega = omega.map_or_else(String::new, |omega| format!("   ω {} of itself", error(omega)));
        let line =
            format!("attitude {} rad{omega}   (estimate, at the end of the worst member)", error(attitude));
        text.push_str(&labelled("error", &line.replace("   ", "\u{a0}\u{a0} ")));
    }
    let strong = summary.correlations.iter().filter(|c| c.value.abs() >= LEAST_CORRELATION);
    for (k, pair) in strong.take(MOST_CORRELATIONS).enumerate() {
        let line =
            format!("{:+.2}  {} with {}", pair.value, printable(&pair.outcome), printable(&pair.input));
        let label = if k == 0 { "rank correlation" } else { "" };
        text.push_str(&labelled(label, &line.replacen("  ", "\u{a0} ", 1)));
    }
    let note = match summary.intervals {
        SweepIntervals::Given { confidence } => format!(
            "hold with {} %: means by Student's t, shares by Wilson's; those of quantiles are in summary.json",
            number(100.0 * confidence, 3)
        ),
        SweepIntervals::OfSets { confidence, sets } => format!(
            "hold with {} %: by how far {sets} sets differ that were drawn each for itself; quantiles have none",
            number(100.0 * confidence, 3)
        ),
        SweepIntervals::None { why } => format!("none: {why}"),
    };
    text.push_str(&labelled("intervals", &note));
    plain_spaces(&text)
}

/// `12.3 % (10.9 … 13.8 %) have largest_angle > 90 deg: 123 of 1,000`
fn answer(question: &SweepQuestion, members: u64) -> String {
    let condition = printable(&question.condition);
    let Some(share) = question.share else { return format!("no member has all columns of {condition}") };
    let percent = |x: f64| number(100.0 * x, 4);
    let interval = question
        .interval
        .map_or_else(String::new, |[low, high]| format!(" ({} … {} %)", percent(low), percent(high)));
    let lacking = match members.saturating_sub(question.of) {
        0 => String::new(),
        without => format!("; {} without an answer", count(without)),
    };
    let (yes, of) = (count(question.count), count(question.of));
    format!("{} %{interval} have {condition}: {yes} of {of}{lacking}", percent(share))
}

/// `complete 998 (99.8 %, 99.3 … 99.9 %), failed 2 (0.2 %)`
fn shares(shares: &[SweepShare], members: u64) -> String {
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

/// A line for each column; those that do not vary in one.
fn table(summary: &SweepSummary) -> String {
    let head = ["mean", "", "least", "5 %", "median", "95 %", "largest"];
    let mut text = String::new();
    for (title, statistics) in [("inputs", &summary.inputs), ("outcomes", &summary.outcomes)] {
        let (varying, same): (Vec<_>, Vec<_>) = statistics
            .iter()
            .filter(|s| s.count > 0 && !DRIFT.contains(&s.name.as_str()))
            .partition(|s| s.varies());
        let mut rows: Vec<Vec<String>> =
            vec![std::iter::once(title).chain(head).map(str::to_owned).collect()];
        rows.extend(varying.into_iter().map(|statistic| row(statistic, summary.members)));
        if rows.len() > 1 {
            text.push_str(&(columns(&rows).join("\n") + "\n"));
        }
        let one = |s: &&SweepStatistic| Some(format!("{}\u{a0}{}", printable(&s.name), number(s.min?, 6)));
        let same: Vec<String> = same.iter().filter_map(one).collect();
        if !same.is_empty() {
            text.push_str(&labelled("the same for all", &same.join(", ")));
        }
    }
    text
}

fn row(statistic: &SweepStatistic, members: u64) -> Vec<String> {
    let shown = |x: Option<f64>| x.map_or_else(String::new, |x| ungrouped(x, 4));
    let of = if statistic.count < members { format!(" ({})", count(statistic.count)) } else { String::new() };
    let half = statistic.mean_interval.map(|[low, high]| format!("± {}", ungrouped(0.5 * (high - low), 2)));
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
