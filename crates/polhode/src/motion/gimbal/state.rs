//! The state of a rotor in its gimbals at one time.

use crate::math::frame::{Body, Space};
use crate::math::vector::{AngularMomentum, Torque};
use crate::motion::model::energy::Energy;
use crate::motion::model::state::State;
use crate::motion::solve::system::Sampled;

/// A rotor in its gimbals at one time. Where there are three numbers for axes, they are the outer's, the inner's and the rotor's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GimbalState {
    /// Time, and attitude and ω of the rotor, both relative to space.
    pub state: State,
    /// α, β, γ, rad.
    pub angles: [f64; 3],
    /// Their rates, rad/s.
    pub rates: [f64; 3],
    /// The torques of the locks and motors that hold axes, N·m; zero of axes that are free.
    pub holding: [f64; 3],
    /// L of the rotor and its gimbals about the crossing.
    pub momentum: AngularMomentum<Space>,
    /// The torque about the crossing on the rotor, of its weight and of the gimbals.
    pub torque: Torque<Body>,
    /// T of the rotor and its gimbals, the turning of the base included, J.
    pub kinetic_energy: f64,
    /// −Σ m c · g, J: zero with all centres of mass at the crossing.
    pub potential_energy: f64,
    /// The energy of springs, J.
    pub spring_energy: f64,
    /// The work of damping since the start, J: never positive.
    pub damping_work: f64,
    /// The work of motors since the start, J.
    pub motor_work: f64,
    /// The work of constant torques since the start, J.
    pub torque_work: f64,
    /// The work since the start that the base does by its turning, J: ω₀ · (L − L(0)).
    pub base_work: f64,
}

impl GimbalState {
    /// Energy with that of springs, and the works of damping, motors, constant torques and the base.
    pub(in crate::motion) fn energy(&self) -> Energy {
        Energy {
            kinetic: self.kinetic_energy,
            potential: Some(self.potential_energy + self.spring_energy),
            work: self.work(),
        }
    }

    /// All works since the start: of damping, motors, constant torques and the base, J.
    fn work(&self) -> f64 {
        self.damping_work + self.motor_work + self.torque_work + self.base_work
    }

    /// T + U and the energy of springs, less all works, J: as it was at the start.
    pub(in crate::motion) fn balance(&self) -> f64 {
        self.kinetic_energy + self.potential_energy + self.spring_energy - self.work()
    }

    /// Sum of all absolute energies and works, J.
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
