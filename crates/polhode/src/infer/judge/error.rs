//! Errors of judging a motion.

use core::fmt;

use super::omega_reading::OmegaResidual;
use super::reading::ReadingResidual;
use crate::motion::error::MotionError;

/// Error of judging a motion.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum JudgeError {
    /// The scenario's motion is prescribed, so a log cannot be compared with a computed motion.
    NoMotion,
    /// The mass properties of the scenario's body change; causes of errors are implemented only for
    /// constant bodies.
    Changing,
    /// The scenario's body is on the ground; causes of errors are implemented only for bodies that
    /// are free or on a pivot.
    OnGround,
    /// The scenario's body is in gimbals; causes of errors are implemented only for bodies that are
    /// free or on a pivot.
    InGimbals,
    /// A time is before the scenario's start.
    BeforeStart {
        /// Time of the row, s.
        time: f64,
        /// Time of the start, s.
        start: f64,
    },
    /// A time is after an event that ends the scenario's motion.
    Ends {
        /// Time of the row, s.
        time: f64,
        /// End of the motion, s.
        end: f64,
    },
    /// The exact motion cannot be computed.
    Motion(MotionError),
    /// No reading of the log's numbers begins like the scenario.
    NoReading {
        /// All readings that were tried, best first.
        tried: Vec<ReadingResidual>,
    },
    /// The log rotates more than five times faster or slower than the scenario near its start, and
    /// no other unit of time fits.
    OtherRate {
        /// Angular velocity of the log relative to that of the scenario.
        ratio: f64,
        /// All readings that were tried, best first.
        tried: Vec<ReadingResidual>,
    },
    /// No reading of the log's numbers begins like the scenario. A log that starts some time after
    /// the scenario's start was not considered, because the exact motion cannot be computed far
    /// enough.
    NotSearched {
        /// All readings that were tried, best first.
        tried: Vec<ReadingResidual>,
    },
    /// Several readings of the log's numbers fit about equally well, and differ later.
    Ambiguous {
        /// All readings that were tried, best first.
        tried: Vec<ReadingResidual>,
        /// Number of readings that fit.
        fitting: usize,
    },
    /// No reading of the log's angular velocities begins like the scenario.
    NoOmega {
        /// All readings that were tried, best first.
        tried: Vec<OmegaResidual>,
    },
    /// Several readings of the log's angular velocities fit about equally well, and differ later.
    AmbiguousOmega {
        /// Readings that fit, best first.
        tried: Vec<OmegaResidual>,
    },
    /// The first row is too long after the scenario's start to compute the motion up to it, and the
    /// log does not begin like the scenario's start either.
    FarTimes {
        /// Time of the first row, s.
        first: f64,
        /// Time of the scenario's start, s.
        start: f64,
    },
}

impl fmt::Display for JudgeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoMotion => {
                f.write_str("the scenario prescribes its motion, so it has no computed motion to compare with")
            }
            Self::Changing => f.write_str(
                "the mass properties of the scenario's body change, but only motions of constant bodies can be judged",
            ),
            Self::OnGround => f.write_str(
                "the scenario's body is on the ground, but only motions of bodies that are free or held at a point can be judged",
            ),
            Self::InGimbals => f.write_str(
                "the scenario's body is in gimbals, but only motions of bodies that are free or held at a point can be judged",
            ),
            Self::BeforeStart { time, start } => {
                write!(f, "the run has a row at {time} s, before the scenario's start at {start} s")
            }
            Self::Ends { time, end } => {
                write!(f, "the run has a row at {time} s, after the scenario's motion has ended at {end} s")
            }
            Self::Motion(error) => error.fmt(f),
            Self::NoReading { tried } => {
                f.write_str("no interpretation of the run's attitudes matches the scenario at the beginning")?;
                list(f, tried, 4)
            }
            Self::OtherRate { ratio, tried } => {
                write!(
                    f,
                    "the run rotates {ratio:.4} times as fast as the scenario at its start, and no other unit of time fits"
                )?;
                list(f, tried, 2)
            }
            Self::NotSearched { tried } => {
                f.write_str(
                    "no interpretation of the run's attitudes matches the scenario at the beginning; a later beginning was not searched, \
                     because the exact motion cannot be computed far enough",
                )?;
                list(f, tried, 4)
            }
            Self::Ambiguous { tried, fitting } => {
                write!(f, "{fitting} interpretations of the run's attitudes fit its beginning, but differ later")?;
                list(f, tried, *fitting)
            }
            Self::NoOmega { tried } => {
                f.write_str("no interpretation of the run's angular velocities matches the scenario at the beginning")?;
                list_omega(f, tried)
            }
            Self::AmbiguousOmega { tried } => {
                f.write_str("several interpretations of the run's angular velocities fit, but differ later")?;
                list_omega(f, tried)
            }
            Self::FarTimes { first, start } => write!(
                f,
                "the run's first row is at {first} s, too long after the scenario's start at {start} s for the motion to be computed \
                 until then, and it does not match the scenario's start either"
            ),
        }
    }
}

fn list_omega(f: &mut fmt::Formatter<'_>, tried: &[OmegaResidual]) -> fmt::Result {
    for (k, OmegaResidual { reading, relative }) in tried.iter().take(3).enumerate() {
        write!(f, "{} {reading} (error {relative:.1e} of |ω|)", if k == 0 { ":" } else { ";" })?;
    }
    Ok(())
}

fn list(f: &mut fmt::Formatter<'_>, tried: &[ReadingResidual], count: usize) -> fmt::Result {
    for (k, ReadingResidual { reading, attitude, .. }) in tried.iter().take(count).enumerate() {
        write!(f, "{} {reading} (error {attitude:.1e} rad)", if k == 0 { ":" } else { ";" })?;
    }
    Ok(())
}

impl core::error::Error for JudgeError {}

impl From<MotionError> for JudgeError {
    fn from(error: MotionError) -> Self {
        Self::Motion(error)
    }
}
