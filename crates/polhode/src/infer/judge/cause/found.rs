//! Results of trying causes.

use core::fmt;

use super::name::Cause;

/// Causes of a run's error, each tried: the motion of a program with this mistake, from the same
/// start, is compared with the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Causes {
    /// All causes that were tried, best first.
    pub tried: Vec<TriedCause>,
    /// RMS angle between the run and the exact motion over the compared rows, rad.
    pub error: f64,
    /// First and last compared time, s: from the start until the run and the exact motion have
    /// diverged.
    pub span: [f64; 2],
    /// Start state of the trials.
    pub start: TriedStart,
    /// Reason why no cause was tried; `None` if causes were tried.
    pub untried: Option<Untried>,
}

/// Result of trying one cause.
#[derive(Clone, Debug, PartialEq)]
pub struct TriedCause {
    /// Mistake or method of the program.
    pub cause: Cause,
    /// RMS angle between the run and the motion of such a program, rad.
    pub residual: f64,
    /// RMS angle between the run and the exact motion over the same rows, rad.
    pub error: f64,
    /// Fraction of the error that the cause explains, 1 − residual/error; 0 or less if it explains
    /// nothing.
    pub explained: f64,
    /// True if the cause explains the run: its fit is good enough, and no other cause is much
    /// better.
    pub is_named: bool,
    pub(super) score: f64,
    pub(super) passes: bool,
}

/// Start state of the trials.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TriedStart {
    /// Start of the scenario.
    Scenario,
    /// First row of the run, which differs from the scenario's start; all errors refer to motions
    /// from there.
    FirstRow,
}

/// Reason why no cause was tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Untried {
    /// Exact: over the compared rows the run equals the exact motion to 1e-8 rad, so there is
    /// nothing to explain.
    Exact,
    /// Too short: fewer than two rows can be compared.
    TooShort,
    /// Prescribed: the motion of the scenario is given, not computed.
    Prescribed,
    /// Switched: events switch torques on or off.
    Switched,
    /// Late: the run begins so long after the scenario's start that wrong motions cannot be
    /// integrated from there.
    Late,
}

impl fmt::Display for Untried {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Exact => {
                "the run agrees with the exact motion to 1e-8 rad while the body rotates by 120 rad"
            }
            Self::TooShort => "fewer than two rows can be compared",
            Self::Prescribed => "the motion of the scenario is prescribed, not computed",
            Self::Switched => "events of the scenario switch torques",
            Self::Late => "the run begins after more than 2000 rad of rotation since the scenario's start",
        })
    }
}

/// Largest ratio of a score to the best score for which a cause is also named.
const BESIDE: f64 = 10.0;

impl Causes {
    pub(super) fn untried(why: Untried) -> Self {
        let (tried, start, untried) = (Vec::new(), TriedStart::Scenario, Some(why));
        Self { tried, error: 0.0, span: [0.0; 2], start, untried }
    }

    /// Sorts the causes and marks those that are named.
    pub(super) fn ranked(mut self) -> Self {
        // A different start explains every motion from it, so causes that explain the run from the
        // scenario's start are ranked first.
        let elsewhere = |tried: &TriedCause| matches!(tried.cause, Cause::OtherStart { .. });
        self.tried.sort_by(|a, b| {
            let order = b.passes.cmp(&a.passes).then(elsewhere(a).cmp(&elsewhere(b)));
            order.then(a.score.total_cmp(&b.score))
        });
        let best = self.tried.first().map_or(f64::INFINITY, |tried| tried.score);
        for tried in &mut self.tried {
            tried.is_named = tried.passes && tried.score <= BESIDE * best;
        }
        self
    }

    /// Returns the causes that explain the run, best first.
    pub fn named(&self) -> impl Iterator<Item = &TriedCause> {
        self.tried.iter().filter(|tried| tried.is_named)
    }

    /// Returns the most likely cause.
    pub fn likeliest(&self) -> Option<&TriedCause> {
        self.named().next()
    }

    /// Returns the most likely cause if it is a mistake.
    pub fn mistake(&self) -> Option<&TriedCause> {
        self.likeliest().filter(|tried| tried.cause.is_mistake())
    }
}
