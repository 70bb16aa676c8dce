//! The report of `polhode sweep`: what many members come to.

mod summary;
mod text;

use polhode::body::Finding;
use polhode_document::Document;
use serde_json::Value;

/// What a sweep comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepSummary {
    /// What it is about.
    pub title: Option<String>,
    /// A name for everything that the results depend on.
    pub digest: String,
    /// How many members there are.
    pub members: u64,
    /// How they were drawn: `grid`, `monte_carlo`, `latin_hypercube` or `sobol`.
    pub sampling: &'static str,
    /// What the draws follow from; `None` where nothing is drawn.
    pub seed: Option<u64>,
    /// Whether there are confidence intervals.
    pub intervals: SweepIntervals,
    /// How the motions ended.
    pub statuses: Vec<SweepShare>,
    /// Which kind of free motion the starts have.
    pub regimes: Vec<SweepShare>,
    /// And the ends.
    pub end_regimes: Vec<SweepShare>,
    /// What was asked, and the answers.
    pub questions: Vec<SweepQuestion>,
    /// The mean of each attitude.
    pub attitudes: Vec<SweepAttitude>,
    /// The first members that failed, and why.
    pub failures: Vec<(u64, String)>,
    /// What differs from member to member.
    pub inputs: Vec<SweepStatistic>,
    /// What becomes of them.
    pub outcomes: Vec<SweepStatistic>,
    /// How many members the correlations are of.
    pub sampled: usize,
    /// The strongest dependencies of outcomes on inputs.
    pub correlations: Vec<SweepCorrelation>,
}

/// Whether there are confidence intervals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SweepIntervals {
    /// There are.
    Given {
        /// The probability that an interval holds what it is about.
        confidence: f64,
    },
    /// There are, from how far sets of members that were drawn each for itself differ.
    OfSets {
        /// The probability that an interval holds what it is about.
        confidence: f64,
        /// How many sets there are.
        sets: u64,
    },
    /// There are none.
    None {
        /// Why not.
        why: &'static str,
    },
}

/// How many members have something in common.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepShare {
    /// What.
    pub name: String,
    /// How many.
    pub count: u64,
    /// An interval of the proportion.
    pub interval: Option<[f64; 2]>,
}

/// A condition on the columns of a member, and how many fulfil it.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepQuestion {
    /// What the plan calls it.
    pub name: String,
    /// The condition.
    pub condition: String,
    /// How many members fulfil it.
    pub count: u64,
    /// How many have all columns that it is about.
    pub of: u64,
    /// The share of the members that have them; `None` if none has.
    pub share: Option<f64>,
    /// An interval of the probability.
    pub interval: Option<[f64; 2]>,
    /// The share among the first members, for ever more of them.
    pub convergence: Vec<SweepStep>,
}

/// The share that fulfils a condition among the first members.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepStep {
    /// How many members.
    pub members: u64,
    /// The share.
    pub share: f64,
    /// Its interval.
    pub interval: Option<[f64; 2]>,
}

/// The mean of an attitude: the columns `NAME_from_mean_rad`, `NAME_from_mean_x_rad` … are turns from it.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepAttitude {
    /// What the columns of its quaternion begin with.
    pub name: String,
    /// (w, x, y, z), w ≥ 0.
    pub mean: [f64; 4],
}

/// The numbers of one column.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepStatistic {
    /// The column.
    pub name: String,
    /// Its unit in SI; empty if there is none.
    pub unit: String,
    /// What it is.
    pub description: String,
    /// How many members have it.
    pub count: u64,
    /// Their mean.
    pub mean: Option<f64>,
    /// An interval of the mean.
    pub mean_interval: Option<[f64; 2]>,
    /// √(Σ (x − mean)² / (n − 1)).
    pub standard_deviation: Option<f64>,
    /// The least.
    pub min: Option<f64>,
    /// The largest.
    pub max: Option<f64>,
    /// Some quantiles, in ascending order.
    pub quantiles: Vec<SweepQuantile>,
    /// How they are distributed; `None` if they do not vary.
    pub histogram: Option<SweepHistogram>,
}

/// A quantile: at (n − 1) p between the numbers in ascending order, from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepQuantile {
    /// p
    pub probability: f64,
    /// The number there.
    pub value: f64,
    /// Order statistics that hold the quantile of the distribution between them, where there are enough members.
    pub interval: [Option<f64>; 2],
}

/// How many numbers are in each of some bins of equal width, or of equal ratio.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepHistogram {
    /// Where the first bin begins.
    pub least: f64,
    /// Where the last bin ends.
    pub greatest: f64,
    /// Whether bins have equal ratios.
    pub log: bool,
    /// Numbers in each bin.
    pub counts: Vec<u64>,
    /// Numbers below the first.
    pub below: u64,
    /// Numbers above the last.
    pub above: u64,
}

/// How an outcome depends on an input.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepCorrelation {
    /// The input's column.
    pub input: String,
    /// The outcome's column.
    pub outcome: String,
    /// Spearman's rank correlation, −1 … 1.
    pub value: f64,
}

/// Some members, column by column, for pictures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SweepSample {
    /// The columns.
    pub names: Vec<String>,
    /// Their numbers, one for each member, where there is one.
    pub columns: Vec<Vec<Option<f64>>>,
    /// The regime of each member.
    pub regimes: Vec<Option<String>>,
    /// Which of the columns are inputs.
    pub inputs: Vec<String>,
    /// Of each question, what each member answers, where it can.
    pub answers: Vec<Vec<Option<bool>>>,
}

impl SweepSummary {
    /// One screen for people.
    pub fn to_text(&self) -> String {
        text::write(self)
    }

    /// The same as a document, with what was noticed about the plan.
    pub fn to_document(&self, findings: Vec<Finding>) -> Document {
        text::document(self, findings)
    }

    /// The content of `summary.json`.
    pub fn to_json(&self) -> Value {
        summary::of(self)
    }
}

impl SweepSample {
    /// How many members there are.
    pub fn rows(&self) -> usize {
        self.regimes.len()
    }
}

impl SweepStatistic {
    /// The quantile of a probability, if it is there.
    pub fn quantile(&self, probability: f64) -> Option<f64> {
        self.quantiles.iter().find(|q| q.probability == probability).map(|q| q.value)
    }

    /// True if the members do not all have the same number.
    pub fn varies(&self) -> bool {
        self.min < self.max
    }
}
