//! Contact laws: the constraint or friction at the point of contact, and rolling and pivoting
//! resistance.

use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Law of the contact force and torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLaw {
    grip: Grip,
    resistance: Resistance,
}

/// Constraint or friction at the point of contact.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Grip {
    /// The contact never slips, however large the required force is.
    NoSlip,
    /// The contact slips if the required force exceeds static friction.
    Friction(Friction),
}

/// Friction at the point of contact: F = −(µ N/|u| + c) u while slipping with u; at most µₛ N
/// without slip.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Friction {
    /// Coefficient of static friction µₛ.
    pub sticking: f64,
    /// Coefficient of kinetic friction µ.
    pub kinetic: f64,
    /// Coefficient of viscous friction c, N·s/m.
    pub viscous: f64,
}

/// Resistance to rolling and pivoting: the torque −N (µᵣ `ω_t`/|`ω_t`| + µₚ `ω_n`/|`ω_n`|). `ω_t`
/// is tangential to the ground, `ω_n` along its normal; µᵣ and µₚ are lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resistance {
    /// Length µᵣ of rolling resistance, m.
    pub rolling: f64,
    /// Length µₚ of pivoting resistance, m.
    pub pivoting: f64,
}

impl ContactLaw {
    /// Rolling without slip and without resistance.
    pub const ROLLING: Self =
        Self { grip: Grip::NoSlip, resistance: Resistance { rolling: 0.0, pivoting: 0.0 } };

    /// Contact without friction.
    pub const FRICTIONLESS: Self = Self {
        grip: Grip::Friction(Friction { sticking: 0.0, kinetic: 0.0, viscous: 0.0 }),
        resistance: Resistance { rolling: 0.0, pivoting: 0.0 },
    };

    /// Creates a law with friction.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if a coefficient is negative or not
    /// finite, or if static friction is below kinetic friction. Also if kinetic friction is zero
    /// and static friction is not.
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

    /// Adds resistance to rolling and pivoting.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if a length is negative or not finite.
    pub fn resisted_by(self, resistance: Resistance) -> Result<Self, MotionError> {
        require::not_negative("the lever of rolling friction", resistance.rolling)?;
        require::not_negative("the lever of pivoting friction", resistance.pivoting)?;
        Ok(Self { resistance, ..self })
    }

    /// Returns the constraint or friction at the point of contact.
    pub const fn grip(&self) -> &Grip {
        &self.grip
    }

    /// Returns the resistance to rolling and pivoting.
    pub const fn resistance(&self) -> Resistance {
        self.resistance
    }

    /// Returns the friction coefficients; zero if the contact never slips.
    pub(super) fn friction(&self) -> Friction {
        match self.grip {
            Grip::NoSlip => Friction::default(),
            Grip::Friction(friction) => friction,
        }
    }
}
