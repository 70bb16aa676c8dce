//! What kind of file a body comes in.

use std::path::Path;

use clap::ValueEnum;

use crate::model_file::is_model;

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Kind {
    /// A scenario (.toml).
    Scenario,
    /// STL, binary or ASCII.
    Stl,
    /// Wavefront OBJ; its groups are parts.
    Obj,
    /// Stanford PLY.
    Ply,
    /// Geomview OFF.
    Off,
    /// glTF 2.0 (.gltf, .glb); its nodes are parts.
    Gltf,
    /// 3MF; its build items are parts.
    #[value(name = "3mf")]
    ThreeMf,
    /// A table of particles or points (.csv).
    Particles,
    /// A CAD program's mass properties, pasted as text (.txt).
    Cad,
    /// XYZ, a molecule.
    Xyz,
    /// MOL or SDF, a molecule (.mol, .sdf).
    Mol,
    /// PDB, a molecule (.pdb, .ent).
    Pdb,
    /// A robot model: URDF, SDFormat, MJCF (.urdf, .sdf, .xml).
    Robot,
    /// A voxel grid as a NumPy array.
    Npy,
    /// A voxel grid as NRRD (.nrrd, .nhdr).
    Nrrd,
}

impl Kind {
    /// What files with this ending are, in any case. Robot models share .sdf with molecules, and .xml with anything: their root
    /// element decides.
    pub(super) fn of_path(path: &Path) -> Option<Self> {
        if is_model(path) {
            return Some(Self::Robot);
        }
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Some(match extension.as_str() {
            "urdf" => Self::Robot,
            "toml" => Self::Scenario,
            "stl" => Self::Stl,
            "obj" => Self::Obj,
            "ply" => Self::Ply,
            "off" => Self::Off,
            "gltf" | "glb" => Self::Gltf,
            "3mf" => Self::ThreeMf,
            "csv" | "tsv" => Self::Particles,
            "txt" => Self::Cad,
            "xyz" | "extxyz" => Self::Xyz,
            "mol" | "sdf" | "sd" => Self::Mol,
            "pdb" | "ent" => Self::Pdb,
            "npy" => Self::Npy,
            "nrrd" | "nhdr" => Self::Nrrd,
            _ => return None,
        })
    }

    /// True if it is a mesh.
    pub(super) const fn is_mesh(self) -> bool {
        matches!(self, Self::Stl | Self::Obj | Self::Ply | Self::Off | Self::Gltf | Self::ThreeMf)
    }

    /// In words, after "is".
    pub(super) const fn in_words(self) -> &'static str {
        match self {
            Self::Scenario => "a scenario",
            Self::Particles => "a table of particles",
            Self::Cad => "a CAD report",
            Self::Xyz | Self::Mol | Self::Pdb => "a molecule",
            Self::Npy | Self::Nrrd => "a voxel grid",
            Self::Robot => "a robot model",
            _ => "a mesh",
        }
    }
}
