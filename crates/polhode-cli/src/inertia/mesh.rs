//! The mass properties of a mesh file.

use std::path::Path;

use clap::Args;
use polhode::{
    Body, BodyError, ClosedMesh, Finding, MassProperties, PlacedPart, Position, Rotation, Shape as _,
    Substance,
};
use polhode_formats::mesh::{MeshFormat, MeshSolid, SolidPart};
use polhode_report::{InertiaReport, PartRow, SourceInfo, parts};

use super::substance::{PartSubstance, SubstanceFlags, assumed, part};
use crate::failure::Failure;

/// Flags for meshes.
#[derive(Debug, Args)]
pub(super) struct MeshFlags {
    /// What one part of a mesh is made of: its name in the file, and its density, mass or material; may be repeated.
    #[arg(long, value_name = "NAME=WHAT", value_parser = part)]
    part: Vec<PartSubstance>,
}

impl MeshFlags {
    /// The first that is given.
    pub(super) fn given(&self) -> Option<&'static str> {
        (!self.part.is_empty()).then_some("--part")
    }
}

pub(super) fn report(
    file: &Path,
    format: MeshFormat,
    unit: Option<f64>,
    substance: &SubstanceFlags,
    flags: &MeshFlags,
) -> Result<InertiaReport, Failure> {
    let solid = MeshSolid::read(file, format, unit)?;
    let mut findings = solid.findings_in(&file.display().to_string());
    let rows = weighed(&solid, substance, flags, &mut findings)?;
    let bodies: Vec<_> = rows.iter().map(|row| row.properties).collect();
    let properties = MassProperties::combined(&bodies).map_err(unfit)?;
    let properties = if let [only] = bodies.as_slice() { *only } else { properties };
    let volume: f64 = solid.parts.iter().map(|part| part.mesh.volume()).sum();
    Ok(InertiaReport {
        volume: Some(volume),
        surface_area: Some(solid.parts.iter().map(|part| part.mesh.surface_area()).sum()),
        density: Some(properties.mass() / volume),
        extras: if rows.len() > 1 { vec![parts(&rows)] } else { Vec::new() },
        findings,
        ..InertiaReport::new(source(file, &solid), properties)
    })
}

/// Each part with its mass.
fn weighed(
    solid: &MeshSolid,
    substance: &SubstanceFlags,
    flags: &MeshFlags,
    findings: &mut Vec<Finding>,
) -> Result<Vec<PartRow>, Failure> {
    if let Some(unknown) = flags.part.iter().find(|given| solid.parts.iter().all(|p| p.name != given.name)) {
        let names: Vec<_> = solid.parts.iter().map(|part| format!("{:?}", part.name)).collect();
        return Err(Failure::usage(
            format!("the mesh has no part named {:?}", unknown.name),
            format!("its parts are {}", names.join(", ")),
        ));
    }
    let own = |part: &SolidPart| {
        flags.part.iter().rev().find(|given| given.name == part.name).map(|given| given.substance)
    };
    let rest: f64 = solid.parts.iter().filter(|part| own(part).is_none()).map(|p| p.mesh.volume()).sum();
    let common = match substance.given() {
        // the mass of all parts that have none of their own, at one density
        Some(Substance::Mass(mass)) if rest > 0.0 => Substance::Density(mass / rest),
        Some(substance) => substance,
        None if rest > 0.0 => assumed(findings),
        None => Substance::Density(1.0),
    };
    let row = |part: &SolidPart| {
        let substance = own(part).unwrap_or(match substance.given() {
            Some(Substance::Mass(mass)) if solid.parts.len() == 1 => Substance::Mass(mass),
            _ => common,
        });
        let properties = body(&part.mesh, substance).map_err(unfit)?;
        Ok(PartRow { name: part.name.clone(), properties, volume: Some(part.mesh.volume()) })
    };
    solid.parts.iter().map(row).collect()
}

/// A file's axes are the body's.
fn body(mesh: &ClosedMesh, substance: Substance) -> Result<MassProperties<Body>, BodyError> {
    let part = mesh.mass_properties(substance)?;
    Ok(PlacedPart::new(part, Position::ZERO, Rotation::identity())?.in_body())
}

fn unfit(error: BodyError) -> Failure {
    Failure::usage(error.to_string(), "check --density, --mass, --part and --unit")
}

fn source(file: &Path, solid: &MeshSolid) -> SourceInfo {
    let turned = solid.parts.iter().any(|part| part.mesh.inverted());
    let kind = if solid.encoding.is_empty() {
        solid.format.title().to_owned()
    } else {
        format!("{} {}", solid.format.title(), solid.encoding)
    };
    let parts = if let [_] = solid.parts.as_slice() {
        String::new()
    } else {
        format!(", {} parts", solid.parts.len())
    };
    let description = format!(
        "{kind}, {} triangles{parts}, closed, {}",
        solid.triangles,
        if turned { "wound inward (turned)" } else { "consistently wound" }
    );
    SourceInfo::new(file.display().to_string(), solid.format.name())
        .described(description)
        .with("encoding", solid.encoding)
        .with("triangles", solid.triangles)
        .with("vertices", solid.parts.iter().map(|part| part.mesh.vertices()).sum::<usize>())
        .with("parts", solid.parts.len())
        .with("unit_m", solid.unit)
}
