//! How a trajectory ended, and why it was computed as it was.

use core::fmt;

use crate::motion::contact::ContactChange;
use crate::motion::error::MotionError;

/// How a trajectory ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// At the last of its times.
    Complete,
    /// At an event that stops it.
    Stopped {
        /// Which of the events, from 0.
        event: usize,
        /// When, s: the time of the last sample.
        time: f64,
    },
    /// At a change of the contact with the ground after which the motion is not known.
    Contact {
        /// What changed.
        change: ContactChange,
        /// When, s: the time of the last sample.
        time: f64,
    },
    /// It could not go on; what comes before is good.
    Failed {
        /// The last good time, s: that of the last sample.
        time: f64,
        /// Why.
        cause: MotionError,
    },
}

impl Ending {
    /// The ending at a time: by an event, a change of the contact, a cause, or by none of them.
    pub(crate) fn of(ended: Result<Option<Halt>, MotionError>, time: f64) -> Self {
        match ended {
            Ok(None) => Self::Complete,
            Ok(Some(Halt::Event(event))) => Self::Stopped { event, time },
            Ok(Some(Halt::Change(change))) => Self::Contact { change, time },
            Err(cause) => Self::Failed { time, cause },
        }
    }

    /// True unless the computation failed: a motion that an event stopped is all that was asked for.
    pub const fn is_complete(&self) -> bool {
        !matches!(self, Self::Failed { .. })
    }
}

/// Reason why a motion does not go on, though its computation could.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Halt {
    /// An event that stops it, by its number from 0.
    Event(usize),
    /// A change of the contact after which it is not known.
    Change(ContactChange),
}

/// Why a motion was computed by its method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MethodReason {
    /// It was asked for.
    Asked,
    /// The motion was given.
    Given,
    /// A body on the ground has series for each phase of its motion.
    Contact,
    /// The equations of a rotor in gimbals have series.
    Gimbals,
    /// A closed form is known.
    ClosedForm {
        /// Which.
        title: &'static str,
    },
    /// No closed form is known, and all torques are analytic between switching times.
    Smooth {
        /// Why there is no closed form.
        no_closed_form: &'static str,
    },
    /// No closed form is known, and a torque has no Taylor series.
    Rough {
        /// Why there is no closed form.
        no_closed_form: &'static str,
        /// Which of the torques has no series, from 0.
        torque: usize,
        /// What it has that has none: a function of a formula.
        why: &'static str,
    },
}

impl fmt::Display for MethodReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Asked => f.write_str("it was asked for"),
            Self::Given => f.write_str("the motion is given"),
            Self::Gimbals => f.write_str("the equations of a rotor in gimbals have Taylor series"),
            Self::Contact => f.write_str(
                "a body on the ground is computed phase by phase, by collocation where its motion is smooth and else by Taylor series",
            ),
            Self::ClosedForm { title } => write!(f, "there is a closed form: {title}"),
            Self::Smooth { no_closed_form } => {
                write!(
                    f,
                    "no closed form is known, as {no_closed_form}; the torques are analytic between switching times"
                )
            }
            Self::Rough { no_closed_form, torque, why } => {
                write!(
                    f,
                    "no closed form is known, as {no_closed_form}; torque {} has no Taylor series, as it has {why}",
                    torque + 1
                )
            }
        }
    }
}
