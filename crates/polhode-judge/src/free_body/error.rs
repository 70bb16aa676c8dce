//! Errors of a first row that does not determine a start.

use std::fmt;

use polhode::infer::judge::JudgeError;
use polhode_document::number::number;
use polhode_source::FormatError;

use crate::report::judge_hint;

/// Error of a first row that does not determine the start of a motion.
#[derive(Debug)]
#[non_exhaustive]
pub enum FirstRowError {
    /// The log has no ω, and none is given.
    NoOmega,
    /// Contradiction: the next rows continue the first one in no interpretation.
    Unlike {
        /// Rotation rate between the first two rows relative to |ω| of the first one.
        ratio: f64,
        /// Interpretations by the names of the columns, best first, with their relative residuals.
        tried: Vec<(String, f64)>,
        /// True if the user stated ω.
        is_given: bool,
    },
    /// Several interpretations fit, and give different starts.
    Ambiguous {
        /// Interpretations that fit, best first, with their relative residuals.
        fitting: Vec<(String, f64)>,
        /// True if the user stated ω.
        is_given: bool,
    },
    /// ω of the first row is 0, but the attitude changes later.
    AtRest {
        /// Row before the first rotation, from 1.
        row: usize,
        /// Rotation rate from this row to the next, rad/s.
        rate: f64,
    },
    /// The exact motion from the start cannot be computed.
    Motion(JudgeError),
    /// The start is outside the range of a scenario.
    Start(FormatError),
}

impl fmt::Display for FirstRowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let readings = match self {
            Self::NoOmega => {
                return f.write_str(
                    "the log has no angular velocity, so its first row does not determine the motion",
                );
            }
            Self::Motion(error) => return error.fmt(f),
            Self::Start(error) => return error.fmt(f),
            Self::AtRest { row, rate } => {
                let (rate, next) = (number(*rate, 4), row + 1);
                return write!(
                    f,
                    "ω of the first row is 0, but the attitude rotates at {rate} rad/s between rows {row} and {next}"
                );
            }
            Self::Unlike { ratio, tried, .. } => {
                f.write_str("the next rows do not rotate as the ω of the first row states; ")?;
                match *ratio {
                    0.0 => f.write_str("the attitude is the same in rows 1 and 2")?,
                    ratio => write!(f, "the rate is {} times |ω|", number(ratio, 4))?,
                }
                &tried[..tried.len().min(2)]
            }
            Self::Ambiguous { fitting, .. } => {
                let count = fitting.len();
                write!(
                    f,
                    "{count} interpretations of the first row fit the next rows, but give different starts"
                )?;
                fitting.as_slice()
            }
        };
        for (k, (reading, relative)) in readings.iter().enumerate() {
            let mark = if k == 0 { ":" } else { ";" };
            write!(f, "{mark} {reading} (error {} of the rotation)", number(*relative, 2))?;
        }
        Ok(())
    }
}

impl std::error::Error for FirstRowError {}

impl FirstRowError {
    /// Returns a hint by the options of the command.
    pub fn hint(&self) -> &'static str {
        match self {
            Self::NoOmega => "state ω at the first row along body axes by --start-omega X,Y,Z",
            Self::AtRest { row: 1, .. } => "state ω at the first row: --start-omega X,Y,Z; or delete the row",
            Self::AtRest { .. } => {
                "delete the rows before the motion, which starts at the first row; or state ω at the first row: --start-omega X,Y,Z"
            }
            Self::Unlike { is_given: true, .. } => {
                "check --start-omega, and the unit of the times: --columns \"time ms = t\"; or state the conventions: --quaternion, --sense"
            }
            Self::Unlike { .. } => {
                "check the units of ω and of the times (deg/s for rad/s is a factor of 57.3): --columns \"omega deg/s = wx wy wz\"; or state the \
                 conventions: --quaternion, --sense, --omega body or space; or ω at the first row: --start-omega X,Y,Z"
            }
            Self::Ambiguous { is_given: true, .. } => "state its conventions: --quaternion, --sense",
            Self::Ambiguous { .. } => {
                "state its conventions: --quaternion, --sense, --omega body or space; or ω at the first row: --start-omega X,Y,Z"
            }
            Self::Motion(error) => judge_hint(error).unwrap_or_default(),
            Self::Start(_) => "check the units of --moments and of ω",
        }
    }
}

impl From<JudgeError> for FirstRowError {
    fn from(error: JudgeError) -> Self {
        Self::Motion(error)
    }
}

impl From<FormatError> for FirstRowError {
    fn from(error: FormatError) -> Self {
        Self::Start(error)
    }
}
