//! Inspection of a mesh: all its errors and their places.
//!
//! The mesh is read as a scenario reads it, with all parts of the file as one surface. The findings
//! are those of the core and of `polhode inertia`, which stops at the first error. Numbers in
//! messages are in the file's unit; places are in metres.

use std::borrow::Cow;
use std::collections::BTreeSet;

use polhode::body::mesh::{
    ClosedMesh, ComponentRole, EdgePlace, MeshDiagnosis, MeshFlaws, MeshPlaces, PairPlace, Triangle,
    TriangleMesh, TrianglePlace,
};
use polhode::body::{BodyError, Finding, Severity};
use polhode_scenario::report::display::decimated;
use polhode_shape::mesh::MeshContents;
use serde::Serialize;

use crate::part_names::PartNames;
use crate::rows::{Row, Rows};

/// Maximum number of places that a finding marks.
pub(crate) const MARKS: usize = 20_000;

/// Maximum number of triangles shown. A mesh with more is made coarser.
const SHOWN: usize = 300_000;

/// Maximum number of findings listed.
const LISTED: usize = 200;

/// Inspection of a mesh: `MeshInspection` of `viewer/src/live/protocol.ts`.
#[derive(Debug, Serialize)]
pub struct MeshInspection {
    name: String,
    /// Coordinates as f32, m.
    vertices: Row,
    /// Vertex indices as u32.
    triangles: Row,
    /// Number of triangles in the file.
    of: usize,
    findings: Vec<MeshFinding>,
    /// Numbers of all rows.
    #[serde(skip)]
    rows: Vec<u8>,
}

#[derive(Debug, Serialize)]
struct MeshFinding {
    code: &'static str,
    severity: &'static str,
    message: String,
    /// Advice for a fix.
    hint: Option<&'static str>,
    /// Marked edges as pairs of points, f32, m.
    edges: Row,
    /// Marked triangles as three corners each, f32, m.
    faces: Row,
}

impl MeshInspection {
    /// Returns the rows of numbers that follow the JSON, little-endian f32 and u32.
    pub fn rows(&self) -> &[u8] {
        &self.rows
    }

    /// Inspects the contents of a file as one part, with its flaws; `unit` is in metres.
    pub(crate) fn of(
        name: &str,
        contents: &MeshContents,
        parts: &PartNames,
        flaws: &MeshFlaws,
        unit: f64,
    ) -> Self {
        let mut findings = wrong(flaws, parts);
        findings.extend(contents.findings.iter().cloned().map(Marked::unmarked));
        if let Some(count) = parts.several() {
            findings.push(Marked::remark(
                "mesh.joined",
                format!("the {count} parts of the file are treated as one surface: triangles are numbered through all parts"),
            ));
        }
        findings.extend(assumed(contents, unit));
        Self::shown(name, &flaws.surface, contents.triangles(), findings, unit)
    }

    /// Inspects the contents of a file as one part that bounds a solid.
    pub(crate) fn of_solid(
        name: &str,
        contents: &MeshContents,
        (solid, places): (&ClosedMesh, &MeshPlaces),
        surface: &TriangleMesh,
        unit: f64,
    ) -> Self {
        let diagnosis = solid.diagnosis();
        let at = Places { diagnosis, places, surface };
        let mut findings: Vec<_> =
            diagnosis.findings().into_iter().map(|finding| at.of_finding(finding)).collect();
        findings.extend(contents.findings.iter().cloned().map(Marked::unmarked));
        findings.extend(assumed(contents, unit));
        Self::shown(name, surface, contents.triangles(), findings, unit)
    }

    fn shown(name: &str, surface: &TriangleMesh, of: usize, mut findings: Vec<Marked>, unit: f64) -> Self {
        let many = surface.triangles().len() > SHOWN;
        let shown = if many { Cow::Owned(decimated(surface, SHOWN)) } else { Cow::Borrowed(surface) };
        let (mut vertices, mut triangles) =
            (shown.coordinates().as_flattened(), shown.triangles().as_flattened());
        let in_metres = |x: &f64| (x * unit) as f32;
        if !vertices.iter().all(|x| in_metres(x).is_finite()) {
            (vertices, triangles) = (&[], &[]);
        }
        if triangles.is_empty() {
            findings.push(Marked::remark(
                "mesh.not_shown",
                "the mesh is not shown: its size is zero or beyond single precision".to_owned(),
            ));
        }
        findings.sort_by_key(|found| rank(found.finding.severity));
        if findings.len() > LISTED {
            let all = findings.len();
            findings.truncate(LISTED);
            findings.push(Marked::remark("mesh.more", format!("{LISTED} of {all} findings are listed")));
        }
        let mut rows = Rows::default();
        Self {
            name: name.to_owned(),
            vertices: rows.f32s(vertices.iter().map(in_metres)),
            triangles: rows.u32s(triangles.iter().copied()),
            of,
            findings: findings.iter().map(|found| found.in_metres(unit, &mut rows)).collect(),
            rows: rows.into_bytes(),
        }
    }
}

