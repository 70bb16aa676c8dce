//! Standard figures, by name.

/// Figure that `polhode` draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Figure {
    /// ω along the principal axes, against time.
    Omega,
    /// Euler angles of the body, 3-1-3, against time.
    Euler,
    /// Angles of the body's directions to nadir, velocity or another direction of interest, against
    /// time.
    Pointing,
    /// T, against time: its shares along the principal axes, or U and T + U.
    Energy,
    /// L, against time: in the body if it is free, else in space.
    Momentum,
    /// Momenta and speeds of the wheels, against time.
    Wheels,
    /// N along body axes, against time.
    Torque,
    /// Departures of T and L from their balances, against time, on a logarithmic scale.
    Drift,
    /// L in the body on its sphere: this motion, others of the same |L|, and the separatrix between
    /// them.
    Polhodes,
    /// Path of ω on the invariable plane.
    Herpolhode,
    /// Path of the axis of a body that gravity turns about a pivot, on a sphere and unrolled.
    Axis,
}

impl Figure {
    /// All figures, in the order in which a sheet of them is read.
    pub const ALL: [Self; 11] = [
        Self::Omega,
        Self::Euler,
        Self::Pointing,
        Self::Axis,
        Self::Polhodes,
        Self::Herpolhode,
        Self::Energy,
        Self::Momentum,
        Self::Wheels,
        Self::Torque,
        Self::Drift,
    ];

    /// Returns its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Omega => "omega",
            Self::Euler => "euler",
            Self::Pointing => "pointing",
            Self::Energy => "energy",
            Self::Momentum => "momentum",
            Self::Wheels => "wheels",
            Self::Torque => "torque",
            Self::Drift => "drift",
            Self::Polhodes => "polhodes",
            Self::Herpolhode => "herpolhode",
            Self::Axis => "axis",
        }
    }

    /// Returns the figure of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|figure| figure.name() == name)
    }
}
