//! Samples at which a motion is compared with others: all of them, or some hundreds.

use super::distance::Distance;
use crate::motion::model::state::State;
use crate::motion::model::state::StateError;
use crate::motion::run::trajectory::Trajectory;

/// Largest number of compared samples, which cost as much as computed ones. Between two of them the
/// larger distance is used.
const MOST: usize = 512;

/// Samples in the order of their distance from the start.
pub(super) struct ComparedSamples {
    /// All samples, compared or not.
    samples: Vec<State>,
    /// Indices of the compared samples: at a constant stride, and the last.
    at: Vec<usize>,
    pub(super) states: Vec<State>,
    pub(super) times: Vec<f64>,
}

impl ComparedSamples {
    /// Selects samples of a trajectory.
    pub(super) fn of_trajectory(trajectory: &Trajectory) -> Self {
        let samples: Vec<State> = trajectory.samples().iter().map(|sample| sample.state).collect();
        let every = samples.len().div_ceil(MOST).max(1);
        Self::of(samples, every)
    }

    /// Selects each sample whose index is a multiple of `every`, and the last.
    pub(super) fn of(samples: Vec<State>, every: usize) -> Self {
        let last = samples.len().saturating_sub(1);
        let at: Vec<usize> = (0..last).step_by(every).chain((!samples.is_empty()).then_some(last)).collect();
        let states: Vec<State> = at.iter().map(|&k| samples[k]).collect();
        let times = states.iter().map(|state| state.time).collect();
        Self { samples, at, states, times }
    }

    /// Returns the error of all samples from the distance at the compared ones.
    pub(super) fn errors(&self, distance: &Distance, floor: StateError) -> Vec<StateError> {
        distance.at_all(&self.at).relative_to(&self.samples, floor)
    }
}
