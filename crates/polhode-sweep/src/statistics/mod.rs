//! Statistics of a sweep: counts, means, quantiles, intervals, the strongest dependencies.
//!
//! All results are exact. Memory does not grow with the number of members. Several passes over the
//! parts compute:
//!
//! 1. counts, moments, extremes, and a sample of members (`tally.rs`)
//! 2. order statistics, in six passes of eleven bits each (`selection.rs`)
//! 3. histograms (`histogram.rs`)
//!
//! Results do not depend on the number of threads: counts may be added in any order, and moments
//! are added in the order of the parts.

mod answers;
mod attitude;
mod histogram;
mod interval;
mod passes;
mod rank_correlation;
mod sample;
mod selection;
mod tally;

use std::ops::Range;

use crate::batch::{Batch, MEMBER, Values};
use crate::error::SweepError;
use crate::plan::{Plan, Sampling};
use crate::report::{
    SweepAttitude, SweepCorrelation, SweepQuantile, SweepSample, SweepShare, SweepStatistic, SweepSummary,
};
use crate::sampling;
use answers::Count;
use attitude::MeanAttitude;
use passes::Parts;
use selection::Selection;
use tally::{Moments, Tally};

/// Confidence level of all intervals.
const CONFIDENCE: f64 = 0.95;
/// Probabilities of the quantiles.
const PROBABILITIES: [f64; 7] = [0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99];
/// Outcomes excluded from correlations: properties of the body, cost and accuracy of the
/// computation.
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
/// Prefix of the outcome that is an attitude; its four components have no meaning individually.
const END_ATTITUDE: &str = "end_attitude";

/// Sampling design, as far as confidence intervals depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Design {
    /// Independent members.
    Independent,
    /// Independent sets of `size` members.
    Sets { size: u64, count: u64 },
    /// A single set, or a grid.
    Fixed,
}

impl Design {
    fn of(plan: &Plan) -> Self {
        match (plan.sampling(), plan.replicates()) {
            (Sampling::MonteCarlo, _) => Self::Independent,
            (_, count) if count > 1 => Self::Sets { size: plan.members() / count, count },
            _ => Self::Fixed,
        }
    }

    /// Returns the index of a member's set.
    const fn set(self, member: u64) -> u64 {
        match self {
            Self::Sets { size, .. } => member / size,
            _ => 0,
        }
    }
}

/// Returns the rows of all parts.
pub(crate) fn each(
    parts: u64,
    threads: usize,
    read: &(dyn Fn(u64) -> Result<Batch, SweepError> + Sync),
) -> Result<Vec<Batch>, SweepError> {
    let merge = |mut all: Vec<Batch>, more| {
        all.extend(more);
        all
    };
    let parts = Parts { count: parts, threads, read };
    Ok(parts.in_order(|part| Ok(vec![read(part)?]), merge)?.unwrap_or_default())
}

/// Returns the statistics of all parts, and a sample of their members.
pub(crate) fn of(
    plan: &Plan,
    parts: u64,
    threads: usize,
    read: &(dyn Fn(u64) -> Result<Batch, SweepError> + Sync),
) -> Result<(SweepSummary, SweepSample), SweepError> {
    let stems: Vec<String> = plan.rotations().map(str::to_owned).chain([END_ATTITUDE.to_owned()]).collect();
    let means = attitude::means(&Parts { count: parts, threads, read }, &stems)?;
    let read = &|part: u64| Ok(means.iter().fold(read(part)?, |batch, mean| mean.put(batch)));
    let parts = Parts { count: parts, threads, read };
    let design = Design::of(plan);
    let heads = read(0)?;
    let names: Vec<&str> = numeric(&heads).map(|(name, ..)| name).collect();
    let tally = parts.in_order(|part| Tally::of(&read(part)?, &names, plan, design), Tally::merge)?;
    let tally = tally.unwrap_or_default();

    let independent = design == Design::Independent;
    let ranks: Vec<Vec<u64>> = tally.all.moments.iter().map(|moments| ranks(moments, independent)).collect();
    let chosen = selection::select(&parts, &names, ranks)?;
    let plans: Vec<_> =
        tally.all.moments.iter().zip(&chosen).map(|(m, s)| histogram::Bins::of(m, s)).collect();
    let histograms = histogram::count(&parts, &names, &plans)?;

    let mut statistics = Vec::new();
    for (k, (name, unit, description)) in numeric(&heads).enumerate() {
        let (Some(moments), Some(selection), Some(bins)) =
            (tally.all.moments.get(k), chosen.get(k), histograms.get(k))
        else {
            continue;
        };
        statistics.push(SweepStatistic {
            name: name.to_owned(),
            unit: unit.to_owned(),
            description: description.to_owned(),
            histogram: bins.clone(),
            mean_interval: design.mean(moments, || tally.sets.values().filter_map(|set| set.moments.get(k))),
            ..statistic(moments, selection, independent)
        });
    }
    let turned = means.iter().filter(|mean| mean.stem != END_ATTITUDE).flat_map(MeanAttitude::columns);
    let inputs: Vec<String> =
        plan.variables().iter().map(|variable| variable.name.clone()).chain(turned).collect();
    let sample = tally.sample.finish(&names, &inputs);
    let correlations = rank_correlation::strongest(&sample, &inputs, &PLAIN)
        .into_iter()
        .map(|(input, outcome, value)| SweepCorrelation { input, outcome, value })
        .collect();
    let (inputs, outcomes) = statistics.into_iter().partition(|s| inputs.contains(&s.name));
    let shares = |name: &str| shares(&tally, name, plan.members(), design);
    let answered = plan.questions().iter().zip(&tally.answers);
    let questions =
        answered.map(|(question, answers)| answers.finish(question, plan.members(), design)).collect();
    let summary = SweepSummary {
        title: plan.nominal().title().map(str::to_owned),
        digest: plan.digest(),
        members: plan.members(),
        sampling: sampling::name(plan.sampling()),
        seed: plan.seed(),
        intervals: sampling::intervals(plan.sampling(), plan.replicates(), CONFIDENCE),
        statuses: shares("status"),
        regimes: shares("regime"),
        end_regimes: shares("end_regime"),
        questions,
        attitudes: means
            .iter()
            .map(|mean| SweepAttitude { name: mean.stem.clone(), mean: mean.quaternion() })
            .collect(),
        failures: tally.failures,
        inputs,
        outcomes,
        sampled: sample.rows(),
        correlations,
    };
    Ok((summary, sample))
}

