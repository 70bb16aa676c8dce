//! `[[body.part]]`: a shape, mesh, particles or tensor, with its substance and placement.

use std::any::Any;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use polhode::body::mesh::{ClosedMesh, MeshUnion};
use polhode::body::shape::Extent;
use polhode::body::{BodyPart, Finding, Particle, mass_properties_of_particles};
use polhode::math::{Part, Position};
use polhode_shape::brep::BrepFormat;
use polhode_shape::mesh::{MeshContents, MeshFormat, MeshLength, MeshRepair, MeshSolid, UnitedMesh};
use polhode_source::toml::reader::{Table, Value};
use polhode_source::toml::tree::Known;
use polhode_source::unit;
use polhode_source::unit::{Dimension, UnitError};
use polhode_source::{FormatError, FormatErrorKind};

use super::known_mesh::KnownMesh;
use super::molecule::molecule;
use super::placement::Placement;
use super::shape::{Geometry, SHAPES, shape};
use super::substance::{self, Matter, matter};
use super::tensor;

/// Keys allowed for every part.
const COMMON: [&str; 4] = ["name", "shape", "position", "rotate"];

/// Reads part number `number`, counted from 1; remarks are added to `findings`.
pub fn part(table: Table<'_>, number: usize, findings: &mut Vec<Finding>) -> Result<BodyPart, FormatError> {
    let kind = kind(&table)?;
    let table = table.called(format!("[[body.part]] of shape \"{kind}\""));
    table.allow(&keys(kind))?;
    let name = match table.get("name") {
        Some(name) => name.string()?.to_owned(),
        None => format!("{kind} {number}"),
    };
    let placement = Placement::read(&table)?;
    let form = match kind {
        "particles" => return particles(&table, name, &placement),
        "molecule" => return molecule(&table, name, &placement, findings),
        "tensor" => {
            let properties = placement.place(&table, tensor::mass_properties(&table)?)?;
            return Ok(BodyPart {
                name,
                kind,
                properties,
                extent: None,
                surface_area: None,
                particles: Vec::new(),
                form: None,
            });
        }
        "mesh" if is_united(&table)? => Geometry::Union(Box::new(united(&table, &name, findings)?)),
        "mesh" => Geometry::Mesh(mesh(&table, &name, findings)?),
        _ => shape(kind, &table)?,
    };
    let solid = form.as_shape();
    let extent = solid.spread().extent();
    let (matter, given) = matter(&table, extent)?;
    let properties = match matter {
        Matter::Uniform(substance) => solid.mass_properties(substance).map_err(|e| given.body(e))?,
        Matter::Varying(formula) => formula.integrate(&form, &given, &name, findings)?,
    };
    let surface_area = (!matches!(extent, Extent::Length(_))).then(|| solid.surface_area());
    let properties = placement.place(&table, properties)?;
    // Display geometry is skipped for sweep members.
    let form = table.is_shown().then(|| solid.form()).flatten().map(|form| placement.form(form));
    Ok(BodyPart { name, kind, properties, extent: Some(extent), surface_area, particles: Vec::new(), form })
}

