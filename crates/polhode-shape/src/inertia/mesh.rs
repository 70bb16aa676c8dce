//! The mass properties of a mesh file.

use std::collections::BTreeSet;
use std::path::Path;

use polhode::body::mesh::{ConvexHull, MeshShell};
use polhode::body::shape::{Extent, Shape, Substance};
use polhode::body::{Finding, MassProperties, Severity};
use polhode_document::SourceInfo;
use polhode_source::Failure;
use polhode_source::files::Files;
use polhode_source::given::{Given, Length, Positive};

use super::choice::PartSubstance;
use super::field;
use super::host::Host;
use super::model::{Model, Piece, unfit};
use super::request::Request;
use super::voxel::in_body;
use super::written::MeshFile;
use crate::mesh::{
    AssumedMetres, MeshContents, MeshFormat, MeshLength, MeshRepair, MeshSolid, RepairBound, SolidPart,
    UnitedMesh,
};
use crate::report::{InertiaReport, PartRow, parts};

pub(super) fn report(
    files: &dyn Files,
    file: &Path,
    format: MeshFormat,
    request: &Request,
    host: &mut dyn Host,
) -> Result<(InertiaReport, Option<MeshFile>), Failure> {
    let (unit, choice) = (request.length_unit(), &request.mesh);
    let mut findings = Vec::new();
    let model = model(files, file, format, request, host, &mut findings)?;
    let Model { source, unit: in_m, pieces, field } = model;
    let rows = weighed(&pieces, request, &mut findings, field.is_some())?;
    let rows = match &field {
        Some(found) => found.rows.clone(),
        None => rows,
    };
    let bodies: Vec<_> = rows.iter().map(|row| row.properties).collect();
    let properties = match bodies.as_slice() {
        [only] => *only,
        _ => MassProperties::combined(&bodies).map_err(unfit)?,
    };
    let volume: f64 = pieces.iter().map(Piece::volume).sum();
    let target = choice.write_mesh.as_ref();
    let written = target.map(|target| MeshFile::of(&pieces, in_m, target, &mut findings)).transpose()?;
    let mut source = source;
    if unit.is_none() && !format.has_unit() {
        let words = format!("{}, in m as no unit is given", source.description);
        source = source.described(words).with("unit_assumed", true);
        let assumed = AssumedMetres {
            properties: &properties,
            extent: Some(Extent::Volume(volume)),
            mass_given: request.substance.mass().is_some(),
            others: None,
            remedy: "--unit mm, or --unit m if it is so",
        };
        findings.extend(assumed.finding(Some(file.display().to_string())));
    }
    let mut extras = if rows.len() > 1 { vec![parts(&rows)] } else { Vec::new() };
    extras.extend(field.map(|found| found.error));
    let report = InertiaReport {
        surface_area: Some(pieces.iter().map(|piece| piece.shape.surface_area()).sum()),
        extras,
        findings,
        ..InertiaReport::new(source, properties).with_volume(Some(volume))
    };
    Ok((report, written))
}

