//! Content of a sweep's `summary.json`.

use polhode_document::VERSION;
use polhode_document::json::numbers;
use serde_json::{Map, Value, json};

use super::{
    SweepHistogram, SweepIntervals, SweepQuantile, SweepQuestion, SweepShare, SweepStatistic, SweepStep,
    SweepSummary,
};

pub(crate) fn of(summary: &SweepSummary) -> Value {
    let (confidence, why) = match summary.intervals {
        SweepIntervals::Given { confidence } => (Some(confidence), None),
        SweepIntervals::OfSets { confidence, .. } => (Some(confidence), None),
        SweepIntervals::None { why } => (None, Some(why)),
    };
    let sets = if let SweepIntervals::OfSets { sets, .. } = summary.intervals { Some(sets) } else { None };
    let shares =
        |shares: &[SweepShare]| object(shares.iter().map(|s| (s.name.clone(), share(s, summary.members))));
    let statistics = |all: &[SweepStatistic]| object(all.iter().map(|s| (s.name.clone(), statistic(s))));
    json!({
        "polhode": VERSION,
        "title": summary.title,
        "digest": summary.digest,
        "members": summary.members,
        "sampling": summary.sampling,
        "seed": summary.seed,
        "intervals": { "confidence": confidence, "sets": sets, "why_none": why },
        "status": shares(&summary.statuses),
        "regime": shares(&summary.regimes),
        "end_regime": shares(&summary.end_regimes),
        "questions": object(summary.questions.iter().map(|q| (q.name.clone(), question(q)))),
        "mean_attitudes": object(summary.attitudes.iter().map(|a| (a.name.clone(), numbers(&a.mean)))),
        "failures": summary.failures.iter().map(|(member, cause)| json!({ "member": member, "cause": cause })).collect::<Value>(),
        "inputs": statistics(&summary.inputs),
        "outcomes": statistics(&summary.outcomes),
        "correlations": {
            "kind": "spearman",
            "of_members": summary.sampled,
            "strongest": summary.correlations.iter().map(|c| {
                json!({ "input": c.input, "outcome": c.outcome, "value": c.value })
            }).collect::<Value>(),
        },
    })
}

fn object(entries: impl Iterator<Item = (String, Value)>) -> Value {
    Value::Object(entries.collect::<Map<_, _>>())
}

fn question(question: &SweepQuestion) -> Value {
    let step = |step: &SweepStep| json!({ "members": step.members, "probability": step.share, "interval": step.interval.map(|ends| numbers(&ends)) });
    json!({
        "condition": question.condition,
        "count": question.count,
        "of": question.of,
        "probability": question.share,
        "interval": question.interval.map(|interval| numbers(&interval)),
        "convergence": question.convergence.iter().map(step).collect::<Value>(),
    })
}

fn share(share: &SweepShare, members: u64) -> Value {
    json!({
        "count": share.count,
        "share": if members == 0 { 0.0 } else { share.count as f64 / members as f64 },
        "interval": share.interval.map(|interval| numbers(&interval)),
    })
}

fn statistic(statistic: &SweepStatistic) -> Value {
    let quantile = |q: &SweepQuantile| {
        (format!("{}", q.probability), json!({ "value": q.value, "interval": q.interval }))
    };
    json!({
        "unit": if statistic.unit.is_empty() { "1" } else { &statistic.unit },
        "description": statistic.description,
        "count": statistic.count,
        "mean": statistic.mean,
        "mean_interval": statistic.mean_interval.map(|interval| numbers(&interval)),
        "standard_deviation": statistic.standard_deviation,
        "min": statistic.min,
        "max": statistic.max,
        "quantiles": object(statistic.quantiles.iter().map(quantile)),
        "histogram": statistic.histogram.as_ref().map(histogram),
    })
}

fn histogram(histogram: &SweepHistogram) -> Value {
    json!({
        "least": histogram.least,
        "greatest": histogram.greatest,
        "bins": if histogram.log { "equal_ratio" } else { "equal_width" },
        "counts": histogram.counts,
        "below": histogram.below,
        "above": histogram.above,
    })
}
