//! Classical orbital elements.

/// Classical orbital elements at t = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitalElements {
    /// Semi-major axis a, m; negative for a hyperbola.
    pub semi_major_axis: f64,
    /// Eccentricity e, not 1.
    pub eccentricity: f64,
    /// Inclination i to the xy plane of space, rad.
    pub inclination: f64,
    /// Longitude Ω of the ascending node, from the x axis of space, rad.
    pub node: f64,
    /// Argument of periapsis ω, from the node, rad.
    pub periapsis: f64,
    /// Position on the orbit.
    pub anomaly: Anomaly,
}

/// Anomaly: position on an orbit, measured from the periapsis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Anomaly {
    /// Mean anomaly M, rad: grows linearly with time.
    Mean(f64),
    /// True anomaly ν, rad: the angle at the point mass.
    True(f64),
}