/// The model of a mesh file.
fn model(
    files: &dyn Files,
    file: &Path,
    format: MeshFormat,
    request: &Request,
    host: &mut dyn Host,
    findings: &mut Vec<Finding>,
) -> Result<Model, Failure> {
    let (unit, choice) = (request.length_unit(), &request.mesh);
    let mut contents = match choice.hull {
        true => MeshContents::read_for_hull(files, file, format)?,
        false => MeshContents::read(files, file, format)?,
    };
    let (given, count) = (contents.triangles(), contents.parts.len());
    let encoding = contents.encoding;
    let described = |what: &str, triangles: usize, parts: usize, unit: f64| {
        let kind = format!("{} {encoding}", format.title()).trim_end().to_owned();
        let several = if parts > 1 { format!(", {parts} parts") } else { String::new() };
        let before = if given == triangles { String::new() } else { format!(" ({given} in the file)") };
        let source = SourceInfo::new(file.display().to_string(), format.name())
            .described(format!("{kind}, {triangles} triangles{before}{several}, {what}"))
            .with("encoding", encoding)
            .with("triangles", triangles);
        let source = if given == triangles { source } else { source.with("triangles_in_file", given) };
        source.with("parts", parts).with("unit_m", unit)
    };
    if let Some(Positive(Length(thickness))) = choice.shell.as_ref().map(|shell| shell.value) {
        let contents = contents.in_metres(unit);
        let shells = contents.parts.iter().map(|part| MeshShell::new(&part.mesh, thickness));
        let shells = shells.collect::<Result<Vec<_>, _>>().map_err(unfit)?;
        let named = contents.parts.iter().map(|part| part.name.clone()).zip(shells);
        let pieces = named.map(|(name, shell)| Piece { name, shape: Box::new(shell) as Box<dyn Shape> });
        findings.extend(contents.findings);
        let source = described("taken as a sheet", given, count, contents.unit.unwrap_or(1.0))
            .with("taken_as", "sheet");
        return Ok(Model {
            source,
            unit: contents.unit.unwrap_or(1.0),
            pieces: pieces.collect(),
            field: None,
        });
    }
    let is_cloud = choice.hull && given == 0;
    let points: usize = contents.parts.iter().map(|part| part.mesh.coordinates().len()).sum();
    if choice.hull {
        for part in &mut contents.parts {
            part.mesh = ConvexHull::of(part.mesh.coordinates()).map_err(unfit)?;
        }
    }
    let length = |given: &Option<Given<Positive<MeshLength>>>| given.as_ref().map(|given| given.value.0);
    let (contents, repairs) = contents.mended(length(&choice.weld), length(&choice.fill), unit, file)?;
    let name = file.display().to_string();
    let explained = |error| MeshRepair::explained(&repairs, error);
    if choice.union {
        let united = UnitedMesh::of(contents, file, unit).map_err(explained)?;
        findings.extend(united.findings_of(&repairs, &name));
        findings.extend(united.findings_in(&name));
        let what = if choice.hull {
            "taken as the union of convex hulls"
        } else {
            "taken as the union of its parts"
        };
        let (union, numbers) = united.for_programs();
        let source =
            described(what, given, count, united.unit).with("taken_as", "union").with(union, numbers);
        let source = mended(source, &repairs);
        let unit = united.unit;
        let pieces = vec![Piece { name: String::new(), shape: Box::new(united.union) }];
        return Ok(Model { source, unit, pieces, field: None });
    }
    let solid = MeshSolid::of(contents, file, format, unit).map_err(explained)?;
    findings.extend(MeshRepair::findings(&repairs, &solid, &name));
    findings.extend(solid.findings_in(&name));
    let turned = solid.parts.iter().any(|part| part.mesh.inverted());
    let what = match (choice.hull, turned) {
        (true, _) if is_cloud => format!("taken as the convex hull of {points} points"),
        (true, _) => "taken as its convex hull".to_owned(),
        (false, true) => "closed, wound inward (turned)".to_owned(),
        (false, false) => "closed, consistently wound".to_owned(),
    };
    let vertices: usize = solid.parts.iter().map(|part| part.mesh.vertices()).sum();
    // of a hull and of what was mended, what they are of
    let triangles = match choice.hull || !repairs.is_empty() {
        true => solid.parts.iter().map(|part| part.mesh.surface().triangles().len()).sum(),
        false => given,
    };
    let taken_as = if choice.hull { "convex_hull" } else { "solid" };
    let source = described(&what, triangles, solid.parts.len(), solid.unit)
        .with("vertices", vertices)
        .with("taken_as", taken_as);
    let source = mended(source, &repairs);
    let tolerance = choice.tolerance.as_ref().map(|tolerance| tolerance.value.0.0);
    let field = match &choice.field {
        Some(formula) => Some(field::found(&solid.parts, &formula.value.0, tolerance, host)?),
        None => None,
    };
    let piece = |part: SolidPart| Piece { name: part.name, shape: Box::new(part.mesh) };
    Ok(Model { source, unit: solid.unit, pieces: solid.parts.into_iter().map(piece).collect(), field })
}

