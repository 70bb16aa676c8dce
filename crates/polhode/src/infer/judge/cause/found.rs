//! What came of trying causes.

use core::fmt;

use super::name::Cause;

/// Causes of a run's error, each tried: the motion that a program with this mistake makes from the same start, against the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Causes {
    /// All that were tried, best first.
    pub tried: Vec<TriedCause>,
    /// rms of the angle between the run and the exact motion over the rows that were compared, rad.
    pub error: f64,
    /// The first and the last time compared, s: from the start until the run and the exact motion have lost each other.
    pub span: [f64; 2],
    /// From where they were tried.
    pub start: TriedStart,
    /// Why none was tried.
    pub untried: Option<Untried>,
}

/// One cause that was tried.
#[derive(Clone, Debug, PartialEq)]
pub struct TriedCause {
    /// What the program would do.
    pub cause: Cause,
    /// rms of the angle between the run and what such a program computes, rad.
    pub residual: f64,
    /// rms of the angle between the run and the exact motion over the same rows, rad.
    pub error: f64,
    /// The part of the error that the cause explains, 1 − residual/error; 0 or less if none of it.
    pub explained: f64,
    /// Whether it explains the run: well enough, and no other one much better.
    pub is_named: bool,
    pub(super) score: f64,
    pub(super) passes: bool,
}

/// From where causes were tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TriedStart {
    /// The scenario's start.
    Scenario,
    /// The run's first row, which is not the scenario's start; all errors are those of motions from there.
    FirstRow,
}

/// Why no cause was tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Untried {
    /// Over the rows that are compared the run is the exact motion to 1e-8 rad: there is nothing to explain.
    Exact,
    /// Fewer than two rows can be compared.
    TooShort,
    /// The motion of the scenario is given, not computed.
    Prescribed,
    /// Events switch torques on or off.
    Switched,
    /// The run begins so long after the scenario's start that wrong motions cannot be followed from there.
    Late,
}

impl fmt::Display for Untried {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Exact => "the run is the exact motion to 1e-8 rad while the body turns by 120 rad",
            Self::TooShort => "fewer than two rows can be compared",
            Self::Prescribed => "the motion of the scenario is given, not computed",
            Self::Switched => "events of the scenario switch torques",
            Self::Late => "the run begins more than 2000 rad of turning after the scenario's start",
        })
    }
}

/// A score this many times the best is not named beside it.
const BESIDE: f64 = 10.0;

impl Causes {
    pub(super) fn untried(why: Untried) -> Self {
        let (tried, start, untried) = (Vec::new(), TriedStart::Scenario, Some(why));
        Self { tried, error: 0.0, span: [0.0; 2], start, untried }
    }

    /// Sorted, and named.
    pub(super) fn ranked(mut self) -> Self {
        // Another start explains whatever begins with it: what explains the run from the right one comes before.
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

    /// The causes that explain the run, best first.
    pub fn named(&self) -> impl Iterator<Item = &TriedCause> {
        self.tried.iter().filter(|tried| tried.is_named)
    }

    /// The likeliest.
    pub fn likeliest(&self) -> Option<&TriedCause> {
        self.named().next()
    }

    /// The likeliest, if it is a mistake.
    pub fn mistake(&self) -> Option<&TriedCause> {
        self.likeliest().filter(|tried| tried.cause.is_mistake())
    }
}
