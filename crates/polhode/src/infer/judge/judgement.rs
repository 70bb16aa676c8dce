//! Judgement of a motion: all results of the comparison.

use super::declared::DeclaredReading;
use super::error::JudgeError;
use super::growth::Growth;
use super::log::MotionLog;
use super::motion::ReadMotion;
use super::readings::Readings;
use super::reference::Reference;
use super::row_errors::RowErrors;
use super::split::Split;
use crate::motion::task::scenario::Scenario;

/// Judgement of a motion that another program computed.
///
/// ```
/// use polhode::infer::judge::{DeclaredReading, Judgement, MotionLog};
/// use polhode::prelude::*;
/// let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// let body = MassProperties::new(2.0, Position::ZERO, inertia)?;
/// let omega = AngularVelocity::new(0.3, -1.2, 0.4);
/// let start = State { time: 0.0, attitude: Attitude::from_quaternion([0.6, -0.3, 0.5, 0.2])?, omega };
/// let scenario = Scenario::new(body).starting(start)?;
///
/// // A program that writes x, y, z, w, and leaves out ω × I ω, so that the body turns about one axis for ever.
/// let times: Vec<f64> = (0..200).map(|k| 0.02 * f64::from(k)).collect();
/// let turned = |t: &f64| -> Result<[f64; 4], Box<dyn std::error::Error>> {
///     let turn = Rotation::<Body, Body>::from_axis_angle(Direction::from_array(omega.to_array()), omega.norm() * t)?;
///     let [w, x, y, z] = (start.attitude * turn).quaternion();
///     Ok([x, y, z, w])
/// };
/// let log = MotionLog::new(times.clone(), times.iter().map(turned).collect::<Result<_, _>>()?)?;
/// let judgement = Judgement::of(&scenario, &log, &DeclaredReading::default())?;
/// assert!(judgement.readings.reading.to_string().starts_with("quaternions x, y, z, w of body to space"));
/// assert!(judgement.largest_attitude_error() > 0.3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// Meaning of the log's numbers.
    pub readings: Readings,
    /// Motion of the log with this meaning.
    pub motion: ReadMotion,
    /// Exact motion at the same times.
    pub reference: Reference,
    /// Errors of the motion, row by row.
    pub errors: RowErrors,
    /// Components of the attitude error.
    pub split: Split,
    /// Growth of the error with time.
    pub growth: Growth,
    /// True if the log's numbers have at most the 24 bits of single precision.
    pub is_single_precision: bool,
}

impl Judgement {
    /// Judges the log of another program's motion of a scenario.
    ///
    /// # Errors
    /// The errors of [`Readings::of`] and [`Reference::of`].
    pub fn of(scenario: &Scenario, log: &MotionLog, declared: &DeclaredReading) -> Result<Self, JudgeError> {
        let readings = Readings::of(log, scenario, declared)?;
        let motion = readings.read(log);
        let reference = Reference::of(scenario, &motion.times)?;
        let errors = RowErrors::of(scenario.rotor(), &motion, reference.states());
        let split = Split::of(&motion, reference.states());
        let is_single_precision = log.is_single_precision();
        let mut judgement =
            Self { readings, motion, reference, errors, split, growth: Growth::Unknown, is_single_precision };
        judgement.growth = Growth::of(&judgement.motion.times, &judgement.errors.angles(), judgement.floor());
        Ok(judgement)
    }

    /// Returns the uncertainty of the exact attitude at the last row, including the rounding of a
    /// quaternion and of the run's times, rad. Smaller errors are not significant.
    pub fn floor(&self) -> f64 {
        let last = self.reference.error(self.motion.times.len().saturating_sub(1)).attitude;
        // Times are rounded by half a unit in their last place while the body rotates.
        let ends = [self.motion.times.first(), self.motion.times.last()].into_iter().flatten();
        let reading = &self.readings.reading;
        let written = |time: &f64| (time + reading.time_origin * reading.time_factor).abs();
        let latest = ends.map(written).fold(0.0, f64::max);
        last.max(ROUNDING).max(latest * (0.5 * f64::EPSILON) * self.reference.fastest())
    }

    /// Returns the largest angle between an attitude and the exact one, rad.
    pub fn largest_attitude_error(&self) -> f64 {
        self.errors.angles().into_iter().fold(0.0, f64::max)
    }

    /// Returns the angle between the attitude of the last row and the exact one, rad.
    pub fn last_attitude_error(&self) -> f64 {
        self.errors.angle(self.motion.times.len().saturating_sub(1))
    }
}

/// Rotation that rounding a quaternion to f64 may cause, rad.
const ROUNDING: f64 = 5e-16;
