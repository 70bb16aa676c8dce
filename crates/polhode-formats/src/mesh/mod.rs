//! Triangle meshes: files in, closed solids out.

pub mod gltf;
pub mod obj;
pub mod off;
pub mod ply;
pub mod stl;
pub mod stl_quick;
pub mod threemf;

use std::path::Path;

use polhode::{BodyError, ClosedMesh, Finding, Severity, TriangleMesh};

use crate::error::{FormatError, FormatErrorKind, Place};
use crate::file;
use crate::text::escaped;
use stl::{StlError, StlKind, StlPlace};

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

/// A mesh file that has been read.
#[derive(Clone, Debug)]
pub struct MeshFile {
    /// The solid that it bounds, in metres.
    pub mesh: ClosedMesh,
    /// How the file was encoded.
    pub kind: StlKind,
    /// The name that the file gives itself; often empty.
    pub name: String,
    /// Triangles in the file, degenerate ones too.
    pub triangles: usize,
}

impl MeshFile {
    /// What had to be turned or left out; `place` says which mesh it is.
    pub fn findings(&self, place: &str) -> Vec<Finding> {
        let finding =
            |code, severity, message| Finding { code, severity, message, place: Some(escaped(place)) };
        let mut findings = Vec::new();
        if self.mesh.inverted() {
            let message = "the normals of the mesh pointed inward and were turned".to_owned();
            findings.push(finding("mesh.inverted", Severity::Warning, message));
        }
        if let count @ 1.. = self.mesh.degenerate() {
            let message =
                format!("{count} of {} triangles have two equal corners and were left out", self.triangles);
            findings.push(finding("mesh.degenerate", Severity::Info, message));
        }
        findings
    }
}

/// Reads a mesh from an STL file whose unit of length is `unit` metres: 0.001 for millimetres.
///
/// # Errors
/// [`FormatError`] if the file cannot be read, is not STL, or does not bound a solid.
pub fn read(path: &Path, unit: f64) -> Result<MeshFile, FormatError> {
    read_as(path, &path.to_string_lossy(), unit)
}

/// Reads the mesh that a user calls `written`.
pub(crate) fn read_as(path: &Path, written: &str, unit: f64) -> Result<MeshFile, FormatError> {
    let bytes = file::bytes(path, written, u64::MAX).map_err(|kind| FormatError::new(path, None, kind))?;
    parse(&bytes, path, unit)
}

/// Reads a mesh from the bytes of an STL file; `path` is for messages.
///
/// # Errors
/// [`FormatError`] if the bytes are not STL or do not bound a solid.
pub fn parse(bytes: &[u8], path: &Path, unit: f64) -> Result<MeshFile, FormatError> {
    if !(unit > 0.0 && unit.is_finite()) {
        let error =
            BodyError::Parameter { what: "the mesh's unit", value: unit, rule: "positive and finite" };
        return Err(FormatError::new(path, None, FormatErrorKind::Body(error)));
    }
    let fail = |e: StlError| FormatError::new(path, place(bytes, &e), FormatErrorKind::Stl(e));
    let mut file = stl::read(bytes).map_err(fail)?;
    let triangles = file.triangles.len();
    file.triangles.iter_mut().flatten().flatten().for_each(|coordinate| *coordinate *= unit);
    let mesh = ClosedMesh::from_triangles(file.triangles).map_err(|scaled| {
        FormatError::new(path, None, FormatErrorKind::Body(unscaled(bytes).unwrap_or(scaled)))
    })?;
    Ok(MeshFile { mesh, kind: file.kind, name: file.name, triangles })
}

/// The same complaint with the numbers that stand in the file.
fn unscaled(bytes: &[u8]) -> Option<BodyError> {
    ClosedMesh::from_triangles(stl::read(bytes).ok()?.triangles).err()
}

/// Where in an ASCII file an error is: its column counts characters, not bytes.
fn place(bytes: &[u8], error: &StlError) -> Option<Place> {
    let StlPlace::Text { line, column } = error.place()? else { return None };
    // Lines end in \n, \r\n or \r, as the parser counts them.
    let mut start = 0;
    for _ in 1..line {
        let end = start + bytes[start..].iter().position(|b| b"\r\n".contains(b))?;
        start = end + if bytes[end..].starts_with(b"\r\n") { 2 } else { 1 };
    }
    let length = bytes[start..].iter().position(|b| b"\r\n".contains(b)).unwrap_or(bytes.len() - start);
    let text = &bytes[start..start + length];
    let (before, after) = text.split_at_checked(column - 1)?;
    let token = after.iter().position(u8::is_ascii_whitespace).unwrap_or(after.len());
    let before = String::from_utf8_lossy(before);
    let line_text = format!("{before}{}", String::from_utf8_lossy(after));
    let local = Place::in_text(&line_text, before.len()..before.len() + token);
    let offset = start + column - 1;
    Some(Place { line, span: offset..offset + token, ..local })
}
