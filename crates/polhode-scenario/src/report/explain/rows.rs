//! Rows of the table of step 5: instants at which it shows ω.
//!
//! Evenly chosen samples of a whole run may alias with the motion. A pendulum that is shown every
//! 51/50 of its period seems not to swing.
//!
//! So the table covers one period of ω in the body, or the run if that is shorter. A motion without
//! a period is shown over the run if a turn has several rows then, or else at its beginning.

use std::f64::consts::TAU;

use polhode::motion::{MotionError, Rotor, Run, Sample, Scenario, Trajectory};
use polhode_document::number::number;

/// Instants at which a table shows the motion, and the words for them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rows {
    pub samples: Vec<Sample>,
    /// Words after the title: `, one period (1.58 s) in eighths`.
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
                // ω changes more slowly than the run lasts, however fast the body turns.
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
            // Samples that are far apart may have missed the fastest part of the motion.
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

/// Returns the largest rate at which ω changes its direction or its size along the run, rad/s.
///
/// It is |ω| of turns, |dω/dt|/|ω| of oscillations.
fn fastest_rate(rotor: &Rotor, samples: &[Sample]) -> f64 {
    let largest = |of: &dyn Fn(&Sample) -> f64| samples.iter().map(of).fold(0.0, f64::max);
    let omega = largest(&|sample| sample.state.omega.norm());
    let acceleration = largest(&|sample| {
        let (omega, h) = (sample.state.omega, rotor.wheel_momentum(sample.state.time));
        rotor.acceleration(omega, sample.torque + h.cross(omega)).norm()
    });
    if omega > 0.0 { omega.max(acceleration / omega) } else { 0.0 }
}
