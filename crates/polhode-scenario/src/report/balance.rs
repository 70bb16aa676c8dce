//! What a computed motion should keep, by name: the lines of its drift.

use polhode::motion::{Mechanism, MethodReason, Sample, Scenario, Solution, Trajectory};
use polhode::observe::Drift;

/// What turns a body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Driven {
    /// A torque acts, or would have to, or the ground or gimbals do.
    pub by_torques: bool,
    /// Wheels spin inside.
    pub by_wheels: bool,
    /// Its mass changes.
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

    /// What the work done since the start is called.
    pub(crate) const fn work(self) -> &'static str {
        if self.by_torques || self.by_mass { "work" } else { "work of the motors" }
    }
}

/// True if all samples have a finite potential energy.
pub(crate) fn has_potential<'a>(samples: impl IntoIterator<Item = &'a Sample>) -> bool {
    samples.into_iter().all(|sample| sample.potential_energy.is_some_and(f64::is_finite))
}

/// One balance, and how far it fails at each sample, relative to its size.
#[derive(Clone, Debug)]
pub(crate) struct Balance {
    pub name: &'static str,
    pub values: Vec<f64>,
}

/// The balances that a motion keeps, and that say something of how it was computed; with the estimated error of the attitude, if
/// there is one. None of a prescribed motion.
pub(crate) fn balances(trajectory: &Trajectory, driven: Driven) -> Vec<Balance> {
    let error = trajectory.error().map(|error| Balance {
        name: "attitude error, rad (estimate)",
        values: error.computation().iter().map(|e| e.attitude).collect(),
    });
    kept(trajectory, driven).into_iter().chain(error).collect()
}

/// The balance of energy of a body on the ground or in gimbals, by name; `None` of any other motion.
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
    let Some(drift) = Drift::along(trajectory) else { return Vec::new() };
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
    // Work and impulse of a closed form are what T and L have gained.
    if let (Solution::ClosedForm(_), Some(total)) = (trajectory.solution(), &total) {
        return vec![total.clone()];
    }
    let impulse = if driven.by_torques || driven.by_mass { "L − impulse" } else { "L in space" };
    let both = [one("T − work", |d| d.work_energy), one(impulse, |d| d.momentum)];
    both.into_iter().chain(total).collect()
}
