//! The motion of a rotor in its gimbals at given times.

use super::sample::GimbalSample;
use crate::motion::error::MotionError;
use crate::motion::solve::propagate::step_statistics::StepStatistics;

/// The motion of a rotor in its gimbals at given times.
#[derive(Clone, Debug, PartialEq)]
pub struct GimbalTrajectory {
    pub(super) start: GimbalSample,
    pub(super) samples: Vec<GimbalSample>,
    pub(super) ending: Option<(f64, MotionError)>,
    pub(super) statistics: StepStatistics,
}

impl GimbalTrajectory {
    /// The motion at the start, which need not be one of the times.
    pub const fn start(&self) -> &GimbalSample {
        &self.start
    }

    /// The motion at each time, in the order of the times, and at its end.
    pub fn samples(&self) -> &[GimbalSample] {
        &self.samples
    }

    /// Why it ended before the last of its times, and when, s; [`MotionError::GimbalLock`] where the gimbals lock. `None` if it did not.
    pub fn failure(&self) -> Option<(f64, &MotionError)> {
        self.ending.as_ref().map(|(time, cause)| (*time, cause))
    }

    /// What it cost.
    pub const fn statistics(&self) -> StepStatistics {
        self.statistics
    }

    /// The change of [`GimbalSample::balance`] at each sample, relative to the largest of all energies and works together.
    pub fn energy_departures(&self) -> Vec<f64> {
        let first = self.start.balance();
        let size = |s: &GimbalSample| {
            let energies = [s.kinetic_energy, s.potential_energy, s.spring_energy];
            let works = [s.damping_work, s.motor_work, s.torque_work, s.base_work];
            energies.iter().chain(&works).map(|x| x.abs()).sum::<f64>()
        };
        let scale = self.samples.iter().map(size).fold(size(&self.start), f64::max);
        let departure = |s: &GimbalSample| match (s.balance() - first).abs() {
            0.0 => 0.0,
            change => change / scale,
        };
        self.samples.iter().map(departure).collect()
    }

    /// The largest of [`GimbalTrajectory::energy_departures`].
    pub fn energy_drift(&self) -> f64 {
        self.energy_departures().into_iter().fold(0.0, f64::max)
    }
}