/// Returns name, unit and description of each column of numbers.
fn numeric(batch: &Batch) -> impl Iterator<Item = (&str, &str, &str)> {
    let numbers = batch.columns().iter().filter(|column| {
        matches!(column.values, Values::Numbers(_) | Values::Perhaps(_)) && column.name != MEMBER
    });
    numbers.map(|column| (column.name.as_str(), column.unit.as_str(), column.description.as_str()))
}

/// Returns the values of some rows in a column, without missing ones.
fn values_of<'a>(batch: &'a Batch, name: &str, rows: Range<usize>) -> Box<dyn Iterator<Item = f64> + 'a> {
    match batch.column(name).map(|column| &column.values) {
        Ok(Values::Numbers(values)) => Box::new(values.get(rows).unwrap_or_default().iter().copied()),
        Ok(Values::Perhaps(values)) => {
            Box::new(values.get(rows).unwrap_or_default().iter().flatten().copied())
        }
        _ => Box::new(std::iter::empty()),
    }
}

/// Returns the values of a column, without missing ones.
fn values<'a>(batch: &'a Batch, name: &str) -> Box<dyn Iterator<Item = f64> + 'a> {
    values_of(batch, name, 0..batch.rows())
}

/// Returns the ranks (from 0) of the order statistics that quantiles and their intervals need.
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

impl Design {
    /// Returns the confidence interval of a mean, from the moments of all members and of each set.
    fn mean<'a, I: Iterator<Item = &'a Moments>>(
        self,
        moments: &Moments,
        sets: impl FnOnce() -> I,
    ) -> Option<[f64; 2]> {
        let interval = match self {
            Self::Independent => {
                let deviation = moments.standard_deviation()?;
                let half = interval::half_of_mean(moments.count, deviation, CONFIDENCE)?;
                [moments.mean - half, moments.mean + half]
            }
            Self::Sets { .. } => {
                let means: Vec<f64> = sets().filter(|set| set.count > 0).map(|set| set.mean).collect();
                interval::of_sets(&means, CONFIDENCE)?
            }
            Self::Fixed => return None,
        };
        interval.iter().all(|end| end.is_finite()).then_some(interval)
    }
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
        // This form lies between both values whatever their magnitudes.
        let value = if a == b { a } else { a * (1.0 - part) + b * part };
        Some(SweepQuantile { probability: p, value, interval })
    };
    SweepStatistic {
        name: String::new(),
        unit: String::new(),
        description: String::new(),
        count: n,
        mean,
        mean_interval: None,
        standard_deviation: deviation,
        min: finite(moments.min),
        max: finite(moments.max),
        quantiles: PROBABILITIES.into_iter().filter_map(quantile).collect(),
        histogram: None,
    }
}

/// Returns the share of each text in a column, most frequent first.
fn shares(tally: &Tally, column: &str, members: u64, design: Design) -> Vec<SweepShare> {
    let size = if let Design::Sets { size, .. } = design { size } else { members };
    let share = |(name, &count): (&String, &u64)| {
        let sets = tally.sets.values().map(|set| Count { yes: set.count(column, name), of: size });
        let interval = design.share(Count { yes: count, of: members }, sets);
        SweepShare { name: name.clone(), count, interval }
    };
    let mut shares: Vec<SweepShare> = tally.all.texts.get(column).into_iter().flatten().map(share).collect();
    shares.sort_by(|a, b| b.count.cmp(&a.count).then_with(|| a.name.cmp(&b.name)));
    shares
}

#[cfg(test)]
mod tests;
