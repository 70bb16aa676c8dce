//! Solids that somebody else has measured: of STEP files, by OpenCASCADE.

use polhode::body::shape::Substance;
use polhode::body::{Finding, InertiaTensor, MassProperties, Severity};
use polhode::math::{Body, Position};
use polhode_document::SourceInfo;
use polhode_shape::mass_assumed;
use polhode_shape::report::{InertiaReport, PartRow};
use pyo3::prelude::*;

use crate::error::Raise;
use crate::mass_properties::PyMassProperties;
use crate::substance::Given;

/// A solid at a density of 1 kg/m³, SI.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Solid {
    name: String,
    volume: f64,
    area: f64,
    center: [f64; 3],
    /// About its centre.
    tensor: [[f64; 3]; 3],
}

/// What is to be said of the file.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Step {
    /// Shells and faces that bound no solid.
    left_out: usize,
    /// Solids that OpenCASCADE finds fault with, from 1.
    invalid: Vec<usize>,
    /// How far two of its quadratures are apart, relative: of volume, centre and tensor of each solid the most.
    error: f64,
}

/// An error of the quadrature above this is said.
const LARGE: f64 = 1e-7;

/// The mass properties of the solids of a STEP file, each a part.
///
/// # Errors
/// `PolhodeError` for a density or a mass that gives none.
#[pyfunction]
pub(crate) fn step_solids(
    path: &str,
    solids: Vec<Solid>,
    said: Step,
    given: Given,
) -> PyResult<PyMassProperties> {
    let mut findings = said.findings(path);
    let whole: f64 = solids.iter().map(|solid| solid.volume).sum();
    let density = match given.substance()? {
        Some(Substance::Mass(mass)) => mass / whole,
        Some(Substance::Density(density)) => density,
        _ => {
            findings.push(mass_assumed(None));
            1.0
        }
    };
    let row = |solid: &Solid| {
        let tensor = InertiaTensor::<Body>::from_matrix(solid.tensor.map(|row| row.map(|e| density * e)))?;
        let properties =
            MassProperties::new(density * solid.volume, Position::from_array(solid.center), tensor)?;
        Ok(PartRow { name: solid.name.clone(), properties, volume: Some(solid.volume) })
    };
    let rows =
        solids.iter().map(row).collect::<Result<Vec<_>, polhode::body::BodyError>>().map_err(Raise::raise)?;
    let several = if rows.len() > 1 { format!(", {} solids", rows.len()) } else { String::new() };
    let source = SourceInfo::new(path, "step")
        .described(format!("STEP{several}, exact shapes, measured by OpenCASCADE"))
        .with("parts", rows.len())
        .with("quadrature_error", said.error);
    let report = InertiaReport::of_parts(source, &rows).map_err(Raise::raise)?;
    Ok(PyMassProperties::of(InertiaReport {
        surface_area: Some(solids.iter().map(|solid| solid.area).sum()),
        findings,
        ..report
    }))
}

impl Step {
    fn findings(&self, path: &str) -> Vec<Finding> {
        let mut findings = Vec::new();
        let mut warn = |code, message| {
            findings.push(Finding {
                code,
                severity: Severity::Warning,
                message,
                place: Some(path.to_owned()),
            });
        };
        if self.left_out > 0 {
            warn(
                "step.not_a_solid",
                format!("{} shells or faces bound no solid and were left out", self.left_out),
            );
        }
        if !self.invalid.is_empty() {
            let numbers: Vec<_> = self.invalid.iter().map(ToString::to_string).collect();
            warn("step.invalid", format!("OpenCASCADE finds fault with solid {}", numbers.join(", ")));
        }
        if self.error > LARGE {
            warn(
                "step.error",
                format!("OpenCASCADE knows volume, centre and tensor of a solid to {:.1e} only", self.error),
            );
        }
        findings
    }
}
