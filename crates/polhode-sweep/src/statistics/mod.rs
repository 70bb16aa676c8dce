//! What a sweep comes to: counts, means, quantiles, intervals, the strongest dependencies.
//!
//! All of it exactly, in memory that does not grow with the number of members, in passes over the parts:
//!
//! 1. counts, moments, extremes, and a sample of members (`tally.rs`);
//! 2. six passes that close in on the order statistics, eleven bits of each number at a time (`selection.rs`);
//! 3. histograms (`histogram.rs`).
//!
//! Nothing depends on the number of threads: counts add in any order, moments are added in the order of the parts.

mod histogram;
mod interval;
mod passes;
mod rank_correlation;
mod sample;
mod selection;
mod tally;

use polhode_report::{
    SweepCorrelation, SweepQuantile, SweepSample, SweepShare, SweepStatistic, SweepSummary,
};

use crate::batch::{Batch, Values};
use crate::error::SweepError;
use crate::plan::{Plan, Sampling};
use crate::rows::MEMBER;
use crate::sampling;
use interval::Interval;
use passes::Parts;
pub(crate) use passes::most_threads;
use selection::Selection;
use tally::{Moments, Tally};

/// Of the probability of each interval.
const CONFIDENCE: f64 = 0.95;
/// Which quantiles there are.
const PROBABILITIES: [f64; 7] = [0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99];
/// Outcomes whose dependence on inputs says nothing: what the body is, what its motion cost to compute, and how good that is.
const PLAIN: [&str; 11] = [
    "mass_kg",
    "moment_1_kg_m2",
    "moment_2_kg_m2",
    "moment_3_kg_m2",
    "energy_drift",
    "momentum_drift",
    "error_attitude_rad",
    "error_omega",
    "steps_accepted",
    "steps_rejected",
    "evaluations",
];
/// Final attitudes are four numbers that mean nothing one by one.
const APART: [&str; 4] = ["end_attitude_w", "end_attitude_x", "end_attitude_y", "end_attitude_z"];

/// What the rows of so many parts come to, and some of their members.
pub(crate) fn of(
    plan: &Plan,
    parts: u64,
    threads: usize,
    read: &(dyn Fn(u64) -> Result<Batch, SweepError> + Sync),
) -> Result<(SweepSummary, SweepSample), SweepError> {
    let parts = Parts { count: parts, threads, read };
    let heads = read(0)?;
    let names: Vec<&str> = numeric(&heads).map(|(name, ..)| name).collect();
    let tally = parts.in_order(|part| Tally::of(&read(part)?, &names, plan.members()), Tally::merge)?;
    let tally = tally.unwrap_or_default();

    let independent = plan.sampling() == Sampling::MonteCarlo;
    let ranks: Vec<Vec<u64>> = tally.moments.iter().map(|moments| ranks(moments, independent)).collect();
    let chosen = selection::select(&parts, &names, ranks)?;
    let plans: Vec<_> = tally.moments.iter().zip(&chosen).map(|(m, s)| histogram::Bins::of(m, s)).collect();
    let histograms = histogram::count(&parts, &names, &plans)?;

    let mut statistics = Vec::new();
    for (k, (name, unit, description)) in numeric(&heads).enumerate() {
        let (Some(moments), Some(selection), Some(bins)) =
            (tally.moments.get(k), chosen.get(k), histograms.get(k))
        else {
            continue;
        };
        statistics.push(SweepStatistic {
            name: name.to_owned(),
            unit: unit.to_owned(),
            description: description.to_owned(),
            histogram: bins.clone(),
            ..statistic(moments, selection, independent)
        });
    }
    let inputs: Vec<String> = plan.variables().iter().map(|variable| variable.name.clone()).collect();
    let sample = tally.sample.finish(&names, &inputs);
    let correlations = rank_correlation::strongest(&sample, &inputs, &PLAIN)
        .into_iter()
        .map(|(input, outcome, value)| SweepCorrelation { input, outcome, value })
        .collect();
    let (inputs, outcomes) = statistics.into_iter().partition(|s| inputs.contains(&s.name));
    let shares = |name: &str| shares(tally.texts.get(name), plan.members(), independent);
    let summary = SweepSummary {
        title: plan.nominal().title().map(str::to_owned),
        digest: plan.digest(),
        members: plan.members(),
        sampling: sampling::name(plan.sampling()),
        seed: plan.seed(),
        intervals: sampling::intervals(plan.sampling(), CONFIDENCE),
        statuses: shares("status"),
        regimes: shares("regime"),
        end_regimes: shares("end_regime"),
        failures: tally.failures,
        inputs,
        outcomes,
        sampled: sample.rows(),
        correlations,
    };
    Ok((summary, sample))
}

