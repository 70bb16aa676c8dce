//! Prescribed motions, as input of inverse dynamics.
//!
//! `euler` and `quaternion` have the kinematics of prescribed attitudes. `turning` integrates the
//! attitude if ω is prescribed, by formulas or by a table (`rates`). `table` interpolates a table.

mod euler;
mod quaternion;
mod rates;
mod table;
mod turning;

use crate::math::formula::Formula;
use crate::math::frame::Body;
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::{AngularAcceleration, AngularVelocity, Direction};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::state::State;
use rates::Rates;

pub use table::{AttitudeTable, Uncertainty};
pub use turning::{RateAxes, Turning};

/// Prescribed motion, for which the required torque can be computed.
///
/// ```
/// use polhode::math::{Attitude, Direction};
/// use polhode::motion::Prescribed;
/// // A shaft along the body's (0, 1, 1), speeding up from 3 rad/s by 0.5 rad/s².
/// let motion = Prescribed::fixed_axis(Attitude::identity(), Direction::new(0.0, 1.0, 1.0), 3.0, 0.5)?;
/// let (state, acceleration) = motion.at(2.0)?;
/// assert!((state.omega.norm() - 4.0).abs() < 1e-15);
/// assert!((acceleration.norm() - 0.5).abs() < 1e-15);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Prescribed {
    /// Rotation about an axis fixed in the body and in space: ω(t) = n (rate + acceleration t).
    #[non_exhaustive]
    FixedAxis {
        /// Attitude at t = 0.
        attitude: Attitude,
        /// Unit vector n of the axis, body axes.
        axis: Direction<Body>,
        /// ω at t = 0, rad/s.
        rate: f64,
        /// dω/dt, rad/s².
        acceleration: f64,
    },
    /// Euler angles (3-1-3) that change uniformly: φ = φ₀ + φ̇ t, and likewise θ and ψ.
    #[non_exhaustive]
    EulerRates {
        /// φ, θ, ψ at t = 0, rad.
        angles: [f64; 3],
        /// φ̇, θ̇, ψ̇, rad/s.
        rates: [f64; 3],
    },
    /// Euler angles (3-1-3) φ, θ, ψ, rad, as formulas of t.
    EulerAngles([Formula; 3]),
    /// Attitude q/|q| whose components w, x, y, z are formulas of t.
    Quaternion([Formula; 4]),
    /// Angular velocity ω(t), with an initial attitude.
    Turning(Box<Turning>),
    /// Table of attitudes, interpolated by a smooth curve.
    Table(Box<AttitudeTable>),
}

impl Prescribed {
    /// Creates a rotation about a fixed axis.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the axis is zero, or a number is not
    /// finite.
    pub fn fixed_axis(
        attitude: Attitude,
        axis: Direction<Body>,
        rate: f64,
        acceleration: f64,
    ) -> Result<Self, MotionError> {
        let axis = require::direction("the length of the axis", axis)?;
        require::finite("the rate", rate)?;
        require::finite("the acceleration", acceleration)?;
        Ok(Self::FixedAxis { attitude, axis, rate, acceleration })
    }

    /// Creates a motion with uniformly changing 3-1-3 Euler angles, such as steady precession or a
    /// rolling coin.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if a number is not finite.
    pub fn euler_rates(angles: [f64; 3], rates: [f64; 3]) -> Result<Self, MotionError> {
        for angle in angles {
            require::finite("the Euler angle", angle)?;
        }
        for rate in rates {
            require::finite("the Euler angle's rate", rate)?;
        }
        Ok(Self::EulerRates { angles, rates })
    }

    /// Creates a motion from ω as three formulas of t along body or space axes, rad/s. It starts
    /// from an attitude at t = 0 and ends at `end`, s.
    ///
    /// The attitude is integrated immediately, in at least 256 steps. [`Turning::attitude_error`]
    /// returns an estimate of its error. A pulse much shorter than a step may be missed.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] if ω is not finite. [`MotionError::StepTooSmall`] or
    /// [`MotionError::TooManySteps`] if ω changes too fast. A parameter's error
    /// ([`MotionError::is_parameter`]) if the end is negative or not finite.
    pub fn omega(
        attitude: Attitude,
        axes: RateAxes,
        omega: [Formula; 3],
        end: f64,
    ) -> Result<Self, MotionError> {
        require::not_negative("the end of the motion", end)?;
        let turning = Turning::new(Rates::Formulas(omega), axes, attitude, [0.0, end])?;
        Ok(Self::Turning(Box::new(turning)))
    }

    /// Creates a motion from a table of ω, rad/s, at ascending times, s, and an attitude at the
    /// first time. A spline of degree 7 interpolates ω, and the attitude is integrated from it.
    ///
    /// # Errors
    /// The errors of [`Prescribed::omega`]. A parameter's error ([`MotionError::is_parameter`]) if
    /// there are fewer than four rows, if times do not ascend, or if a number is not finite.
    pub fn omega_table(
        attitude: Attitude,
        axes: RateAxes,
        times: &[f64],
        omega: &[[f64; 3]],
    ) -> Result<(Self, Uncertainty), MotionError> {
        let (rates, span, uncertainty) = table::rates(times, omega)?;
        Ok((Self::Turning(Box::new(Turning::new(rates, axes, attitude, span)?)), uncertainty))
    }

