//! What the parts of a mesh file enclose together.

use std::path::Path;

use polhode::body::mesh::MeshUnion;
use polhode::body::{BodyError, Finding};
use polhode_source::text::escaped;
use polhode_source::{FormatError, FormatErrorKind};
use serde_json::{Value, json};

use super::{MeshContents, MeshRepair, RepairBound, solid};
use crate::finding::{info, warning};

/// A mesh file as the union of all its parts, in metres: what lies in several of them is there once.
#[derive(Clone, Debug)]
pub struct UnitedMesh {
    /// How the file is encoded, in a word or two.
    pub encoding: &'static str,
    /// Metres in the file's unit of length.
    pub unit: f64,
    /// Triangles in the file, degenerate ones too.
    pub triangles: usize,
    /// What the parts enclose.
    pub union: MeshUnion,
    findings: Vec<Finding>,
}

impl UnitedMesh {
    /// The union of what has been read; `unit` is what one is in metres, if the file does not say or is wrong.
    ///
    /// # Errors
    /// [`FormatError`] if the parts together are not closed, or have no union: by the numbers as they stand in the file.
    pub fn of(contents: MeshContents, path: &Path, unit: Option<f64>) -> Result<Self, FormatError> {
        Self::watched(contents, path, unit, &|| true)
    }

    /// The same as long as it `goes_on`, which is asked often: of what would take longer it is undecided.
    ///
    /// # Errors
    /// As [`UnitedMesh::of`].
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

    /// Its name and numbers, for programs.
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

    /// What was united, and what is worth a remark, each with the file that it is about.
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
            return info(code, "nothing was united, as was asked: no parts of the mesh overlap");
        }
        let (volume, effect) = (union.volume(), union.effect(union.error(), 0.0));
        let what = match union.parts() {
            1 => "what overlaps was united".to_owned(),
            parts => format!("{parts} parts were united"),
        };
        let left_out = match union.left_out() {
            0.0 => "as measured on the surface, ".to_owned(),
            folds => format!("{folds:.1e} m³ in folds that are inside out were left out; with these, "),
        };
        let message = format!(
            "{what}, as was asked: {:.4e} m³ ({:.1e} of the volume) lay in more than one place of the mesh and counted once; {left_out}the volume may be off by {:.1e} m³ ({:.1e} of it), the centre of mass by {:.1e} m, the tensor at one density by {:.1e} of \
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

    /// What repairs of the contents mean for the union: warnings, or notes of what was asked for in vain.
    pub fn findings_of(&self, repairs: &[MeshRepair], file: &str) -> Vec<Finding> {
        let effect = |bound: RepairBound| Some(self.union.effect(bound.volume, bound.beyond));
        MeshRepair::findings_on(repairs, self.union.volume(), effect, file)
    }
}
