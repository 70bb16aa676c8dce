//! The energy of a system at one time.

/// Energy of a system at one time, and the work done on it since the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy {
    /// Kinetic energy, J: of a free or pivoted rotor that of its rotation, of a body on the ground with that of its
    /// centre of mass, of a rotor in gimbals with that of the gimbals.
    pub kinetic: f64,
    /// Potential energy, J: of the torques, of the weight, of weights and springs; `None` if some torque has none.
    pub potential: Option<f64>,
    /// Work since the start, J: of all torques on a free or pivoted rotor; of friction and of the ground; of damping,
    /// motors, constant torques and the base.
    pub work: f64,
}
