//! Members of an ensemble: inputs, failures, stops and events.

use core::fmt;

use crate::motion::error::MotionError;
use crate::motion::model::event::{Crossing, Event};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;

/// Member of an ensemble: a body, its torques and its start.
///
/// A member with events, or with torques that are switched off, is computed separately, like
/// [`Simulation::run`](crate::motion::Simulation::run). The reason is that event detection examines
/// the motion within each step.
#[derive(Clone, Debug)]
pub struct Member {
    /// Body, its reference point, and its wheels.
    pub rotor: Rotor,
    /// Torques on the body.
    pub torques: Vec<TorqueModel>,
    /// Indices, from 0, of the torques that are switched off until an event switches them on.
    pub switched_off: Vec<usize>,
    /// State at the start.
    pub start: State,
    /// Events to detect.
    pub events: Vec<Event>,
}

impl Member {
    /// Creates a member without events. All torques act.
    pub const fn new(rotor: Rotor, torques: Vec<TorqueModel>, start: State) -> Self {
        Self { rotor, torques, switched_off: Vec::new(), start, events: Vec::new() }
    }

    /// Adds events to detect.
    #[must_use]
    pub fn watching(self, events: Vec<Event>) -> Self {
        Self { events, ..self }
    }

    /// Sets the torques, by index from 0, that are switched off until an event switches them on.
    #[must_use]
    pub fn switched_off(self, switched_off: Vec<usize>) -> Self {
        Self { switched_off, ..self }
    }

    /// Returns true if the motion within the steps must be examined, for events or for switched
    /// torques.
    pub(super) const fn is_watched(&self) -> bool {
        !self.events.is_empty() || !self.switched_off.is_empty()
    }
}

/// Failure of a member, whose motion could not be computed to the last time.
#[derive(Clone, Debug, PartialEq)]
pub struct MemberFailure {
    /// Index of the member, from 0.
    pub member: usize,
    /// Cause of the failure.
    pub cause: MotionError,
}

impl fmt::Display for MemberFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "member {}: {}", self.member, self.cause)
    }
}

impl core::error::Error for MemberFailure {}

/// Event that stopped a member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberStop {
    /// Index of the member, from 0.
    pub member: usize,
    /// Index of the event among those of the member, from 0.
    pub event: usize,
    /// Time of the event, s.
    pub time: f64,
}

/// Event of a member that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct MemberCrossing {
    /// Index of the member, from 0.
    pub member: usize,
    /// Event and state.
    pub crossing: Crossing,
}