/// A finding and its marked places, in the file's unit.
#[derive(Debug)]
struct Marked {
    finding: Finding,
    hint: Option<&'static str>,
    edges: Vec<[[f64; 3]; 2]>,
    faces: Vec<Triangle>,
}

impl Marked {
    fn unmarked(finding: Finding) -> Self {
        let hint = hint(finding.code);
        Self { finding, hint, edges: Vec::new(), faces: Vec::new() }
    }

    fn remark(code: &'static str, message: String) -> Self {
        Self::unmarked(Finding { code, severity: Severity::Info, message, place: None })
    }

    /// Marks edges; `of` is their total number.
    fn edges(mut self, places: &[EdgePlace], of: usize) -> Self {
        self.edges.extend(places.iter().take(MARKS).map(|place| place.ends));
        let marked = self.edges.len();
        self.says_how_many(marked, of, "edges")
    }

    /// Marks triangles; `of` is their total number.
    fn triangles(mut self, places: &[TrianglePlace], of: usize) -> Self {
        self.faces.extend(places.iter().take(MARKS).map(|place| place.corners));
        let marked = self.faces.len();
        self.says_how_many(marked, of, "triangles")
    }

    /// Marks both triangles of each pair; `of` is the total number of pairs.
    fn pairs(mut self, pairs: &[PairPlace], of: usize, mesh: &TriangleMesh) -> Self {
        let mut numbers = BTreeSet::new();
        let mut marked = 0;
        for pair in pairs {
            if numbers.len() + 2 > MARKS {
                break;
            }
            numbers.extend(pair.triangles);
            marked += 1;
        }
        self.faces.extend(numbers.into_iter().filter_map(|number| corners(mesh, number)));
        self.says_how_many(marked, of, "pairs")
    }

    fn says_how_many(mut self, marked: usize, of: usize, what: &str) -> Self {
        if marked < of {
            // The number of pairs is incomplete above this limit.
            let of = if of > 10_000 && what == "pairs" { "all".to_owned() } else { format!("{of}") };
            self.finding.message += &format!("; {marked} {what} of {of} are marked");
        }
        self
    }

    fn in_metres(&self, unit: f64, rows: &mut Rows) -> MeshFinding {
        let mut metres = |points: &[[f64; 3]], size: usize| {
            let points: Vec<f32> = points.as_flattened().iter().map(|x| (x * unit) as f32).collect();
            let whole = points.chunks(size).filter(|mark| mark.iter().all(|x| x.is_finite()));
            rows.f32s(whole.flatten().copied().collect::<Vec<_>>().into_iter())
        };
        let Finding { code, severity, message, place } = &self.finding;
        MeshFinding {
            code,
            severity: severity.name(),
            hint: self.hint,
            message: match place {
                Some(place) => format!("{place}: {message}"),
                None => message.clone(),
            },
            edges: metres(self.edges.as_flattened(), 6),
            faces: metres(self.faces.as_flattened(), 9),
        }
    }
}

const fn rank(severity: Severity) -> u8 {
    match severity {
        Severity::Error => 0,
        Severity::Warning => 1,
        Severity::Info => 2,
    }
}

/// Returns the corners of a triangle by its number, from 1.
fn corners(mesh: &TriangleMesh, number: usize) -> Option<Triangle> {
    let corners = mesh.triangles().get(number.checked_sub(1)?)?;
    let at = |k: u32| mesh.coordinates().get(k as usize).copied();
    let [a, b, c] = corners.map(at);
    Some([a?, b?, c?])
}

/// Returns a remark if the unit, in metres, was assumed.
fn assumed(contents: &MeshContents, unit: f64) -> Option<Marked> {
    let word = if unit == 1.0 { "metres" } else { "millimetres" };
    let message = format!("the file has no unit of length: {word} are assumed from its size");
    contents.unit.is_none().then(|| Marked::remark("mesh.unit", message))
}

/// Returns the errors of a surface.
fn wrong(flaws: &MeshFlaws, parts: &PartNames) -> Vec<Marked> {
    let of_each = |error: &BodyError| {
        let message = match first_triangle(error).and_then(|triangle| parts.of_triangle(triangle)) {
            Some(part) => format!("{error}; that is in part {part:?}"),
            None => error.to_string(),
        };
        let finding = Finding { code: code(error), severity: Severity::Error, message, place: None };
        let marked = Marked { hint: error.hint(), ..Marked::unmarked(finding) };
        of_error(marked, error, flaws)
    };
    let at = Places { diagnosis: &flaws.diagnosis, places: &flaws.places, surface: &flaws.surface };
    let findings = flaws.diagnosis.findings().into_iter().map(|finding| at.of_finding(finding));
    flaws.errors().map(of_each).chain(findings).collect()
}

