//! Smooth interpolation of a table of attitudes or of ω.
//!
//! Attitudes are interpolated as quaternions. Each component has a spline of degree 7, and the
//! result is normalised. A change of space or body axes multiplies all quaternions by a constant
//! one, which is a linear operation. The curve therefore does not depend on the axes. With rows at
//! distance h, the errors are of order h⁸ in the attitude, h⁷ in ω and h⁶ in dω/dt. All three are
//! continuous, and ω and dω/dt are exact derivatives of the interpolated attitude.
//!
//! The error is estimated from the difference to a less accurate spline of degree 5 through the
//! same rows: this is an upper estimate. With every second row the difference must be larger. If it
//! is smaller, the rows are dominated by noise.

use crate::math::rotation::Attitude;
use crate::math::spline::Spline;
use crate::math::vector::{AngularAcceleration, AngularVelocity};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::state::State;

use super::quaternion;
use super::rates::Rates;
use crate::math::frame::Body;

/// Degrees of the interpolating curve and of the curve for comparison.
const DEGREE: usize = 7;
const LOWER: usize = 5;

/// Minimum number of rows that determine dω/dt.
const FEWEST: usize = 4;

/// Smooth motion through a table of attitudes.
#[derive(Clone, Debug, PartialEq)]
pub struct AttitudeTable {
    spline: Spline<4>,
    span: [f64; 2],
    uncertainty: Uncertainty,
}

/// Estimated difference between a motion through the rows of a table and the sampled motion. It is
/// the largest difference between splines of degree 7 and 5, halfway between rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncertainty {
    /// Attitude, rad.
    pub attitude: f64,
    /// ω, rad/s.
    pub omega: f64,
    /// dω/dt, rad/s².
    pub acceleration: f64,
    /// `acceleration` relative to the largest |dω/dt| + |ω|² of the motion.
    pub relative: f64,
    /// Time of the largest difference in dω/dt, s.
    pub time: f64,
    /// True if the difference is smaller with every second row than with all rows. Then the rows
    /// are rounded or noisy, and closer rows do not help.
    pub is_noisy: bool,
}

impl AttitudeTable {
    /// Creates a motion through attitudes at ascending times.
    ///
    /// # Errors
    /// The errors of [`Prescribed::attitude_table`](super::Prescribed::attitude_table).
    pub(super) fn new(times: &[f64], attitudes: &[Attitude]) -> Result<Self, MotionError> {
        let span = require_rows(times, attitudes.len())?;
        let mut quaternions: Vec<[f64; 4]> = Vec::with_capacity(attitudes.len());
        let mut last = attitudes.first().copied().unwrap_or(Attitude::identity());
        for attitude in attitudes {
            let turn = last.angle_to(*attitude);
            let rule = "at most a quarter of a turn, π/2 rad: what lies between is a guess";
            let holds = turn <= core::f64::consts::FRAC_PI_2;
            require::that("the turn from a row to the next", turn, holds, rule)?;
            last = attitude.continuous_with(last);
            quaternions.push(last.quaternion());
        }
        let curve = |times: &[f64], rows: &[[f64; 4]], degree| {
            let spline = Spline::through(times, rows, degree)?;
            Some(move |t: f64| {
                let (attitude, omega, acceleration) = quaternion::kinematics(spline.at(t))?;
                Some(TablePoint { attitude, omega, acceleration })
            })
        };
        let uncertainty = Uncertainty::of(times, &quaternions, curve);
        let spline = Spline::through(times, &quaternions, DEGREE).ok_or_else(|| disorder(times))?;
        Ok(Self { spline, span, uncertainty })
    }

    /// Returns the times of the first and the last row, s.
    pub const fn span(&self) -> [f64; 2] {
        self.span
    }

    /// Returns the estimated difference from the sampled motion.
    pub const fn uncertainty(&self) -> Uncertainty {
        self.uncertainty
    }

    /// Returns the state and dω/dt at a time of the span; `None` if the curve is undetermined.
    pub(super) fn at(&self, time: f64) -> Option<(State, AngularAcceleration<Body>)> {
        let (attitude, omega, acceleration) = quaternion::kinematics(self.spline.at(time))?;
        Some((State { time, attitude, omega }, acceleration))
    }
}