/// What was mended, for programs.
fn mended(source: SourceInfo, repairs: &[MeshRepair]) -> SourceInfo {
    if repairs.is_empty() {
        return source;
    }
    let each = repairs.iter().map(MeshRepair::for_programs);
    each.fold(source, |source, (name, value)| source.with(name, value))
        .with("volume_bound_m3", RepairBound::of(repairs).volume)
}

/// Each part with its mass.
fn weighed(
    pieces: &[Piece],
    request: &Request,
    findings: &mut Vec<Finding>,
    by_field: bool,
) -> Result<Vec<PartRow>, Failure> {
    if by_field {
        return Ok(Vec::new());
    }
    let (substance, choice) = (&request.substance, &request.mesh);
    if let Some(unknown) = choice.parts().find(|given| pieces.iter().all(|p| p.name != given.name)) {
        let names: Vec<_> = pieces.iter().map(|piece| format!("{:?}", piece.name)).collect();
        return Err(Failure::usage(
            format!("the mesh has no part named {:?}", unknown.name),
            format!("its parts are {}", names.join(", ")),
        ));
    }
    let own =
        |piece: &Piece| choice.parts().find(|given| given.name == piece.name).map(|given| given.substance);
    let mut names = BTreeSet::new();
    if let Some(twice) = choice.parts().find(|given| !names.insert(&given.name)) {
        return Err(Failure::usage(
            format!("--part {} is given twice", twice.name),
            "a part is made of one thing: leave one of them out",
        ));
    }
    let called = |given: &PartSubstance| pieces.iter().filter(|piece| piece.name == given.name).count();
    let is_mass = |given: &&PartSubstance| matches!(given.substance, Substance::Mass(_));
    if let Some(shared) = choice.parts().filter(is_mass).find(|given| called(given) > 1) {
        return Err(Failure::usage(
            format!(
                "{} parts of the mesh are named {:?}: is the mass that of each?",
                called(shared),
                shared.name
            ),
            "give a density or a material, which counts for each, or name the parts apart in the file",
        ));
    }
    let rest: Vec<_> = pieces.iter().filter(|piece| own(piece).is_none()).collect();
    if rest.is_empty() && substance.given().is_some() {
        return Err(Failure::usage(
            "--density, --mass or --material is for the parts without a --part of their own, and every part has one",
            "leave it out, or leave out a --part",
        ));
    }
    let common = match substance.given() {
        // the mass of all parts that have none of their own, at one density
        Some(Substance::Mass(mass)) if rest.len() > 1 => {
            Substance::Density(mass / rest.iter().map(|piece| piece.volume()).sum::<f64>())
        }
        Some(substance) => substance,
        None if rest.is_empty() => Substance::Density(1.0),
        None => assumed(findings),
    };
    let row = |piece: &Piece| {
        let part = piece.shape.mass_properties(own(piece).unwrap_or(common));
        let properties = part.and_then(in_body).map_err(unfit)?;
        Ok(PartRow { name: piece.name.clone(), properties, volume: Some(piece.volume()) })
    };
    pieces.iter().map(row).collect()
}

/// Assumption of 1 kg/m³ where nothing is given, and a finding that says so.
fn assumed(findings: &mut Vec<Finding>) -> Substance {
    findings.push(Finding {
        code: "mass.assumed",
        severity: Severity::Warning,
        message: "neither density, mass nor material is given: 1 kg/m³ is assumed".to_owned(),
        place: Some("--density, --mass or --material".to_owned()),
    });
    Substance::Density(1.0)
}
