//! Kinds of files that contain bodies.

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::mesh::MeshFormat;

/// Kind of a file that contains bodies. It serializes as its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub enum Kind {
    /// Scenario, read by another crate.
    Scenario,
    Mesh(MeshFormat),
    /// Table of particles or points (CSV).
    Particles,
    /// Mass-property report of a CAD program, as text.
    Cad,
    /// Molecule in XYZ format.
    Xyz,
    /// Molecule in MOL or SDF format.
    Mol,
    /// Molecule in PDB format.
    Pdb,
    /// Robot model, read by another crate.
    Robot,
    /// Voxel grid as a NumPy array (NPY).
    Npy,
    /// Voxel grid in NRRD format.
    Nrrd,
}

/// Kind with its name, help text and extensions.
type Entry = (Kind, &'static str, &'static str, &'static [&'static str]);

/// Kinds other than meshes; mesh formats are listed in [`MeshFormat`].
const OTHERS: [Entry; 9] = [
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

/// All kinds: scenario, mesh formats, then the others.
const ALL: [Kind; COUNT] = {
    let mut all = [Kind::Scenario; COUNT];
    let (meshes, mut k) = (MeshFormat::ALL.len(), 1);
    while k < COUNT {
        all[k] = if k <= meshes { Kind::Mesh(MeshFormat::ALL[k - 1]) } else { OTHERS[k - meshes].0 };
        k += 1;
    }
    all
};

#[cfg(feature = "arguments")]
impl clap::ValueEnum for Kind {
    fn value_variants<'a>() -> &'a [Self] {
        &ALL
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        Some(clap::builder::PossibleValue::new(self.name()).help(self.about()))
    }
}

impl From<Kind> for String {
    fn from(kind: Kind) -> Self {
        kind.name().to_owned()
    }
}

impl TryFrom<String> for Kind {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        let known = ALL.into_iter().find(|kind| kind.name() == name);
        known.ok_or_else(|| format!("{name:?} is not a kind of file: {}", ALL.map(Self::name).join(", ")))
    }
}

impl Kind {
    /// Returns the name for the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mesh(format) => format.name(),
            other => other.entry().map_or("", |(_, name, ..)| name),
        }
    }

    #[cfg(feature = "arguments")]
    fn about(self) -> &'static str {
        match self {
            Self::Mesh(format) => format.description().trim_end_matches('.'),
            other => other.entry().map_or("", |(_, _, about, _)| about),
        }
    }

    fn entry(self) -> Option<&'static Entry> {
        OTHERS.iter().find(|(kind, ..)| *kind == self)
    }

    /// Returns the kind of files with this extension, in any case. For .sdf it is the molecule
    /// format.
    pub(super) fn of_path(path: &Path) -> Option<Self> {
        if let Some(format) = MeshFormat::of_path(path) {
            return Some(Self::Mesh(format));
        }
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        let others = OTHERS.iter().find(|(_, _, _, extensions)| extensions.contains(&extension.as_str()));
        others.map(|(kind, ..)| *kind)
    }

    /// Returns true for a mesh.
    pub(super) const fn is_mesh(self) -> bool {
        matches!(self, Self::Mesh(_))
    }

    /// Returns the kind in words, to follow "is".
    pub const fn in_words(self) -> &'static str {
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
