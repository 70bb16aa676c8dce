//! Programs that read models, and refuse or change some that their languages allow.

use serde::{Deserialize, Serialize};

use crate::model::ModelFormat;

/// A simulator that reads robot models.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Program {
    /// MuJoCo 3.
    Mujoco,
    /// Gazebo, which reads models by libsdformat.
    Gazebo,
    /// Drake, with its parsers of URDF, SDF and MJCF.
    Drake,
    /// Isaac Sim, whose engine is PhysX.
    Isaac,
}

impl Program {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Mujoco, Self::Gazebo, Self::Drake, Self::Isaac];

    /// Its name in messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mujoco => "MuJoCo",
            Self::Gazebo => "Gazebo",
            Self::Drake => "Drake",
            Self::Isaac => "Isaac Sim",
        }
    }

    /// Returns true if it reads models in this language.
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
