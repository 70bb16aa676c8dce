//! Forces on the particles of a prescribed motion.

use polhode::motion::{ParticleForce, Required, Scenario};

/// Returns the force on each particle; empty unless the body consists of particles only.
pub(crate) fn on_particles(scenario: &Scenario, needed: &Required) -> Vec<ParticleForce> {
    if !scenario.is_all_particles() {
        return Vec::new();
    }
    let point = scenario.pivot().unwrap_or(scenario.body().center_of_mass());
    let force = |p| ParticleForce::of(p, point, needed.state.omega, needed.acceleration);
    scenario.particles().iter().map(force).collect()
}