/// Returns the number of the first triangle in an error, from 1.
const fn first_triangle(error: &BodyError) -> Option<usize> {
    match error {
        BodyError::OpenMesh { triangle, .. }
        | BodyError::InconsistentWinding { triangle, .. }
        | BodyError::Unorientable { triangle, .. }
        | BodyError::DuplicateTriangle { first: triangle, .. }
        | BodyError::OverlappingMesh { triangles: [triangle, _], .. }
        | BodyError::NestedSolid { triangle, .. }
        | BodyError::InvertedPart { triangle, .. } => Some(*triangle),
        _ => None,
    }
}

/// Returns advice for a finding, if there is any.
fn hint(code: &str) -> Option<&'static str> {
    Some(match code {
        "mesh.flipped" => "make the normals consistent in the tool that made the mesh",
        "mesh.inverted" => "flip the normals outward in the tool that made the mesh",
        "mesh.overlap" => "unite the overlapping parts in the tool that made the mesh (boolean union)",
        "mesh.degenerate" => "merge vertices by distance in the tool that made the mesh",
        "mesh.unit" => "export it as 3MF, glTF or COLLADA, which contain the unit",
        "mesh.more" => "the worst are listed first: fix these, and save the file",
        _ => return None,
    })
}

fn of_error(marked: Marked, error: &BodyError, flaws: &MeshFlaws) -> Marked {
    let MeshFlaws { diagnosis, places, surface: mesh, .. } = flaws;
    let of_role = |marked: Marked, role: ComponentRole, places: &[TrianglePlace]| {
        let parts = diagnosis.components.iter().filter(|part| part.role == role);
        marked.triangles(places, parts.map(|part| part.triangles).sum())
    };
    match error {
        BodyError::OpenMesh { edges, .. } => marked.edges(&places.boundary, *edges),
        BodyError::Unorientable { edges, .. } | BodyError::InconsistentWinding { edges, .. } => {
            marked.edges(&[places.inconsistent.as_slice(), &places.unbalanced].concat(), *edges)
        }
        BodyError::DuplicateTriangle { count, .. } => marked.pairs(&places.duplicates, *count, mesh),
        BodyError::OverlappingMesh { pairs, .. } => marked.pairs(&places.overlaps, *pairs, mesh),
        BodyError::NestedSolid { .. } => of_role(marked, ComponentRole::InnerSolid, &places.inner_solids),
        BodyError::InvertedPart { .. } => of_role(marked, ComponentRole::Inverted, &places.inverted),
        _ => marked,
    }
}

/// Places that a diagnosis counts.
#[derive(Clone, Copy)]
struct Places<'a> {
    diagnosis: &'a MeshDiagnosis,
    places: &'a MeshPlaces,
    surface: &'a TriangleMesh,
}

impl Places<'_> {
    fn of_finding(self, finding: Finding) -> Marked {
        let Self { diagnosis, places, surface: mesh } = self;
        let marked = Marked::unmarked(finding);
        match marked.finding.code {
            "mesh.flipped" => {
                let of = diagnosis.components.iter().map(|part| part.flipped).sum();
                marked.triangles(&places.flipped, of)
            }
            // Degenerate triangles have no visible area, so their edges are marked.
            "mesh.degenerate" => {
                let side = |place: &TrianglePlace| {
                    let [a, b, c] = place.corners;
                    EdgePlace { triangle: place.triangle, ends: if a == b { [b, c] } else { [a, b] } }
                };
                let sides: Vec<EdgePlace> = places.degenerate.iter().map(side).collect();
                marked.edges(&sides, diagnosis.degenerate.count)
            }
            "mesh.overlap" => marked.pairs(&places.self_overlaps, diagnosis.self_overlaps.count, mesh),
            "mesh.touching" => {
                let pairs = [places.back_to_back.as_slice(), &places.contacts].concat();
                marked.pairs(&pairs, diagnosis.back_to_back.count + diagnosis.contacts.count, mesh)
            }
            _ => marked,
        }
    }
}

/// Returns the identifier of an error for programs, like those of findings.
const fn code(error: &BodyError) -> &'static str {
    match error {
        BodyError::Empty { .. } => "mesh.empty",
        BodyError::OpenMesh { .. } => "mesh.open",
        BodyError::Unorientable { .. } => "mesh.unorientable",
        BodyError::InconsistentWinding { .. } => "mesh.winding",
        BodyError::DuplicateTriangle { .. } => "mesh.duplicate",
        BodyError::OverlappingMesh { .. } => "mesh.parts_cross",
        BodyError::OverlapsUndecided { .. } => "mesh.undecided",
        BodyError::NestedSolid { .. } => "mesh.nested_solid",
        BodyError::InvertedPart { .. } => "mesh.inverted_part",
        BodyError::FlatMesh { .. } | BodyError::FlatPoints { .. } => "mesh.flat",
        _ => "mesh.no_solid",
    }
}
