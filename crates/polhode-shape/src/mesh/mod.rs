//! Triangle meshes: reads files and returns closed solids.

mod affine;
mod assumed_unit;
mod closure;
pub mod collada;
mod fill;
pub mod gltf;
mod holes_left;
mod length;
mod notes;
pub mod obj;
pub mod off;
mod parts;
pub mod ply;
pub mod points;
mod polygon;
mod repair;
mod scan;
mod share;
mod solid;
pub mod stl;
pub mod stl_error;
pub mod threemf;
mod union;
mod union_hint;
mod write;

use std::path::Path;

use polhode::body::mesh::TriangleMesh;
use polhode::body::{BodyError, Finding};
use polhode_source::FormatError;
use polhode_source::file;
use polhode_source::files::Files;
use polhode_source::{ContentError, ContentErrorKind};

use crate::brep::BrepFormat;
use crate::finding::warning;

pub use assumed_unit::{AssumedMetres, longest_side};
pub use closure::{MeshClosure, UnboundedClosure};
pub use length::MeshLength;
pub use polygon::Polygons;
pub use repair::{MeshRepair, RepairBound};
pub(crate) use share::percent_above;
pub use share::{Fraction, Share};
pub use solid::{MeshSolid, SolidPart};
pub use union::UnitedMesh;

/// Contents of a mesh file: parts with their triangles, in the file's own unit of length.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshContents {
    /// Encoding of the file: `"binary"`, `"ascii"`, `"binary, big-endian"`.
    pub encoding: &'static str,
    /// Name stored in the file; often empty.
    pub name: String,
    /// Unit of length, m, if the file or the format defines it.
    pub unit: Option<f64>,
    /// Parts in file order: groups, nodes, build items. There is at least one, and each has
    /// triangles.
    pub parts: Vec<MeshPart>,
    /// Findings of the reader: omitted faces, elements that are not read.
    pub findings: Vec<Finding>,
}

/// Part of a mesh file, placed as in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshPart {
    /// Name in the file; often empty.
    pub name: String,
    pub mesh: TriangleMesh,
}

/// Reader of a format. The path is for messages; its folder resolves the files that the mesh names.
type Reader = fn(&dyn Files, &[u8], &Path) -> Result<MeshContents, FormatError>;

/// Table of the formats: lower-case name, official name, file extensions, reader. All other code
/// that lists mesh formats uses this table.
macro_rules! formats {
    ($($(#[doc = $about:literal])* $format:ident: $name:literal, $title:literal, $extensions:expr, $unit:literal, $reader:expr;)*) => {
        /// Mesh file formats that are read.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum MeshFormat {
            $($(#[doc = $about])* $format,)*
        }

        impl MeshFormat {
            /// List of all formats.
            pub const ALL: &[Self] = &[$(Self::$format),*];

            /// Returns the lower-case name, as in `source.format`.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$format => $name,)*
                }
            }

            /// Returns the official name.
            pub const fn title(self) -> &'static str {
                match self {
                    $(Self::$format => $title,)*
                }
            }

            /// Returns a one-line description.
            pub fn description(self) -> &'static str {
                match self {
                    $(Self::$format => concat!($($about),*).trim(),)*
                }
            }

            /// Returns the file extensions in lower case, without the dot.
            pub const fn extensions(self) -> &'static [&'static str] {
                match self {
                    $(Self::$format => &$extensions,)*
                }
            }

            /// Returns true if the files or the format define the unit of length.
            pub const fn has_unit(self) -> bool {
                match self {
                    $(Self::$format => $unit,)*
                }
            }

            const fn reader(self) -> Reader {
                if !cfg!(feature = "formats") && !matches!(self, Self::Stl | Self::Obj) {
                    return left_out;
                }
                match self {
                    $(Self::$format => $reader,)*
                }
            }
        }
    };
}

formats! {
    /// STL, binary or ASCII.
    Stl: "stl", "STL", ["stl"], false, |_, bytes, path| stl::contents(bytes, path);
    /// Wavefront OBJ; its groups are parts.
    Obj: "obj", "OBJ", ["obj"], false, |_, bytes, path| located(obj::read(bytes), bytes, path);
    /// Stanford PLY, ASCII or binary of either endianness.
    Ply: "ply", "PLY", ["ply"], false, |_, bytes, path| located(ply::read(bytes), bytes, path);
    /// Points, one in a line, for their convex hull.
    Points: "points", "points", [], false, |_, bytes, path| {
        located(points::read(bytes).and_then(points::with_faces), bytes, path)
    };
    /// Geomview OFF.
    Off: "off", "OFF", ["off"], false, |_, bytes, path| located(off::read(bytes), bytes, path);
    /// glTF 2.0, as JSON or GLB; its nodes are parts.
    Gltf: "gltf", "glTF", ["gltf", "glb"], true, |files, bytes, path| {
        located(gltf::read(files, bytes, path.parent().unwrap_or(Path::new(""))), bytes, path)
    };
    /// 3MF; its build items are parts.
    ThreeMf: "3mf", "3MF", ["3mf"], true, |_, bytes, path| located(threemf::read(bytes), bytes, path);
    /// COLLADA; the geometries of its scene are parts.
    Collada: "dae", "COLLADA", ["dae"], true, |_, bytes, path| {
        let text = str::from_utf8(bytes).map_err(|e| FormatError::not_utf8(path, bytes, e.valid_up_to()))?;
        located(collada::read(text), bytes, path)
    };
}

