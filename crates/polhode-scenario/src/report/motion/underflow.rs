//! Energies of a rotating body that underflow.

use polhode::body::{Finding, Severity};
use polhode::motion::{Sample, Scenario, Trajectory};

/// Returns the finding `motion.underflow` if T of a sample underflows but T of the start does not.
/// For the start, the scenario has a finding of its own.
pub(crate) fn finding(scenario: &Scenario, trajectory: &Trajectory) -> Option<Finding> {
    let rotor = scenario.rotor();
    let small = |sample: &&Sample| rotor.kinetic_energy_underflows(sample.state.omega);
    let samples = trajectory.samples();
    let sample =
        samples.iter().find(small).filter(|_| !samples.first().is_some_and(|first| small(&first)))?;
    Some(Finding {
        code: "motion.underflow",
        severity: Severity::Info,
        message: format!(
            "from t = {} s on T is below 2.2e-308 J, the range of numbers with all their digits, and comes out as {:e}: energies and their \
             drift say nothing there",
            sample.state.time, sample.kinetic_energy
        ),
        place: None,
    })
}
