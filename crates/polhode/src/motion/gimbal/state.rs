//! The state of a rotor in its gimbals at one time.

use crate::math::frame::{Body, Space};
use crate::math::vector::{AngularMomentum, Torque};
use crate::motion::model::energy::Energy;
use crate::motion::model::state::State;
use crate::motion::solve::system::Sampled;

/// State of a rotor in its gimbals at one time. Arrays of three are in the order outer axis, inner
/// axis, rotor axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GimbalState {
    /// Time, and attitude and ω of the rotor relative to space.
    pub state: State,
    /// Angles α, β, γ, rad.
    pub angles: [f64; 3],
    /// Rates of the angles, rad/s.
    pub rates: [f64; 3],
    /// Torques of the locks and motors about their axes, N·m; zero for free axes.
    pub holding: [f64; 3],
    /// L of rotor and gimbals about the intersection of the axes.
    pub momentum: AngularMomentum<Space>,
    /// Torque on the rotor about the intersection of the axes, due to its weight and the gimbals.
    pub torque: Torque<Body>,
    /// Kinetic energy T of rotor and gimbals, rotation of the base included, J.
    pub kinetic_energy: f64,
    /// Potential energy −Σ m c · g, J: zero if all centres of mass are at the intersection of the
    /// axes.
    pub potential_energy: f64,
    /// Energy of the springs, J.
    pub spring_energy: f64,
    /// Work of damping since the start, J: never positive.
    pub damping_work: f64,
    /// Work of motors since the start, J.
    pub motor_work: f64,
    /// Work of constant torques since the start, J.
    pub torque_work: f64,
    /// Work done by the rotation of the base since the start, J: ω₀ · (L − L(0)).
    pub base_work: f64,
}

impl GimbalState {
    /// Returns the energies, springs included, and the work of damping, motors, constant torques
    /// and the base.
    pub(in crate::motion) fn energy(&self) -> Energy {
        Energy {
            kinetic: self.kinetic_energy,
            potential: Some(self.potential_energy + self.spring_energy),
            work: self.work(),
        }
    }

    /// Returns the total work since the start, of damping, motors, constant torques and the base,
    /// J.
    fn work(&self) -> f64 {
        self.damping_work + self.motor_work + self.torque_work + self.base_work
    }

    /// Returns T + U plus the energy of the springs minus the total work, J: constant along the
    /// motion.
    pub(in crate::motion) fn balance(&self) -> f64 {
        self.kinetic_energy + self.potential_energy + self.spring_energy - self.work()
    }

    /// Returns the sum of the absolute values of all energies and works, J.
    pub(in crate::motion) fn size_of_balance(&self) -> f64 {
        let energies = [self.kinetic_energy, self.potential_energy, self.spring_energy];
        let works = [self.damping_work, self.motor_work, self.torque_work, self.base_work];
        energies.iter().chain(&works).map(|x| x.abs()).sum()
    }
}

impl Sampled for GimbalState {
    fn state(&self) -> State {
        self.state
    }
}
