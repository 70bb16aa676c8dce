//! The forces on the particles of a prescribed motion.

use polhode::motion::{ParticleForce, Required, Scenario};

/// The force on each particle; empty unless particles are all that the body is made of.
pub(crate) fn on_particles(scenario: &Scenario, needed: &Required) -> Vec<ParticleForce> {
    if !scenario.is_all_particles() {
        return Vec::new();
    }
    let point = scenario.pivot().unwrap_or(scenario.body().center_of_mass());
    let force = |p| ParticleForce::on(p, point, needed.state.omega, needed.acceleration);
    scenario.particles().iter().map(force).collect()
}