/// Interpolates a table of ω. Returns ω as functions of time, their span, and their uncertainty.
pub(super) fn rates(times: &[f64], rows: &[[f64; 3]]) -> Result<(Rates, [f64; 2], Uncertainty), MotionError> {
    let span = require_rows(times, rows.len())?;
    for &value in rows.as_flattened() {
        require::finite("ω in the table", value)?;
    }
    let curve = |times: &[f64], rows: &[[f64; 3]], degree| {
        let spline = Spline::through(times, rows, degree)?;
        Some(move |t: f64| {
            let [omega, rate, _] = spline.at(t);
            Some(TablePoint {
                attitude: Attitude::identity(),
                omega: AngularVelocity::from_array(omega),
                acceleration: AngularAcceleration::from_array(rate),
            })
        })
    };
    let mut uncertainty = Uncertainty::of(times, rows, curve);
    // Upper limit of the attitude error: the error of ω times the whole duration.
    uncertainty.attitude = uncertainty.omega * (span[1] - span[0]);
    let spline = Spline::through(times, rows, DEGREE).ok_or_else(|| disorder(times))?;
    Ok((Rates::Table(spline), span, uncertainty))
}

/// Motion at one time, for comparison.
struct TablePoint {
    attitude: Attitude,
    omega: AngularVelocity<Body>,
    acceleration: AngularAcceleration<Body>,
}

impl Uncertainty {
    /// Estimates the uncertainty from curves of two degrees, through all rows and through every
    /// second row.
    fn of<const N: usize, F: Fn(f64) -> Option<TablePoint>>(
        times: &[f64],
        rows: &[[f64; N]],
        curve: impl Fn(&[f64], &[[f64; N]], usize) -> Option<F>,
    ) -> Self {
        let mut all =
            Self::between(times, curve(times, rows, DEGREE).as_ref(), curve(times, rows, LOWER).as_ref());
        let second: (Vec<f64>, Vec<[f64; N]>) =
            times.iter().copied().zip(rows.iter().copied()).step_by(2).unzip();
        if second.0.len() > DEGREE {
            let (times, rows) = (&second.0, &second.1);
            let half =
                Self::between(times, curve(times, rows, DEGREE).as_ref(), curve(times, rows, LOWER).as_ref());
            all.is_noisy = all.acceleration > half.acceleration;
        }
        all
    }

    fn between<F: Fn(f64) -> Option<TablePoint>>(
        times: &[f64],
        better: Option<&F>,
        worse: Option<&F>,
    ) -> Self {
        let mut most =
            Self { attitude: 0.0, omega: 0.0, acceleration: 0.0, relative: 0.0, time: 0.0, is_noisy: false };
        let mut scale = 0.0_f64;
        for pair in times.windows(2) {
            let time = 0.5 * (pair[0] + pair[1]);
            let points = (better.and_then(|f| f(time)), worse.and_then(|f| f(time)));
            let (Some(a), Some(b)) = points else { continue };
            scale = scale.max(a.acceleration.norm() + a.omega.dot(a.omega));
            most.attitude = most.attitude.max(a.attitude.angle_to(b.attitude));
            most.omega = most.omega.max((a.omega - b.omega).norm());
            let difference = (a.acceleration - b.acceleration).norm();
            if difference > most.acceleration {
                (most.acceleration, most.time) = (difference, time);
            }
        }
        most.relative = if scale > 0.0 { most.acceleration / scale } else { 0.0 };
        most
    }
}

/// Checks the number and the order of times; returns the first and the last time.
fn require_rows(times: &[f64], rows: usize) -> Result<[f64; 2], MotionError> {
    let holds = times.len() >= FEWEST && rows == times.len();
    require::that("the number of rows", rows as f64, holds, "at least 4, with a time for each")?;
    let ascends = |pair: &[f64]| pair[0] < pair[1];
    match (times.first(), times.last()) {
        (Some(&first), Some(&last))
            if times.windows(2).all(ascends) && first.is_finite() && last.is_finite() =>
        {
            Ok([first, last])
        }
        _ => Err(disorder(times)),
    }
}

/// Returns the error for the first time that is not after its predecessor.
fn disorder(times: &[f64]) -> MotionError {
    let wrong = times.windows(2).find(|pair| !(pair[0] < pair[1]));
    let value = wrong.map_or(f64::NAN, |pair| pair[1]);
    let (parameter, rule) = ("a time of the table", "finite, and after the one before it");
    MotionError::ParameterOutOfRange { parameter, value, rule }
}
