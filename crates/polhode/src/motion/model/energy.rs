//! The energy of a system at one time.

/// Energy of a system at one time, and the work done on it since the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy {
    /// Kinetic energy, J. For a free or pivoted rotor: that of the rotation. For a body on the
    /// ground: that of the centre of mass included. For a rotor in gimbals: that of the gimbals
    /// included.
    pub kinetic: f64,
    /// Potential energy, J, of the torques, the weight, the weights on the mechanism and the
    /// springs; `None` if some torque has no potential.
    pub potential: Option<f64>,
    /// Work since the start, J. Free or pivoted rotor: of all torques. Body on the ground: of
    /// friction and of the ground. Gimbals: of damping, motors, constant torques and the base.
    pub work: f64,
}
