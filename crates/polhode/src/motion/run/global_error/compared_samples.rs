//! The samples at which a motion is compared with others: all of them, or some hundreds of many.

use super::distance::Distance;
use crate::motion::model::state::State;
use crate::motion::model::state::StateError;
use crate::motion::run::trajectory::Trajectory;

/// Compared samples cost as much as computed ones. Between two of them the larger distance is taken.
const MOST: usize = 512;

/// Samples in the order of their distance from the start.
pub(super) struct ComparedSamples {
    /// All samples.
    samples: Vec<State>,
    /// Which of them are compared: every so many, and the last.
    at: Vec<usize>,
    pub(super) states: Vec<State>,
    pub(super) times: Vec<f64>,
}

impl ComparedSamples {
    /// Those of a run.
    pub(super) fn of_trajectory(trajectory: &Trajectory) -> Self {
        let samples: Vec<State> = trajectory.samples().iter().map(|sample| sample.state).collect();
        let every = samples.len().div_ceil(MOST).max(1);
        Self::of(samples, every)
    }

    /// Every so many.
    pub(super) fn of(samples: Vec<State>, every: usize) -> Self {
        let last = samples.len().saturating_sub(1);
        let at: Vec<usize> = (0..last).step_by(every).chain((!samples.is_empty()).then_some(last)).collect();
        let states: Vec<State> = at.iter().map(|&k| samples[k]).collect();
        let times = states.iter().map(|state| state.time).collect();
        Self { samples, at, states, times }
    }

    /// The error of all samples from the distance at those that were compared.
    pub(super) fn errors(&self, distance: &Distance, floor: StateError) -> Vec<StateError> {
        distance.at_all(&self.at).relative_to(&self.samples, floor)
    }
}
