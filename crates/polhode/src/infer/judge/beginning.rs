//! First rows of a log, with the exact states at their times.

use super::difference::{angle_between, conjugate, product};
use super::error::JudgeError;
use super::log::MotionLog;
use super::reading::{Reading, ReadingResidual};
use super::reference::{spread, states_within};
use crate::motion::model::state::State;
use crate::motion::task::scenario::Scenario;

/// Angle through which the body rotates in the beginning of a log, rad; at least three rows are
/// used.
pub(super) const BEGINNING: f64 = 0.1;
/// Ratio of residuals above which the smaller one decides.
pub(super) const CLEARLY: f64 = 10.0;
/// Maximum number of rows that are compared.
pub(super) const COMPARED: usize = 64;
/// Bounds of the rotation angle by which residuals are divided, rad. Above the upper bound, the
/// difference of attitudes no longer increases with the rotation angle.
const NO_TURN: f64 = 1e-3;
const WHOLE_TURN: f64 = 1.0;
/// Largest angle between two rows that represent a continuous motion, rad.
const FOLLOWED: f64 = 1.0;
/// Largest relative difference of angular velocities that count as equal.
///
/// A program that takes deg/s for rad/s rotates 57.3 times too slowly. This differs by 5 % from the
/// factor 60 between s and min.
const SAME_RATE: f64 = 0.01;

/// Relation of a log's clock to the scenario's: t = (t_log − origin) · factor, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Clock {
    pub(super) origin: f64,
    pub(super) factor: f64,
}

impl Clock {
    /// Returns the clock of a log that begins at a time of the scenario, s, rounded so that no row
    /// is before that time.
    pub(super) fn beginning_at(time: f64, log: &MotionLog, factor: f64) -> Self {
        let first = log.times()[0];
        let mut clock = Self { origin: first - time / factor, factor };
        while clock.time(first) < time {
            clock.origin = clock.origin.next_down();
        }
        clock
    }

    pub(super) fn time(self, logged: f64) -> f64 {
        (logged - self.origin) * self.factor
    }

    pub(super) fn is_of(self, reading: &Reading) -> bool {
        self == Self { origin: reading.time_origin, factor: reading.time_factor }
    }
}

/// First rows of a log, with the exact states for a given clock.
#[derive(Clone, Debug)]
pub(super) struct Beginning {
    pub(super) clock: Clock,
    pub(super) rows: Vec<usize>,
    pub(super) exact: Vec<State>,
}

impl Beginning {
    /// Computes the exact states; `None` if this takes more than `most` steps.
    ///
    /// # Errors
    /// The errors of [`super::Reference::of`].
    pub(super) fn of(
        log: &MotionLog,
        scenario: &Scenario,
        clock: Clock,
        most: usize,
    ) -> Result<Option<Self>, JudgeError> {
        let times = log.times();
        let first = [clock.time(times[0])];
        let Some(&[first]) =
            states_within(scenario, scenario.start(), &first, most)?.as_deref().and_then(<[_]>::first_chunk)
        else {
            return Ok(None);
        };
        let upto = |last: usize| {
            let rows = spread(last + 1, COMPARED);
            let at: Vec<f64> = rows.iter().map(|&row| clock.time(times[row])).collect();
            let exact = states_within(scenario, first, &at, most)?;
            Ok::<_, JudgeError>(exact.map(|exact| Self { clock, rows, exact }))
        };
        let mut last = times.len().min(3) - 1;
        let Some(mut found) = upto(last)? else { return Ok(None) };
        while last + 1 < times.len() {
            last = (2 * last).min(times.len() - 1);
            match upto(last) {
                Ok(Some(further)) if further.turn() <= BEGINNING => found = further,
                _ => break,
            }
        }
        Ok(Some(found))
    }

    /// Returns ∫ |ω| dt by the trapezoidal rule, rad.
    pub(super) fn turn(&self) -> f64 {
        let part = |pair: &[State]| {
            0.5 * (pair[0].omega.norm() + pair[1].omega.norm()) * (pair[1].time - pair[0].time)
        };
        self.exact.windows(2).map(part).sum()
    }

