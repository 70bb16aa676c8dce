//! The motion of a body on the ground at given times.

use super::change::{ContactChange, ContactEvent};
use super::sample::ContactSample;
use crate::motion::error::MotionError;
use crate::motion::model::event::Crossing;
use crate::motion::solve::propagate::step_statistics::StepStatistics;
use crate::motion::solve::solver::Solver;

/// How a motion on the ground ended.
#[derive(Clone, Debug, PartialEq)]
pub enum ContactEnding {
    /// At the last of its times.
    Complete,
    /// At an event that stops it, by its number from 0.
    Stopped {
        /// Which.
        event: usize,
        /// When, s: the time of the last sample.
        time: f64,
    },
    /// The contact changed, and the motion is not known after that.
    Changed {
        /// How.
        change: ContactChange,
        /// When, s: the time of the last sample.
        time: f64,
    },
    /// It could not go on; what comes before is good.
    Failed {
        /// Why.
        cause: MotionError,
        /// The last good time, s: that of the last sample.
        time: f64,
    },
}

/// The motion of a body on the ground at given times.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactTrajectory {
    pub(super) start: ContactSample,
    pub(super) samples: Vec<ContactSample>,
    pub(super) changes: Vec<ContactEvent>,
    pub(super) crossings: Vec<Crossing>,
    pub(super) ending: ContactEnding,
    pub(super) solver: Solver,
    pub(super) statistics: StepStatistics,
}

impl ContactTrajectory {
    /// The motion at the start, which need not be one of the times.
    pub const fn start(&self) -> &ContactSample {
        &self.start
    }

    /// The motion at each time, in the order of the times, and at its end.
    pub fn samples(&self) -> &[ContactSample] {
        &self.samples
    }

    /// The solvers of its phases.
    pub const fn solver(&self) -> Solver {
        self.solver
    }

    /// What changed about the contact, in the order of time.
    pub fn changes(&self) -> &[ContactEvent] {
        &self.changes
    }

    /// The events that happened, in the order of time.
    pub fn events(&self) -> &[Crossing] {
        &self.crossings
    }

    /// How it ended.
    pub const fn ending(&self) -> &ContactEnding {
        &self.ending
    }

    /// What it cost.
    pub const fn statistics(&self) -> StepStatistics {
        self.statistics
    }

    /// The change of T + U less the work of friction and of the ground at each sample, relative to the largest of T, |U| and these works together.
    pub fn energy_departures(&self) -> Vec<f64> {
        let first = self.start.balance();
        let size = |s: &ContactSample| {
            s.kinetic_energy.abs() + s.potential_energy.abs() + s.friction_work.abs() + s.ground_work.abs()
        };
        let scale = self.samples.iter().map(size).fold(size(&self.start), f64::max);
        let departure = |s: &ContactSample| match (s.balance() - first).abs() {
            0.0 => 0.0,
            change => change / scale,
        };
        self.samples.iter().map(departure).collect()
    }

    /// The largest of [`ContactTrajectory::energy_departures`].
    pub fn energy_drift(&self) -> f64 {
        self.energy_departures().into_iter().fold(0.0, f64::max)
    }
}
