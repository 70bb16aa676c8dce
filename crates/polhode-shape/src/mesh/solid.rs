//! Solids bounded by the parts of a mesh file.

use std::path::Path;

use polhode::body::mesh::{ClosedMesh, MeshFlaws, TriangleMesh};
use polhode::body::shape::{Shape, Substance};
use polhode::body::{BodyError, Finding, MassProperties};
use polhode::math::Part;
use polhode_source::files::Files;
use polhode_source::text::{counted, escaped};
use polhode_source::{FormatError, FormatErrorKind};

use super::{MeshContents, MeshFormat, MeshLength, MeshPart, Share, percent_above, union_hint};
use crate::finding::{info, warning};

/// Mesh file as solids, in metres.
#[derive(Clone, Debug)]
pub struct MeshSolid {
    pub format: MeshFormat,
    /// Encoding of the file.
    pub encoding: &'static str,
    /// Name stored in the file; often empty.
    pub name: String,
    /// Unit of length of the file, m.
    pub unit: f64,
    /// Number of triangles in the file, including degenerate ones.
    pub triangles: usize,
    /// Solids; at least one.
    pub parts: Vec<SolidPart>,
    /// Findings: parts that were reversed, joined or omitted.
    pub findings: Vec<Finding>,
}

/// Solid of a mesh file.
#[derive(Clone, Debug)]
pub struct SolidPart {
    /// Name in the file; often empty.
    pub name: String,
    /// Closed surface of the solid.
    pub mesh: ClosedMesh,
}

impl MeshSolid {
    /// Reads a mesh file as solids. `unit` is the unit of length in metres (0.001 for millimetres),
    /// if the file does not state it or states it wrongly.
    ///
    /// Each closed part is a separate solid. If a part is not closed, all parts together form one
    /// solid: the groups of an OBJ file often divide a surface, not a body.
    ///
    /// # Errors
    /// [`FormatError`] if the file cannot be read, does not follow its format, or does not bound a
    /// solid.
    pub fn read(
        files: &dyn Files,
        path: &Path,
        format: MeshFormat,
        unit: Option<f64>,
    ) -> Result<Self, FormatError> {
        Self::of(MeshContents::read(files, path, format)?, path, format, unit)
    }

    /// Returns the mass properties of all solids together, with one density. A mass is that of all
    /// solids.
    ///
    /// # Errors
    /// [`BodyError`] if the density or mass is not positive and finite.
    pub fn mass_properties(&self, substance: Substance) -> Result<MassProperties<Part>, BodyError> {
        let substance = match substance {
            Substance::Mass(mass) => {
                Substance::Density(mass / self.parts.iter().map(|part| part.mesh.volume()).sum::<f64>())
            }
            density => density,
        };
        let of_part = |part: &SolidPart| part.mesh.mass_properties(substance);
        MassProperties::combined(&self.parts.iter().map(of_part).collect::<Result<Vec<_>, _>>()?)
    }

    /// Returns the solids of the contents of a mesh file.
    ///
    /// # Errors
    /// [`FormatError`] if the parts do not bound solids. The numbers in the message are in the
    /// file's unit.
    pub fn of(
        contents: MeshContents,
        path: &Path,
        format: MeshFormat,
        unit: Option<f64>,
    ) -> Result<Self, FormatError> {
        Self::watched(contents, path, format, unit, &|| true)
    }

