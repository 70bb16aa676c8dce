//! The mass properties of a mesh file.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode::body::mesh::{ConvexHull, MeshShell};
use polhode::body::shape::{Extent, Shape, Substance};
use polhode::body::{Finding, MassProperties};
use polhode_document::SourceInfo;
use polhode_scenario::report::{PartRow, parts};
use polhode_shape::mesh::{
    AssumedMetres, MeshContents, MeshFormat, MeshLength, MeshRepair, MeshSolid, RepairBound, UnitedMesh,
};
use polhode_shape::report::InertiaReport;
use polhode_source::expression::Expression;
use polhode_source::files::Disk;
use polhode_source::given::{positive, quantity};
use polhode_source::unit::Dimension;

use super::field;
use super::model::{Model, Piece, unfit};
use super::substance::{PartSubstance, SubstanceFlags, assumed, part};
use super::voxel::in_body;
use super::written::{MeshFile, written_format};
use crate::failure::Failure;
use crate::page;

/// What says a mesh's density otherwise than --field, or leaves no solid for it, and so for --tolerance: of an option that requires
/// another, clap asks nothing where that other conflicts with what is given.
const WITHOUT_FIELD: [&str; 5] = ["density", "mass", "material", "part", "shell"];

/// Flags for meshes.
#[derive(Debug, Args)]
pub(super) struct MeshFlags {
    /// What one part of a mesh is made of: its name in the file, and its density, mass or material; may be repeated.
    #[arg(long, value_name = "NAME=WHAT", value_parser = part)]
    part: Vec<PartSubstance>,
    /// The convex hull of each part of a mesh, closed or not, instead of the mesh. Clouds of points
    /// have one too: .xyz files, and .ply and .obj files without faces.
    #[arg(long, conflicts_with = "shell")]
    hull: bool,
    /// A sheet of this thickness along a mesh, closed or not, instead of the solid in it.
    #[arg(long, value_name = "THICKNESS", value_parser = thickness)]
    shell: Option<f64>,
    /// Density of a mesh as a formula of x, y, z in metres, in kg/m³, such as "2700 - 300*hypot(x, y)".
    #[arg(long, value_name = "FORMULA", value_parser = formula, conflicts_with_all = WITHOUT_FIELD, allow_hyphen_values = true)]
    field: Option<Expression>,
    /// The estimated relative error that is good enough for --field [default: 1e-10].
    #[arg(long, value_name = "ERROR", requires = "field", conflicts_with_all = WITHOUT_FIELD, value_parser = tolerance)]
    tolerance: Option<f64>,
    /// Join vertices of open edges that are at most so far apart: a length such as "0.01 mm", or a plain number, a part of the mesh's size (the
    /// diagonal of its box).
    #[arg(long, value_name = "TOL", value_parser = beside_mesh, conflicts_with_all = ["hull", "shell"])]
    weld: Option<MeshLength>,
    /// Close holes that are at most so large across, after a weld: a length such as "2 mm", or a plain number, a part of the mesh's size.
    #[arg(long, value_name = "SIZE", value_parser = beside_mesh, conflicts_with_all = ["hull", "shell"])]
    fill: Option<MeshLength>,
    /// Take what lies in several parts of a mesh, or more than once in one, once: parts that overlap or repeat are one body, after a weld and a
    /// fill.
    #[arg(long, conflicts_with_all = ["shell", "part", "field", "tolerance", "write_mesh", "force"])]
    union: bool,
    /// Write the mesh as it was used, welded, filled and wound outward, in the file's unit: .stl (binary), .obj or .ply.
    #[arg(long, value_name = "FILE", conflicts_with = "shell")]
    write_mesh: Option<PathBuf>,
    /// Replace what --write-mesh names, if it is there.
    #[arg(long, requires = "write_mesh", conflicts_with = "shell")]
    force: bool,
}

impl MeshFlags {
    pub(super) const fn is_hull(&self) -> bool {
        self.hull
    }

    /// Where the mesh goes, and in which format; of one file.
    pub(super) fn check_output(&self, files: usize) -> Result<(), Failure> {
        let Some(file) = &self.write_mesh else { return Ok(()) };
        if files > 1 {
            return Err(Failure::usage(
                "--write-mesh is for one mesh, and several files are given",
                "name one",
            ));
        }
        written_format(file)?;
        page::check_file(file, self.force)
    }

    /// The first that is given.
    pub(super) fn given(&self) -> Option<&'static str> {
        let flags = [
            (!self.part.is_empty(), "--part"),
            (self.hull, "--hull"),
            (self.shell.is_some(), "--shell"),
            (self.field.is_some(), "--field"),
            (self.weld.is_some(), "--weld"),
            (self.fill.is_some(), "--fill"),
            (self.union, "--union"),
            (self.write_mesh.is_some(), "--write-mesh"),
        ];
        flags.into_iter().find(|(given, _)| *given).map(|(_, flag)| flag)
    }
}

