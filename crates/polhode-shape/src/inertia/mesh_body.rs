//! Mesh as a body: the bounded solid, its hull, a shell, or the union of its parts, with their
//! masses.

use std::collections::BTreeSet;
use std::path::Path;

use polhode::body::mesh::{ConvexHull, MeshShell};
use polhode::body::shape::{Extent, Substance};
use polhode::body::{BodyError, Finding, Severity};
use polhode_document::{Extra, SourceInfo};
use polhode_source::expression::Expression;
use polhode_source::files::Files;

use super::bounded::Uncertain;
use super::choice::PartSubstance;
use super::field;
use super::host::Host;
use super::in_body;
use super::mesh_error::MeshBodyError;
use super::piece::Piece;
use super::print::{self, Print};
use crate::mesh::{
    AssumedMetres, MeshContents, MeshFormat, MeshLength, MeshRepair, MeshSolid, RepairBound, Share,
    SolidPart, UnitedMesh,
};
use crate::report::{InertiaReport, PartRow};

/// Options for a mesh: shape and substances.
#[derive(Clone, Copy)]
#[allow(missing_debug_implementations, reason = "a function has no form for people")]
pub struct MeshUse<'a> {
    /// Unit of length, m, if given.
    pub unit: Option<f64>,
    /// True to use the convex hull of each part.
    pub hull: bool,
    /// Thickness of a shell along the mesh, used instead of the solid, m.
    pub shell: Option<f64>,
    /// Maximum distance between vertices of open edges that are joined.
    pub weld: Option<MeshLength>,
    /// Maximum size of holes that are closed.
    pub fill: Option<MeshLength>,
    /// Largest share of the volume that may be uncertain when all holes are closed.
    pub close_within: Option<Share>,
    /// Walls and infill of a print.
    pub print: Option<Print>,
    /// True to use the union of all parts.
    pub union: bool,
    /// True to search for triangles that intersect; hulls, sheets and unions do not depend on it.
    pub check: bool,
    /// Substance of all parts without their own substance.
    pub substance: Option<Substance>,
    /// Substances of individual parts.
    pub parts: &'a [PartSubstance],
    /// Density formula of x, y and z in m, in kg/m³.
    pub field: Option<&'a Expression>,
    /// Relative error tolerance for `field`.
    pub tolerance: Option<f64>,
    /// Returns false to cancel; called often.
    pub goes_on: &'a (dyn Fn() -> bool + Sync),
    /// Texts in findings.
    pub words: MeshWords<'a>,
}

/// Texts in findings that depend on the user interface.
#[derive(Clone, Copy, Debug)]
pub struct MeshWords<'a> {
    /// Hint to state the unit: `--unit mm, or --unit m if metres are right`.
    pub unit: &'a str,
    /// Place of the finding that metres are assumed.
    pub file: Option<&'a str>,
    /// Place of the finding that a density is assumed.
    pub substance: Option<&'a str>,
}

/// Origin of a mesh.
#[derive(Clone, Debug)]
pub struct MeshOrigin<'a> {
    /// Path, for messages.
    pub path: &'a Path,
    /// Format of the file.
    pub format: MeshFormat,
    /// Source in the report.
    pub source: SourceInfo,
    /// Beginning of the description: format and encoding.
    pub title: String,
}

impl<'a> MeshOrigin<'a> {
    /// Returns the origin of a mesh read from a file.
    pub fn of_file(path: &'a Path, format: MeshFormat, contents: &MeshContents) -> Self {
        let title = format!("{} {}", format.title(), contents.encoding).trim_end().to_owned();
        Self { path, format, source: SourceInfo::new(path.display().to_string(), format.name()), title }
    }
}

/// Mesh as a body.
#[allow(missing_debug_implementations, reason = "a shape has no form for people")]
pub struct MeshBody<'a> {
    source: SourceInfo,
    /// Unit of length of the file, m.
    pub(super) unit: f64,
    pub(super) pieces: Vec<Piece>,
    pub(super) findings: Vec<Finding>,
    rows: Vec<PartRow>,
    errors: Vec<Extra>,
    metres_assumed: bool,
    how: MeshUse<'a>,
}