    /// Returns the solids as [`MeshSolid::of`] does, while `goes_on` returns true; the function is
    /// called often. After cancellation it is undecided if the mesh bounds a solid.
    ///
    /// # Errors
    /// [`FormatError`], as for [`MeshSolid::of`].
    pub fn watched(
        mut contents: MeshContents,
        path: &Path,
        format: MeshFormat,
        unit: Option<f64>,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, FormatError> {
        let (solids, joined) = solids(&contents.parts, true, goes_on)
            .map_err(|unsound| open_or_unsound(&contents, unsound, path, goes_on))?;
        contents.findings.extend(joined);
        Self::of_solids(contents, solids, path, format, unit)
    }

    /// Works like [`MeshSolid::watched`], but does not search for triangles that intersect
    /// ([`ClosedMesh::unchecked`]), neither within a part nor between parts.
    ///
    /// # Errors
    /// [`FormatError`], as for [`MeshSolid::of`], except for overlaps.
    pub fn unchecked(
        mut contents: MeshContents,
        path: &Path,
        format: MeshFormat,
        unit: Option<f64>,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, FormatError> {
        let (solids, joined) = solids(&contents.parts, false, goes_on)
            .map_err(|unsound| open_or_unsound(&contents, unsound, path, goes_on))?;
        contents.findings.extend(joined);
        Self::of_solids(contents, solids, path, format, unit)
    }

    /// Returns the solids of contents whose solids are already known, in the file's unit.
    ///
    /// # Errors
    /// [`FormatError`] for an invalid unit, or if a volume in metres overflows.
    pub fn of_solids(
        contents: MeshContents,
        solids: Vec<SolidPart>,
        path: &Path,
        format: MeshFormat,
        unit: Option<f64>,
    ) -> Result<Self, FormatError> {
        if let Some(value) = unit.filter(|unit| !(*unit > 0.0 && unit.is_finite())) {
            let error = BodyError::Parameter { what: "the mesh's unit", value, rule: "positive and finite" };
            return Err(FormatError::new(path, None, FormatErrorKind::Body(error)));
        }
        let triangles = contents.triangles();
        let contents = contents.in_metres(unit);
        let unit = contents.unit.unwrap_or(1.0);
        let in_metres = |SolidPart { name, mesh }: SolidPart| match mesh.scaled(unit) {
            Ok(mesh) => Ok(SolidPart { name, mesh }),
            Err(error) => Err(no_solid(path, &name, error)),
        };
        let parts = solids.into_iter().map(in_metres).collect::<Result<Vec<_>, _>>()?;
        let mut findings = contents.findings;
        findings.extend(overlap(&contents.parts, &parts));
        for part in &parts {
            let place = (!part.name.is_empty()).then(|| format!("part \"{}\"", escaped(&part.name)));
            findings.extend(part.mesh.findings().iter().map(|finding| Finding {
                place: finding.place.clone().or_else(|| place.clone()),
                ..finding.clone()
            }));
        }
        Ok(Self {
            format,
            encoding: contents.encoding,
            name: contents.name,
            unit,
            triangles,
            parts,
            findings,
        })
    }

    /// Returns the findings, each with the name of the file.
    pub fn findings_in(&self, file: &str) -> Vec<Finding> {
        let file = escaped(file);
        let place = |own: &Option<String>| match own {
            Some(own) => format!("{file}, {own}"),
            None => file.clone(),
        };
        self.findings.iter().map(|f| Finding { place: Some(place(&f.place)), ..f.clone() }).collect()
    }
}

/// Returns the error for a part that does not bound a solid.
pub(crate) fn no_solid(path: &Path, part: &str, error: BodyError) -> FormatError {
    let part = (!part.is_empty()).then(|| escaped(part));
    FormatError::new(path, None, FormatErrorKind::Mesh { part, error })
}

/// Returns the error for one of the parts. It suggests the weld or fill that closes an open mesh,
/// or the union of overlapping parts.
fn open_or_unsound(
    contents: &MeshContents,
    Unsound { part, flaws }: Unsound,
    path: &Path,
    goes_on: &(dyn Fn() -> bool + Sync),
) -> FormatError {
    let is_open = matches!(flaws.first, BodyError::OpenMesh { .. });
    let all = joined(&contents.parts).ok();
    let union = all.as_ref().and_then(|all| union_hint::hint(all, &flaws, goes_on));
    let name = contents.parts.get(part).map_or("", |part| &part.name);
    let error = no_solid(path, name, flaws.first);
    if let Some(union) = union {
        return error.with_hint(union);
    }
    let Some(all) = all.filter(|_| is_open) else { return error };
    const ELSE: &str = "or use its convex hull by --hull, or a shell along it by --shell";
    if let Some(weld) = all.closing_weld(goes_on) {
        return error.with_hint(format!(
            "it closes if vertices are welded within {:.1e} of its size: --weld {:e} ({} vertices become {}), or weld = {:e} in a scenario; {ELSE}",
            weld.least, weld.tolerance, weld.joined, weld.points, weld.tolerance
        ));
    }
    let fill = all.closing_fill(goes_on).filter(|fill| {
        let filled = contents.clone().filled(MeshLength::OfSize(fill.size), None, path);
        filled.is_ok_and(|(filled, _)| solids(&filled.parts, true, goes_on).is_ok())
    });
    match fill {
        Some(fill) => error.with_hint(format!(
            "it closes if holes of up to {:.1e} of its size are filled: --fill {:e} ({}, {}), or fill = {:e} in a scenario; {ELSE}",
            fill.largest,
            fill.size,
            counted(fill.holes, "hole"),
            counted(fill.triangles, "triangle"),
            fill.size
        )),
        None => match bounded_share(contents, path, goes_on) {
            Some(share) => error.with_hint(format!(
                "close the surface in the tool that made it; or `polhode inertia` with --close-within {} closes its holes and reports values with bounds, with --hull uses its convex hull, with --shell a sheet along it",
                percent_above(share)
            )),
            None => error,
        },
    }
}

/// Returns the share of the volume to which closing all holes bounds the volume, if it is at most
/// one half.
fn bounded_share(contents: &MeshContents, path: &Path, goes_on: &(dyn Fn() -> bool + Sync)) -> Option<f64> {
    if !goes_on() {
        return None;
    }
    let (capped, closure) = contents.clone().capped(path, goes_on).ok()?;
    let (solids, _) = solids(&capped.parts, true, goes_on).ok()?;
    if closure.crossing(&capped.parts, &solids, 1.0).is_some() {
        return None;
    }
    let volume: f64 = solids.iter().map(|solid| solid.mesh.volume()).sum();
    Some(closure.share(volume, 0.0)).filter(|share| *share <= Share::MOST)
}

/// First part that does not bound a solid, with its flaws.
struct Unsound {
    part: usize,
    flaws: Box<MeshFlaws>,
}

/// Returns the solid of each part, or of all parts together; otherwise the part that is not a
/// solid. Intersections are searched only if `is_checked`.
fn solids(
    parts: &[MeshPart],
    is_checked: bool,
    goes_on: &(dyn Fn() -> bool + Sync),
) -> Result<(Vec<SolidPart>, Option<Finding>), Unsound> {
    let solid = |mesh: &TriangleMesh| match is_checked {
        true => ClosedMesh::or_flaws(mesh, 0, goes_on).map(|(solid, _)| solid),
        false => ClosedMesh::unchecked(mesh, goes_on),
    };
    let mut solids = Vec::new();
    for (part, MeshPart { name, mesh }) in parts.iter().enumerate() {
        match solid(mesh) {
            Ok(mesh) => solids.push(SolidPart { name: name.clone(), mesh }),
            Err(flaws) => {
                // The part may be a piece of a larger surface.
                let one =
                    if parts.len() > 1 { joined(parts).ok().and_then(|all| solid(&all).ok()) } else { None };
                let Some(mesh) = one else { return Err(Unsound { part, flaws }) };
                let message = format!("the {} parts of the file together enclose one solid", parts.len());
                let part = SolidPart { name: String::new(), mesh };
                return Ok((vec![part], Some(info("mesh.joined", message))));
            }
        }
    }
    Ok((solids, None))
}

/// Reports parts that intersect or contain each other. Their common volume counts for each of them.
fn overlap(parts: &[MeshPart], solids: &[SolidPart]) -> Option<Finding> {
    let is_unsearched = |solid: &SolidPart| solid.mesh.diagnosis().unsearched;
    if parts.len() < 2 || solids.len() < 2 || solids.iter().any(is_unsearched) {
        return None;
    }
    // A part that was reversed is a solid like the others, not a cavity in them.
    let outward = solids.iter().zip(parts).map(|(solid, part)| MeshPart {
        name: String::new(),
        mesh: if solid.mesh.inverted() { solid.mesh.surface().clone() } else { part.mesh.clone() },
    });
    let error = joined(&outward.collect::<Vec<_>>()).and_then(|all| ClosedMesh::of(&all)).err()?;
    let say = |message: String| warning("mesh.parts_overlap", message);
    if matches!(error, BodyError::OverlapsUndecided { .. }) {
        return Some(say(error.to_string()));
    }
    let twice = matches!(
        error,
        BodyError::OverlappingMesh { .. }
            | BodyError::NestedSolid { .. }
            | BodyError::DuplicateTriangle { .. }
    );
    twice.then(|| {
        say(format!(
            "regions shared by several parts count once per part, unless united by --union: {error} (triangles are numbered through all parts)"
        ))
    })
}

/// Combines the triangles of all parts in one mesh.
pub(crate) fn joined<'a>(parts: impl IntoIterator<Item = &'a MeshPart>) -> Result<TriangleMesh, BodyError> {
    parts.into_iter().try_fold(TriangleMesh::default(), |all, part| all.joined(&part.mesh))
}
