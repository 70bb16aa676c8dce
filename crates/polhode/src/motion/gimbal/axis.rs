//! An axis of the suspension: initial angle and rate, constraint, and torque.

use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Constraint on an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// No constraint.
    Free,
    /// A lock keeps the angle constant.
    Locked,
    /// A motor keeps the rate constant, whatever the required torque.
    Driven,
}

/// Torsion spring about an axis, with the torque −k (φ − φ₀).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Stiffness k, N·m/rad.
    pub stiffness: f64,
    /// Rest angle φ₀, rad.
    pub rest: f64,
}

/// Axis of a suspension: initial angle φ and rate, constraint, and the torque about it,
/// −d φ̇ − k (φ − φ₀) + τ.
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
    /// Free axis, at rest at angle zero.
    pub const FREE: Self =
        Self { hold: Hold::Free, angle: 0.0, rate: 0.0, damping: 0.0, spring: None, torque: 0.0 };

    /// Creates a free axis with an initial angle, rad, and rate, rad/s.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if a number is not finite.
    pub fn free(angle: f64, rate: f64) -> Result<Self, MotionError> {
        Self::held(Hold::Free, angle, rate)
    }

    /// Creates an axis that is locked at an angle, rad.
    ///
    /// # Errors
    /// The errors of [`Axis::free`].
    pub fn locked(angle: f64) -> Result<Self, MotionError> {
        Self::held(Hold::Locked, angle, 0.0)
    }

    /// Creates an axis that a motor turns at a constant rate, rad/s, from an angle, rad.
    ///
    /// # Errors
    /// The errors of [`Axis::free`].
    pub fn driven(angle: f64, rate: f64) -> Result<Self, MotionError> {
        Self::held(Hold::Driven, angle, rate)
    }

    fn held(hold: Hold, angle: f64, rate: f64) -> Result<Self, MotionError> {
        require::finite("the angle of an axis", angle)?;
        require::finite("the rate of an axis", rate)?;
        Ok(Self { hold, angle, rate, ..Self::FREE })
    }

    /// Sets the viscous damping d, N·m·s/rad.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if it is negative or not finite.
    pub fn damped(self, damping: f64) -> Result<Self, MotionError> {
        require::not_negative("the damping of an axis", damping)?;
        Ok(Self { damping, ..self })
    }

    /// Sets the spring.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the stiffness is negative, or a
    /// number is not finite.
    pub fn sprung(self, spring: Spring) -> Result<Self, MotionError> {
        require::not_negative("the stiffness of a spring", spring.stiffness)?;
        require::finite("the angle of a spring at rest", spring.rest)?;
        Ok(Self { spring: Some(spring), ..self })
    }

    /// Sets a constant torque τ, N·m.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the torque is not finite.
    pub fn turned_by(self, torque: f64) -> Result<Self, MotionError> {
        require::finite("the torque about an axis", torque)?;
        Ok(Self { torque, ..self })
    }

    /// Returns the constraint.
    pub const fn hold(&self) -> Hold {
        self.hold
    }

    /// Returns the initial angle, rad.
    pub const fn angle(&self) -> f64 {
        self.angle
    }

    /// Returns the initial rate, rad/s. The rate of a driven axis is constant.
    pub const fn rate(&self) -> f64 {
        self.rate
    }

    /// Returns the damping d, N·m·s/rad.
    pub const fn damping(&self) -> f64 {
        self.damping
    }

    /// Returns the spring, if there is one.
    pub const fn spring(&self) -> Option<Spring> {
        self.spring
    }

    /// Returns the constant torque τ, N·m.
    pub const fn torque(&self) -> f64 {
        self.torque
    }

    /// Replaces the initial angle and rate of a free axis; a locked or driven axis is unchanged.
    pub(in crate::motion) fn starting(self, angle: f64, rate: f64) -> Self {
        match self.hold {
            Hold::Free => Self { angle, rate, ..self },
            Hold::Locked | Hold::Driven => self,
        }
    }

    /// Returns the energy of the spring, ½ k (φ − φ₀)², J.
    pub(super) fn spring_energy(&self, angle: f64) -> f64 {
        self.spring
            .map_or(0.0, |Spring { stiffness, rest }| 0.5 * stiffness * (angle - rest) * (angle - rest))
    }
}