/// Shapes of a mesh, before masses are assigned.
struct Model {
    source: SourceInfo,
    unit: f64,
    pieces: Vec<Piece>,
    findings: Vec<Finding>,
    field: Option<field::Found>,
    uncertain: Option<Uncertain>,
}

/// Common part of the source of every model.
struct Stated<'a> {
    origin: &'a MeshOrigin<'a>,
    encoding: &'static str,
    /// Number of triangles in the file.
    given: usize,
}

impl Stated<'_> {
    fn source(&self, what: &str, triangles: usize, parts: usize, unit: f64) -> SourceInfo {
        let (title, given) = (&self.origin.title, self.given);
        let several = if parts > 1 { format!(", {parts} parts") } else { String::new() };
        let before = if given == triangles { String::new() } else { format!(" ({given} in the file)") };
        let words = format!("{title}, {triangles} triangles{before}{several}, {what}");
        let mut source = self.origin.source.clone().described(words);
        if !self.encoding.is_empty() {
            source = source.with("encoding", self.encoding);
        }
        source = source.with("triangles", triangles);
        if given != triangles {
            source = source.with("triangles_in_file", given);
        }
        source.with("parts", parts).with("unit_m", unit)
    }
}

impl<'a> MeshUse<'a> {
    /// Reads a mesh file and makes a body of it.
    ///
    /// # Errors
    /// [`MeshBodyError`] if the file cannot be read, bounds no solid, or lacks a named part.
    pub fn read(
        self,
        files: &dyn Files,
        path: &Path,
        format: MeshFormat,
        host: &mut dyn Host,
    ) -> Result<MeshBody<'a>, MeshBodyError> {
        let contents = match self.hull {
            true => MeshContents::read_for_hull(files, path, format)?,
            false => MeshContents::read(files, path, format)?,
        };
        let origin = MeshOrigin::of_file(path, format, &contents);
        self.body(contents, &origin, host)
    }

    /// Makes a body of the contents of a mesh file.
    ///
    /// # Errors
    /// [`MeshBodyError`], as for [`MeshUse::read`].
    pub fn body(
        self,
        contents: MeshContents,
        origin: &MeshOrigin<'_>,
        host: &mut dyn Host,
    ) -> Result<MeshBody<'a>, MeshBodyError> {
        self.require_wanted()?;
        let metres_assumed = self.unit.is_none() && contents.unit.is_none();
        let Model { source, unit, pieces, mut findings, field, uncertain } =
            self.model(contents, origin, host)?;
        let (rows, error) = match field {
            Some(found) => (found.rows, Some(found.error)),
            None => (self.weighed(&pieces, &mut findings)?, None),
        };
        let mut errors = Vec::from_iter(error);
        if let Some(uncertain) = uncertain {
            errors.push(uncertain.bounds(&rows, self.parts, self.substance)?);
        }
        let printed: Vec<_> = pieces.iter().filter_map(|piece| piece.printed.as_ref()).collect();
        if !printed.is_empty() {
            errors.push(print::bounds(&printed, &rows, self.parts, self.substance)?);
        }
        Ok(MeshBody { source, unit, pieces, findings, rows, errors, metres_assumed, how: self })
    }

    fn require_wanted(&self) -> Result<(), MeshBodyError> {
        if (self.goes_on)() { Ok(()) } else { Err(MeshBodyError::Interrupted) }
    }

    fn model(
        &self,
        mut contents: MeshContents,
        origin: &MeshOrigin<'_>,
        host: &mut dyn Host,
    ) -> Result<Model, MeshBodyError> {
        let (given, count) = (contents.triangles(), contents.parts.len());
        let stated = Stated { origin, encoding: contents.encoding, given };
        if let Some(thickness) = self.shell {
            let contents = contents.in_metres(self.unit);
            let unit = contents.unit.unwrap_or(1.0);
            let sheet = |part: &crate::mesh::MeshPart| {
                Ok(Piece::new(part.name.clone(), MeshShell::new(&part.mesh, thickness)?))
            };
            let pieces = contents.parts.iter().map(sheet).collect::<Result<_, BodyError>>()?;
            let source = stated.source("taken as a sheet", given, count, unit).with("taken_as", "sheet");
            return Ok(Model {
                source,
                unit,
                pieces,
                findings: contents.findings,
                field: None,
                uncertain: None,
            });
        }
        let points: usize = contents.parts.iter().map(|part| part.mesh.coordinates().len()).sum();
        if self.hull {
            for part in &mut contents.parts {
                part.mesh = ConvexHull::of(part.mesh.coordinates())?;
            }
        }
        let (contents, repairs) = contents.mended(self.weld, self.fill, self.unit, origin.path)?;
        let file = origin.path.display().to_string();
        let explained = |error| MeshRepair::explained(&repairs, error);
        self.require_wanted()?;
        if self.union {
            let united =
                UnitedMesh::watched(contents, origin.path, self.unit, self.goes_on).map_err(explained)?;
            let mut findings = united.findings_of(&repairs, &file);
            findings.extend(united.findings_in(&file));
            let of = if self.hull { "convex hulls" } else { "its parts" };
            let (name, numbers) = united.for_programs();
            let source = stated.source(&format!("taken as the union of {of}"), given, count, united.unit);
            let source = with_repairs(source.with("taken_as", "union").with(name, numbers), &repairs);
            let unit = united.unit;
            let pieces = vec![Piece::new(String::new(), united.union)];
            return Ok(Model { source, unit, pieces, findings, field: None, uncertain: None });
        }
        let (contents, closure) = match self.close_within {
            None => (contents, None),
            Some(_) => contents
                .capped(origin.path, self.goes_on)
                .map(|(contents, closure)| (contents, Some(closure)))?,
        };
        // Bounds hold only for caps that do not intersect the mesh.
        let solids = if self.check || closure.is_some() { MeshSolid::watched } else { MeshSolid::unchecked };
        let capped = if closure.is_some() { contents.parts.clone() } else { Vec::new() };
        let solid =
            solids(contents, origin.path, origin.format, self.unit, self.goes_on).map_err(explained)?;
        self.require_wanted()?;
        let mut findings = MeshRepair::findings(&repairs, &solid, &file);
        findings.extend(solid.findings_in(&file));
        let uncertain = match self.close_within.zip(closure) {
            None => None,
            Some((most, closure)) => {
                Uncertain::of(&solid, &capped, closure, &repairs, most, (&mut findings, &file))?
            }
        };
        let turned = solid.parts.iter().any(|part| part.mesh.inverted());
        let what = match (self.hull, turned) {
            (true, _) if given == 0 => format!("taken as the convex hull of {points} points"),
            (true, _) => "taken as its convex hull".to_owned(),
            (false, true) => "closed, wound inward (reversed)".to_owned(),
            (false, false) => "closed, consistently wound".to_owned(),
        };
        let what = if self.check { what } else { format!("{what}, not checked for self-intersections") };
        let what = match self.print {
            None => what,
            Some(print) => format!("{what}, {}", print.in_words()),
        };
        let vertices: usize = solid.parts.iter().map(|part| part.mesh.vertices()).sum();
        // A hull or a repaired mesh has different triangles than the file.
        let triangles = match self.hull || !repairs.is_empty() || uncertain.is_some() {
            true => solid.parts.iter().map(|part| part.mesh.surface().triangles().len()).sum(),
            false => given,
        };
        let taken_as = if self.hull { "convex_hull" } else { "solid" };
        let source = stated.source(&what, triangles, solid.parts.len(), solid.unit);
        let mut source = with_repairs(source.with("vertices", vertices).with("taken_as", taken_as), &repairs);
        if let Some(uncertain) = &uncertain {
            source = uncertain.stated(source);
        }
        let field = match self.field {
            Some(formula) => Some(field::found(&solid.parts, formula, self.tolerance, host)?),
            None => None,
        };
        let piece = |part: SolidPart| -> Result<Piece, MeshBodyError> {
            let printed = self.print.map(|print| print.of(part.mesh.clone(), self.goes_on)).transpose()?;
            Ok(Piece { printed, ..Piece::new(part.name, part.mesh) })
        };
        let pieces = solid.parts.into_iter().map(piece).collect::<Result<Vec<_>, _>>()?;
        self.require_wanted()?;
        if let Some(print) = self.print {
            source = print.stated(source, pieces.iter().filter_map(|piece| piece.printed.as_ref()));
        }
        Ok(Model { source, unit: solid.unit, pieces, findings, field, uncertain })
    }

    /// Returns each part with its mass.
    fn weighed(&self, pieces: &[Piece], findings: &mut Vec<Finding>) -> Result<Vec<PartRow>, MeshBodyError> {
        let called = |given: &PartSubstance| pieces.iter().filter(|piece| piece.name == given.name).count();
        let name = |given: &PartSubstance| given.name.clone();
        if let Some(unknown) = self.parts.iter().find(|given| called(given) == 0) {
            let known = pieces.iter().map(|piece| piece.name.clone()).collect();
            return Err(MeshBodyError::UnknownPart { name: name(unknown), known });
        }
        let mut names = BTreeSet::new();
        if let Some(twice) = self.parts.iter().find(|given| !names.insert(&given.name)) {
            return Err(MeshBodyError::PartTwice { name: name(twice) });
        }
        let is_mass = |given: &&PartSubstance| matches!(given.substance, Substance::Mass(_));
        if let Some(shared) = self.parts.iter().filter(is_mass).find(|given| called(given) > 1) {
            return Err(MeshBodyError::SharedMass { name: name(shared), count: called(shared) });
        }
        let own = |piece: &Piece| self.parts.iter().find(|given| given.name == piece.name);
        let rest: Vec<_> = pieces.iter().filter(|piece| own(piece).is_none()).collect();
        let common = match self.substance {
            Some(_) if rest.is_empty() => return Err(MeshBodyError::AllNamed),
            // The total mass of the remaining parts, at one common density.
            Some(Substance::Mass(mass)) if rest.len() > 1 => {
                Substance::Density(mass / rest.iter().map(|piece| piece.material()).sum::<f64>())
            }
            Some(substance) => substance,
            None => {
                if !rest.is_empty() {
                    findings.push(mass_assumed(self.words.substance));
                }
                Substance::Density(1.0)
            }
        };
        let row = |piece: &Piece| {
            let substance = own(piece).map_or(common, |given| given.substance);
            let properties = in_body(piece.mass_properties(substance)?)?;
            Ok(PartRow { name: piece.name.clone(), properties, volume: Some(piece.volume()) })
        };
        pieces.iter().map(row).collect()
    }
}

