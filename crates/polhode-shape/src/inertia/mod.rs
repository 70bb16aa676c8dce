//! Bodies of files of any kind, and shapes without a file.

use polhode::body::{BodyError, MassProperties, PlacedPart};
use polhode::math::{Body, Part, Position, Rotation};

mod bodies;
mod bounded;
mod cad;
mod choice;
mod field;
mod host;
mod kind;
mod mesh;
mod mesh_body;
mod mesh_error;
mod molecule;
mod particles;
mod piece;
mod primitive;
mod print;
mod request;
mod run;
mod voxel;
mod written;

pub use bodies::{Bodies, FileBodies, failed, noticed};
pub use choice::{
    CadChoice, Corner, DensityFormula, MaterialNamed, MeshChoice, MoleculeChoice, PartSubstance,
    PrimitiveChoice, Spacing, SubstanceChoice, VoxelChoice,
};
pub use host::Host;
pub use kind::Kind;
pub use mesh_body::{MeshBody, MeshOrigin, MeshUse, MeshWords, mass_assumed};
pub use mesh_error::MeshBodyError;
pub use primitive::{Measured, Primitive};
pub use print::Print;
pub use request::{LengthUnit, MassUnit, Point, Request, Turn};
pub use run::{run, run_in};
pub use voxel::voxel_report;
pub use written::MeshFile;

/// Returns the mass properties of a single part as a body; part and body have the same axes and
/// origin.
///
/// # Errors
/// [`BodyError`] if the part is not a physical body.
pub fn in_body(part: MassProperties<Part>) -> Result<MassProperties<Body>, BodyError> {
    Ok(PlacedPart::new(part, Position::ZERO, Rotation::identity())?.in_body())
}
