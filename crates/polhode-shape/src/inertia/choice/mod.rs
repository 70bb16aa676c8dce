//! Options for each kind of file.

mod cad;
mod mesh;
mod molecule;
mod substance;
mod voxel;

pub use cad::CadChoice;
pub use mesh::{DensityFormula, MeshChoice};
pub use molecule::MoleculeChoice;
pub use substance::{MaterialNamed, PartSubstance, SubstanceChoice};
pub use voxel::{Corner, Spacing, VoxelChoice};
