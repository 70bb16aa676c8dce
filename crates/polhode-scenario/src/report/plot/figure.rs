//! Standard figures, by name.

/// Standard figure of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Figure {
    /// Angular velocity ω along the principal axes, against time.
    Omega,
    /// Euler angles 3-1-3 of the body, against time.
    Euler,
    /// Pointing angles between body directions and nadir, velocity or other references, against
    /// time.
    Pointing,
    /// Energy against time: terms of T along the principal axes, or T, U and T + U.
    Energy,
    /// Angular momentum L against time, along body axes if the body is free, else along space axes.
    Momentum,
    /// Angular momenta and speeds of the wheels, against time.
    Wheels,
    /// Torque N along body axes, against time.
    Torque,
    /// Drift of T and L relative to their balances, against time, on a logarithmic scale.
    Drift,
    /// Momentum sphere in the body: this motion, others with the same |L|, and the separatrix.
    Polhodes,
    /// Path of ω on the invariable plane.
    Herpolhode,
    /// Path of the axis of a body that gravity turns about a pivot: on a sphere, and as θ over φ.
    Axis,
}

impl Figure {
    /// All figures, in the order of an overview.
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

    /// Returns the figure with this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|figure| figure.name() == name)
    }
}
