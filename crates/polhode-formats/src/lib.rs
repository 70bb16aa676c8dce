//! Files in, [`polhode`] values out: the one place that knows units other than SI, file formats, and where in a file
//! something stands.
//!
//! - [`scenario`]: one body and one motion, as TOML
//! - [`mesh`]: triangle meshes, as STL, OBJ, PLY, OFF, glTF, 3MF and COLLADA
//! - [`brep`]: STEP and IGES, which are recognised and refused
//! - [`molecule`]: atoms, as XYZ, MOL, SDF and PDB
//! - [`cad`]: mass-property reports of CAD programs, as text
//! - [`particles`]: particles and point clouds, as CSV
//! - [`run_log`]: motions that other programs logged, as CSV, Parquet and JSON lines
//! - [`mod@identify`]: what was measured of a body, and how, as TOML
//! - [`budget`]: parts lists, as CSV, XLSX and TOML
//! - [`mod@unit`]: quantities in text
//! - [`expression`]: formulas in text
//! - [`voxel`]: densities on a grid, as NPY and NRRD
//! - [`material`]: materials by name
//! - [`xml`]: elements, attributes and numbers with their places
//! - [`times`]: lists of times, one per line
//! - [`suite`]: the cases by which other programs are graded
//! - [`table`]: the other way, trajectories as CSV and Parquet, curves as CSV
//!
//! Whatever cannot be read is a [`FormatError`]: path, line, column, what stands there, the rule, a hint.

pub mod brep;
pub mod budget;
pub mod cad;
mod confinement;
mod content;
mod error;
pub mod expression;
mod file;
pub mod identify;
mod json;
pub mod material;
pub mod mesh;
pub mod molecule;
mod package;
pub mod particles;
mod reading;
pub mod run_log;
pub mod scenario;
pub mod suite;
pub mod table;
mod text;
pub mod times;
pub mod unit;
pub mod voxel;
pub mod xml;

pub use confinement::{Confinement, NotOpened};
pub use content::{ContentError, ContentErrorKind, ContentPlace};
pub use error::{FormatError, FormatErrorKind, Place};
pub use json::json_value;
pub use reading::{read_file, read_text_file};
pub use scenario::suggestion::nearest;
