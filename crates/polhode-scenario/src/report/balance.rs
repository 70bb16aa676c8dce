//! Quantities that a computed motion should conserve, by name, and their drift.

use polhode::motion::{Mechanism, MethodReason, Sample, Scenario, Solution, Trajectory};
use polhode::observe::Drift;

/// Causes that make the motion differ from that of a free rigid body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Driven {
    /// A torque acts, the motion is prescribed, or the ground or gimbals hold the body.
    pub by_torques: bool,
    /// Wheels spin inside the body.
    pub by_wheels: bool,
    /// The mass of the body changes.
    pub by_mass: bool,
}

impl Driven {
    pub(crate) fn of(scenario: &Scenario) -> Self {
        Self {
            by_torques: scenario.prescribed().is_some()
                || !scenario.torques().is_empty()
                || scenario.mechanism() != Mechanism::Rotor,
            by_wheels: !scenario.wheels().is_empty(),
            by_mass: scenario.history().is_some(),
        }
    }

    /// True if the motion is not that of a free rigid body.
    pub(crate) const fn at_all(self) -> bool {
        self.by_torques || self.by_wheels || self.by_mass
    }

    /// Returns the name of the work done since the start.
    pub(crate) const fn work(self) -> &'static str {
        if self.by_torques || self.by_mass { "work" } else { "work of the motors" }
    }
}

/// Returns true if all samples have a finite potential energy.
pub(crate) fn has_potential<'a>(samples: impl IntoIterator<Item = &'a Sample>) -> bool {
    samples.into_iter().all(|sample| sample.potential_energy.is_some_and(f64::is_finite))
}

/// A balance and its error at each sample, relative to the size of its terms.
#[derive(Clone, Debug)]
pub(crate) struct Balance {
    pub name: &'static str,
    pub values: Vec<f64>,
}

/// Returns the balances that a motion should keep and that test its computation. The estimated
/// error of the attitude follows, if there is one. A prescribed motion has no balance.
pub(crate) fn balances(trajectory: &Trajectory, driven: Driven) -> Vec<Balance> {
    let error = trajectory.error().map(|error| Balance {
        name: "attitude error, rad (estimate)",
        values: error.computation().iter().map(|e| e.attitude).collect(),
    });
    kept(trajectory, driven).into_iter().chain(error).collect()
}

/// Returns the name of the energy balance of a body on the ground or in gimbals; `None` for any
/// other motion.
pub(crate) fn energy_balance(trajectory: &Trajectory) -> Option<&'static str> {
    match trajectory.reason() {
        MethodReason::Contact => Some("T + U − works of the contact"),
        MethodReason::Gimbals => Some("T + U − works of the axes and the base"),
        _ => None,
    }
}

fn kept(trajectory: &Trajectory, driven: Driven) -> Vec<Balance> {
    if let Some(name) = energy_balance(trajectory) {
        return vec![Balance { name, values: trajectory.energy_departures() }];
    }
    let Some(drift) = Drift::at_samples(trajectory) else { return Vec::new() };
    let one = |name: &'static str, value: fn(&Drift) -> f64| Balance {
        name,
        values: drift.iter().map(value).collect(),
    };
    if !driven.at_all() {
        return vec![
            one("T", |d| d.kinetic_energy),
            one("|L|", |d| d.momentum_magnitude),
            one("L in space", |d| d.momentum),
        ];
    }
    let has_potential = drift.iter().all(|d| d.total_energy.is_some());
    let total = has_potential.then(|| one("T + U", |d| d.total_energy.unwrap_or_default()));
    // In a closed form, work and impulse are the gains of T and L, so they test nothing.
    if let (Solution::ClosedForm(_), Some(total)) = (trajectory.solution(), &total) {
        return vec![total.clone()];
    }
    let impulse = if driven.by_torques || driven.by_mass { "L − impulse" } else { "L in space" };
    let both = [one("T − work", |d| d.work_energy), one(impulse, |d| d.momentum)];
    both.into_iter().chain(total).collect()
}
