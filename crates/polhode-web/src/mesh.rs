//! Mesh files, read and inspected together: a solid, or the errors of the mesh.

use std::path::Path;

use polhode::body::mesh::{ClosedMesh, MeshFlaws, TriangleMesh};
use polhode_shape::mesh::{MeshContents, MeshFormat, MeshSolid, SolidPart};
use polhode_source::files::Files;

use crate::inspect::{MARKS, MeshInspection};
use crate::part_names::PartNames;

/// Contents of a mesh file, with all its parts as one surface.
#[derive(Debug)]
pub(crate) enum Mesh {
    /// Solid, and the assumed unit in metres if the format has none.
    Solid(Box<MeshSolid>, Option<f64>),
    Flawed(MeshInspection),
}

impl Mesh {
    /// Reads the bytes of a file, which may name others in `files`; an error says why they are not
    /// a mesh.
    pub(crate) fn of(
        name: &str,
        path: &Path,
        (bytes, files): (&[u8], &dyn Files),
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, String> {
        let read = Read::of(path, bytes, files)?;
        match ClosedMesh::or_flaws(read.surface()?, MARKS, goes_on) {
            Ok((mesh, _)) => {
                let given = (!read.format.has_unit()).then_some(read.assumed);
                let solids = vec![SolidPart { name: String::new(), mesh }];
                let solid = MeshSolid::of_solids(read.contents, solids, path, read.format, given);
                Ok(Self::Solid(Box::new(solid.map_err(|error| error.message())?), given))
            }
            Err(flaws) => Ok(Self::Flawed(read.flawed(name, &flaws))),
        }
    }
}

/// Inspects a mesh file, whether it bounds a solid or not; an error says why its bytes are not a
/// mesh.
pub(crate) fn looked_at(
    name: &str,
    path: &Path,
    (bytes, files): (&[u8], &dyn Files),
    goes_on: &(dyn Fn() -> bool + Sync),
) -> Result<MeshInspection, String> {
    let read = Read::of(path, bytes, files)?;
    let surface = read.surface()?;
    Ok(match ClosedMesh::or_flaws(surface, MARKS, goes_on) {
        Ok((solid, places)) => {
            MeshInspection::of_solid(name, &read.contents, (&solid, &places), surface, read.unit())
        }
        Err(flaws) => read.flawed(name, &flaws),
    })
}

/// Contents of a mesh file, with its parts as one surface.
struct Read {
    format: MeshFormat,
    contents: MeshContents,
    parts: PartNames,
    /// Unit assumed from the size, in metres.
    assumed: f64,
}

impl Read {
    fn of(path: &Path, bytes: &[u8], files: &dyn Files) -> Result<Self, String> {
        let format = MeshFormat::of_path(path).ok_or("it is not a mesh")?;
        let contents = MeshContents::parse(files, bytes, path, format).map_err(|error| error.message())?;
        let (assumed, parts) = (assumed_unit(&contents), PartNames::of(&contents));
        let contents = contents.as_one().map_err(|error| error.to_string())?;
        Ok(Self { format, contents, parts, assumed })
    }

    fn surface(&self) -> Result<&TriangleMesh, String> {
        Ok(self.contents.parts.first().map(|part| &part.mesh).ok_or("it has no triangles")?)
    }

    /// Returns the unit in metres.
    fn unit(&self) -> f64 {
        self.contents.unit.unwrap_or(self.assumed)
    }

    fn flawed(&self, name: &str, flaws: &MeshFlaws) -> MeshInspection {
        MeshInspection::of(name, &self.contents, &self.parts, flaws, self.unit())
    }
}

/// Returns the assumed unit in metres of a mesh without a unit. A machine part in millimetres would
/// be several metres long in metres.
fn assumed_unit(contents: &MeshContents) -> f64 {
    if contents.parts.iter().any(|part| largest(&part.mesh) > 2.5) { 0.001 } else { 1.0 }
}

/// Returns the largest absolute coordinate, in the file's unit.
fn largest(mesh: &TriangleMesh) -> f64 {
    mesh.coordinates().iter().flatten().fold(0.0, |most, x| x.abs().max(most))
}
