//! What is odd about a log.

use core::fmt;

use super::edge::EdgeKind;

/// Something that is probably wrong with the log, or with the model.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PayloadFinding {
    /// Least squares has a mass that is negative beyond noise: the wrench is that on the other side, or gravity points up.
    /// Noise of the motion is not regarded then.
    NegativeMass {
        /// kg
        mass: f64,
        /// kg
        sd: f64,
    },
    /// Unconstrained least squares is no possible body, beyond noise: the model is wrong somewhere.
    ImpossibleBeyondNoise {
        /// By how much χ² rises where the body has to be possible.
        chi_square_rise: f64,
    },
    /// The payload is not what it was said to be, beyond noise.
    NotOfKind {
        /// What it was said to be.
        kind: EdgeKind,
        /// By how much χ² rises where it has to be that.
        chi_square_rise: f64,
    },
    /// Gravity is not of one size.
    GravityVaries {
        /// m/s²
        least: f64,
        /// m/s²
        most: f64,
    },
    /// Gravity is not that of the Earth, nor zero.
    UnusualGravity {
        /// m/s²
        size: f64,
    },
    /// Residuals are too large, and far smaller if a mistake was made.
    Likely {
        /// Which.
        mistake: Mistake,
        /// χ²/degrees of freedom as it is.
        as_given: f64,
        /// And with the mistake undone.
        undone: f64,
    },
    /// More than one row in ten is far off: none was left out.
    ManyOutliers {
        /// How many.
        count: usize,
    },
}

/// A mistake in a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mistake {
    /// Accelerations in units of 9.80665 m/s².
    AccelerationInG,
    /// Accelerations are what an accelerometer reads, a − g, already.
    AccelerationHasGravity,
    /// Gravity points up.
    GravityReversed,
    /// Angular velocity in °/s.
    OmegaInDegrees,
    /// Angular acceleration in °/s².
    AlphaInDegrees,
    /// Both.
    AnglesInDegrees,
    /// Angular acceleration of the opposite sign.
    AlphaReversed,
    /// Torques in N·cm.
    TorqueInCentimetres,
    /// Torques in N·mm.
    TorqueInMillimetres,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::AccelerationInG => "the acceleration is in units of g",
            Self::AccelerationHasGravity => {
                "the acceleration has gravity in it, as an accelerometer reads it"
            }
            Self::GravityReversed => "gravity points up",
            Self::OmegaInDegrees => "the angular velocity is in °/s",
            Self::AlphaInDegrees => "the angular acceleration is in °/s²",
            Self::AnglesInDegrees => "the angular velocity and acceleration are in °/s and °/s²",
            Self::AlphaReversed => "the angular acceleration has the opposite sign",
            Self::TorqueInCentimetres => "the torque is in N·cm",
            Self::TorqueInMillimetres => "the torque is in N·mm",
        })
    }
}

impl fmt::Display for PayloadFinding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NegativeMass { mass, sd } => write!(
                f,
                "the mass would be {} ± {} kg: the wrench is that on the other side of the sensor, or gravity points up",
                short(*mass),
                short(*sd)
            ),
            Self::ImpossibleBeyondNoise { chi_square_rise } => write!(
                f,
                "no possible body fits as well as an impossible one: χ² rises by {}, more than noise explains",
                short(*chi_square_rise)
            ),
            Self::NotOfKind { kind, chi_square_rise } => write!(
                f,
                "the payload is not {kind}: χ² rises by {}, more than noise explains",
                short(*chi_square_rise)
            ),
            Self::GravityVaries { least, most } => {
                write!(f, "gravity is between {} and {} m/s²", short(*least), short(*most))
            }
            Self::UnusualGravity { size } => write!(f, "gravity is {} m/s²", short(*size)),
            Self::Likely { mistake, as_given, undone } => write!(
                f,
                "probably {mistake}: χ² by degrees of freedom would be {}, and is {}",
                short(*undone),
                short(*as_given)
            ),
            Self::ManyOutliers { count } => {
                write!(f, "{count} rows are far off, more than one in ten: none was left out")
            }
        }
    }
}

/// Four digits.
fn short(x: f64) -> String {
    let size = if x == 0.0 { 0.0 } else { x.abs().log10().floor() };
    let decimals = (3.0 - size).clamp(0.0, 15.0) as usize;
    format!("{x:.decimals$}")
}
