//! The state of a body and its contact at one time.

use super::change::ContactPhase;
use crate::math::frame::{Body, Space};
use crate::math::vector::{Direction, Force, Position, Torque, Velocity};
use crate::motion::model::energy::Energy;
use crate::motion::model::state::State;
use crate::motion::solve::system::Sampled;

/// A body and its contact at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactState {
    /// Time, attitude and ω.
    pub state: State,
    /// Whether it rolls, slides or flies.
    pub phase: ContactPhase,
    /// The centre of mass.
    pub center: Position<Space>,
    /// Its velocity.
    pub velocity: Velocity<Space>,
    /// Where the ground is touched; of what flies the lowest point.
    pub contact: Position<Space>,
    /// The same point in the body.
    pub contact_in_body: Position<Body>,
    /// The normal of the ground there, towards the body.
    pub normal: Direction<Space>,
    /// The velocity of the body's point of contact relative to the ground's.
    pub slip: Velocity<Space>,
    /// N ≥ 0, N.
    pub normal_force: f64,
    /// The force of friction.
    pub friction: Force<Space>,
    /// The torque about the centre of mass, of all forces at the contact.
    pub torque: Torque<Body>,
    /// T, with that of the centre of mass, J.
    pub kinetic_energy: f64,
    /// −m g · x of the centre of mass, J: zero at the origin.
    pub potential_energy: f64,
    /// The work of friction since the start, relative to the ground, J: never positive.
    pub friction_work: f64,
    /// The work that the ground has done by its own motion since the start, J.
    pub ground_work: f64,
}

impl ContactState {
    /// Energy, and the works of friction and of the ground.
    pub(in crate::motion) fn energy(&self) -> Energy {
        Energy {
            kinetic: self.kinetic_energy,
            potential: Some(self.potential_energy),
            work: self.friction_work + self.ground_work,
        }
    }

    /// T + U less the work of friction and of the ground, J: as it was at the start.
    pub(in crate::motion) fn balance(&self) -> f64 {
        self.kinetic_energy + self.potential_energy - self.friction_work - self.ground_work
    }

    /// |T| + |U| + the absolute works, J.
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
