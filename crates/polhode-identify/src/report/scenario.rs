//! Export of the estimated body as a scenario file.

use core::fmt;

/// Properties of a body that the user states in addition to the estimate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodySize {
    /// Mass, kg.
    pub mass: Option<f64>,
    /// Greatest principal moment, kg·m².
    pub greatest_moment: Option<f64>,
}

/// Reason why a body cannot be written as a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NoBody {
    /// Body that is not completely determined.
    Unknown {
        /// Kind of measurement.
        by: &'static str,
    },
    /// Mass required; tumbles do not determine it.
    Mass,
    /// Greatest moment required; these tumbles determine only ratios.
    Size,
    /// Stated value that was estimated.
    Found {
        /// Name of the option: `mass`, `greatest-moment`.
        what: &'static str,
    },
}

impl NoBody {
    /// Returns a hint on how to fix the error.
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::Unknown { .. } => "run without --body to see which parameters are unobservable",
            Self::Mass => "weigh the body, and add the mass: --mass \"350 g\"",
            Self::Size => {
                "measure the greatest moment, for example with a swing test, and add it: --greatest-moment \"0.0166 kg m^2\""
            }
            Self::Found { .. } => "remove this option",
        }
    }
}

impl fmt::Display for NoBody {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { by } => {
                write!(f, "--body cannot print the body: {by} does not determine it completely")
            }
            Self::Mass => {
                f.write_str("--body cannot print the body: free motion does not determine the mass")
            }
            Self::Size => f.write_str(
                "--body cannot print the body: this motion determines only the ratios of the moments",
            ),
            Self::Found { what } => {
                write!(f, "--{what} has no effect: the measurements determine the {}", what.replace('-', " "))
            }
        }
    }
}

impl std::error::Error for NoBody {}
