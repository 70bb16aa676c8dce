//! Torques: a sum of small models, each in its own file.

pub(crate) mod constant;
pub(crate) mod drag;
pub(crate) mod energy_sink;
pub(crate) mod formula;
pub(crate) mod gravity;
pub(crate) mod gravity_gradient;
pub(crate) mod magnetic;
pub(crate) mod schedule;
pub(crate) mod scheduled;
pub(crate) mod thruster;
pub(crate) mod torsion;

use super::rotor::Rotor;
use super::state::State;
use super::wheel::Wheel;
use crate::math::frame::Body;
use crate::math::vector::Torque;

pub use constant::ConstantTorque;
pub use drag::{Drag, DragLaw};
pub use energy_sink::EnergySink;
pub use formula::FormulaTorque;
pub use gravity::UniformGravity;
pub use gravity_gradient::{Attracted, GravityGradient};
pub use magnetic::{Magnetic, MagneticField};
pub use schedule::Schedule;
pub use scheduled::Scheduled;
pub use thruster::Thruster;
pub use torsion::Torsion;
pub(crate) use torsion::half_angle_over_sine;

/// One cause of torque about the point that the body turns about.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum TorqueModel {
    /// Constant along body or space axes.
    Constant(ConstantTorque),
    /// The weight of a body held at a pivot.
    Gravity(UniformGravity),
    /// Gravity that differs from one end of an orbiting body to the other.
    GravityGradient(Box<GravityGradient>),
    /// Resistance to turning.
    Drag(Drag),
    /// A torsion spring or wire.
    Torsion(Torsion),
    /// A magnet in a field.
    Magnetic(Box<Magnetic>),
    /// A force fixed to the body.
    Thruster(Thruster),
    /// Energy lost inside the body.
    EnergySink(EnergySink),
    /// Given by formulas.
    Formula(Box<FormulaTorque>),
    /// Another one, at its times only.
    Scheduled(Box<Scheduled>),
}

impl TorqueModel {
    /// The torque on the body in a state, body axes, N·m. What acts inside the body only is none.
    pub fn torque(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        match self {
            Self::Constant(model) => model.torque(state.attitude),
            Self::Gravity(model) => model.torque(rotor, state.attitude),
            Self::GravityGradient(model) => model.torque(rotor, state),
            Self::Drag(model) => model.torque(state),
            Self::Torsion(model) => model.torque(state),
            Self::Magnetic(model) => model.torque(state),
            Self::Thruster(model) => model.torque(rotor),
            Self::EnergySink(_) => Torque::ZERO,
            Self::Formula(model) => model.torque(rotor, state),
            Self::Scheduled(model) if model.schedule.is_on(state.time) => model.torque.torque(rotor, state),
            Self::Scheduled(_) => Torque::ZERO,
        }
    }

    /// The potential energy whose loss is this torque's work, J; `None` if it has none.
    pub fn potential(&self, rotor: &Rotor, state: &State) -> Option<f64> {
        match self {
            Self::Gravity(model) => Some(model.potential(rotor, state.attitude)),
            Self::Torsion(model) => Some(model.potential(state.attitude)),
            Self::Magnetic(model) => model.potential(state.attitude),
            // In general: a torque that follows the body, or that changes with time, has none.
            _ => None,
        }
    }

    /// Its greatest size, or where there is none its size in a state, N·m: what its rounding is relative to.
    pub(crate) fn scale(&self, rotor: &Rotor, state: &State) -> f64 {
        match self {
            Self::Constant(model) => model.scale(),
            Self::Gravity(model) => rotor.mass() * model.acceleration.norm() * rotor.lever().norm(),
            Self::GravityGradient(model) => model.scale(rotor),
            Self::Drag(model) => model.scale(rotor, state),
            Self::Torsion(model) => model.scale(),
            Self::Magnetic(model) => model.scale(),
            Self::Thruster(model) => model.scale(rotor),
            Self::EnergySink(_) => 0.0,
            Self::Formula(model) => model.scale(rotor, state),
            Self::Scheduled(model) => model.torque.scale(rotor, state),
        }
    }

    /// α of an energy sink, 1/(N·m·s); zero for everything else.
    pub(crate) const fn sink(&self) -> f64 {
        match self {
            Self::EnergySink(model) => model.coefficient(),
            _ => 0.0,
        }
    }

    /// Why it cannot be expanded into a power series, if it cannot.
    pub(crate) fn roughness(&self) -> Option<&'static str> {
        match self {
            Self::Formula(model) => model.roughness(),
            Self::Scheduled(model) => model.torque.roughness(),
            _ => None,
        }
    }

    /// When it begins or ends next after a time, s; infinite if it does not.
    pub(crate) fn next_change(&self, time: f64) -> f64 {
        match self {
            Self::Scheduled(model) => model.schedule.next_change(time).min(model.torque.next_change(time)),
            _ => f64::INFINITY,
        }
    }

    /// How many pulses begin after a time and no later than another.
    pub(crate) fn pulses_between(&self, from: f64, to: f64) -> f64 {
        match self {
            Self::Scheduled(model) => {
                model.schedule.pulses_between(from, to) + model.torque.pulses_between(from, to)
            }
            _ => 0.0,
        }
    }

    /// What it is just after a time, without a schedule; `None` if it does not act then.
    pub(crate) fn acting(&self, time: f64) -> Option<&Self> {
        match self {
            Self::Scheduled(model) if model.schedule.is_on(time) => model.torque.acting(time),
            Self::Scheduled(_) => None,
            model => Some(model),
        }
    }

    /// The name in scenario files and summaries.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Constant(_) => "constant",
            Self::Gravity(_) => "gravity",
            Self::GravityGradient(_) => "gravity_gradient",
            Self::Drag(_) => "drag",
            Self::Torsion(_) => "torsion",
            Self::Magnetic(_) => "magnetic",
            Self::Thruster(_) => "thruster",
            Self::EnergySink(_) => "energy_sink",
            Self::Formula(_) => "formula",
            Self::Scheduled(model) => model.torque.name(),
        }
    }
}

/// The sum of torques, body axes, N·m.
pub(crate) fn total_torque<'a>(
    models: impl IntoIterator<Item = &'a TorqueModel>,
    rotor: &Rotor,
    state: &State,
) -> Torque<Body> {
    models.into_iter().fold(Torque::ZERO, |sum, model| sum + model.torque(rotor, state))
}

/// The sum of all potentials, J; `None` if some torque has none (or there is no torque), or if a motor
/// does work on the body.
pub(crate) fn total_potential(models: &[TorqueModel], rotor: &Rotor, state: &State) -> Option<f64> {
    if rotor.wheels().iter().any(Wheel::is_driven) {
        return None;
    }
    let (first, others) = models.split_first()?;
    others
        .iter()
        .try_fold(first.potential(rotor, state)?, |sum, model| Some(sum + model.potential(rotor, state)?))
}
