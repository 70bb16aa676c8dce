//! Bodies of varying density: ρ(x, y, z) over a solid by cubature, and voxel grids by exact sums.

pub(crate) mod cubature;
pub(crate) mod domain;
pub(crate) mod field;
pub(crate) mod grid;
pub(crate) mod parametrised;
pub(crate) mod rule;

pub use field::{Cubature, DensityField, FieldError, FieldMassProperties, Solid, mass_properties_of_field};
pub use grid::{VoxelGrid, VoxelMassProperties};
pub use parametrised::Parametrised;
