//! A motion at one time.

use polhode::motion::State;

/// A motion at one time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant {
    pub(super) state: State,
    /// J
    pub(super) kinetic_energy: f64,
    /// |L|, kg·m²/s
    pub(super) momentum: f64,
}
