//! What kind of file a body comes in.

use std::path::Path;

use clap::ValueEnum;
use clap::builder::PossibleValue;
use polhode_shape::mesh::MeshFormat;

use super::robot::is_model;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Scenario,
    Mesh(MeshFormat),
    Particles,
    Cad,
    Xyz,
    Mol,
    Pdb,
    Robot,
    Npy,
    Nrrd,
}

/// Kinds other than meshes, whose formats are listed where they are read: name, help, extensions.
const OTHERS: [(Kind, &str, &str, &[&str]); 9] = [
    (Kind::Scenario, "scenario", "A scenario (.toml)", &["toml"]),
    (Kind::Particles, "particles", "A table of particles or points (.csv)", &["csv", "tsv"]),
    (Kind::Cad, "cad", "A CAD program's mass properties, pasted as text (.txt)", &["txt"]),
    (Kind::Xyz, "xyz", "XYZ, a molecule", &["xyz", "extxyz"]),
    (Kind::Mol, "mol", "MOL or SDF, a molecule (.mol, .sdf)", &["mol", "sdf", "sd"]),
    (Kind::Pdb, "pdb", "PDB, a molecule (.pdb, .ent)", &["pdb", "ent"]),
    (
        Kind::Robot,
        "robot",
        "A robot model: URDF, SDFormat, MJCF, USD, OpenSim (.urdf, .sdf, .xml, .usda, .osim)",
        &["urdf"],
    ),
    (Kind::Npy, "npy", "A voxel grid as a NumPy array", &["npy"]),
    (Kind::Nrrd, "nrrd", "A voxel grid as NRRD (.nrrd, .nhdr)", &["nrrd", "nhdr"]),
];

const COUNT: usize = OTHERS.len() + MeshFormat::ALL.len();

/// The scenario, meshes, the others.
const ALL: [Kind; COUNT] = {
    let mut all = [Kind::Scenario; COUNT];
    let (meshes, mut k) = (MeshFormat::ALL.len(), 1);
    while k < COUNT {
        all[k] = if k <= meshes { Kind::Mesh(MeshFormat::ALL[k - 1]) } else { OTHERS[k - meshes].0 };
        k += 1;
    }
    all
};

impl ValueEnum for Kind {
    fn value_variants<'a>() -> &'a [Self] {
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        if let Self::Mesh(format) = self {
            return Some(PossibleValue::new(format.name()).help(format.about().trim_end_matches('.')));
        }
        let (_, name, help, _) = OTHERS.iter().find(|(kind, ..)| kind == self)?;
        let is_left_out = *self == Self::Robot && !cfg!(feature = "robot");
        Some(PossibleValue::new(*name).help(*help).hide(is_left_out))
    }
}

impl Kind {
    /// What files with this extension are, in any case. Robot models share .sdf with molecules, and .xml with anything: their root
    /// element decides.
    pub(super) fn of_path(path: &Path) -> Option<Self> {
        if is_model(path) {
            return Some(Self::Robot);
        }
        if let Some(format) = MeshFormat::of_path(path) {
            return Some(Self::Mesh(format));
        }
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        let others = OTHERS.iter().find(|(_, _, _, extensions)| extensions.contains(&extension.as_str()));
        others.map(|(kind, ..)| *kind)
    }

    /// True if it is a mesh.
    pub(super) const fn is_mesh(self) -> bool {
        matches!(self, Self::Mesh(_))
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
            Self::Mesh(_) => "a mesh",
        }
    }
}