pub(super) fn report(
    file: &Path,
    format: MeshFormat,
    unit: Option<f64>,
    substance: &SubstanceFlags,
    flags: &MeshFlags,
) -> Result<(InertiaReport, Option<MeshFile>), Failure> {
    let mut findings = Vec::new();
    let Model { source, unit: in_m, pieces, field } = model(file, format, unit, flags, &mut findings)?;
    let rows = weighed(&pieces, substance, flags, &mut findings, field.is_some())?;
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
    let target = flags.write_mesh.as_ref();
    let written =
        target.map(|target| MeshFile::of(&pieces, in_m, target, flags.force, &mut findings)).transpose()?;
    let mut source = source;
    if unit.is_none() && !format.has_unit() {
        let words = format!("{}, in m as no unit is given", source.description);
        source = source.described(words).with("unit_assumed", true);
        let assumed = AssumedMetres {
            properties: &properties,
            extent: Some(Extent::Volume(volume)),
            mass_given: substance.mass().is_some(),
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
    file: &Path,
    format: MeshFormat,
    unit: Option<f64>,
    flags: &MeshFlags,
    findings: &mut Vec<Finding>,
) -> Result<Model, Failure> {
    let mut contents = match flags.hull {
        true => MeshContents::read_for_hull(&Disk, file, format)?,
        false => MeshContents::read(&Disk, file, format)?,
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
    if let Some(thickness) = flags.shell {
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
    let is_cloud = flags.hull && given == 0;
    let points: usize = contents.parts.iter().map(|part| part.mesh.coordinates().len()).sum();
    if flags.hull {
        for part in &mut contents.parts {
            part.mesh = ConvexHull::of(part.mesh.coordinates()).map_err(unfit)?;
        }
    }
    let (contents, repairs) = contents.mended(flags.weld, flags.fill, unit, file)?;
    let name = file.display().to_string();
    let explained = |error| MeshRepair::explained(&repairs, error);
    if flags.union {
        let united = UnitedMesh::of(contents, file, unit).map_err(explained)?;
        findings.extend(united.findings_of(&repairs, &name));
        findings.extend(united.findings_in(&name));
        let what =
            if flags.hull { "taken as the union of convex hulls" } else { "taken as the union of its parts" };
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
    let what = match (flags.hull, turned) {
        (true, _) if is_cloud => format!("taken as the convex hull of {points} points"),
        (true, _) => "taken as its convex hull".to_owned(),
        (false, true) => "closed, wound inward (turned)".to_owned(),
        (false, false) => "closed, consistently wound".to_owned(),
    };
    let vertices: usize = solid.parts.iter().map(|part| part.mesh.vertices()).sum();
    // of a hull and of what was mended, what they are of
    let triangles = match flags.hull || !repairs.is_empty() {
        true => solid.parts.iter().map(|part| part.mesh.surface().triangles().len()).sum(),
        false => given,
    };
    let taken_as = if flags.hull { "convex_hull" } else { "solid" };
    let source = described(&what, triangles, solid.parts.len(), solid.unit)
        .with("vertices", vertices)
        .with("taken_as", taken_as);
    let source = mended(source, &repairs);
    let field = match &flags.field {
        Some(formula) => Some(field::found(&solid.parts, formula, flags.tolerance)?),
        None => None,
    };
    let piece = |part: polhode_shape::mesh::SolidPart| Piece { name: part.name, shape: Box::new(part.mesh) };
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
    substance: &SubstanceFlags,
    flags: &MeshFlags,
    findings: &mut Vec<Finding>,
    by_field: bool,
) -> Result<Vec<PartRow>, Failure> {
    if by_field {
        return Ok(Vec::new());
    }
    if let Some(unknown) = flags.part.iter().find(|given| pieces.iter().all(|p| p.name != given.name)) {
        let names: Vec<_> = pieces.iter().map(|piece| format!("{:?}", piece.name)).collect();
        return Err(Failure::usage(
            format!("the mesh has no part named {:?}", unknown.name),
            format!("its parts are {}", names.join(", ")),
        ));
    }
    let own =
        |piece: &Piece| flags.part.iter().find(|given| given.name == piece.name).map(|given| given.substance);
    let mut names = BTreeSet::new();
    if let Some(twice) = flags.part.iter().find(|given| !names.insert(&given.name)) {
        return Err(Failure::usage(
            format!("--part {} is given twice", twice.name),
            "a part is made of one thing: leave one of them out",
        ));
    }
    let called = |given: &PartSubstance| pieces.iter().filter(|piece| piece.name == given.name).count();
    let is_mass = |given: &&PartSubstance| matches!(given.substance, Substance::Mass(_));
    if let Some(shared) = flags.part.iter().filter(is_mass).find(|given| called(given) > 1) {
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

fn thickness(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::LENGTH)?)
}

fn beside_mesh(text: &str) -> Result<MeshLength, String> {
    let length = MeshLength::parse(text).map_err(|error| match error.hint() {
        Some(hint) => format!("{error} (hint: {hint})"),
        None => error.to_string(),
    })?;
    positive(length.value()).map(|_| length)
}

fn tolerance(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::NONE)?)
}

fn formula(text: &str) -> Result<Expression, String> {
    Expression::parse(text, &["x", "y", "z"]).map_err(|error| match error.hint() {
        Some(hint) => format!("{error} (hint: {hint})"),
        None => error.to_string(),
    })
}
