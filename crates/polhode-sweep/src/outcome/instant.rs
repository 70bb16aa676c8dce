//! Motion at one time.

use polhode::motion::State;

/// Motion at one time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant {
    pub(super) state: State,
    /// Rotational kinetic energy, J.
    pub(super) kinetic_energy: f64,
    /// Angular momentum |L|, kg·m²/s.
    pub(super) momentum: f64,
}
