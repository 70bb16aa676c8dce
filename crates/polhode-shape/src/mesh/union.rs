//! Union of the parts of a mesh file.

use std::path::Path;

use polhode::body::mesh::MeshUnion;
use polhode::body::{BodyError, Finding};
use polhode_source::text::escaped;
use polhode_source::{FormatError, FormatErrorKind};
use serde_json::{Value, json};

use super::{MeshContents, MeshRepair, RepairBound, solid};
use crate::finding::{info, warning};

/// Union of all parts of a mesh file, in metres. Volume that belongs to several parts counts once.
#[derive(Clone, Debug)]
pub struct UnitedMesh {
    /// Encoding of the file.
    pub encoding: &'static str,
    /// Unit of length of the file, m.
    pub unit: f64,
    /// Number of triangles in the file, including degenerate ones.
    pub triangles: usize,
    /// Union of the parts.
    pub union: MeshUnion,
    findings: Vec<Finding>,
}

impl UnitedMesh {
    /// Returns the union of the contents of a mesh file. `unit` is the unit of length in metres, if
    /// the file does not state it or states it wrongly.
    ///
    /// # Errors
    /// [`FormatError`] if the parts together are not closed, or have no union. The numbers in the
    /// message are in the file's unit.
    pub fn of(contents: MeshContents, path: &Path, unit: Option<f64>) -> Result<Self, FormatError> {
        Self::watched(contents, path, unit, &|| true)
    }

    /// Returns the union as [`UnitedMesh::of`] does, while `goes_on` returns true; the function is
    /// called often. After cancellation the result is undecided.
    ///
    /// # Errors
    /// [`FormatError`], as for [`UnitedMesh::of`].
    pub fn watched(
        contents: MeshContents,
        path: &Path,
        unit: Option<f64>,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, FormatError> {
        let refused = |error| solid::no_solid(path, "", error);
        if let Some(value) = unit.filter(|unit| !(*unit > 0.0 && unit.is_finite())) {
            let error = BodyError::Parameter { what: "the mesh's unit", value, rule: "positive and finite" };
            return Err(FormatError::new(path, None, FormatErrorKind::Body(error)));
        }
        let mesh = solid::joined(&contents.parts).map_err(refused)?;
        let union = MeshUnion::watched(&mesh, goes_on).map_err(refused)?;
        let (encoding, triangles) = (contents.encoding, contents.triangles());
        let MeshContents { unit, findings, .. } =
            MeshContents { parts: Vec::new(), ..contents }.in_metres(unit);
        let unit = unit.unwrap_or(1.0);
        let union = union.scaled(unit).map_err(refused)?;
        Ok(Self { encoding, unit, triangles, union, findings })
    }

    /// Returns name and numbers as JSON.
    pub fn for_programs(&self) -> (&'static str, Value) {
        let union = &self.union;
        (
            "union",
            json!({
                "parts": union.parts(),
                "shared_m3": union.shared(),
                "left_out_m3": union.left_out(),
                "volume_error_m3": union.error(),
            }),
        )
    }

    /// Returns the findings about the union, each with the name of the file.
    pub fn findings_in(&self, file: &str) -> Vec<Finding> {
        let file = escaped(file);
        let place = |own: &Option<String>| own.as_ref().map_or(file.clone(), |own| format!("{file}, {own}"));
        let all =
            [self.united()].into_iter().chain(self.findings.iter().chain(self.union.findings()).cloned());
        all.map(|finding| Finding { place: Some(place(&finding.place)), ..finding }).collect()
    }

    fn united(&self) -> Finding {
        let (union, code) = (&self.union, "mesh.united");
        if union.solid().is_some() {
            return info(code, "union had no effect: no parts of the mesh overlap");
        }
        let (volume, effect) = (union.volume(), union.effect(union.error(), 0.0));
        let what = match union.parts() {
            1 => "overlapping regions were united".to_owned(),
            parts => format!("{parts} parts were united"),
        };
        let left_out = match union.left_out() {
            0.0 => "measured on the surface, ".to_owned(),
            folds => format!("{folds:.1e} m³ in inverted folds were omitted; with these, "),
        };
        let message = format!(
            "union: {what}: {:.4e} m³ ({:.1e} of the volume) were covered more than once and count once; {left_out}the volume may be off by {:.1e} m³ ({:.1e} relative), the centre of mass by {:.1e} m, the tensor at fixed density by {:.1e} of \
             its largest moment",
            union.shared(),
            union.shared() / volume,
            union.error(),
            effect.volume,
            effect.center,
            effect.inertia
        );
        warning(code, message)
    }

    /// Returns warnings about the effect of repairs on the union, or notes about repairs that had
    /// no effect.
    pub fn findings_of(&self, repairs: &[MeshRepair], file: &str) -> Vec<Finding> {
        let effect = |bound: RepairBound| Some(self.union.effect(bound.volume, bound.beyond));
        MeshRepair::findings_on(repairs, self.union.volume(), effect, file)
    }
}
