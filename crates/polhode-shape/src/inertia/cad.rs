//! Mass properties from the report of a CAD program.

use std::path::Path;

use polhode::body::shape::{Extent, Substance};
use polhode_document::SourceInfo;
use polhode_source::files::Files;
use polhode_source::{Failure, read_text_file};

use super::request::Request;
use crate::cad;
use crate::cad::{CadOptions, CadReport, GeometryProgram, GeometryReport};
use crate::mesh::AssumedMetres;
use crate::report::{InertiaReport, sign_proof};

/// Contents of a text: a report with a mass, or the geometric properties of a shape.
enum Read {
    Report(Box<CadReport>),
    Geometry(GeometryReport),
}

pub(super) fn report(files: &dyn Files, file: &Path, request: &Request) -> Result<InertiaReport, Failure> {
    let (flags, substance) = (&request.cad, request.substance.given());
    let (length_unit, mass_unit) = (request.length_unit(), request.mass_unit());
    let options = CadOptions { decimal: flags.decimal, products: flags.products, mass_unit, length_unit };
    let read = read_text_file(files, file, |text| match GeometryProgram::of_text(text) {
        // Such a report has a known sign and reference point; only the substance is missing.
        Some(program) if substance.is_some() => {
            GeometryReport::read(program, text, length_unit).map(Read::Geometry)
        }
        _ => cad::read(text, &options).map(|report| Read::Report(Box::new(report))),
    })?;
    let report = match (read, substance) {
        (Read::Report(report), None) => *report,
        (Read::Report(_), Some(_)) => {
            return Err(Failure::usage(
                format!(
                    "--density, --mass or --material is only for shapes, but the report in {} has a mass",
                    file.display()
                ),
                "leave it out",
            ));
        }
        (Read::Geometry(_), _) if flags.given().is_some() || mass_unit.is_some() => {
            let flag = flags.given().unwrap_or("--mass-unit");
            return Err(Failure::usage(
                format!(
                    "{flag} is only for a report with a mass, but {} has the measures of a shape",
                    file.display()
                ),
                "leave it out",
            ));
        }
        (Read::Geometry(shape), Some(substance)) => return measured(file, shape, substance),
        (Read::Geometry(_), None) => {
            return Err(Failure::usage("the file has no mass", "give --density or --mass"));
        }
    };
    Ok(report.into_report(file))
}

impl CadReport {
    /// Returns the report of the body.
    pub fn into_report(self, file: &Path) -> InertiaReport {
        let Self { product, properties, volume, surface_area, density, proof, findings } = self;
        let source = SourceInfo::new(file.display().to_string(), "cad")
            .described(format!("mass properties by {}", product.name()))
            .with("product", product.name());
        InertiaReport {
            volume,
            surface_area,
            density,
            extras: vec![sign_proof(&proof)],
            findings,
            ..InertiaReport::new(source, properties)
        }
    }
}

/// Returns the report of a shape with geometric properties and a substance.
fn measured(file: &Path, shape: GeometryReport, substance: Substance) -> Result<InertiaReport, Failure> {
    let properties = shape.mass_properties(substance).map_err(|error| {
        let hint =
            "if the shape is a rod or a plate, print more digits: rounding can make its tensor impossible";
        Failure::usage(format!("{}: {error}", file.display()), hint)
    })?;
    let name = shape.program.name();
    let words = if shape.unit_assumed { ", in m because no unit is given" } else { "" };
    let source = SourceInfo::new(file.display().to_string(), "cad")
        .described(format!("volume, centre and tensor of a shape by {name}{words}"))
        .with("product", name)
        .with("unit_m", shape.unit);
    let mut findings = shape.findings;
    let source = if shape.unit_assumed { source.with("unit_assumed", true) } else { source };
    if shape.unit_assumed {
        let assumed = AssumedMetres {
            properties: &properties,
            extent: Some(Extent::Volume(shape.volume)),
            mass_given: matches!(substance, Substance::Mass(_)),
            others: None,
            remedy: "--unit mm, or --unit m if metres are right",
        };
        findings.extend(assumed.finding(Some(file.display().to_string())));
    }
    Ok(InertiaReport {
        surface_area: shape.surface_area,
        findings,
        ..InertiaReport::new(source, properties).with_volume(Some(shape.volume))
    })
}

/// Returns true for geometric properties without a unit of length, as those of a mesh.
pub(super) fn leaves_unit_open(files: &dyn Files, file: &Path) -> bool {
    let program = read_text_file(files, file, |text| Ok(GeometryProgram::of_text(text)));
    matches!(program, Ok(Some(GeometryProgram::MeshLab)))
}
