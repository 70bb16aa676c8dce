//! One axis of the suspension: where it stands at the start, what holds it, and what turns it.

use crate::motion::error::MotionError;
use crate::motion::model::require;

/// What holds an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// Nothing: it turns as it must.
    Free,
    /// A lock keeps its angle.
    Locked,
    /// A motor keeps its rate, whatever torque that takes.
    Driven,
}

/// A spring about an axis: −k (φ − φ₀).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// k, N·m/rad
    pub stiffness: f64,
    /// φ₀, rad
    pub rest: f64,
}

/// An axis of a suspension: its angle φ and its rate at the start, what holds it, and the torque about it, −d φ̇ − k (φ − φ₀) + τ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    hold: Hold,
    angle: f64,
    rate: f64,
    damping: f64,
    spring: Option<Spring>,
    torque: f64,
}

impl Axis {
    /// One that is free, and at rest at zero.
    pub const FREE: Self =
        Self { hold: Hold::Free, angle: 0.0, rate: 0.0, damping: 0.0, spring: None, torque: 0.0 };

    /// One that turns as it must, from an angle, rad, and a rate, rad/s.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for numbers that are not finite.
    pub fn free(angle: f64, rate: f64) -> Result<Self, MotionError> {
        Self::held(Hold::Free, angle, rate)
    }

    /// One that is locked at an angle, rad.
    ///
    /// # Errors
    /// As [`Axis::free`].
    pub fn locked(angle: f64) -> Result<Self, MotionError> {
        Self::held(Hold::Locked, angle, 0.0)
    }

    /// One that a motor turns at a constant rate, rad/s, from an angle, rad.
    ///
    /// # Errors
    /// As [`Axis::free`].
    pub fn driven(angle: f64, rate: f64) -> Result<Self, MotionError> {
        Self::held(Hold::Driven, angle, rate)
    }

    fn held(hold: Hold, angle: f64, rate: f64) -> Result<Self, MotionError> {
        require::finite("the angle of an axis", angle)?;
        require::finite("the rate of an axis", rate)?;
        Ok(Self { hold, angle, rate, ..Self::FREE })
    }

    /// With viscous damping d, N·m·s/rad.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for what is negative or not finite.
    pub fn damped(self, damping: f64) -> Result<Self, MotionError> {
        require::not_negative("the damping of an axis", damping)?;
        Ok(Self { damping, ..self })
    }

    /// With a spring.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for a stiffness that is negative, and numbers that are not finite.
    pub fn sprung(self, spring: Spring) -> Result<Self, MotionError> {
        require::not_negative("the stiffness of a spring", spring.stiffness)?;
        require::finite("the angle of a spring at rest", spring.rest)?;
        Ok(Self { spring: Some(spring), ..self })
    }

    /// With a constant torque τ, N·m.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for a torque that is not finite.
    pub fn turned_by(self, torque: f64) -> Result<Self, MotionError> {
        require::finite("the torque about an axis", torque)?;
        Ok(Self { torque, ..self })
    }

    /// What holds it.
    pub const fn hold(&self) -> Hold {
        self.hold
    }

    /// Its angle at the start, rad.
    pub const fn angle(&self) -> f64 {
        self.angle
    }

    /// Its rate at the start, rad/s; of one that is driven, always.
    pub const fn rate(&self) -> f64 {
        self.rate
    }

    /// d, N·m·s/rad
    pub const fn damping(&self) -> f64 {
        self.damping
    }

    /// Its spring.
    pub const fn spring(&self) -> Option<Spring> {
        self.spring
    }

    /// τ, N·m
    pub const fn torque(&self) -> f64 {
        self.torque
    }

    /// With another angle and rate at the start, of what is not locked or driven.
    pub(in crate::motion) fn starting(self, angle: f64, rate: f64) -> Self {
        match self.hold {
            Hold::Free => Self { angle, rate, ..self },
            Hold::Locked | Hold::Driven => self,
        }
    }

    /// ½ k (φ − φ₀)², J
    pub(super) fn spring_energy(&self, angle: f64) -> f64 {
        self.spring
            .map_or(0.0, |Spring { stiffness, rest }| 0.5 * stiffness * (angle - rest) * (angle - rest))
    }
}
