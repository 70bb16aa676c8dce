//! What is asked of the body of a scenario, and how it is held.

use super::mounted_shaft::MountedShaft;
use crate::math::frame::{Body, Space};
use crate::math::vector::{Direction, Position};
use crate::motion::contact::{Contact, StartVelocity};
use crate::motion::gimbal::Gimbals;
use crate::motion::inverse::prescribed::Prescribed;
use crate::motion::model::event::Event;
use crate::motion::model::event_detection::EventSide;
use crate::motion::model::torque::TorqueModel;

/// What is asked of the body.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Task {
    /// Forward dynamics: from torques to the motion.
    Forward(Forward),
    /// Inverse dynamics: from a motion to the torque that it needs.
    Inverse(Prescribed),
    /// A shaft that turns as prescribed: what its bearings hold.
    Shaft(Box<MountedShaft>, Prescribed),
}

/// The torques on a body, and the events to detect.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Forward {
    pub(super) torques: Vec<TorqueModel>,
    pub(super) names: Vec<Option<String>>,
    pub(super) switched_off: Vec<usize>,
    pub(super) events: Vec<Event>,
    /// On which side of each event's value it starts, where another motion goes on.
    pub(super) event_sides: Vec<EventSide>,
    pub(super) hanging: Option<Suspension>,
}

/// A torque of a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct ActingTorque {
    /// What turns the body.
    pub model: TorqueModel,
    /// By which events switch it.
    pub name: Option<String>,
    /// Whether it acts from the start, or once an event has switched it on.
    pub is_on: bool,
}

impl From<TorqueModel> for ActingTorque {
    fn from(model: TorqueModel) -> Self {
        Self { model, name: None, is_on: true }
    }
}

/// How a body is on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundContact {
    /// What touches what, and how.
    pub contact: Contact,
    /// The point of the ground that is touched at the start.
    pub at: Position<Space>,
    /// The velocity of the centre of mass at the start.
    pub velocity: StartVelocity,
}

/// The support of a body while it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mechanism<'a> {
    /// A rotor that is free or held at a pivot.
    Rotor,
    /// A body on the ground.
    Ground(&'a GroundContact),
    /// A rotor in gimbals.
    Gimbals(&'a Gimbals),
}

/// The fixed axis of a pendulum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Suspension {
    /// The axis through the pivot.
    pub axis: Direction<Body>,
    /// The amplitude of its swing, rad; that of the start if `None`.
    pub amplitude: Option<f64>,
}
