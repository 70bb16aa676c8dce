//! Errors of plots.

use std::fmt;

use polhode::observe::CurveError;

use super::figure::Figure;

/// Reason why a figure cannot be drawn.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PlotError {
    /// A figure that does not apply to this motion.
    NotThere {
        /// Figure that was requested.
        figure: Figure,
        /// Reason, a fact about the motion: `a torque acts on the body: it has no polhode`.
        why: &'static str,
    },
    /// A motion with fewer than two samples.
    TooFewSamples {
        /// Number of samples.
        count: usize,
    },
    /// Samples too far apart to follow the angles.
    TooCoarse {
        /// Figure that was requested.
        figure: Figure,
        /// Largest rotation between consecutive samples, rad.
        turn: f64,
    },
    /// A curve that cannot be computed, such as one with too many points.
    Curve {
        /// Figure that was requested.
        figure: Figure,
        /// Error of the curve.
        error: CurveError,
    },
}

impl PlotError {
    /// Returns advice for the user.
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
            Self::NotThere { figure, why } => write!(f, "the motion has no figure {}: {why}", figure.name()),
            Self::TooFewSamples { count } => {
                write!(f, "a plot against time needs at least 2 samples, but the motion has {count}")
            }
            Self::TooCoarse { figure, turn } => write!(
                f,
                "cannot draw the figure {}: the body rotates by up to {} rad from one sample to the next",
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
