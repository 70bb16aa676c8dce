//! Momentum wheels: what spins inside a body.

use crate::math::frame::Body;
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::schedule::Schedule;

/// A wheel whose axis a is fixed in the body: with wheels the body is a *gyrostat*. The body's inertia holds the wheel's as if it
/// were locked.
///
/// The wheel is symmetric about its axis, so that it turns without changing the body's inertia, and all that matters of it is h,
/// its angular momentum along a. With L = I ω + Σ h a and the torque N from outside
///
/// I ω̇ = L × ω + N − Σ ḣ a
///
/// Where a motor turns the wheel, or nothing does, I is without what the wheel has about its own axis ([`crate::motion::Rotor::with_wheels`]).
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::Motor;
/// let inertia = InertiaTensor::diagonal([4.0, 5.0, 7.0])?;
/// let body = Rotor::free(&MassProperties::new(10.0, Position::ZERO, inertia)?);
/// // A motor spins a wheel up from rest for 2 s: L stays zero, and the carrier turns at −h/I the other way.
/// let motor = Motor::Torque { inertia: 1.0, torque: 0.3, schedule: None };
/// let body = body.with_wheels(&[Wheel::new(Direction::new(0.0, 0.0, 1.0), 0.0, motor)?])?;
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
/// let motion = Trajectory::compute(&body, &[], start, &[2.0], Method::Auto, 1e-13)?;
/// assert!((motion.samples()[0].state.omega.z - -0.6 / 6.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Wittenburg, Dynamics of Multibody Systems (2nd ed., 2008), on gyrostats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel {
    axis: Direction<Body>,
    momentum: f64,
    motor: Motor,
}

/// What the motor of a wheel does.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Motor {
    /// It holds the speed relative to the body: h = J Ω is constant along the axis.
    HeldSpeed,
    /// It turns the wheel with a torque, which may be zero: h = J (a·ω + Ω) changes at that rate, along the axis.
    Torque {
        /// The wheel's moment of inertia about its axis, kg·m².
        inertia: f64,
        /// On the wheel, along the axis, N·m.
        torque: f64,
        /// When; `None`: always.
        schedule: Option<Schedule>,
    },
}

impl Wheel {
    /// A wheel with this angular momentum along its axis at t = 0, kg·m²/s: that relative to the body, J Ω, if the motor holds its
    /// speed; else that relative to space, J (a·ω + Ω).
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the axis has no direction, a number is not finite, or an inertia not positive.
    pub fn new(axis: Direction<Body>, momentum: f64, motor: Motor) -> Result<Self, MotionError> {
        let axis = require::direction("the length of the wheel's axis", axis)?;
        require::finite("the wheel's angular momentum", momentum)?;
        if let Motor::Torque { inertia, torque, .. } = motor {
            require::positive("the wheel's moment of inertia", inertia)?;
            require::finite("the motor's torque", torque)?;
        }
        Ok(Self { axis, momentum, motor })
    }

    /// A wheel that turns freely or by its motor, which starts at `speed` relative to the body, whose ω at t = 0 is given:
    /// h = J (a·ω + Ω).
    ///
    /// # Errors
    /// As [`Wheel::new`].
    pub fn turning(
        axis: Direction<Body>,
        speed: f64,
        motor: Motor,
        omega: AngularVelocity<Body>,
    ) -> Result<Self, MotionError> {
        let wheel = Self::new(axis, 0.0, motor)?;
        let inertia = match motor {
            Motor::HeldSpeed => 0.0,
            Motor::Torque { inertia, .. } => inertia,
        };
        Self::new(axis, inertia * (wheel.axis.dot(omega) + speed), motor)
    }

    /// Its axis, a unit vector.
    pub const fn axis(&self) -> Direction<Body> {
        self.axis
    }

    /// Its angular momentum along the axis at t = 0, kg·m²/s: relative to the body if its speed is held, else relative to space.
    pub const fn momentum(&self) -> f64 {
        self.momentum
    }

    /// What its motor does.
    pub const fn motor(&self) -> Motor {
        self.motor
    }

    /// True if its motor turns it at some time, and so does work on the body.
    pub fn is_driven(&self) -> bool {
        matches!(self.motor, Motor::Torque { torque, .. } if torque != 0.0)
    }

    /// Its angular momentum along the axis at a time, kg·m²/s.
    pub fn momentum_at(&self, time: f64) -> f64 {
        match self.motor {
            Motor::HeldSpeed => self.momentum,
            Motor::Torque { torque, schedule, .. } => {
                self.momentum + torque * schedule.map_or(time, |schedule| schedule.time_on(time))
            }
        }
    }

    /// Its speed relative to a body with the angular velocity ω at a time, Ω = h/J − a·ω, rad/s; `None` where the speed is held: the
    /// body's inertia then holds the wheel's, which is not known.
    pub fn speed_at(&self, time: f64, omega: AngularVelocity<Body>) -> Option<f64> {
        match self.motor {
            Motor::HeldSpeed => None,
            Motor::Torque { inertia, .. } => Some(self.momentum_at(time) / inertia - self.axis.dot(omega)),
        }
    }

    /// The motor's torque on it just after a time, N·m.
    pub fn torque_at(&self, time: f64) -> f64 {
        match self.motor {
            Motor::Torque { torque, schedule, .. } if schedule.is_none_or(|s| s.is_on(time)) => torque,
            _ => 0.0,
        }
    }

    /// How many pulses of its motor begin after a time and no later than another.
    pub(crate) fn pulses_between(&self, from: f64, to: f64) -> f64 {
        match self.motor {
            Motor::Torque { schedule: Some(schedule), .. } => schedule.pulses_between(from, to),
            _ => 0.0,
        }
    }

    /// When its motor's torque changes next, s.
    pub(crate) fn next_change(&self, time: f64) -> f64 {
        match self.motor {
            Motor::Torque { schedule: Some(schedule), .. } => schedule.next_change(time),
            _ => f64::INFINITY,
        }
    }
}