/// The columns of numbers: name, unit, description.
fn numeric(batch: &Batch) -> impl Iterator<Item = (&str, &str, &str)> {
    let numbers = batch.columns().iter().filter(|column| {
        matches!(column.values, Values::Numbers(_) | Values::Perhaps(_))
            && column.name != MEMBER
            && !APART.contains(&column.name.as_str())
    });
    numbers.map(|column| (column.name.as_str(), column.unit.as_str(), column.description.as_str()))
}

/// The numbers of the column of a name, those that are there.
fn values<'a>(batch: &'a Batch, name: &str) -> Box<dyn Iterator<Item = f64> + 'a> {
    match batch.column(name).map(|column| &column.values) {
        Ok(Values::Numbers(values)) => Box::new(values.iter().copied()),
        Ok(Values::Perhaps(values)) => Box::new(values.iter().flatten().copied()),
        _ => Box::new(std::iter::empty()),
    }
}

/// The order statistics that quantiles and their intervals need, from 0.
fn ranks(moments: &Moments, independent: bool) -> Vec<u64> {
    let n = moments.count;
    let mut ranks = Vec::new();
    for p in PROBABILITIES {
        let (below, above, _) = interval::around(n, p);
        ranks.extend([below, above].into_iter().filter(|_| n > 0));
        if independent {
            ranks.extend(interval::of_quantile(n, p, CONFIDENCE).into_iter().flatten());
        }
    }
    ranks.sort_unstable();
    ranks.dedup();
    ranks
}

fn statistic(moments: &Moments, selection: &Selection, independent: bool) -> SweepStatistic {
    let n = moments.count;
    let finite = |x: f64| x.is_finite().then_some(x);
    let mean = finite(moments.mean).filter(|_| n > 0);
    let deviation = moments.standard_deviation().and_then(finite);
    let quantile = |p: f64| {
        let (below, above, part) = interval::around(n, p);
        let (a, b) = (selection.at(below)?, selection.at(above)?);
        let ends = if independent { interval::of_quantile(n, p, CONFIDENCE) } else { [None; 2] };
        let interval = ends.map(|rank| rank.and_then(|rank| selection.at(rank)));
        // In this form it is between both whatever their size.
        let value = if a == b { a } else { a * (1.0 - part) + b * part };
        Some(SweepQuantile { probability: p, value, interval })
    };
    SweepStatistic {
        name: String::new(),
        unit: String::new(),
        description: String::new(),
        count: n,
        mean,
        mean_interval: mean.zip(deviation).filter(|_| independent).and_then(|(mean, deviation)| {
            let Interval { half } = Interval::of_mean(n, deviation, CONFIDENCE)?;
            Some([mean - half, mean + half])
        }),
        standard_deviation: deviation,
        min: finite(moments.min),
        max: finite(moments.max),
        quantiles: PROBABILITIES.into_iter().filter_map(quantile).collect(),
        histogram: None,
    }
}

/// What there is of each text, the most frequent first.
fn shares(
    counts: Option<&std::collections::BTreeMap<String, u64>>,
    members: u64,
    independent: bool,
) -> Vec<SweepShare> {
    let share = |(name, &count): (&String, &u64)| SweepShare {
        name: name.clone(),
        count,
        interval: independent.then(|| interval::of_share(count, members)),
    };
    let mut shares: Vec<SweepShare> = counts.into_iter().flatten().map(share).collect();
    shares.sort_by(|a, b| b.count.cmp(&a.count).then_with(|| a.name.cmp(&b.name)));
    shares
}

#[cfg(test)]
mod tests;
