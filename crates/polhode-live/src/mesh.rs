//! The file of a mesh, read and looked at once: a solid, or what is wrong with it.

use std::path::Path;

use polhode::body::mesh::{ClosedMesh, TriangleMesh};
use polhode_formats::mesh::{MeshContents, MeshFormat, MeshSolid, SolidPart};

use crate::inspect::{MARKS, MeshInspection};

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
        let format = MeshFormat::of_path(path).ok_or("it is no mesh")?;
        let contents = MeshContents::parse(bytes, path, format).map_err(|error| error.message())?;
        let assumed = assumed_unit(&contents);
        let parts = PartNames::of(&contents);
        let contents = contents.as_one().map_err(|error| error.to_string())?;
        let surface = contents.parts.first().map(|part| &part.mesh).ok_or("it has no triangles")?;
        match ClosedMesh::or_flaws(surface, MARKS, goes_on) {
            Ok(mesh) => {
                let given = (!format.has_unit()).then_some(assumed);
                let solids = vec![SolidPart { name: String::new(), mesh }];
                let solid = MeshSolid::of_solids(contents, solids, path, format, given);
                Ok(Self::Solid(Box::new(solid.map_err(|error| error.message())?), given))
            }
            Err(flaws) => {
                let unit = contents.unit.unwrap_or(assumed);
                Ok(Self::Flawed(MeshInspection::of(name, &contents, &parts, &flaws, unit)))
            }
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
    if let Mesh::Flawed(found) = Mesh::of(name, path, bytes, goes_on)? {
        return Ok(found);
    }
    let format = MeshFormat::of_path(path).ok_or("it is no mesh")?;
    let contents = MeshContents::parse(bytes, path, format).map_err(|error| error.message())?;
    let unit = contents.unit.unwrap_or_else(|| assumed_unit(&contents));
    let contents = contents.as_one().map_err(|error| error.to_string())?;
    let surface = contents.parts.first().map(|part| &part.mesh).ok_or("it has no triangles")?;
    Ok(MeshInspection::of_solid(name, &contents, surface, unit))
}

/// The parts of a file by the triangles of all of them, numbered through.
#[derive(Debug)]
pub(crate) struct PartNames(Vec<(String, usize)>);

impl PartNames {
    fn of(contents: &MeshContents) -> Self {
        let named = contents.parts.iter().map(|part| (part.name.clone(), part.mesh.triangles().len()));
        Self(named.collect())
    }

    /// How many there are, if there are several.
    pub(crate) fn several(&self) -> Option<usize> {
        Some(self.0.len()).filter(|count| *count > 1)
    }

    /// The name of the part that has a triangle, from 1, of several parts.
    pub(crate) fn of_triangle(&self, triangle: usize) -> Option<&str> {
        self.several()?;
        let mut last = 0;
        let part = self.0.iter().find(|(_, count)| {
            last += count;
            triangle <= last
        });
        part.map(|(name, _)| name.as_str()).filter(|name| !name.is_empty())
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
