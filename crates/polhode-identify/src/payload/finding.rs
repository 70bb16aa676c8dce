//! Suspicious properties of a log.

use core::fmt;

use super::edge::EdgeKind;

/// Probable error in the log or in the model.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PayloadFinding {
    /// Significantly negative mass: the wrench has the opposite sense, or gravity points up. Noise
    /// of the motion is ignored in this case.
    NegativeMass {
        /// Estimated mass, kg.
        mass: f64,
        /// Standard deviation of the mass, kg.
        sd: f64,
    },
    /// Unconstrained least squares is significantly inconsistent with a physical body: the model is
    /// wrong.
    ImpossibleBeyondNoise {
        /// Increase of χ² caused by the constraint.
        chi_square_rise: f64,
    },
    /// Payload significantly different from the stated kind.
    NotOfKind {
        /// Stated kind.
        kind: EdgeKind,
        /// Increase of χ² caused by this kind.
        chi_square_rise: f64,
    },
    /// Gravity of varying magnitude.
    GravityVaries {
        /// Smallest magnitude, m/s².
        least: f64,
        /// Largest magnitude, m/s².
        most: f64,
    },
    /// Gravity that is neither that of the Earth nor zero.
    UnusualGravity {
        /// Magnitude, m/s².
        size: f64,
    },
    /// Large residuals that one mistake in the log would explain.
    Likely {
        /// Most likely mistake.
        mistake: Mistake,
        /// Reduced χ² of the log as read.
        as_given: f64,
        /// Reduced χ² with the mistake corrected.
        undone: f64,
    },
    /// More than one outlier in ten rows; none was left out.
    ManyOutliers {
        /// Number of outliers.
        count: usize,
    },
}

/// Mistake in a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mistake {
    /// Accelerations in units of 9.80665 m/s².
    AccelerationInG,
    /// Accelerations as an accelerometer reads them, a − g.
    AccelerationHasGravity,
    /// Gravity that points up.
    GravityReversed,
    /// Angular velocity in °/s.
    OmegaInDegrees,
    /// Angular acceleration in °/s².
    AlphaInDegrees,
    /// Angular velocity in °/s and angular acceleration in °/s².
    AnglesInDegrees,
    /// Angular acceleration with the opposite sign.
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
            Self::AccelerationHasGravity => "the acceleration includes gravity, as accelerometer readings do",
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
                "the estimated mass is negative, {} ± {} kg: the wrench has the opposite sign (swap \"on sensor\" and \"on payload\" in the plan), or gravity points up",
                short(*mass),
                short(*sd)
            ),
            Self::ImpossibleBeyondNoise { chi_square_rise } => write!(
                f,
                "no physical body fits the data: the constraint to physical bodies increases χ² by {}, more than noise explains",
                short(*chi_square_rise)
            ),
            Self::NotOfKind { kind, chi_square_rise } => write!(
                f,
                "the payload is not {kind}: this kind increases χ² by {}, more than noise explains",
                short(*chi_square_rise)
            ),
            Self::GravityVaries { least, most } => {
                write!(
                    f,
                    "gravity is not constant: it varies between {} and {} m/s²",
                    short(*least),
                    short(*most)
                )
            }
            Self::UnusualGravity { size } => {
                write!(f, "gravity is {} m/s², unlike that of the Earth", short(*size))
            }
            Self::Likely { mistake, as_given, undone } => write!(
                f,
                "probably {mistake}: reduced χ² would be {} instead of {}",
                short(*undone),
                short(*as_given)
            ),
            Self::ManyOutliers { count } => {
                write!(f, "{count} rows are outliers, more than one in ten; none was discarded")
            }
        }
    }
}

/// Formats a number with four significant digits.
fn short(x: f64) -> String {
    let size = if x == 0.0 { 0.0 } else { x.abs().log10().floor() };
    let decimals = (3.0 - size).clamp(0.0, 15.0) as usize;
    format!("{x:.decimals$}")
}
