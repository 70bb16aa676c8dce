//! Prescribed motions: given, not computed.

use super::error::MotionError;
use super::state::State;
use crate::math::frame::{Body, Space};
use crate::math::real::sin_cos;
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::{AngularAcceleration, AngularVelocity, Direction, Vector};

/// A motion that is prescribed; the question is what torque it needs.
///
/// ```
/// use polhode::{Attitude, Direction, Prescribed};
/// // A shaft along the body's (0, 1, 1), speeding up from 3 rad/s by 0.5 rad/s².
/// let motion = Prescribed::fixed_axis(Attitude::identity(), Direction::new(0.0, 1.0, 1.0), 3.0, 0.5)?;
/// let (state, acceleration) = motion.at(2.0);
/// assert!((state.omega.norm() - 4.0).abs() < 1e-15);
/// assert!((acceleration.norm() - 0.5).abs() < 1e-15);
/// # Ok::<(), polhode::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Prescribed {
    /// Rotation about an axis fixed in the body and in space: ω(t) = n (rate + acceleration t).
    #[non_exhaustive]
    FixedAxis {
        /// The attitude at t = 0.
        attitude: Attitude,
        /// The axis n, a unit vector.
        axis: Direction<Body>,
        /// ω at t = 0, rad/s.
        rate: f64,
        /// dω/dt, rad/s².
        acceleration: f64,
    },
    /// 3-1-3 Euler angles that change uniformly: φ = φ₀ + φ̇ t and so on.
    #[non_exhaustive]
    EulerRates {
        /// φ, θ, ψ at t = 0, rad.
        angles: [f64; 3],
        /// φ̇, θ̇, ψ̇, rad/s.
        rates: [f64; 3],
    },
}

impl Prescribed {
    /// A rotation about a fixed axis.
    ///
    /// # Errors
    /// [`MotionError::Parameter`] if the axis has no direction or a number is not finite.
    pub fn fixed_axis(
        attitude: Attitude,
        axis: Direction<Body>,
        rate: f64,
        acceleration: f64,
    ) -> Result<Self, MotionError> {
        let Some(axis) = axis.direction() else {
            let rule = "a direction: finite and not zero";
            return Err(MotionError::Parameter { what: "the length of the axis", value: axis.norm(), rule });
        };
        finite("the rate", rate)?;
        finite("the acceleration", acceleration)?;
        Ok(Self::FixedAxis { attitude, axis, rate, acceleration })
    }

    /// Uniformly changing 3-1-3 Euler angles: steady precession, a coin's roll, a gyroscope's sweep.
    ///
    /// # Errors
    /// [`MotionError::Parameter`] if a number is not finite.
    pub fn euler_rates(angles: [f64; 3], rates: [f64; 3]) -> Result<Self, MotionError> {
        for angle in angles {
            finite("the Euler angle", angle)?;
        }
        for rate in rates {
            finite("the Euler angle's rate", rate)?;
        }
        Ok(Self::EulerRates { angles, rates })
    }

    /// The state and the angular acceleration (body axes) at a time, s.
    pub fn at(&self, time: f64) -> (State, AngularAcceleration<Body>) {
        match *self {
            Self::FixedAxis { attitude, axis, rate, acceleration } => {
                let angle = (rate + 0.5 * acceleration * time) * time;
                let omega: AngularVelocity<Body> = axis.as_quantity() * (rate + acceleration * time);
                let attitude = attitude * Rotation::<Body, Body>::turn(axis, angle);
                (State { time, attitude, omega }, axis.as_quantity() * acceleration)
            }
            Self::EulerRates { angles, rates } => {
                let [phi, theta, psi]: [f64; 3] = core::array::from_fn(|k| angles[k] + rates[k] * time);
                let (omega, acceleration) = euler_kinematics([phi, theta, psi], rates);
                (State { time, attitude: euler_turns([phi, theta, psi]), omega }, acceleration)
            }
        }
    }
}

/// R₃(φ) R₁(θ) R₃(ψ)
fn euler_turns([phi, theta, psi]: [f64; 3]) -> Attitude {
    let z = Direction::new(0.0, 0.0, 1.0);
    let first = Rotation::<Space, Space>::turn(z, phi);
    let second = Rotation::<Space, Body>::turn(Direction::new(1.0, 0.0, 0.0), theta);
    first * second * Rotation::<Body, Body>::turn(Direction::new(0.0, 0.0, 1.0), psi)
}

/// ω = (φ̇ sθ sψ + θ̇ cψ, φ̇ sθ cψ − θ̇ sψ, φ̇ cθ + ψ̇) and its derivative at constant rates.
///
/// The derivative of R₃(φ) R₁(θ) R₃(ψ), which the tests difference.
fn euler_kinematics(
    [_, theta, psi]: [f64; 3],
    [p, n, s]: [f64; 3],
) -> (AngularVelocity<Body>, AngularAcceleration<Body>) {
    let ((st, ct), (sp, cp)) = (sin_cos(theta), sin_cos(psi));
    let omega = Vector::new(p * st * sp + n * cp, p * st * cp - n * sp, p * ct + s);
    let acceleration = Vector::new(
        p * n * ct * sp + p * s * st * cp - n * s * sp,
        p * n * ct * cp - p * s * st * sp - n * s * cp,
        -p * n * st,
    );
    (omega, acceleration)
}

fn finite(what: &'static str, value: f64) -> Result<(), MotionError> {
    if value.is_finite() { Ok(()) } else { Err(MotionError::Parameter { what, value, rule: "finite" }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn euler_rates_are_the_derivative_of_the_attitude() {
        let motion = Prescribed::euler_rates([0.4, 0.9, -1.2], [0.7, -0.3, 2.1]).unwrap();
        let (t, h) = (0.6, 1e-5);
        let (before, after) = (motion.at(t - h).0, motion.at(t + h).0);
        let (state, acceleration) = motion.at(t);
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
        assert!(motion.at(0.0).0.attitude.angle_to(start) < 1e-15);
        let (t, h) = (1.3, 1e-5);
        let (before, after) = (motion.at(t - h).0, motion.at(t + h).0);
        let [_, x, y, z] = (before.attitude.inverse() * after.attitude).canonical_quaternion();
        assert!((AngularVelocity::<Body>::new(x, y, z) / h - motion.at(t).0.omega).norm() < 1e-9);
        assert!(Prescribed::fixed_axis(start, Direction::ZERO, 1.0, 0.0).is_err());
        assert!(Prescribed::euler_rates([0.0; 3], [f64::NAN, 0.0, 0.0]).is_err());
    }
}
