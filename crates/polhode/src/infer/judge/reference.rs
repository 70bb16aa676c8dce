//! Exact motion at the times of a log.

use super::error::JudgeError;
use crate::motion::error::MotionError;
use crate::motion::model::state::{State, StateError};
use crate::motion::run::global_error::ErrorEffort;
use crate::motion::run::simulation::Simulation;
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::method::Method;
use crate::motion::task::asked::{Mechanism, Task};
use crate::motion::task::run::Run;
use crate::motion::task::scenario::Scenario;

/// States of a scenario at given times, with error estimates.
///
/// # Accuracy
/// Closed forms are used where they are known, otherwise Taylor's method with a step tolerance of
/// 1e-14. [`Reference::error`] is estimated as for every computed motion
/// ([`crate::motion::GlobalError`]), at up to 64 of the times; in between, it is that of the next
/// of these times.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    states: Vec<State>,
    errors: Vec<(usize, StateError)>,
}

/// Number of times at which the error is estimated.
const ESTIMATED: usize = 64;
/// Relative tolerance of each step.
const TOLERANCE: f64 = 1e-14;

impl Reference {
    /// Computes the motion of a scenario at times (s, ascending, none before its start).
    ///
    /// # Errors
    /// [`JudgeError::NoMotion`] for a prescribed motion; [`JudgeError::Changing`],
    /// [`JudgeError::OnGround`] or [`JudgeError::InGimbals`] for a body that changes, is on the
    /// ground or is in gimbals; [`JudgeError::BeforeStart`] and [`JudgeError::Ends`] for times
    /// outside the motion; [`JudgeError::Motion`] if the motion cannot be computed.
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

    /// Returns one state for each time.
    pub fn states(&self) -> &[State] {
        &self.states
    }

    /// Returns the largest |ω|, rad/s.
    pub fn fastest(&self) -> f64 {
        self.states.iter().map(|state| state.omega.norm()).fold(0.0, f64::max)
    }

    /// Returns the estimated error of the state of a row, from 0.
    pub fn error(&self, row: usize) -> StateError {
        let next = self.errors.partition_point(|&(at, _)| at < row);
        let known = self.errors.get(next).or_else(|| self.errors.last());
        known.map_or(StateError { attitude: 0.0, omega: 0.0 }, |&(_, error)| error)
    }
}

/// Checks that a scenario has a motion with which others can be compared.
///
/// # Errors
/// [`JudgeError::NoMotion`], [`JudgeError::Changing`], [`JudgeError::OnGround`] or
/// [`JudgeError::InGimbals`] otherwise.
pub(super) fn require_judged(scenario: &Scenario) -> Result<(), JudgeError> {
    if scenario.history().is_some() {
        return Err(JudgeError::Changing);
    }
    match scenario.mechanism() {
        Mechanism::Ground(_) => return Err(JudgeError::OnGround),
        Mechanism::Gimbals(_) => return Err(JudgeError::InGimbals),
        Mechanism::Rotor => {}
    }
    if !matches!(scenario.task(), Task::Forward(_)) {
        return Err(JudgeError::NoMotion);
    }
    Ok(())
}

fn require_after_start(scenario: &Scenario, times: &[f64]) -> Result<(), JudgeError> {
    let start = scenario.start().time;
    match times.first() {
        Some(&time) if time < start => Err(JudgeError::BeforeStart { time, start }),
        _ => Ok(()),
    }
}

/// Returns the states at the given times.
///
/// # Errors
/// The errors of [`Reference::of`].
fn states(scenario: &Scenario, times: &[f64]) -> Result<Vec<State>, JudgeError> {
    require_judged(scenario)?;
    require_after_start(scenario, times)?;
    if scenario.events().is_empty() {
        return Ok(simulation(scenario, scenario.start(), times).states()?);
    }
    whole(scenario, times, &simulation(scenario, scenario.start(), times).run()?)
}

/// Returns the states at the given times, starting from a state of the motion; `None` if this takes
/// more than `most` integration steps.
///
/// # Errors
/// The errors of [`Reference::of`].
pub(super) fn states_within(
    scenario: &Scenario,
    from: State,
    times: &[f64],
    most: usize,
) -> Result<Option<Vec<State>>, JudgeError> {
    require_after_start(scenario, times)?;
    // Events before `from` may have switched torques.
    let from = if scenario.events().is_empty() { from } else { scenario.start() };
    let mut steps = 0;
    let run = simulation(scenario, from, times).run_watched(&mut |_| {
        steps += 1;
        steps <= most
    });
    match run {
        Err(MotionError::Stopped { .. }) => Ok(None),
        run => whole(scenario, times, &run?).map(Some),
    }
}

fn simulation<'a>(scenario: &'a Scenario, from: State, times: &'a [f64]) -> Simulation<'a> {
    Simulation::new(scenario.rotor(), scenario.torques(), from, times)
        .switched_off(scenario.switched_off())
        .events(scenario.events())
        .tolerance(TOLERANCE)
}

/// Returns the states of a trajectory; an error if it does not reach all times.
fn whole(scenario: &Scenario, times: &[f64], motion: &Trajectory) -> Result<Vec<State>, JudgeError> {
    let mut states: Vec<State> = motion.samples().iter().map(|sample| sample.state).collect();
    // A motion that ends early has its last sample at its end.
    let is_reached = |k: usize| states.get(k).is_some_and(|state| state.time == times[k]);
    match (0..times.len()).find(|&k| !is_reached(k)) {
        None => {
            states.truncate(times.len());
            Ok(states)
        }
        Some(k) => {
            let end = states.last().map_or(scenario.start().time, |state| state.time);
            Err(JudgeError::Ends { time: times[k], end })
        }
    }
}

/// Returns up to `most` of `count` rows, evenly spread, including the first and the last.
pub(super) fn spread(count: usize, most: usize) -> Vec<usize> {
    let (last, steps) = (count.saturating_sub(1), most.min(count).saturating_sub(1).max(1));
    let mut rows: Vec<usize> =
        (0..=steps).map(|k| (last as u128 * k as u128 / steps as u128) as usize).collect();
    rows.dedup();
    rows
}
