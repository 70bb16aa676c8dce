//! Triangle meshes: files in, closed solids out.

mod affine;
mod assumed_unit;
mod budget;
pub mod gltf;
mod notes;
mod number;
pub mod obj;
pub mod off;
mod parts;
pub mod ply;
mod polygon;
mod scan;
mod solid;
pub mod stl;
pub mod stl_quick;
pub mod threemf;

use std::path::Path;

use polhode::body::mesh::TriangleMesh;
use polhode::body::{BodyError, Finding, Severity};

use crate::content::{ContentError, ContentErrorKind, ContentPlace};
use crate::error::FormatError;
use crate::file;

pub use assumed_unit::{AssumedMetres, longest_side};
pub use solid::{MeshSolid, SolidPart};

/// What a mesh file says: parts and their triangles, in the file's own unit of length.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshContents {
    /// How the file is encoded, in a word or two: `"binary"`, `"ascii"`, `"binary, big-endian"`.
    pub encoding: &'static str,
    /// The name that the file gives itself; often empty.
    pub name: String,
    /// Metres in the unit of length, if the file or the format says so.
    pub unit: Option<f64>,
    /// At least one, none without triangles: groups, nodes, build items, in the file's order.
    pub parts: Vec<MeshPart>,
    /// What was noticed on the way: faces left out, elements not read.
    pub findings: Vec<Finding>,
}

/// One part of a mesh file, placed where the file places it.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshPart {
    /// Its name in the file; often empty.
    pub name: String,
    /// Its triangles.
    pub mesh: TriangleMesh,
}

/// The formats of mesh files that polhode reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// STL, binary or ASCII.
    Stl,
    /// Wavefront OBJ.
    Obj,
    /// Stanford PLY, ASCII or binary of either endianness.
    Ply,
    /// Geomview OFF.
    Off,
    /// glTF 2.0, as JSON or GLB.
    Gltf,
    /// 3MF.
    ThreeMf,
}

impl MeshFormat {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Stl, Self::Obj, Self::Ply, Self::Off, Self::Gltf, Self::ThreeMf];

    /// Its name in lower case, as `source.format` has it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stl => "stl",
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Off => "off",
            Self::Gltf => "gltf",
            Self::ThreeMf => "3mf",
        }
    }

    /// Its name as its makers write it.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Stl => "STL",
            Self::Obj => "OBJ",
            Self::Ply => "PLY",
            Self::Off => "OFF",
            Self::Gltf => "glTF",
            Self::ThreeMf => "3MF",
        }
    }

    /// The format whose files end like this, in any case.
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "glb" => Some(Self::Gltf),
            _ => Self::ALL.into_iter().find(|format| format.name() == extension),
        }
    }
}

impl MeshContents {
    /// Reads what a mesh file says.
    ///
    /// # Errors
    /// [`FormatError`] if the file cannot be read or does not follow its format.
    pub fn read(path: &Path, format: MeshFormat) -> Result<Self, FormatError> {
        Self::read_as(path, &path.to_string_lossy(), format)
    }

    /// Reads the mesh that a user calls `written`.
    pub(crate) fn read_as(path: &Path, written: &str, format: MeshFormat) -> Result<Self, FormatError> {
        let bytes =
            file::bytes(path, written, u64::MAX).map_err(|kind| FormatError::new(path, None, kind))?;
        Self::parse(&bytes, path, format)
    }

    /// Reads the bytes of a mesh file; `path` is for messages, and its folder for the files that a glTF names.
    ///
    /// # Errors
    /// [`FormatError`] if the bytes do not follow the format.
    pub fn parse(bytes: &[u8], path: &Path, format: MeshFormat) -> Result<Self, FormatError> {
        let contents = match format {
            MeshFormat::Stl => return stl::contents(bytes, path),
            MeshFormat::Obj => obj::read(bytes),
            MeshFormat::Ply => ply::read(bytes),
            MeshFormat::Off => off::read(bytes),
            MeshFormat::Gltf => gltf::read(bytes, path.parent().unwrap_or(Path::new(""))),
            MeshFormat::ThreeMf => threemf::read(bytes),
        };
        contents.and_then(Self::with_parts).map_err(|error| FormatError::of_content(path, bytes, error))
    }

    fn with_parts(self) -> Result<Self, ContentError> {
        if !self.parts.is_empty() {
            return Ok(self);
        }
        let missing = ContentErrorKind::Missing { what: "triangles".to_owned() };
        Err(ContentError::new(missing, ContentPlace::Whole)
            .hint("export the solid body, not the empty document"))
    }

    /// Triangles in all parts.
    pub fn triangles(&self) -> usize {
        self.parts.iter().map(|part| part.mesh.triangles().len()).sum()
    }

    /// All parts as one, without a name.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] for more vertices than can be numbered.
    pub fn as_one(self) -> Result<Self, BodyError> {
        let parts = vec![MeshPart { name: String::new(), mesh: solid::joined(&self.parts)? }];
        Ok(Self { parts, ..self })
    }

    /// The same in metres: by the unit that the user gives, else by the file's own, else it is in metres already.
    ///
    /// A user's unit that differs from the file's own is a finding.
    #[must_use]
    pub fn in_metres(mut self, given: Option<f64>) -> Self {
        let unit = given.or(self.unit).unwrap_or(1.0);
        if let Some(own) = self.unit.filter(|own| *own != unit) {
            self.findings.push(Finding {
                code: "mesh.unit",
                severity: Severity::Warning,
                message: format!("the file's own unit is {own} m, and {unit} m was used as you said"),
                place: None,
            });
        }
        for part in &mut self.parts {
            part.mesh = std::mem::take(&mut part.mesh).scaled(unit);
        }
        self.unit = Some(unit);
        self
    }
}
