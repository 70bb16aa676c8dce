//! The classical elements of an orbit.

/// The classical elements of an orbit at t = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitalElements {
    /// a, m; negative for a hyperbola.
    pub semi_major_axis: f64,
    /// e, not 1.
    pub eccentricity: f64,
    /// i, from the xy plane of space, rad.
    pub inclination: f64,
    /// Ω, from the x axis of space to the ascending node, rad.
    pub node: f64,
    /// ω, from the node to the periapsis, rad.
    pub periapsis: f64,
    /// Where on the orbit.
    pub anomaly: Anomaly,
}

/// Where on an orbit something is, from the periapsis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Anomaly {
    /// M, rad: an angle that grows evenly with time.
    Mean(f64),
    /// ν, rad: the angle at the point mass.
    True(f64),
}
