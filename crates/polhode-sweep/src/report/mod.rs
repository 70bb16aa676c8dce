//! Report of `polhode sweep`: statistics over many members.

mod summary;
mod text;

use polhode::body::Finding;
use polhode_document::Document;
use serde_json::Value;

/// Summary of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepSummary {
    /// Title of the plan.
    pub title: Option<String>,
    /// Digest of everything that the results depend on.
    pub digest: String,
    /// Number of members.
    pub members: u64,
    /// Sampling method: `grid`, `monte_carlo`, `latin_hypercube` or `sobol`.
    pub sampling: &'static str,
    /// Seed of the random numbers; `None` for a grid.
    pub seed: Option<u64>,
    /// Kind of the confidence intervals.
    pub intervals: SweepIntervals,
    /// Number of members by status of the motion.
    pub statuses: Vec<SweepShare>,
    /// Number of members by regime of free motion at the start.
    pub regimes: Vec<SweepShare>,
    /// Number of members by regime of free motion at the end.
    pub end_regimes: Vec<SweepShare>,
    /// Questions of the plan, with their answers.
    pub questions: Vec<SweepQuestion>,
    /// Mean of each attitude.
    pub attitudes: Vec<SweepAttitude>,
    /// First members that failed, with the cause.
    pub failures: Vec<(u64, String)>,
    /// Statistics of the varied inputs.
    pub inputs: Vec<SweepStatistic>,
    /// Statistics of the outcomes.
    pub outcomes: Vec<SweepStatistic>,
    /// Number of members used for the correlations.
    pub sampled: usize,
    /// Strongest dependencies of outcomes on inputs.
    pub correlations: Vec<SweepCorrelation>,
}

/// Kind of the confidence intervals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SweepIntervals {
    /// Intervals for independent members.
    Given {
        /// Confidence level.
        confidence: f64,
    },
    /// Intervals from the differences between independently drawn sets of members.
    OfSets {
        /// Confidence level.
        confidence: f64,
        /// Number of sets.
        sets: u64,
    },
    /// No intervals.
    None {
        /// Reason.
        why: &'static str,
    },
}

/// Number of members with a common property.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepShare {
    /// Name of the property.
    pub name: String,
    /// Number of members.
    pub count: u64,
    /// Confidence interval of the proportion.
    pub interval: Option<[f64; 2]>,
}

/// Condition on the columns of a member, and the number of members that fulfil it.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepQuestion {
    /// Name in the plan.
    pub name: String,
    /// Text of the condition.
    pub condition: String,
    /// Number of members that fulfil it.
    pub count: u64,
    /// Number of members with all columns of the condition.
    pub of: u64,
    /// Share among the members with all columns; `None` without such members.
    pub share: Option<f64>,
    /// Confidence interval of the probability.
    pub interval: Option<[f64; 2]>,
    /// Share among the first members, for increasing numbers of them.
    pub convergence: Vec<SweepStep>,
}

/// Share that fulfils a condition among the first members.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepStep {
    /// Number of members.
    pub members: u64,
    /// Share among these members.
    pub share: f64,
    /// Confidence interval of the share.
    pub interval: Option<[f64; 2]>,
}

/// Mean of an attitude. The columns `NAME_from_mean_rad`, `NAME_from_mean_x_rad` … contain
/// rotations from it.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepAttitude {
    /// Common prefix of the quaternion's columns.
    pub name: String,
    /// Mean quaternion (w, x, y, z), w ≥ 0.
    pub mean: [f64; 4],
}

/// Statistics of one column.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepStatistic {
    /// Name of the column.
    pub name: String,
    /// SI unit; empty for a dimensionless number.
    pub unit: String,
    /// Description of the column.
    pub description: String,
    /// Number of members with a value.
    pub count: u64,
    /// Mean value, in `unit`.
    pub mean: Option<f64>,
    /// Confidence interval of the mean.
    pub mean_interval: Option<[f64; 2]>,
    /// Sample standard deviation √(Σ (x − mean)² / (n − 1)).
    pub standard_deviation: Option<f64>,
    /// Smallest value.
    pub min: Option<f64>,
    /// Largest value.
    pub max: Option<f64>,
    /// Quantiles in ascending order.
    pub quantiles: Vec<SweepQuantile>,
    /// Histogram; `None` if the values do not vary.
    pub histogram: Option<SweepHistogram>,
}

/// Quantile: interpolated at the rank (n − 1) p among the sorted values, from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepQuantile {
    /// Probability p.
    pub probability: f64,
    /// Value of the quantile.
    pub value: f64,
    /// Confidence interval between two order statistics; an end is `None` with too few members.
    pub interval: [Option<f64>; 2],
}

/// Histogram with bins of equal width, or of equal ratio.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepHistogram {
    /// Lower end of the first bin.
    pub least: f64,
    /// Upper end of the last bin.
    pub greatest: f64,
    /// True if bins have equal ratios.
    pub log: bool,
    /// Number of values in each bin.
    pub counts: Vec<u64>,
    /// Number of values below the first bin.
    pub below: u64,
    /// Number of values above the last bin.
    pub above: u64,
}

/// Dependence of an outcome on an input.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepCorrelation {
    /// Column of the input.
    pub input: String,
    /// Column of the outcome.
    pub outcome: String,
    /// Spearman's rank correlation, −1 … 1.
    pub value: f64,
}

/// Sample of the members in columns, for figures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SweepSample {
    /// Names of the columns.
    pub names: Vec<String>,
    /// Values, one per member; `None` if missing.
    pub columns: Vec<Vec<Option<f64>>>,
    /// Regime of each member.
    pub regimes: Vec<Option<String>>,
    /// Names of the columns that are inputs.
    pub inputs: Vec<String>,
    /// Answers of each member to each question; `None` without answer.
    pub answers: Vec<Vec<Option<bool>>>,
}

impl SweepSummary {
    /// Returns the summary as text that fits on a screen.
    pub fn to_text(&self) -> String {
        text::write(self)
    }

    /// Returns the summary as a document, with findings about the plan.
    pub fn to_document(&self, findings: Vec<Finding>) -> Document {
        text::document(self, findings)
    }

    /// Returns the content of `summary.json`.
    pub fn to_json(&self) -> Value {
        summary::of(self)
    }
}

impl SweepSample {
    /// Returns the number of sampled members.
    pub fn rows(&self) -> usize {
        self.regimes.len()
    }
}

impl SweepStatistic {
    /// Returns the quantile of a probability, if it was computed.
    pub fn quantile(&self, probability: f64) -> Option<f64> {
        self.quantiles.iter().find(|q| q.probability == probability).map(|q| q.value)
    }

    /// Returns true if the members have different values.
    pub fn varies(&self) -> bool {
        self.min < self.max
    }
}