/// Refuses a format in a build with STL and OBJ only.
fn left_out(_: &dyn Files, bytes: &[u8], path: &Path) -> Result<MeshContents, FormatError> {
    let error = ContentErrorKind::unsupported("in this build, which reads STL and OBJ meshes only");
    Err(FormatError::of_content(path, bytes, error.of_whole()))
}

/// Checks that the contents have triangles, and adds the place in the file to an error.
fn located(
    contents: Result<MeshContents, ContentError>,
    bytes: &[u8],
    path: &Path,
) -> Result<MeshContents, FormatError> {
    contents.and_then(MeshContents::with_parts).map_err(|error| FormatError::of_content(path, bytes, error))
}

impl MeshFormat {
    /// Returns the format of files with this extension, in any case.
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Self::ALL.iter().copied().find(|format| format.extensions().contains(&extension.as_str()))
    }
}

impl MeshContents {
    /// Reads a mesh file.
    ///
    /// # Errors
    /// [`FormatError`] if the file cannot be read or does not follow its format.
    pub fn read(files: &dyn Files, path: &Path, format: MeshFormat) -> Result<Self, FormatError> {
        Self::read_as(files, path, &path.to_string_lossy(), format)
    }

    /// Reads a mesh file for its convex hull: a PLY or OBJ file may have only points.
    ///
    /// # Errors
    /// [`FormatError`] if the file cannot be read or does not follow its format.
    pub fn read_for_hull(files: &dyn Files, path: &Path, format: MeshFormat) -> Result<Self, FormatError> {
        let read = match format {
            MeshFormat::Points => points::read,
            MeshFormat::Ply => ply::read_or_cloud,
            MeshFormat::Obj => obj::read_or_cloud,
            _ => return Self::read(files, path, format),
        };
        let bytes = file::bytes(files, path, &path.to_string_lossy(), u64::MAX)
            .map_err(|kind| FormatError::new(path, None, kind))?;
        located(read(&bytes), &bytes, path)
    }

    /// Reads a mesh file with the name `written` in messages.
    pub fn read_as(
        files: &dyn Files,
        path: &Path,
        written: &str,
        format: MeshFormat,
    ) -> Result<Self, FormatError> {
        let is_text = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gltf"));
        let limit = if is_text { gltf::LARGEST_TEXT } else { u64::MAX };
        let bytes =
            file::bytes(files, path, written, limit).map_err(|kind| FormatError::new(path, None, kind))?;
        Self::parse(files, &bytes, path, format)
    }

    /// Parses the bytes of a mesh file. `path` is for messages; its folder resolves the files that
    /// a glTF names.
    ///
    /// # Errors
    /// [`FormatError`] if the bytes do not follow the format.
    pub fn parse(
        files: &dyn Files,
        bytes: &[u8],
        path: &Path,
        format: MeshFormat,
    ) -> Result<Self, FormatError> {
        if let Some(shapes) = BrepFormat::of_bytes(bytes) {
            let what = format!("{}, whatever its file extension: it contains exact shapes", shapes.title());
            let error = ContentErrorKind::unsupported(what).of_whole().hint(shapes.hint(path));
            return Err(FormatError::of_content(path, bytes, error));
        }
        format.reader()(files, bytes, path)
    }

    fn with_parts(self) -> Result<Self, ContentError> {
        if !self.parts.is_empty() {
            return Ok(self);
        }
        let missing = ContentErrorKind::missing("triangles");
        Err(missing.of_whole().hint("export the solid body, not the empty document"))
    }

    /// Returns the number of triangles in all parts.
    pub fn triangles(&self) -> usize {
        self.parts.iter().map(|part| part.mesh.triangles().len()).sum()
    }

    /// Combines all parts into one, without a name.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if there are more vertices than indices.
    pub fn as_one(mut self) -> Result<Self, BodyError> {
        let mesh = match self.parts.as_mut_slice() {
            [only] => std::mem::take(&mut only.mesh),
            parts => solid::joined(&*parts)?,
        };
        let parts = vec![MeshPart { name: String::new(), mesh }];
        Ok(Self { parts, ..self })
    }

    /// Converts to metres: by the given unit, otherwise by the file's own unit. Without either, the
    /// file is in metres.
    ///
    /// A given unit that differs from the file's own is a finding.
    #[must_use]
    pub fn in_metres(mut self, given: Option<f64>) -> Self {
        let unit = given.or(self.unit).unwrap_or(1.0);
        if let Some(own) = self.unit.filter(|own| *own != unit) {
            let message =
                format!("the file states a unit of {own} m, but the given unit of {unit} m was used");
            self.findings.push(warning("mesh.unit", message));
        }
        for part in &mut self.parts {
            part.mesh = std::mem::take(&mut part.mesh).scaled(unit);
        }
        self.unit = Some(unit);
        self
    }
}
