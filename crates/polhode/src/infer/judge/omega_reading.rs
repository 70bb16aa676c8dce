//! Meaning of a log's angular velocities.

use core::f64::consts::{PI, TAU};
use core::fmt;

use super::axes::SignedAxes;
use super::declared::{AttitudeSense, OmegaAxes};

/// Meaning of a log's angular velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OmegaReading {
    /// Frame of the components.
    pub frame: OmegaAxes,
    /// Order and signs of the components, as axes of the log's attitudes; left-handed ones too.
    pub components: SignedAxes,
    /// rad/s per stated rad/s: 1 if the unit is the stated one.
    pub factor: f64,
}

/// Residual of a reading of ω, relative to |ω|: RMS over the rows that are close to the exact
/// motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OmegaResidual {
    /// Reading of the angular velocities.
    pub reading: OmegaReading,
    /// Relative error |δω| / |ω|.
    pub relative: f64,
}

impl OmegaReading {
    /// Returns the reading in the stated unit, along the axes of the log's attitudes.
    pub const fn plain(frame: OmegaAxes) -> Self {
        Self { frame, components: SignedAxes::SAME, factor: 1.0 }
    }

    /// Returns true if the unit and the components are the stated ones.
    pub fn is_plain(&self) -> bool {
        self.components == SignedAxes::SAME && self.factor == 1.0
    }

    /// Returns true if some choice of right-handed axes produces the components; a mirrored ω is a
    /// mistake.
    ///
    /// Attitudes from space to body may be combined with −ω, the angular velocity of space relative
    /// to the body.
    pub(super) fn has_axes(&self, sense: AttitudeSense) -> bool {
        let is_of_space =
            sense == AttitudeSense::SpaceToBody && self.components == SignedAxes::SAME.reversed();
        self.components.is_right_handed() || is_of_space
    }

    /// Units that are tried, as factors of the stated one, with an example of each.
    pub(super) const FACTORS: [(f64, &str); 5] = [
        (1.0, ""),
        (PI / 180.0, "deg/s for rad/s"),
        (180.0 / PI, "rad/s for deg/s"),
        (TAU, "rev/s for rad/s"),
        (TAU / 60.0, "rpm for rad/s"),
    ];
}

/// Text such as `ω along body axes, components (y, x, z), × 0.0174533 (such as deg/s for rad/s)`.
impl fmt::Display for OmegaReading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.frame {
            OmegaAxes::Body => "ω along body axes",
            OmegaAxes::Space => "ω along space axes",
        })?;
        if self.components != SignedAxes::SAME {
            write!(f, ", components {}", self.components)?;
        }
        if let Some((factor, example)) =
            Self::FACTORS.iter().find(|(factor, _)| *factor == self.factor && *factor != 1.0)
        {
            write!(f, ", × {factor:.6} (such as {example})")?;
        }
        Ok(())
    }
}
