//! What friction inside a body makes of its permanent rotations.
//!
//! With an energy sink the axes turn at Ω = ω + α L × ω, and L̇ = L × Ω in the body. A small δL across L changes ω − ν L, which is zero in
//! the rotation, by (I⁻¹ − ν) δL. With M the part of I⁻¹ − ν across L, and J the quarter turn about it,
//!
//! δL̇ = (|L| J − α L²) M δL
//!
//! M is symmetric, so that J M has no trace. With c = L² det M, which decides without friction,
//!
//! s² + α L² tr M s + (1 + α² L²) c = 0
//!
//! The energy on the sphere of constant |L| is ½ δL · M δL more than that of the rotation: where it is greatest both roots have the
//! real part −½ α L² tr M > 0, where it is least both die away. By components,
//!
//! L² tr M = Σ L_k ((L_k − i_i ω_k)/i_i + (L_k − i_j ω_k)/i_j)

use super::{PermanentRotation, Stability};
use crate::motion::model::torque::EnergySink;

/// What becomes of a small departure from a permanent rotation while friction inside the body costs energy.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum DissipativeLimit {
    /// It dies away as exp(−rate t).
    #[non_exhaustive]
    Settles {
        /// 1/s
        rate: f64,
    },
    /// It grows as exp(rate t), and the body goes over to a rotation of less energy.
    #[non_exhaustive]
    Leaves {
        /// 1/s
        rate: f64,
    },
    /// Neither: all rotations near it have the same energy.
    Stays,
}

impl DissipativeLimit {
    /// The name in JSON: `settles`, `leaves` or `stays`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Settles { .. } => "settles",
            Self::Leaves { .. } => "leaves",
            Self::Stays => "stays",
        }
    }
}

impl PermanentRotation {
    /// What becomes of it with an energy sink, from the linear equations.
    ///
    /// A rotation that is one of a circle of them, as a flat spin of a body with two equal moments, settles onto one of the circle.
    ///
    /// ```
    /// use polhode::prelude::*;
    /// use polhode::motion::torque::EnergySink;
    /// use polhode::observe::{PermanentRotation, DissipativeLimit, Stability};
    /// // Explorer 1: spun about its long axis, of least moment, it goes over to a flat spin.
    /// let inertia = InertiaTensor::diagonal([5.0, 5.0, 0.2])?;
    /// let body = Rotor::free(&MassProperties::new(14.0, Position::ZERO, inertia)?);
    /// let spin = PermanentRotation::about(&body, AngularVelocity::new(0.0, 0.0, 10.0))?;
    /// assert!(matches!(spin.stability, Stability::Stable { .. }));
    /// let DissipativeLimit::Leaves { rate, .. } = spin.with_friction(&EnergySink::new(0.002)?) else { return Err("it stays".into()) };
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
        // s² + 2 p s + q = 0
        let (p, q) = (0.5 * sink.coefficient() * self.bend, (1.0 + more * more) * c);
        let square = p * p - q;
        // The real part that is greatest; of two roots with one zero, the other.
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

    /// True if friction inside, of whatever kind, makes it leave: the energy is not least here, for this |L|.
    pub fn is_ended_by_friction(&self) -> bool {
        match self.stability {
            Stability::Unstable { .. } => true,
            Stability::Stable { .. } | Stability::Marginal => self.bend < 0.0,
        }
    }
}
