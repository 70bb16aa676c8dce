//! Output of the mesh after repairs.

use std::path::{Path, PathBuf};

use polhode::body::shape::{Shape, Substance};
use polhode::body::{Finding, Form, MassProperties, Severity};
use polhode::math::Body;
use polhode_source::{Failure, shown};

use super::in_body;
use super::mesh_body::MeshBody;
use super::mesh_error::MeshBodyError;
use super::piece::Piece;
use crate::mesh::{MeshFormat, MeshPart};

/// Mesh after repairs, wound outward, in the file's unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshFile {
    /// Path of the file to write.
    pub path: PathBuf,
    /// Contents of the file.
    pub bytes: Vec<u8>,
}

impl MeshFile {
    /// Writes the surfaces of a body in their file's unit, and reads them again. A significant
    /// change by rounding is a finding.
    pub(super) fn of(body: &mut MeshBody<'_>, target: &Path) -> Result<Self, Failure> {
        let format = written_format(target)?;
        let part = |piece: &Piece| match piece.shape.form() {
            Some(Form::Mesh(mesh)) => {
                Some(MeshPart { name: piece.name.clone(), mesh: mesh.scaled(1.0 / body.unit) })
            }
            _ => None,
        };
        let parts: Vec<_> = body.pieces.iter().filter_map(part).collect();
        let (bytes, written) = format.checked_bytes(&parts, target)?;
        let written = written.parts.into_iter().map(|part| part.mesh.scaled(body.unit));
        let written = written.collect::<Result<Vec<_>, _>>().map_err(MeshBodyError::Body)?;
        let used = at_one_density(body.pieces.iter().map(|piece| piece.shape.as_ref()))?;
        let written = at_one_density(written.iter().map(|mesh| mesh as &dyn Shape))?;
        body.findings.extend(rounded(&used, &written, target));
        Ok(Self { path: target.to_owned(), bytes })
    }
}

/// Returns the mass properties of all shapes together, at 1 kg/m³.
fn at_one_density<'a>(
    shapes: impl Iterator<Item = &'a dyn Shape>,
) -> Result<MassProperties<Body>, MeshBodyError> {
    let each = shapes.map(|shape| shape.mass_properties(Substance::Density(1.0)).and_then(in_body));
    Ok(MassProperties::combined(&each.collect::<Result<Vec<_>, _>>()?)?)
}

/// Reports the change by rounding to seven digits, if it is significant.
fn rounded(used: &MassProperties<Body>, written: &MassProperties<Body>, target: &Path) -> Option<Finding> {
    /// Threshold relative to volume, size and largest moment: the usual effect of seven digits on a
    /// body that is not thin.
    const MUCH: f64 = 1e-6;
    let [used_tensor, tensor] = [used, written].map(|body| body.inertia().matrix());
    let largest = used_tensor.as_flattened().iter().fold(0.0_f64, |max, element| max.max(element.abs()));
    let size = (largest / used.mass()).sqrt();
    let differences =
        tensor.as_flattened().iter().zip(used_tensor.as_flattened()).map(|(a, b)| (a - b).abs());
    let volume = written.mass() / used.mass() - 1.0;
    let center = (written.center_of_mass() - used.center_of_mass()).norm();
    let inertia = differences.fold(0.0, f64::max) / largest;
    let is_much = volume.abs() > MUCH || center > MUCH * size || inertia > MUCH;
    is_much.then(|| Finding {
        code: "mesh.rounded",
        severity: Severity::Warning,
        message: format!(
            "rounding to seven digits changes the volume of the written mesh by {volume:+.1e} (relative), its centre of mass by {center:.1e} m, and \
             its tensor by {inertia:.1e} of the largest element"
        ),
        place: Some(target.display().to_string()),
    })
}

pub(super) fn written_format(file: &Path) -> Result<MeshFormat, Failure> {
    let format = MeshFormat::of_path(file).filter(|format| MeshFormat::WRITTEN.contains(format));
    format.ok_or_else(|| {
        let names = MeshFormat::WRITTEN.iter().flat_map(|format| format.extensions());
        let names = names.map(|name| format!(".{name}")).collect::<Vec<_>>().join(", ");
        Failure::usage(
            format!("--write-mesh does not write {}", shown(file)),
            format!("a mesh is written as {names}"),
        )
    })
}
