//! Task of a scenario, and the support of its body.

use super::mounted_shaft::MountedShaft;
use crate::math::frame::{Body, Space};
use crate::math::vector::{Direction, Position};
use crate::motion::contact::{Contact, StartVelocity};
use crate::motion::gimbal::Gimbals;
use crate::motion::inverse::prescribed::Prescribed;
use crate::motion::model::event::Event;
use crate::motion::model::event_detection::EventSide;
use crate::motion::model::torque::TorqueModel;

/// Task of a scenario.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Task {
    /// Forward dynamics: computes the motion from torques.
    Forward(Forward),
    /// Inverse dynamics: computes the torque that a motion requires.
    Inverse(Prescribed),
    /// Shaft with a prescribed rotation: computes the reactions of its bearings.
    Shaft(Box<MountedShaft>, Prescribed),
}

/// Torques on a body, and events to detect.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Forward {
    pub(super) torques: Vec<TorqueModel>,
    pub(super) names: Vec<Option<String>>,
    pub(super) switched_off: Vec<usize>,
    pub(super) events: Vec<Event>,
    /// Initial side of each event's value, if the motion continues another one.
    pub(super) event_sides: Vec<EventSide>,
    pub(super) hanging: Option<Suspension>,
}

/// Torque of a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct ActingTorque {
    /// Model of the torque.
    pub model: TorqueModel,
    /// Name by which events switch the torque.
    pub name: Option<String>,
    /// True if it acts from the start; false if an event must switch it on.
    pub is_on: bool,
}

impl From<TorqueModel> for ActingTorque {
    fn from(model: TorqueModel) -> Self {
        Self { model, name: None, is_on: true }
    }
}

/// Contact of a body with the ground, and its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundContact {
    /// Surfaces, contact law and gravity.
    pub contact: Contact,
    /// Point of contact on the ground at the start, space axes, m.
    pub at: Position<Space>,
    /// Velocity of the centre of mass at the start.
    pub velocity: StartVelocity,
}

/// Support of a body during its motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mechanism<'a> {
    /// Free rotor, or rotor held at a pivot.
    Rotor,
    /// Body in contact with the ground.
    Ground(&'a GroundContact),
    /// Rotor suspended in gimbals.
    Gimbals(&'a Gimbals),
}

/// Fixed axis of a pendulum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Suspension {
    /// Direction of the axis through the pivot.
    pub axis: Direction<Body>,
    /// Amplitude of the swing, rad; `None` for the one that follows from the start.
    pub amplitude: Option<f64>,
}
