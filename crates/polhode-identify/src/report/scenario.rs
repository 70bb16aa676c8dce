//! The body that was found, as a scenario file.

use core::fmt;

/// What is said of a body besides what was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodySize {
    /// kg
    pub mass: Option<f64>,
    /// kg·m²
    pub greatest_moment: Option<f64>,
}

/// Why there is no scenario of a body.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NoBody {
    /// Not all of it is known.
    Unknown {
        /// What was measured.
        by: &'static str,
    },
    /// Tumbles do not show the mass.
    Mass,
    /// These tumbles do not show how large the moments are.
    Size,
    /// It was found, and cannot be said.
    Found {
        /// `mass`, `greatest-moment`
        what: &'static str,
    },
}

impl NoBody {
    /// What to do.
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::Unknown { .. } => "leave --body out to see what is unknown",
            Self::Mass => "weigh the body, and say it: --mass \"350 g\"",
            Self::Size => "say how large it is, as by one swing test: --greatest-moment \"0.0166 kg m^2\"",
            Self::Found { .. } => "leave the flag out",
        }
    }
}

impl fmt::Display for NoBody {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { by } => {
                write!(f, "--body has no body to print: {by} does not determine all of it")
            }
            Self::Mass => f.write_str("--body has no body to print: free motion does not show the mass"),
            Self::Size => {
                f.write_str("--body has no body to print: this motion shows only ratios of moments")
            }
            Self::Found { what } => {
                write!(f, "--{what} has nothing to say: the {} was found", what.replace('-', " "))
            }
        }
    }
}

impl std::error::Error for NoBody {}
