//! Simulators that read models, and that reject or change some models that the format permits.

use serde::{Deserialize, Serialize};

use crate::model::ModelFormat;

/// Simulator that reads robot models.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Program {
    /// MuJoCo 3.
    Mujoco,
    /// Gazebo, which reads models with libsdformat.
    Gazebo,
    /// Drake, with its parsers for URDF, SDF and MJCF.
    Drake,
    /// Isaac Sim, with the engine PhysX.
    Isaac,
}

impl Program {
    /// List of all simulators.
    pub const ALL: [Self; 4] = [Self::Mujoco, Self::Gazebo, Self::Drake, Self::Isaac];

    /// Returns the display name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mujoco => "MuJoCo",
            Self::Gazebo => "Gazebo",
            Self::Drake => "Drake",
            Self::Isaac => "Isaac Sim",
        }
    }

    /// Returns true if the simulator reads models in this format.
    pub const fn reads(self, format: ModelFormat) -> bool {
        match self {
            Self::Mujoco => matches!(format, ModelFormat::Urdf | ModelFormat::Mjcf),
            Self::Gazebo => matches!(format, ModelFormat::Urdf | ModelFormat::Sdf),
            Self::Drake => matches!(format, ModelFormat::Urdf | ModelFormat::Sdf | ModelFormat::Mjcf),
            Self::Isaac => matches!(format, ModelFormat::Urdf | ModelFormat::Mjcf | ModelFormat::Usd),
        }
    }
}

#[cfg(feature = "arguments")]
impl clap::ValueEnum for Program {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        Some(match self {
            Self::Mujoco => "mujoco".into(),
            Self::Gazebo => "gazebo".into(),
            Self::Drake => "drake".into(),
            Self::Isaac => "isaac".into(),
        })
    }
}
