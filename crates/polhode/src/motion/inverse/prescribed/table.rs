//! A table of attitudes or of ω, made smooth.
//!
//! Attitudes are interpolated as quaternions of four components, each by a spline of degree 7, and the curve is brought back
//! to length 1. Turning the axes of space or of the body multiplies quaternions by a fixed one, which is linear: so the curve
//! does not depend on the axes. Between rows h apart the attitude is wrong by some h⁸, ω by h⁷, dω/dt by h⁶; all three are
//! continuous, and ω and dω/dt are the exact derivatives of the attitude that is given.
//!
//! How wrong is seen from a spline of degree 5 through the same rows, which is worse: their difference is an upper estimate.
//! With every second row it must be larger; where it is smaller, the rows say more of their own noise than of the motion.

use crate::math::rotation::Attitude;
use crate::math::spline::Spline;
use crate::math::vector::{AngularAcceleration, AngularVelocity};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::state::State;

use super::quaternion;
use super::rates::Rates;
use crate::math::frame::Body;

/// The degree of the curve, and of the one that it is compared with.
const DEGREE: usize = 7;
const LOWER: usize = 5;

/// Fewer rows than this say nothing of dω/dt.
const FEWEST: usize = 4;

/// A table of attitudes as a smooth motion.
#[derive(Clone, Debug, PartialEq)]
pub struct AttitudeTable {
    spline: Spline<4>,
    span: [f64; 2],
    uncertainty: Uncertainty,
}

/// How far a motion through the rows of a table may be from the one that was sampled: the largest differences between splines
/// of degree 7 and 5, halfway between rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncertainty {
    /// Of the attitude, rad.
    pub attitude: f64,
    /// Of ω, rad/s.
    pub omega: f64,
    /// Of dω/dt, rad/s².
    pub acceleration: f64,
    /// That of dω/dt relative to the greatest |dω/dt| + |ω|² of the motion.
    pub relative: f64,
    /// When that of dω/dt is greatest, s.
    pub time: f64,
    /// True if every second row gives a smaller difference than all: the rows are rounded or noisy, and nearer ones no better.
    pub is_noisy: bool,
}

impl AttitudeTable {
    /// A motion through attitudes at ascending times.
    ///
    /// # Errors
    /// As [`Prescribed::attitude_table`](super::Prescribed::attitude_table).
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

    /// From the first row to the last, s.
    pub const fn span(&self) -> [f64; 2] {
        self.span
    }

    /// How far it may be from the motion that was sampled.
    pub const fn uncertainty(&self) -> Uncertainty {
        self.uncertainty
    }

    /// The state and dω/dt at a time of the span; `None` where the curve is undetermined.
    pub(super) fn at(&self, time: f64) -> Option<(State, AngularAcceleration<Body>)> {
        let (attitude, omega, acceleration) = quaternion::kinematics(self.spline.at(time))?;
        Some((State { time, attitude, omega }, acceleration))
    }
}

/// The components of ω in a table as functions of time, from when to when, and how far they may be off.
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
    // What ω is wrong by, for as long as it can be.
    uncertainty.attitude = uncertainty.omega * (span[1] - span[0]);
    let spline = Spline::through(times, rows, DEGREE).ok_or_else(|| disorder(times))?;
    Ok((Rates::Table(spline), span, uncertainty))
}

/// A motion at one time, for comparison.
struct TablePoint {
    attitude: Attitude,
    omega: AngularVelocity<Body>,
    acceleration: AngularAcceleration<Body>,
}

impl Uncertainty {
    /// From the curves of two degrees through all rows, and through every second one.
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

/// The first and the last time of enough ascending ones.
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

/// The first time that is not after the one before it.
fn disorder(times: &[f64]) -> MotionError {
    let wrong = times.windows(2).find(|pair| !(pair[0] < pair[1]));
    let value = wrong.map_or(f64::NAN, |pair| pair[1]);
    let (parameter, rule) = ("a time of the table", "finite, and after the one before it");
    MotionError::ParameterOutOfRange { parameter, value, rule }
}
