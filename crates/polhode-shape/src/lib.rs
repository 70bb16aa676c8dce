//! Bodies from files, and bodies for other programs.
//!
//! | module | reads |
//! |---|---|
//! | [`mesh`] | triangle meshes: STL, OBJ, PLY, OFF, glTF, 3MF and COLLADA |
//! | [`brep`] | STEP and IGES, which are recognised and refused |
//! | [`molecule`] | atoms: XYZ, MOL, SDF and PDB |
//! | [`cad`] | mass-property reports of CAD programs, as text |
//! | [`particles`] | particles and point clouds, as CSV |
//! | [`voxel`] | densities on a grid: NPY and NRRD |
//! | [`material`] | materials by name |
//!
//! [`InertiaReport`] says how much mass there is, where, and how it resists being turned; [`export`](fn@export) writes a
//! body for another program.
#![forbid(unsafe_code)]

pub mod brep;
pub mod cad;
mod export;
pub mod material;
pub mod mesh;
pub mod molecule;
pub mod particles;
pub mod report;
pub mod voxel;

pub use export::{ExportBody, ExportError, ExportFormat, export};
pub use report::{InertiaReport, MoleculeReport};