    /// Creates a motion from a table of attitudes at ascending times, s.
    ///
    /// ```
    /// use polhode::math::{Attitude, Direction};
    /// use polhode::motion::Prescribed;
    /// // Six attitudes of a body that turns about z at 0.7 rad/s: the motion between them is found.
    /// let turn = |t: f64| Attitude::from_axis_angle(Direction::new(0.0, 0.0, 1.0), 0.7 * t);
    /// let times = [0.0, 0.2, 0.4, 0.6, 0.8, 1.0];
    /// let rows = times.iter().map(|t| turn(*t)).collect::<Result<Vec<_>, _>>()?;
    /// let (motion, uncertainty) = Prescribed::attitude_table(&times, &rows)?;
    /// let (state, _) = motion.at(0.5)?;
    /// assert!((state.omega.z - 0.7).abs() < 1e-6 && uncertainty.omega < 1e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if there are fewer than four rows, if
    /// times do not ascend, or if successive rows differ by more than a quarter of a turn.
    pub fn attitude_table(times: &[f64], attitudes: &[Attitude]) -> Result<(Self, Uncertainty), MotionError> {
        let table = AttitudeTable::new(times, attitudes)?;
        let uncertainty = table.uncertainty();
        Ok((Self::Table(Box::new(table)), uncertainty))
    }

    /// Returns the interval in which the motion is defined, s; `None` if it is always defined.
    pub fn span(&self) -> Option<[f64; 2]> {
        match self {
            Self::Turning(motion) => Some(motion.span()),
            Self::Table(table) => Some(table.span()),
            _ => None,
        }
    }

    /// Returns the state and the angular acceleration (body axes) at a time, s.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the time is outside
    /// [`Prescribed::span`]. [`MotionError::NotFinite`] if a formula is not finite, or a quaternion
    /// is zero.
    pub fn at(&self, time: f64) -> Result<(State, AngularAcceleration<Body>), MotionError> {
        if let Some([first, last]) = self.span() {
            let rule = "within the time for which the motion is given";
            require::that("the time", time, first <= time && time <= last, rule)?;
        }
        let nowhere = MotionError::NotFinite { time };
        let (state, acceleration) = match self {
            Self::FixedAxis { attitude, axis, rate, acceleration } => {
                let angle = (rate + 0.5 * acceleration * time) * time;
                let omega: AngularVelocity<Body> = axis.as_quantity() * (rate + acceleration * time);
                let attitude = *attitude * Rotation::<Body, Body>::turn(*axis, angle);
                (State { time, attitude, omega }, axis.as_quantity() * *acceleration)
            }
            Self::EulerRates { angles, rates } => {
                let angles = core::array::from_fn(|k| angles[k] + rates[k] * time);
                let (omega, acceleration) = euler::kinematics(angles, *rates, [0.0; 3]);
                (State { time, attitude: euler::turns(angles), omega }, acceleration)
            }
            Self::EulerAngles(formulas) => {
                let jets = formulas.each_ref().map(|formula| formula.derivatives(time));
                let [angles, rates, second] = core::array::from_fn(|order| jets.map(|jet| jet[order]));
                let (omega, acceleration) = euler::kinematics(angles, rates, second);
                (State { time, attitude: euler::turns(angles), omega }, acceleration)
            }
            Self::Quaternion(formulas) => {
                let jets = formulas.each_ref().map(|formula| formula.derivatives(time));
                let jets = core::array::from_fn(|order| jets.map(|jet| jet[order]));
                let (attitude, omega, acceleration) = quaternion::kinematics(jets).ok_or(nowhere.clone())?;
                (State { time, attitude, omega }, acceleration)
            }
            Self::Turning(motion) => motion.at(time),
            Self::Table(table) => table.at(time).ok_or(nowhere.clone())?,
        };
        let is_attitude = state.attitude.quaternion().iter().all(|c| c.is_finite());
        if is_attitude && state.omega.is_finite() && acceleration.is_finite() {
            Ok((state, acceleration))
        } else {
            Err(nowhere)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn euler_rates_are_the_derivative_of_the_attitude() {
        let motion = Prescribed::euler_rates([0.4, 0.9, -1.2], [0.7, -0.3, 2.1]).unwrap();
        let (t, h) = (0.6, 1e-5);
        let (before, after) = (motion.at(t - h).unwrap().0, motion.at(t + h).unwrap().0);
        let (state, acceleration) = motion.at(t).unwrap();
        let [_, x, y, z] = (before.attitude.inverse() * after.attitude).canonical_quaternion();
        let omega = AngularVelocity::<Body>::new(x, y, z) / h; // half the angle over h
        assert!((omega - state.omega).norm() < 1e-9);
        let rate: AngularAcceleration<Body> = ((after.omega - before.omega) / (2.0 * h)).as_quantity();
        assert!((rate - acceleration).norm() < 1e-9);
    }

    #[test]
    fn a_fixed_axis_turns_as_its_rate_says() {
        let start = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
        let motion = Prescribed::fixed_axis(start, Direction::new(1.0, -2.0, 0.5), 3.0, -0.4).unwrap();
        assert!(motion.at(0.0).unwrap().0.attitude.angle_to(start) < 1e-15);
        let (t, h) = (1.3, 1e-5);
        let (before, after) = (motion.at(t - h).unwrap().0, motion.at(t + h).unwrap().0);
        let [_, x, y, z] = (before.attitude.inverse() * after.attitude).canonical_quaternion();
        assert!((AngularVelocity::<Body>::new(x, y, z) / h - motion.at(t).unwrap().0.omega).norm() < 1e-9);
        assert!(Prescribed::fixed_axis(start, Direction::ZERO, 1.0, 0.0).is_err());
        assert!(Prescribed::euler_rates([0.0; 3], [f64::NAN, 0.0, 0.0]).is_err());
    }
}