impl MeshBody<'_> {
    /// Returns the report of the body.
    ///
    /// # Errors
    /// [`MeshBodyError`] if the sum of the parts is not a physical body.
    pub fn into_report(self) -> Result<InertiaReport, MeshBodyError> {
        let MeshUse { substance, words, .. } = self.how;
        let mut source = self.source;
        if self.metres_assumed {
            let description = format!("{}, in m because no unit is given", source.description);
            source = source.described(description).with("unit_assumed", true);
        }
        let mut report = InertiaReport::of_parts(source, &self.rows)?;
        report.surface_area = Some(self.pieces.iter().map(|piece| piece.shape.surface_area()).sum());
        report.extras.extend(self.errors);
        report.findings = self.findings;
        if self.metres_assumed {
            let assumed = AssumedMetres {
                properties: &report.properties,
                extent: report.volume.map(Extent::Volume),
                mass_given: matches!(substance, Some(Substance::Mass(_))),
                others: None,
                remedy: words.unit,
            };
            report.findings.extend(assumed.finding(words.file.map(str::to_owned)));
        }
        Ok(report)
    }
}

/// Adds the repairs to the fields of a source.
fn with_repairs(source: SourceInfo, repairs: &[MeshRepair]) -> SourceInfo {
    if repairs.is_empty() {
        return source;
    }
    let each = repairs.iter().map(MeshRepair::for_programs);
    each.fold(source, |source, (name, value)| source.with(name, value))
        .with("volume_bound_m3", RepairBound::of(repairs).volume)
}

/// Returns the finding that 1 kg/m³ was assumed because no substance is given.
pub fn mass_assumed(place: Option<&str>) -> Finding {
    Finding {
        code: "mass.assumed",
        severity: Severity::Warning,
        message: "no density, mass or material is given: 1 kg/m³ is assumed".to_owned(),
        place: place.map(str::to_owned),
    }
}
