//! A body of an ensemble, and what becomes of it.

use core::fmt;

use crate::motion::error::MotionError;
use crate::motion::model::event::{Crossing, Event};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;

/// A body of an ensemble, and its motion.
///
/// A member with events, or with torques that are switched off, is computed alone, as [`Simulation::run`](crate::motion::Simulation::run) has it: what
/// detects events looks at the motion within each step.
#[derive(Clone, Debug)]
pub struct Member {
    /// The body, the point that it turns about, and its wheels.
    pub rotor: Rotor,
    /// What turns it.
    pub torques: Vec<TorqueModel>,
    /// Which of the torques, from 0, are switched off until an event switches them on.
    pub switched_off: Vec<usize>,
    /// Where it starts.
    pub start: State,
    /// The events to detect.
    pub events: Vec<Event>,
}

impl Member {
    /// A body under torques, all of which act, without events.
    pub const fn new(rotor: Rotor, torques: Vec<TorqueModel>, start: State) -> Self {
        Self { rotor, torques, switched_off: Vec::new(), start, events: Vec::new() }
    }

    /// Detects these events.
    #[must_use]
    pub fn watching(self, events: Vec<Event>) -> Self {
        Self { events, ..self }
    }

    /// Leaves these torques, from 0, switched off until an event switches them on.
    #[must_use]
    pub fn switched_off(self, switched_off: Vec<usize>) -> Self {
        Self { switched_off, ..self }
    }

    /// True if its steps are looked at: for events, and for what they switch.
    pub(super) const fn is_watched(&self) -> bool {
        !self.events.is_empty() || !self.switched_off.is_empty()
    }
}

/// Why a member could go no further.
#[derive(Clone, Debug, PartialEq)]
pub struct MemberFailure {
    /// The member, from 0.
    pub member: usize,
    /// The cause.
    pub cause: MotionError,
}

impl fmt::Display for MemberFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "member {}: {}", self.member, self.cause)
    }
}

impl core::error::Error for MemberFailure {}

/// The event that stopped a member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberStop {
    /// The member, from 0.
    pub member: usize,
    /// Which of its events, from 0.
    pub event: usize,
    /// When, s.
    pub time: f64,
}

/// An event of a member that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct MemberCrossing {
    /// The member, from 0.
    pub member: usize,
    /// What happened.
    pub crossing: Crossing,
}
