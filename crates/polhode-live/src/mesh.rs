//! The file of a mesh, read and looked at once: a solid, or what is wrong with it.

use std::path::Path;

use polhode::body::mesh::{ClosedMesh, MeshFlaws, TriangleMesh};
use polhode_shape::mesh::{MeshContents, MeshFormat, MeshSolid, SolidPart};
use polhode_source::files::Disk;

use crate::inspect::{MARKS, MeshInspection};
use crate::part_names::PartNames;

/// What the file of a mesh has, all its parts as one surface.
#[derive(Debug)]
pub(crate) enum Mesh {
    /// A solid, and the unit that was taken for it where the format has none, in metres.
    Solid(Box<MeshSolid>, Option<f64>),
    Flawed(MeshInspection),
}

impl Mesh {
    /// Of the bytes of a file; an error says why they are no mesh.
    pub(crate) fn of(
        name: &str,
        path: &Path,
        bytes: &[u8],
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, String> {
        let read = Read::of(path, bytes)?;
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

/// What there is to see of the file of a mesh, whether it bounds a solid or not; an error says why its bytes are no mesh.
pub(crate) fn looked_at(
    name: &str,
    path: &Path,
    bytes: &[u8],
    goes_on: &(dyn Fn() -> bool + Sync),
) -> Result<MeshInspection, String> {
    let read = Read::of(path, bytes)?;
    let surface = read.surface()?;
    Ok(match ClosedMesh::or_flaws(surface, MARKS, goes_on) {
        Ok((solid, places)) => {
            MeshInspection::of_solid(name, &read.contents, (&solid, &places), surface, read.unit())
        }
        Err(flaws) => read.flawed(name, &flaws),
    })
}

/// The file of a mesh, its parts as one.
struct Read {
    format: MeshFormat,
    contents: MeshContents,
    parts: PartNames,
    /// The unit by its size, in metres.
    assumed: f64,
}

impl Read {
    fn of(path: &Path, bytes: &[u8]) -> Result<Self, String> {
        let format = MeshFormat::of_path(path).ok_or("it is no mesh")?;
        let contents = MeshContents::parse(&Disk, bytes, path, format).map_err(|error| error.message())?;
        let (assumed, parts) = (assumed_unit(&contents), PartNames::of(&contents));
        let contents = contents.as_one().map_err(|error| error.to_string())?;
        Ok(Self { format, contents, parts, assumed })
    }

    fn surface(&self) -> Result<&TriangleMesh, String> {
        Ok(self.contents.parts.first().map(|part| &part.mesh).ok_or("it has no triangles")?)
    }

    /// In metres.
    fn unit(&self) -> f64 {
        self.contents.unit.unwrap_or(self.assumed)
    }

    fn flawed(&self, name: &str, flaws: &MeshFlaws) -> MeshInspection {
        MeshInspection::of(name, &self.contents, &self.parts, flaws, self.unit())
    }
}

/// Metres in the unit of a mesh that does not say it: a part of a machine in millimetres is some metres long when they are taken for metres.
fn assumed_unit(contents: &MeshContents) -> f64 {
    if contents.parts.iter().any(|part| largest(&part.mesh) > 2.5) { 0.001 } else { 1.0 }
}

/// The largest coordinate, in the file's unit.
fn largest(mesh: &TriangleMesh) -> f64 {
    mesh.coordinates().iter().flatten().fold(0.0, |most, x| x.abs().max(most))
}
