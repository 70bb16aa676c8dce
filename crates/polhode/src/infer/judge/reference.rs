//! The exact motion at the times of a log.

use super::error::JudgeError;
use crate::motion::model::state::{State, StateError};
use crate::motion::run::global_error::ErrorEffort;
use crate::motion::run::simulation::Simulation;
use crate::motion::solve::method::Method;
use crate::motion::task::asked::Task;
use crate::motion::task::run::Run;
use crate::motion::task::scenario::Scenario;

/// The states of a scenario at given times, with what they may be wrong by.
///
/// # Accuracy
/// Closed forms where they are known, else Taylor's method with steps of 1e-14. [`Reference::error`] is estimated as of every
/// computed motion ([`crate::motion::GlobalError`]), at up to 64 of the times, and is that of the next of them between.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    states: Vec<State>,
    errors: Vec<(usize, StateError)>,
}

/// At how many of the times the error is estimated.
const ESTIMATED: usize = 64;
/// Of each step.
const TOLERANCE: f64 = 1e-14;

impl Reference {
    /// The motion of a scenario at times (s, ascending, none before its start).
    ///
    /// # Errors
    /// [`JudgeError::NoMotion`] of a scenario whose motion is prescribed, [`JudgeError::Changing`] and
    /// [`JudgeError::OnGround`] and [`JudgeError::InGimbals`] of one whose body changes, is on the ground or hangs in gimbals; [`JudgeError::BeforeStart`] and [`JudgeError::Ends`] of times at
    /// which it has none; [`JudgeError::Motion`] of a motion that cannot be computed.
    pub fn of(scenario: &Scenario, times: &[f64]) -> Result<Self, JudgeError> {
        let states = states(scenario, times)?;
        let picked = spread(times.len(), ESTIMATED);
        let at: Vec<f64> = picked.iter().map(|&row| times[row]).collect();
        let run = Run { times: at, method: Method::Auto, tolerance: TOLERANCE };
        let estimated = scenario.clone().sampled(run).simulate_with_error(ErrorEffort::Auto, &mut |_| true);
        let errors = match estimated.transpose()?.as_ref().and_then(|motion| motion.error()) {
            Some(error) => picked.into_iter().zip(error.computation().iter().copied()).collect(),
            None => Vec::new(),
        };
        Ok(Self { states, errors })
    }

    /// One for each time.
    pub fn states(&self) -> &[State] {
        &self.states
    }

    /// The largest |ω|, rad/s.
    pub fn fastest(&self) -> f64 {
        self.states.iter().map(|state| state.omega.norm()).fold(0.0, f64::max)
    }

    /// What the state of a row, from 0, may be wrong by.
    pub fn error(&self, row: usize) -> StateError {
        let next = self.errors.partition_point(|&(at, _)| at < row);
        let known = self.errors.get(next).or_else(|| self.errors.last());
        known.map_or(StateError { attitude: 0.0, omega: 0.0 }, |&(_, error)| error)
    }
}

/// The states at times.
///
/// # Errors
/// As [`Reference::of`].
pub(super) fn states(scenario: &Scenario, times: &[f64]) -> Result<Vec<State>, JudgeError> {
    if scenario.history().is_some() {
        return Err(JudgeError::Changing);
    }
    if scenario.ground().is_some() {
        return Err(JudgeError::OnGround);
    }
    if scenario.gimbals().is_some() {
        return Err(JudgeError::InGimbals);
    }
    if !matches!(scenario.task(), Task::Forward(_)) {
        return Err(JudgeError::NoMotion);
    }
    let start = scenario.start();
    if let Some(&time) = times.first().filter(|&&time| time < start.time) {
        return Err(JudgeError::BeforeStart { time, start: start.time });
    }
    let simulation = Simulation::new(scenario.rotor(), scenario.torques(), start, times)
        .switched_off(scenario.switched_off())
        .events(scenario.events())
        .tolerance(TOLERANCE);
    if scenario.events().is_empty() {
        return Ok(simulation.states()?);
    }
    let motion = simulation.run()?;
    let states: Vec<State> = motion.samples().iter().map(|sample| sample.state).collect();
    match times.get(states.len()) {
        None => Ok(states),
        Some(&time) => {
            Err(JudgeError::Ends { time, end: states.last().map_or(start.time, |state| state.time) })
        }
    }
}

/// Up to `most` of `count` rows, evenly spread, the first and the last among them.
pub(super) fn spread(count: usize, most: usize) -> Vec<usize> {
    let (last, steps) = (count.saturating_sub(1), most.min(count).saturating_sub(1).max(1));
    let mut rows: Vec<usize> =
        (0..=steps).map(|k| (last as u128 * k as u128 / steps as u128) as usize).collect();
    rows.dedup();
    rows
}
