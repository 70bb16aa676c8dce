//! Momentum wheels inside a body.

use crate::math::frame::Body;
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::schedule::Schedule;

/// Wheel whose axis a is fixed in the body. A body with wheels is a *gyrostat*. The inertia of the
/// body includes that of the locked wheel.
///
/// The wheel is symmetric about its axis, so its rotation does not change the inertia of the body.
/// Only its angular momentum h along a enters the equations. With L = I ω + Σ h a and the external
/// torque N,
///
/// I ω̇ = L × ω + N − Σ ḣ a
///
/// If the wheel is free or turned by a motor, I excludes the inertia of the wheel about its own
/// axis ([`crate::motion::Rotor::with_wheels`]).
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

/// Action of the motor of a wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Motor {
    /// Constant speed relative to the body: h = J Ω is constant along the axis.
    HeldSpeed,
    /// Torque on the wheel, which may be zero: h = J (a·ω + Ω) changes at that rate, along the
    /// axis.
    Torque {
        /// Moment of inertia of the wheel about its axis, kg·m².
        inertia: f64,
        /// Torque on the wheel, along the axis, N·m.
        torque: f64,
        /// Times at which the torque acts; `None` means always.
        schedule: Option<Schedule>,
    },
}

impl Wheel {
    /// Creates a wheel with angular momentum `momentum` along its axis at t = 0, kg·m²/s.
    ///
    /// If the motor holds the speed, `momentum` is relative to the body, J Ω. Otherwise it is
    /// relative to space, J (a·ω + Ω).
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the axis is zero or not finite, if a
    /// number is not finite, or if an inertia is not positive.
    pub fn new(axis: Direction<Body>, momentum: f64, motor: Motor) -> Result<Self, MotionError> {
        let axis = require::direction("the length of the wheel's axis", axis)?;
        require::finite("the wheel's angular momentum", momentum)?;
        if let Motor::Torque { inertia, torque, .. } = motor {
            require::positive("the wheel's moment of inertia", inertia)?;
            require::finite("the motor's torque", torque)?;
        }
        Ok(Self { axis, momentum, motor })
    }

    /// Creates a free or motor-driven wheel that starts at `speed` (rad/s) relative to the body.
    /// `omega` is ω of the body at t = 0: h = J (a·ω + Ω).
    ///
    /// # Errors
    /// The errors of [`Wheel::new`].
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

    /// Returns the unit vector of the axis, body axes.
    pub const fn axis(&self) -> Direction<Body> {
        self.axis
    }

    /// Returns the angular momentum along the axis at t = 0, kg·m²/s. It is relative to the body if
    /// the speed is held, otherwise relative to space.
    pub const fn momentum(&self) -> f64 {
        self.momentum
    }

    /// Returns the action of the motor.
    pub const fn motor(&self) -> Motor {
        self.motor
    }

    /// Returns true if the motor exerts a torque at some time, and so does work on the body.
    pub fn is_driven(&self) -> bool {
        matches!(self.motor, Motor::Torque { torque, .. } if torque != 0.0)
    }

    /// Returns the angular momentum along the axis at a time (s), kg·m²/s.
    pub fn momentum_at(&self, time: f64) -> f64 {
        match self.motor {
            Motor::HeldSpeed => self.momentum,
            Motor::Torque { torque, schedule, .. } => {
                self.momentum + torque * schedule.map_or(time, |schedule| schedule.time_on(time))
            }
        }
    }

    /// Returns the speed Ω = h/J − a·ω relative to a body with angular velocity ω at a time, rad/s.
    /// `None` if the speed is held: the inertia of the wheel is then part of the body's and not
    /// known.
    pub fn speed_at(&self, time: f64, omega: AngularVelocity<Body>) -> Option<f64> {
        match self.motor {
            Motor::HeldSpeed => None,
            Motor::Torque { inertia, .. } => Some(self.momentum_at(time) / inertia - self.axis.dot(omega)),
        }
    }

    /// Returns the torque of the motor on the wheel just after a time, N·m.
    pub fn torque_at(&self, time: f64) -> f64 {
        match self.motor {
            Motor::Torque { torque, schedule, .. } if schedule.is_none_or(|s| s.is_on(time)) => torque,
            _ => 0.0,
        }
    }

    /// Returns the number of pulses of the motor that begin in the interval (from, to].
    pub(crate) fn pulses_between(&self, from: f64, to: f64) -> f64 {
        match self.motor {
            Motor::Torque { schedule: Some(schedule), .. } => schedule.pulses_between(from, to),
            _ => 0.0,
        }
    }

    /// Returns the next time at which the torque of the motor changes, s.
    pub(crate) fn next_change(&self, time: f64) -> f64 {
        match self.motor {
            Motor::Torque { schedule: Some(schedule), .. } => schedule.next_change(time),
            _ => f64::INFINITY,
        }
    }
}
