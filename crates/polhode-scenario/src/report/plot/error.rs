//! Reasons for which a figure cannot be drawn.

use std::fmt;

use polhode::observe::CurveError;

use super::figure::Figure;

/// Reason for which a figure cannot be drawn.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PlotError {
    /// The motion has nothing of what the figure shows.
    NotThere {
        /// Figure that was asked for.
        figure: Figure,
        /// Fact about the motion that excludes it: `a torque acts on the body: it has no polhode`.
        why: &'static str,
    },
    /// The motion has fewer than two samples, and a curve needs two.
    TooFewSamples {
        /// Number of samples.
        count: usize,
    },
    /// The body turns too far from a sample to the next: angles cannot be followed.
    TooCoarse {
        /// Figure that was asked for.
        figure: Figure,
        /// Largest turn from a sample to the next, rad.
        turn: f64,
    },
    /// A curve has too many points.
    Curve {
        /// Figure that was asked for.
        figure: Figure,
        /// Error of the curve.
        error: CurveError,
    },
}

impl PlotError {
    /// Returns what to do about it.
    pub fn hint(&self) -> &'static str {
        match self {
            Self::NotThere { .. } => "a plot without a name draws all figures that the motion has",
            Self::TooFewSamples { .. } | Self::TooCoarse { .. } => "sample more often, or for a shorter time",
            Self::Curve { .. } => "try a shorter duration, or another figure",
        }
    }
}

impl fmt::Display for PlotError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotThere { figure, why } => write!(f, "there is no figure {}: {why}", figure.name()),
            Self::TooFewSamples { count } => {
                write!(f, "a plot against time needs 2 samples, and there are {count}")
            }
            Self::TooCoarse { figure, turn } => write!(
                f,
                "the figure {} cannot be drawn: the body turns by up to {} rad from a sample to the next",
                figure.name(),
                polhode_document::number::number(*turn, 3)
            ),
            Self::Curve { figure, error } => {
                write!(f, "the figure {} cannot be drawn: {error}", figure.name())
            }
        }
    }
}

impl std::error::Error for PlotError {}
