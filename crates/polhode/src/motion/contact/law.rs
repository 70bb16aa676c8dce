//! What holds a body at its point of contact, and what resists its motion there.

use crate::motion::error::MotionError;
use crate::motion::model::require;

/// How the point of contact is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLaw {
    grip: Grip,
    resistance: Resistance,
}

/// What holds the point of contact.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Grip {
    /// It never slips, however large the force that this needs.
    NoSlip,
    /// It slips where the force would have to be larger than friction is.
    Friction(Friction),
}

/// Friction at the point of contact: F = −(µ N/|u| + c) u of what slips at u; what does not slip holds up to µₛ N.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Friction {
    /// µₛ
    pub sticking: f64,
    /// µ
    pub kinetic: f64,
    /// c, N·s/m
    pub viscous: f64,
}

/// Torques that resist rolling and pivoting, −N (µᵣ ω_t/|ω_t| + µₚ ω_n/|ω_n|), as lengths in m: ω_t lies in the ground, ω_n along its normal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resistance {
    /// µᵣ, m
    pub rolling: f64,
    /// µₚ, m
    pub pivoting: f64,
}

impl ContactLaw {
    /// Rolling without slipping.
    pub const ROLLING: Self =
        Self { grip: Grip::NoSlip, resistance: Resistance { rolling: 0.0, pivoting: 0.0 } };

    /// A contact without friction.
    pub const FRICTIONLESS: Self = Self {
        grip: Grip::Friction(Friction { sticking: 0.0, kinetic: 0.0, viscous: 0.0 }),
        resistance: Resistance { rolling: 0.0, pivoting: 0.0 },
    };

    /// With friction.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for what is negative or not finite, and where friction of what slips is larger than that of
    /// what does not, or is zero and that of what does not is not.
    pub fn with_friction(friction: Friction) -> Result<Self, MotionError> {
        require::not_negative("the coefficient of friction", friction.kinetic)?;
        require::not_negative("the coefficient of static friction", friction.sticking)?;
        require::not_negative("the coefficient of viscous friction", friction.viscous)?;
        let rule = "not below that of sliding: a body that slips would be held better than one that does not";
        let holds = friction.sticking >= friction.kinetic;
        require::that("the coefficient of static friction", friction.sticking, holds, rule)?;
        let holds = friction.kinetic > 0.0 || friction.sticking == 0.0;
        let rule = "positive where there is static friction: what slips without friction never comes to rest";
        require::that("the coefficient of friction", friction.kinetic, holds, rule)?;
        Ok(Self { grip: Grip::Friction(friction), resistance: Resistance::default() })
    }

    /// With what resists rolling and pivoting.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for what is negative or not finite.
    pub fn resisted_by(self, resistance: Resistance) -> Result<Self, MotionError> {
        require::not_negative("the lever of rolling friction", resistance.rolling)?;
        require::not_negative("the lever of pivoting friction", resistance.pivoting)?;
        Ok(Self { resistance, ..self })
    }

    /// What holds the point of contact.
    pub const fn grip(&self) -> &Grip {
        &self.grip
    }

    /// What resists rolling and pivoting.
    pub const fn resistance(&self) -> Resistance {
        self.resistance
    }

    /// Friction of what slips; none of what never does.
    pub(super) fn friction(&self) -> Friction {
        match self.grip {
            Grip::NoSlip => Friction::default(),
            Grip::Friction(friction) => friction,
        }
    }
}
