//! Program mistakes that are found while the meaning of a log is determined.

use core::fmt;

use super::axes::SignedAxes;

/// Mistake of a program that is found while the meaning of its log is determined. The numbers are
/// compared as stated.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LogMistake {
    /// The rows belong to later times than stated.
    LateRows {
        /// Time of the motion minus the stated time, s.
        shift: f64,
    },
    /// The components of ω have signs or an order that no right-handed axes produce.
    OmegaComponents {
        /// Order and signs of the components that the motion shows.
        components: SignedAxes,
    },
}

/// Text such as `each row has the motion of 0.05 s after its stated time`.
impl fmt::Display for LogMistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LateRows { shift } => {
                write!(f, "each row has the motion of {shift:.6} s after its stated time")
            }
            Self::OmegaComponents { components } => {
                write!(f, "ω has the components {components}, which no right-handed axes give")
            }
        }
    }
}