/// Returns the name of the part's shape.
fn kind(table: &Table<'_>) -> Result<&'static str, FormatError> {
    let names: Vec<_> =
        SHAPES.iter().map(|(name, _)| *name).chain(["mesh", "molecule", "particles", "tensor"]).collect();
    if table.get("shape").is_none() {
        // This reports a misspelt `shape` as an unknown key.
        let mut all: Vec<_> = names.iter().flat_map(|name| keys(name)).collect();
        all.sort_unstable();
        all.dedup();
        table.allow(&all)?;
    }
    table.require("shape", "shape = \"box\"")?.choice(&names)
}

fn keys(kind: &str) -> Vec<&'static str> {
    let own: &[&[&'static str]] = match kind {
        "particles" => &[&["particles"]],
        "molecule" => &[&["file", "isotopes"]],
        "tensor" => &[&tensor::KEYS],
        "mesh" => &[&["file", "unit", "weld", "fill", "union"], &substance::KEYS],
        _ => &[SHAPES.iter().find(|(name, _)| *name == kind).map_or(&[], |(_, keys)| keys), &substance::KEYS],
    };
    COMMON.iter().chain(own.iter().copied().flatten()).copied().collect()
}

/// Reads `particles = [{ mass = "1 kg", position = [3] }, …]`.
fn particles(table: &Table<'_>, name: String, placement: &Placement) -> Result<BodyPart, FormatError> {
    let list =
        table.require("particles", "particles = [{ mass = \"1 kg\", position = [0, 0, \"0.5 m\"] }]")?;
    let mut particles = Vec::new();
    for element in list.elements("an array of tables")? {
        let particle = element.table()?.called("a particle".to_owned());
        particle.allow(&["mass", "position"])?;
        let mass = particle.require("mass", "mass = \"1 kg\"")?;
        let position = particle.require("position", "position = [0, 0, \"0.5 m\"]")?;
        let in_part = Position::<Part>::from_array(position.quantities(Dimension::LENGTH)?);
        let in_body = placement.position + placement.rotation * in_part;
        let particle = Particle::new(mass.positive(Dimension::MASS)?, in_body);
        particles.push(particle.map_err(|e| position.body(e))?);
    }
    let properties = mass_properties_of_particles(&particles).map_err(|e| list.body(e))?;
    Ok(BodyPart {
        name,
        kind: "particles",
        properties,
        extent: None,
        surface_area: None,
        particles,
        form: None,
    })
}

/// Mesh of a file, with the findings on it.
struct KeptMesh {
    mesh: Arc<ClosedMesh>,
    noticed: Vec<Finding>,
}

/// Returns the mesh of a part, from the cache if it has been read before.
fn mesh(table: &Table<'_>, name: &str, findings: &mut Vec<Finding>) -> Result<Arc<ClosedMesh>, FormatError> {
    let file = table.require("file", "file = \"part.stl\"")?;
    // A weld or fill may be varied, which gives another mesh for the same file.
    let is_kept = table.get("weld").is_none() && table.get("fill").is_none();
    if let Some(known) = file.known_as::<KeptMesh>().filter(|_| is_kept) {
        findings.extend_from_slice(&known.noticed);
        return Ok(known.mesh.clone());
    }
    let mut noticed = Vec::new();
    let mesh = Arc::new(read_mesh(table, name, &mut noticed)?);
    findings.extend_from_slice(&noticed);
    if is_kept {
        file.keep(Known::File(Arc::new(KeptMesh { mesh: mesh.clone(), noticed })));
    }
    Ok(mesh)
}

/// Settings of a mesh file.
struct MeshFile<'a> {
    value: Value<'a>,
    written: &'a str,
    path: PathBuf,
    format: MeshFormat,
    unit: Option<f64>,
    weld: Option<MeshLength>,
    fill: Option<MeshLength>,
}

impl<'a> MeshFile<'a> {
    /// Reads `file`, a path relative to the scenario; lengths are in `unit`, unless the file has a
    /// unit of its own.
    fn of(table: &Table<'a>) -> Result<Self, FormatError> {
        let value = table.require("file", "file = \"part.stl\"")?;
        let written = value.string()?;
        if written.is_empty() {
            return Err(value
                .invalid("a path")
                .with_hint("write file = \"part.stl\", relative to the scenario"));
        }
        let unit = table.get("unit").map(|value| length_unit(&value)).transpose()?;
        let length = |key, example| table.get(key).map(|value| beside_mesh(&value, example)).transpose();
        let weld = length("weld", "weld = \"0.01 mm\", or weld = 1e-6 of its size")?;
        let fill = length("fill", "fill = \"2 mm\", or fill = 0.01 of its size")?;
        let path = value.path()?;
        let Some(format) = MeshFormat::of_path(&path) else {
            let hint = match BrepFormat::of(value.files(), &path) {
                Some(format) => format!("{}: {}", format.refusal(), format.hint(&path)),
                None => {
                    let known = MeshFormat::ALL.iter().flat_map(|format| format.extensions()).copied();
                    format!("mesh files end in {}", known.collect::<Vec<_>>().join(", "))
                }
            };
            return Err(value.invalid("a mesh file").with_hint(hint));
        };
        Ok(Self { value, written, path, format, unit, weld, fill })
    }

    /// Returns the contents of the file, with each part repaired separately, as the command does.
    fn contents(&self) -> Result<(MeshContents, Vec<MeshRepair>), FormatError> {
        let contents = MeshContents::read_as(self.value.files(), &self.path, self.written, self.format)?;
        contents.mended(self.weld, self.fill, self.unit, &self.path)
    }

    fn blamed(&self, error: FormatError) -> FormatError {
        match error.kind() {
            // A missing file has no lines, so the error refers to the scenario.
            kind @ FormatErrorKind::Io { .. } => self
                .value
                .error(kind.clone())
                .with_hint(format!("paths are relative to the scenario: this one is {:?}", self.path)),
            _ => error.named_in(self.value.source().path, self.value.place()),
        }
    }
}

