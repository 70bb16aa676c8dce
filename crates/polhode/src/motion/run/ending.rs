//! Ending of a trajectory, and reason for the method.

use core::fmt;

use crate::motion::contact::ContactChange;
use crate::motion::error::MotionError;

/// Ending of a trajectory.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// The motion was computed to the last of its times.
    Complete,
    /// An event stopped the motion.
    Stopped {
        /// Index of the event, from 0.
        event: usize,
        /// Time of the event and of the last sample, s.
        time: f64,
    },
    /// The contact with the ground changed, and the motion after the change is not known.
    Contact {
        /// Change of the contact.
        change: ContactChange,
        /// Time of the change and of the last sample, s.
        time: f64,
    },
    /// The computation failed. All samples are good.
    Failed {
        /// Last good time, that of the last sample, s.
        time: f64,
        /// Cause of the failure.
        cause: MotionError,
    },
}

impl Ending {
    /// Returns the ending at a time: by an event, a change of the contact, an error, or by none of
    /// them.
    pub(crate) fn of(ended: Result<Option<Halt>, MotionError>, time: f64) -> Self {
        match ended {
            Ok(None) => Self::Complete,
            Ok(Some(Halt::Event(event))) => Self::Stopped { event, time },
            Ok(Some(Halt::Change(change))) => Self::Contact { change, time },
            Err(cause) => Self::Failed { time, cause },
        }
    }

    /// Returns true unless the computation failed. A motion that an event stopped is complete.
    pub const fn is_complete(&self) -> bool {
        !matches!(self, Self::Failed { .. })
    }
}

/// Reason why a motion ends early although its computation could continue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Halt {
    /// Event that stops the motion, by its index from 0.
    Event(usize),
    /// Change of the contact after which the motion is not known.
    Change(ContactChange),
}

/// Reason for the method by which a motion was computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MethodReason {
    /// The user requested the method.
    Asked,
    /// The motion is prescribed.
    Given,
    /// The body is on the ground. Each phase of its motion has series.
    Contact,
    /// The rotor is in gimbals, whose equations have series.
    Gimbals,
    /// The motion has a known closed form.
    ClosedForm {
        /// Description of the closed form.
        title: &'static str,
    },
    /// The motion has no known closed form, and all torques are analytic between switching times.
    Smooth {
        /// Reason why a closed form is not available.
        no_closed_form: &'static str,
    },
    /// The motion has no known closed form, and a torque has no Taylor series.
    Rough {
        /// Reason why a closed form is not available.
        no_closed_form: &'static str,
        /// Index of the torque without a series, from 0.
        torque: usize,
        /// Function in a formula, or other part of the torque, that has no series.
        why: &'static str,
    },
}

impl fmt::Display for MethodReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Asked => f.write_str("it was requested"),
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
