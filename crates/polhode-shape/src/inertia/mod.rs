//! The bodies of files, whatever kind these are.

mod bodies;
mod cad;
mod choice;
mod field;
mod host;
mod kind;
mod mesh;
mod model;
mod molecule;
mod particles;
mod request;
mod run;
mod voxel;
mod written;

pub use bodies::{Bodies, FileBodies, failed, noticed};
pub use choice::{
    CadChoice, Corner, DensityFormula, Mark, MassesOf, MaterialNamed, MeshChoice, MoleculeChoice,
    PartSubstance, Sign, Spacing, SubstanceChoice, VoxelChoice,
};
pub use host::Host;
pub use kind::Kind;
pub use request::{LengthUnit, MassUnit, Point, Request, Turn};
pub use run::{run, run_in};
pub use written::MeshFile;