    /// Returns the largest |ω|, rad/s.
    pub(super) fn rate(&self) -> f64 {
        self.exact.iter().map(|state| state.omega.norm()).fold(0.0, f64::max)
    }

    /// Returns true if the rotation rate of the log equals that of the exact motion at its first
    /// row.
    ///
    /// The model δ_k = (ε + γ t_k) φ_k is fitted by least squares, where φ_k is the angle of the
    /// exact motion since the first row, and φ_k + δ_k that of the log.
    ///
    /// ε is the relative difference at the first row. A value γ ≠ 0 indicates a wrong law of motion
    /// or an inaccurate method. The fit with γ = 0 has less noise.
    pub(super) fn has_same_rate(&self, log: &MotionLog) -> bool {
        let (Some(&first), Some(start)) = (self.rows.first(), self.exact.first()) else { return false };
        let (mut uu, mut uv, mut vv, mut du, mut dv) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (&row, exact) in self.rows.iter().zip(&self.exact).skip(1) {
            // The angle between two attitudes does not depend on the quaternion convention.
            let u = angle_between(start.attitude.quaternion(), exact.attitude.quaternion());
            let delta = angle_between(log.attitude()[first], log.attitude()[row]) - u;
            let v = u * (exact.time - start.time);
            uu += u * u;
            uv += u * v;
            vv += v * v;
            du += delta * u;
            dv += delta * v;
        }
        let (constant, varying) = (du / uu, (du * vv - dv * uv) / (uu * vv - uv * uv));
        constant.abs() <= SAME_RATE || varying.abs() <= SAME_RATE
    }

    /// Returns the angle between the first row and the exact attitude there, rad.
    pub(super) fn first_angle(&self, log: &MotionLog, reading: &Reading) -> f64 {
        self.exact.first().map_or(f64::INFINITY, |exact| {
            angle_between(exact.attitude.quaternion(), reading.quaternion(log.attitude()[0]))
        })
    }

    /// Returns the residual of a reading; with `from_own_start`, that of the rotation since the
    /// first row.
    pub(super) fn residual(
        &self,
        log: &MotionLog,
        reading: Reading,
        from_own_start: bool,
    ) -> ReadingResidual {
        let read = |row: usize| reading.quaternion(log.attitude()[row]);
        // S = R_read(0) R_exact(0)ᵀ, which is removed with `from_own_start`.
        let own = self.exact.first().map(|first| product(read(0), conjugate(first.attitude.quaternion())));
        let start =
            if from_own_start { own.map_or([1.0, 0.0, 0.0, 0.0], conjugate) } else { [1.0, 0.0, 0.0, 0.0] };
        let square = |(&row, exact): (&usize, &State)| {
            angle_between(exact.attitude.quaternion(), product(start, read(row))).powi(2)
        };
        let squares: f64 = self.rows.iter().zip(&self.exact).map(square).sum();
        let attitude = (squares / self.rows.len().max(1) as f64).sqrt();
        ReadingResidual { reading, attitude, relative: attitude / self.turn().clamp(NO_TURN, WHOLE_TURN) }
    }
}

/// Returns the angular velocity of a log from its attitudes, rad per stated second; `None` if the
/// rows are too far apart.
///
/// The angle between two attitudes does not depend on the quaternion convention.
pub(super) fn logged_rate(log: &MotionLog) -> Option<f64> {
    let rows = log.times().len().min(9);
    let rate = |k: usize| {
        let angle = angle_between(log.attitude()[k - 1], log.attitude()[k]);
        (angle < FOLLOWED).then(|| angle / (log.times()[k] - log.times()[k - 1]))
    };
    let mut rates = (1..rows).map(rate).collect::<Option<Vec<f64>>>()?;
    rates.sort_by(f64::total_cmp);
    rates.get(rates.len() / 2).copied()
}
