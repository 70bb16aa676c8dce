//! The state of a body and its contact at one time.

use super::change::ContactPhase;
use crate::math::frame::{Body, Space};
use crate::math::vector::{Direction, Force, Position, Torque, Velocity};
use crate::motion::model::energy::Energy;
use crate::motion::model::state::State;
use crate::motion::solve::system::Sampled;

/// State of a body and its contact at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactState {
    /// Time, attitude and ω.
    pub state: State,
    /// State of contact: rolling, sliding or flying.
    pub phase: ContactPhase,
    /// Position of the centre of mass, m.
    pub center: Position<Space>,
    /// Velocity of the centre of mass, m/s.
    pub velocity: Velocity<Space>,
    /// Point of contact on the ground, m; for a flying body its lowest point.
    pub contact: Position<Space>,
    /// Same point in the body, m.
    pub contact_in_body: Position<Body>,
    /// Normal of the ground at the contact, towards the body.
    pub normal: Direction<Space>,
    /// Slip: velocity of the body's point of contact relative to the ground, m/s.
    pub slip: Velocity<Space>,
    /// Normal force N ≥ 0, N.
    pub normal_force: f64,
    /// Force of friction, N.
    pub friction: Force<Space>,
    /// Torque about the centre of mass of all contact forces, N·m.
    pub torque: Torque<Body>,
    /// Kinetic energy T, including that of the centre of mass, J.
    pub kinetic_energy: f64,
    /// Potential energy −m g · x of the centre of mass, J: zero at the origin.
    pub potential_energy: f64,
    /// Work of friction since the start, relative to the ground, J: never positive.
    pub friction_work: f64,
    /// Work done by the motion of the ground since the start, J.
    pub ground_work: f64,
}

impl ContactState {
    /// Returns the energies, and the work of friction and of the ground.
    pub(in crate::motion) fn energy(&self) -> Energy {
        Energy {
            kinetic: self.kinetic_energy,
            potential: Some(self.potential_energy),
            work: self.friction_work + self.ground_work,
        }
    }

    /// Returns T + U minus the work of friction and of the ground, J: constant along the motion.
    pub(in crate::motion) fn balance(&self) -> f64 {
        self.kinetic_energy + self.potential_energy - self.friction_work - self.ground_work
    }

    /// Returns |T| + |U| + the absolute values of the work, J.
    pub(in crate::motion) const fn size_of_balance(&self) -> f64 {
        self.kinetic_energy.abs()
            + self.potential_energy.abs()
            + self.friction_work.abs()
            + self.ground_work.abs()
    }
}

impl Sampled for ContactState {
    fn state(&self) -> State {
        self.state
    }
}
