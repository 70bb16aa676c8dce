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
        /// Interpretations that were tried, best first, with their relative residuals.
        tried: Vec<(String, f64)>,
    },
    /// Several interpretations fit, and give different starts.
    Ambiguous {
        /// Interpretations that fit, best first, with their relative residuals.
        fitting: Vec<(String, f64)>,
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
            Self::Unlike { ratio, tried } => {
                let ratio = number(*ratio, 4);
                write!(
                    f,
                    "the next rows do not rotate as the ω of the first row states; the rate is {ratio} times |ω|"
                )?;
                &tried[..tried.len().min(2)]
            }
            Self::Ambiguous { fitting } => {
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
            Self::NoOmega => {
                "state ω at the first row along body axes by --start-omega; or name its columns: --columns \"omega body = wx wy wz\""
            }
            Self::Unlike { .. } => {
                "check the units of ω and of the times (deg/s for rad/s is a factor of 57.3): --columns \"omega deg/s = wx wy wz\"; or state the \
                 conventions: --quaternion, --sense, --omega body or space"
            }
            Self::Ambiguous { .. } => "state its conventions: --quaternion, --sense, --omega body or space",
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
