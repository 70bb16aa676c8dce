//! Options for voxel grids.

use std::str::FromStr;

use polhode_source::given::{Density, Given, Positive, list, numbers, positive};
use polhode_source::unit::Dimension;
use serde::{Deserialize, Serialize};

/// Options for voxel grids.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct VoxelChoice {
    /// The distance of adjacent voxels along the file's axes, one length or three, for a grid whose
    /// file states none.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "A,B,C"))]
    pub spacing: Option<Given<Spacing>>,
    /// The centre of the first voxel, x,y,z, for a grid whose file states none [default: the
    /// origin].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true))]
    pub origin: Option<Given<Corner>>,
    /// The density for a voxel value of 1, such as "1 g/cm^3" [default: 1 kg/m^3].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "DENSITY"))]
    pub per_value: Option<Given<Positive<Density>>>,
}

impl VoxelChoice {
    /// Returns the name of the first option that is set.
    pub(in crate::inertia) const fn given(&self) -> Option<&'static str> {
        match self {
            Self { spacing: Some(_), .. } => Some("--spacing"),
            Self { origin: Some(_), .. } => Some("--origin"),
            Self { per_value: Some(_), .. } => Some("--per-value"),
            _ => None,
        }
    }
}

/// Distances of adjacent voxels along the file's axes, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spacing(pub [f64; 3]);

impl FromStr for Spacing {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let steps = match list(text, Dimension::LENGTH)?.as_slice() {
            [all] => [*all; 3],
            [a, b, c] => [*a, *b, *c],
            other => return Err(format!("expected one length or three, not {}", other.len())),
        };
        steps.into_iter().try_for_each(|step| positive(step).map(|_| ()))?;
        Ok(Self(steps))
    }
}

/// Centre of the first voxel, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner(pub [f64; 3]);

impl FromStr for Corner {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        numbers(text, "x,y,z", Dimension::LENGTH).map(Self)
    }
}
