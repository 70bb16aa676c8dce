//! Options for each kind of body.

mod cad;
mod mesh;
mod molecule;
mod primitive;
mod substance;
mod voxel;

pub use cad::CadChoice;
pub use mesh::{DensityFormula, MeshChoice};
pub use molecule::MoleculeChoice;
pub use primitive::PrimitiveChoice;
pub use substance::{MaterialNamed, PartSubstance, SubstanceChoice};
pub use voxel::{Corner, Spacing, VoxelChoice};
