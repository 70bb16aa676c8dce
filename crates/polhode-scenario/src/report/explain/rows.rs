//! Rows of the table of ω in step 5.
//!
//! Equally spaced samples of a whole run may alias with the motion: a pendulum sampled every 51/50
//! of its period seems not to move.
//!
//! The table therefore covers one period of ω in the body, or the run if that is shorter. Without a
//! period it covers the run if each revolution has several rows, else its beginning.

use std::f64::consts::TAU;

use polhode::motion::{MotionError, Rotor, Run, Sample, Scenario, Trajectory};
use polhode_document::number::number;

/// Rows of the table, and a description of their times.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rows {
    pub samples: Vec<Sample>,
    /// Description, such as `, one period (1.58 s) in eighths`.
    pub words: String,
}

/// Significant digits of a duration.
const DIGITS: usize = 6;
/// Intervals between the rows.
const PARTS: usize = 8;
/// Least number of rows for each turn.
const ROWS_OF_A_TURN: f64 = 4.0;
/// Limit on the refinements of the largest rate.
const MOST_ROUNDS: usize = 20;
/// Ratio from which on one rate counts as larger than another.
const ALIKE: f64 = 1.2;

impl Rows {
    /// Returns the rows of a run; `period` is the period of ω in the body, s, if there is one.
    ///
    /// # Errors
    /// [`MotionError`] if the motion cannot be computed at these instants.
    pub(crate) fn of(
        scenario: &Scenario,
        trajectory: &Trajectory,
        period: Option<f64>,
    ) -> Result<Self, MotionError> {
        let (Some(run), [first, .., last]) = (scenario.run(), trajectory.samples()) else {
            return Ok(Self { samples: trajectory.samples().to_vec(), words: String::new() });
        };
        let duration = last.state.time - first.state.time;
        let mut seen = trajectory.samples().to_vec();
        let mut rate = fastest_rate(scenario.rotor(), &seen);
        let mut rows = Self::default();
        for _ in 0..MOST_ROUNDS {
            let turn = TAU / rate;
            let (span, words) = match period {
                Some(period) if period <= duration => (
                    period,
                    format!(", one period of ω in the body ({} s) in eighths", number(period, DIGITS)),
                ),
                // ω changes slowly relative to the run, even if the body rotates fast.
                Some(period) => (
                    duration,
                    format!(
                        ", the run in eighths (a period of ω in the body takes {} s)",
                        number(period, DIGITS)
                    ),
                ),
                None if duration > PARTS as f64 / ROWS_OF_A_TURN * turn => (
                    turn,
                    format!(
                        ", the first {} s (2π over the largest rate of the run) in eighths",
                        number(turn, DIGITS)
                    ),
                ),
                None => (duration, ", the run in eighths".to_owned()),
            };
            let at = |k: usize| match k {
                PARTS if span == duration => last.state.time,
                _ => first.state.time + span * (k as f64 / PARTS as f64),
            };
            let run = Run { times: (0..=PARTS).map(at).collect(), ..run.clone() };
            let Some(shown) = scenario.clone().sampled(run).simulate() else { break };
            let samples = shown?.samples().to_vec();
            // Samples far apart may miss the fastest part of the motion.
            seen.extend_from_slice(&samples);
            let fastest = fastest_rate(scenario.rotor(), &seen);
            rows = Self { samples, words };
            if fastest <= ALIKE * rate || period.is_some() {
                break;
            }
            rate = fastest;
        }
        Ok(rows)
    }
}

/// Returns the largest rate of change of ω along the run, rad/s.
///
/// This is |ω| for rotation, and |dω/dt|/|ω| for oscillation.
fn fastest_rate(rotor: &Rotor, samples: &[Sample]) -> f64 {
    let largest = |of: &dyn Fn(&Sample) -> f64| samples.iter().map(of).fold(0.0, f64::max);
    let omega = largest(&|sample| sample.state.omega.norm());
    let acceleration = largest(&|sample| {
        let (omega, h) = (sample.state.omega, rotor.wheel_momentum(sample.state.time));
        rotor.acceleration(omega, sample.torque + h.cross(omega)).norm()
    });
    if omega > 0.0 { omega.max(acceleration / omega) } else { 0.0 }
}
