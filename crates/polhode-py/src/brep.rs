//! Solids measured by another program: OpenCASCADE, for STEP files.

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

/// Solid with a density of 1 kg/m³, SI units.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Solid {
    name: String,
    volume: f64,
    area: f64,
    center: [f64; 3],
    /// Inertia tensor about its centre of mass.
    tensor: [[f64; 3]; 3],
}

/// Diagnostics of the STEP file.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Step {
    /// Number of shells and faces that do not bound a solid.
    left_out: usize,
    /// Numbers, from 1, of the solids that OpenCASCADE reports as invalid.
    invalid: Vec<usize>,
    /// Largest relative difference of two quadratures, over volume, centre and tensor of each
    /// solid.
    error: f64,
}

/// Smallest quadrature error that is reported as a finding.
const LARGE: f64 = 1e-7;

/// Returns the mass properties of the solids of a STEP file, each as a part.
///
/// # Errors
/// `PolhodeError` for a density or a mass that does not give a physical body.
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
                match self.left_out {
                    1 => "1 shell or face that does not enclose a solid was left out".to_owned(),
                    n => format!("{n} shells or faces that do not enclose a solid were left out"),
                },
            );
        }
        if !self.invalid.is_empty() {
            let numbers: Vec<_> = self.invalid.iter().map(ToString::to_string).collect();
            warn(
                "step.invalid",
                format!("OpenCASCADE reports invalid geometry in solid {}", numbers.join(", ")),
            );
        }
        if self.error > LARGE {
            warn(
                "step.error",
                format!(
                    "the relative error of volume, centre and tensor of a solid is {:.1e} in OpenCASCADE",
                    self.error
                ),
            );
        }
        findings
    }
}