/// Reads all parts of a mesh file as one mesh.
fn read_mesh(table: &Table<'_>, name: &str, findings: &mut Vec<Finding>) -> Result<ClosedMesh, FormatError> {
    let file = MeshFile::of(table)?;
    let MeshFile { ref value, ref path, written, format, unit, weld, fill } = file;
    let is_as_read = weld.is_none() && fill.is_none();
    let known = value.source().kept.and_then(<dyn Any + Send + Sync>::downcast_ref::<KnownMesh>);
    let known = known.filter(|known| known.path == *path && known.unit == unit && is_as_read);
    let mut repairs = Vec::new();
    let read = || {
        let (contents, done) = file.contents()?;
        repairs = done;
        let one = contents.as_one().map_err(|e| FormatError::new(path, None, FormatErrorKind::Body(e)))?;
        let solid = MeshSolid::watched(one, path, format, unit, value.source().watch.0);
        solid.map_err(|error| MeshRepair::explained(&repairs, error))
    };
    let solid = known.map_or_else(read, |known| Ok(known.solid.clone()));
    let solid = solid.map_err(|error| file.blamed(error))?;
    let place = format!("part \"{name}\", {written}");
    findings.extend(MeshRepair::findings(&repairs, &solid, &place));
    findings.extend(solid.findings_in(&place));
    let mut parts = solid.parts;
    parts.pop().map(|part| part.mesh).ok_or_else(|| value.invalid("a mesh with triangles"))
}

/// Reads `union = true`.
fn is_united(table: &Table<'_>) -> Result<bool, FormatError> {
    table.get("union").map_or(Ok(false), |value| value.boolean())
}

/// Reads the union of all parts of a mesh file.
fn united(table: &Table<'_>, name: &str, findings: &mut Vec<Finding>) -> Result<MeshUnion, FormatError> {
    let file = MeshFile::of(table)?;
    let read = || {
        let (contents, repairs) = file.contents()?;
        let united = UnitedMesh::watched(contents, &file.path, file.unit, file.value.source().watch.0);
        Ok((united.map_err(|error| MeshRepair::explained(&repairs, error))?, repairs))
    };
    let (united, repairs) = read().map_err(|error| file.blamed(error))?;
    let place = format!("part \"{name}\", {}", file.written);
    findings.extend(united.findings_of(&repairs, &place));
    findings.extend(united.findings_in(&place));
    Ok(united.union)
}

/// Returns true if a mesh without any unit has a given mass, false if not; `None` for all other
/// parts.
pub fn assumes_metres(table: &Table<'_>) -> Option<bool> {
    let says = |key| table.get(key).is_some();
    let file =
        table.get("file").filter(|_| table.get("shape").is_some_and(|shape| shape.string() == Ok("mesh")))?;
    let format = MeshFormat::of_path(Path::new(file.string().ok()?))?;
    (!says("unit") && !format.has_unit()).then(|| says("mass"))
}

/// Reads `weld = "0.01 mm"`, or `weld = 1e-6` relative to the size of the mesh.
fn beside_mesh(value: &Value<'_>, example: &str) -> Result<MeshLength, FormatError> {
    let length = match value.string() {
        Ok(text) => MeshLength::parse(text).map_err(|error| value.error(FormatErrorKind::Unit(error)))?,
        Err(_) => MeshLength::OfSize(value.number()?),
    };
    if length.value() > 0.0 && length.value().is_finite() {
        return Ok(length);
    }
    Err(value.invalid("positive and finite").with_hint(format!("write {example}")))
}

/// Reads `unit = "mm"`; returns its value in metres.
fn length_unit(value: &Value<'_>) -> Result<f64, FormatError> {
    let name = value.string()?;
    let hint = "a mesh file has no unit of its own: write unit = \"mm\", \"in\" or \"m\"";
    if !name.trim().starts_with(char::is_alphabetic) {
        return Err(value.invalid("the name of a unit of length").with_hint(hint));
    }
    unit::factor(name, Dimension::LENGTH).map_err(|error| {
        // The hint of the unit error is for a quantity; it is used only if it suggests a name.
        let known = matches!(error, UnitError::UnknownUnit { suggestion: Some(_), .. });
        let error = value.error(FormatErrorKind::Unit(error));
        if known { error } else { error.with_hint(hint) }
    })
}
