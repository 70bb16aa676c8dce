//! Search over all causes.

use super::found::{Causes, TriedStart, Untried};
use super::law::Law;
use super::name::Cause;
use super::rows::{Window, rotation_vector};
use super::trial::Trials;
use crate::infer::judge::motion::ReadMotion;
use crate::math::frame::Space;
use crate::math::rotation::Rotation;
use crate::motion::model::event::Event;
use crate::motion::model::state::State;
use crate::motion::run::simulation::Simulation;
use crate::motion::task::scenario::Scenario;

/// Distance of a run from the exact motion, rad, below which no cause is needed.
const EXACT: f64 = 1e-8;

/// Rotation angle from the scenario's start to the first row above which no wrong motion is
/// integrated, rad.
const LATE: f64 = 2000.0;

/// Deviation of the first row from the start, relative to the error, above which the run has a
/// different start.
const ELSEWHERE: f64 = 1e-3;

/// Finds the causes that explain why a run differs from the exact motion. For each cause, it
/// computes the motion of a program with this mistake from the same start. A cause is named if its
/// motion is much closer to the run than the exact motion.
///
/// `exact` are the exact states at the run's times. `step` is the step size of the program, s, if
/// it is known.
///
/// Rows are compared from the scenario's start until the run and the exact motion differ by
/// 1.5 rad, or the body has rotated by 120 rad.
pub fn causes(scenario: &Scenario, motion: &ReadMotion, exact: &[State], step: Option<f64>) -> Causes {
    if scenario.prescribed().is_some() {
        return Causes::untried(Untried::Prescribed);
    }
    if scenario.events().iter().any(Event::switches) {
        return Causes::untried(Untried::Switched);
    }
    let start = scenario.start();
    let Some(window) = Window::of(motion, exact, start.time) else {
        return Causes::untried(Untried::TooShort);
    };
    let late = motion
        .times
        .first()
        .zip(exact.first())
        .map_or(0.0, |(time, first)| (time - start.time) * start.omega.norm().max(first.omega.norm()));
    if late > LATE {
        return Causes::untried(Untried::Late);
    }
    let found = from_start(scenario, motion, window, start, step);
    let Some(first) = window.state(window.first()) else { return found };
    let faster = (first.omega - start.omega).norm() / start.omega.norm().max(f64::MIN_POSITIVE);
    let off = rotation_vector(start.attitude, first.attitude).norm().max(faster);
    if found.likeliest().is_some() || first.time != start.time || off < ELSEWHERE * found.error {
        return found;
    }
    // Noise has a different value in the next row.
    let error = |k: usize| Some(rotation_vector(exact.get(k)?.attitude, window.attitude(k)?));
    let errors = error(window.first()).zip(error(window.first() + 1));
    if errors.is_some_and(|(here, next)| here.norm() > faster && (next - here).norm() > here.norm()) {
        return found;
    }
    from_first_row(scenario, motion, window, first, step).unwrap_or(found)
}

/// Searches again from the run's own first row; `None` if that explains nothing either.
fn from_first_row(
    scenario: &Scenario,
    motion: &ReadMotion,
    window: Window<'_>,
    first: State,
    step: Option<f64>,
) -> Option<Causes> {
    let times: Vec<f64> = window.times().to_vec();
    let simulation = Simulation::new(scenario.rotor(), scenario.torques(), first, &times);
    let exact = simulation.switched_off(scenario.switched_off()).states().ok()?;
    let rows = ReadMotion {
        attitude: motion.attitude.get(window.range())?.to_vec(),
        omega: match &motion.omega {
            Some(omega) => Some(omega.get(window.range())?.to_vec()),
            None => None,
        },
        times,
    };
    let window = Window::of(&rows, &exact, first.time)?;
    let found = from_start(scenario, &rows, window, first, step);
    found.likeliest()?;
    Some(Causes { start: TriedStart::FirstRow, ..found })
}

fn from_start(
    scenario: &Scenario,
    motion: &ReadMotion,
    window: Window<'_>,
    start: State,
    step: Option<f64>,
) -> Causes {
    let rows = window.rows();
    let (error, span) = (rows.base(usize::MAX).attitude, [start.time, window.end()]);
    if error < EXACT {
        return Causes { error, span, ..Causes::untried(Untried::Exact) };
    }
    let mut trials = Trials { window, rows, law: Law::of(scenario), start, tried: Vec::new() };
    trials.try_readings();
    trials.try_starts(motion);
    trials.try_equations();
    trials.try_tensors(scenario);
    trials.try_torques();
    trials.try_methods(step);
    trials.try_damping();
    trials.try_time_shift();
    trials.try_other_tensor();
    trials.try_damped_methods(step);
    trials.try_rounding(motion, step);
    Causes { tried: trials.tried, error, span, start: TriedStart::Scenario, untried: None }.ranked()
}

impl Trials<'_> {
    /// Tries other quaternion conventions.
    fn try_readings(&mut self) {
        let changed = |change: fn([f64; 4]) -> [f64; 4]| -> Vec<State> {
            let exact = self.rows.exact.iter();
            let read = exact.map(|state| State {
                attitude: Rotation::from_quaternion(change(state.attitude.quaternion()))
                    .unwrap_or(state.attitude),
                ..*state
            });
            read.collect()
        };
        let conjugate = changed(|[w, x, y, z]| [w, -x, -y, -z]);
        let scalar_last = changed(|[w, x, y, z]| [x, y, z, w]);
        self.try_states(Cause::ConjugateAttitude, &conjugate);
        self.try_states(Cause::ScalarLast, &scalar_last);
    }

    /// Tries other starts: that of the run's first row, and the scenario's with ω along other axes.
    fn try_starts(&mut self, motion: &ReadMotion) {
        let (law, right) = (self.law.clone(), self.start);
        let omega = (right.attitude.inverse() * right.omega.as_frame::<Space>()).as_frame();
        self.try_start(Cause::StartOmegaAlongSpace, &law, State { omega, ..right });
        let first = self.window.first();
        let (Some(time), Some(row)) = (motion.times.get(first), self.window.attitude(first)) else { return };
        if *time != right.time {
            return;
        }
        let omega = motion.omega.as_ref().and_then(|omega| omega.get(first)).copied();
        let angle = rotation_vector(right.attitude, row).norm();
        let cause = Cause::OtherStart { angle, omega };
        self.try_start(cause, &law, State { attitude: row, omega: omega.unwrap_or(right.omega), ..right });
    }

    fn try_start(&mut self, cause: Cause, law: &Law<'_>, start: State) {
        let right = core::mem::replace(&mut self.start, start);
        self.try_law(cause, law);
        self.start = right;
    }
}
