//! Effect of internal friction on permanent rotations.
//!
//! An energy sink makes the body axes rotate at Ω = ω + α L × ω, and L̇ = L × Ω in the body.
//! ω − ν L is zero in the rotation, and a small δL perpendicular to L changes it by (I⁻¹ − ν) δL.
//! Let M be the part of I⁻¹ − ν perpendicular to L, and J the rotation by 90° about L:
//!
//! δL̇ = (|L| J − α L²) M δL
//!
//! M is symmetric, so J M has no trace. With c = L² det M, which determines the stability without
//! friction,
//!
//! s² + α L² tr M s + (1 + α² L²) c = 0
//!
//! The energy on the sphere of constant |L| exceeds that of the rotation by ½ δL · M δL. At an
//! energy maximum both roots have the real part −½ α L² tr M > 0; at a minimum both decay. By
//! components,
//!
//! L² tr M = Σ L_k ((L_k − i_i ω_k)/i_i + (L_k − i_j ω_k)/i_j)

use super::{PermanentRotation, Stability};
use crate::motion::model::torque::EnergySink;

/// Effect of internal friction on a small deviation from a permanent rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum DissipativeLimit {
    /// The deviation decays as exp(−rate t).
    #[non_exhaustive]
    Settles {
        /// Decay rate, 1/s.
        rate: f64,
    },
    /// The deviation grows as exp(rate t), and the body changes to a rotation of lower energy.
    #[non_exhaustive]
    Leaves {
        /// Growth rate, 1/s.
        rate: f64,
    },
    /// Neither: all neighbouring rotations have the same energy.
    Stays,
}

impl DissipativeLimit {
    /// Returns the name in JSON: `settles`, `leaves` or `stays`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Settles { .. } => "settles",
            Self::Leaves { .. } => "leaves",
            Self::Stays => "stays",
        }
    }
}

impl PermanentRotation {
    /// Returns the effect of an energy sink on the rotation, from the linear equations.
    ///
    /// A rotation that belongs to a continuous circle of them, such as a flat spin of a body with
    /// two equal moments, settles onto one of the circle.
    ///
    /// ```
    /// use polhode::prelude::*;
    /// use polhode::motion::torque::EnergySink;
    /// use polhode::observe::{PermanentRotation, DissipativeLimit, Stability};
    /// // Explorer 1: spun about its long axis, of least moment, it goes over to a flat spin.
    /// let inertia = InertiaTensor::diagonal([5.0, 5.0, 0.2])?;
    /// let body = Rotor::free(&MassProperties::new(14.0, Position::ZERO, inertia)?);
    /// let spin = PermanentRotation::of(&body, AngularVelocity::new(0.0, 0.0, 10.0))?;
    /// assert!(matches!(spin.stability, Stability::Stable { .. }));
    /// let limit = spin.with_friction(&EnergySink::new(0.002)?);
    /// let DissipativeLimit::Leaves { rate, .. } = limit else { return Err("it stays".into()) };
    /// assert!((rate - 0.002 * 4.0 * (1.0 / 0.2 - 1.0 / 5.0)).abs() < 1e-15); // α L² (1/I − 1/J)
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_friction(&self, sink: &EnergySink) -> DissipativeLimit {
        let c = match self.stability {
            Stability::Stable { frequency } => frequency * frequency,
            Stability::Unstable { growth_rate } => -growth_rate * growth_rate,
            Stability::Marginal => 0.0,
        };
        let more = sink.coefficient() * self.momentum.norm();
        // s² + 2 p s + q = 0.
        let (p, q) = (0.5 * sink.coefficient() * self.bend, (1.0 + more * more) * c);
        let square = p * p - q;
        // The larger real part; if one root is zero, the other root.
        let real = if q == 0.0 {
            -2.0 * p
        } else if square <= 0.0 {
            -p
        } else if p > 0.0 {
            -q / (p + square.sqrt())
        } else {
            square.sqrt() - p
        };
        match real {
            rate if rate > 0.0 => DissipativeLimit::Leaves { rate },
            rate if rate < 0.0 => DissipativeLimit::Settles { rate: -rate },
            _ => DissipativeLimit::Stays,
        }
    }

    /// Returns true if any kind of internal friction makes the body leave this rotation: the energy
    /// is not a minimum for this |L|.
    pub fn is_ended_by_friction(&self) -> bool {
        match self.stability {
            Stability::Unstable { .. } => true,
            Stability::Stable { .. } | Stability::Marginal => self.bend < 0.0,
        }
    }
}
