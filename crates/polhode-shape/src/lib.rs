//! Readers for bodies in files, and exporters for other programs.
//!
//! | module | reads |
//! |---|---|
//! | [`mesh`] | triangle meshes: STL, OBJ, PLY, OFF, glTF, 3MF and COLLADA |
//! | [`brep`] | STEP and IGES: recognized and refused |
//! | [`molecule`] | atoms: XYZ, MOL, SDF and PDB |
//! | [`cad`] | mass-property reports of CAD programs, as text |
//! | [`particles`] | particles and point clouds, as CSV |
//! | [`voxel`] | densities on a grid: NPY and NRRD |
//! | [`material`] | materials by name |
//!
//! [`run`] answers a [`Request`]: it reads files and returns the mass properties of their bodies, or
//! those of a shape without a file ([`PrimitiveChoice`]).
//! An [`InertiaReport`] contains the mass properties of a body. [`export`](fn@export) writes a body
//! in the format of another program.
#![forbid(unsafe_code)]

pub mod brep;
pub mod cad;
mod export;
mod finding;
mod inertia;
pub mod material;
pub mod mesh;
pub mod molecule;
pub mod particles;
pub mod report;
pub mod voxel;

pub use export::{ExportBody, ExportError, ExportFormat, export};
pub use inertia::{
    Bodies, CadChoice, Corner, DensityFormula, FileBodies, Host, Kind, LengthUnit, MassUnit, MaterialNamed,
    Measured, MeshBody, MeshBodyError, MeshChoice, MeshFile, MeshOrigin, MeshUse, MeshWords, MoleculeChoice,
    PartSubstance, Point, Primitive, PrimitiveChoice, Print, Request, Spacing, SubstanceChoice, Turn,
    VoxelChoice, failed, in_body, mass_assumed, noticed, run, run_in, voxel_report,
};
pub use report::{InertiaReport, MoleculeReport};

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../schema/request.json");

/// JSON schema of the report of [`Bodies`]. It also covers reports of scenarios and robot models.
pub const REPORT_SCHEMA: &str = include_str!("../schema/report.json");
