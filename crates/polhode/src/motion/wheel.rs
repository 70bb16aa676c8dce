//! Momentum wheels: what spins inside a body.

use crate::math::frame::Body;
use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::torque::Schedule;

/// A wheel whose axis is fixed in the body. The body's inertia holds the wheel's as if it were locked.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Wheel {
    /// Its axis, a unit vector.
    pub axis: Direction<Body>,
    /// Its angular momentum along the axis at t = 0, kg·m²/s: relative to the body if its speed is held, else relative to space.
    pub momentum: f64,
    /// What its motor does.
    pub motor: Motor,
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
    /// A wheel.
    ///
    /// # Errors
    /// [`MotionError::Parameter`] if the axis has no direction, a number is not finite, or an inertia not positive.
    pub fn new(axis: Direction<Body>, momentum: f64, motor: Motor) -> Result<Self, MotionError> {
        let parameter = |what, value, rule| MotionError::Parameter { what, value, rule };
        let Some(axis) = axis.direction() else {
            let rule = "a direction: finite and not zero";
            return Err(parameter("the length of the wheel's axis", axis.norm(), rule));
        };
        if !momentum.is_finite() {
            return Err(parameter("the wheel's angular momentum", momentum, "finite"));
        }
        if let Motor::Torque { inertia, torque, .. } = motor {
            if !(inertia > 0.0 && inertia.is_finite()) {
                return Err(parameter("the wheel's moment of inertia", inertia, "positive and finite"));
            }
            if !torque.is_finite() {
                return Err(parameter("the motor's torque", torque, "finite"));
            }
        }
        Ok(Self { axis, momentum, motor })
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

    /// The motor's torque on it just after a time, N·m.
    pub fn torque_at(&self, time: f64) -> f64 {
        match self.motor {
            Motor::Torque { torque, schedule, .. } if schedule.is_none_or(|s| s.is_on(time)) => torque,
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
