//! A mesh that bounds no solid, and all that is wrong with it, where it is.
//!
//! The findings are the core's, in the words of `polhode inertia`, which stops at the first error; here all of them are looked for. Numbers in
//! the sentences are those of the file, places are in metres.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};
use std::fs;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use hyper::StatusCode;
use polhode::body::mesh::{
    ClosedMesh, ComponentRole, EdgePlace, MeshDiagnosis, MeshPlaces, PairPlace, Triangle, TriangleMesh,
    TrianglePlace,
};
use polhode::body::{BodyError, Finding, Severity};
use polhode_formats::mesh::{MeshContents, MeshFormat, MeshPart};
use polhode_report::display::{decimated, f32s, u32s};
use serde::Serialize;

use crate::answer::Refusal;
use crate::documents::Document;
use crate::limits;
use crate::opened::assumed_unit;

/// Places that a finding marks.
const MARKS: usize = 20_000;

/// Triangles that are shown; of more, as many as look the same.
const SHOWN: usize = 300_000;

/// Findings that are listed.
const LISTED: usize = 200;

#[derive(Debug, Serialize)]
pub(crate) struct MeshInspection {
    name: String,
    /// f32, base64, m.
    vertices: String,
    /// u32, base64.
    triangles: String,
    /// How many the file has.
    of: usize,
    findings: Vec<MeshFinding>,
}

#[derive(Debug, Serialize)]
struct MeshFinding {
    code: &'static str,
    severity: &'static str,
    message: String,
    /// f32, base64, m: pairs of points.
    edges: String,
    /// f32, base64, m: three corners each.
    faces: String,
}

impl MeshInspection {
    /// Of the document's file as it is now; `stop` ends it between parts.
    pub(crate) fn of(document: &Document, stop: &AtomicBool) -> Result<Self, Refusal> {
        let unreadable = |why: String| {
            let message = format!("{:?} cannot be read: {why}", document.name);
            Refusal::new(StatusCode::UNPROCESSABLE_ENTITY, message)
        };
        let format =
            MeshFormat::of_path(&document.path).ok_or_else(|| unreadable("it is no mesh".to_owned()))?;
        let bytes = fs::read(&document.path).map_err(|error| unreadable(error.to_string()))?;
        let contents = MeshContents::parse(&bytes, &document.path, format)
            .map_err(|error| unreadable(error.message()))?;
        drop(bytes);
        let unit = contents.unit.unwrap_or_else(|| assumed_unit(&contents));
        let mut findings = found(&contents, stop)?;
        findings.extend(contents.findings.iter().cloned().map(Marked::unmarked));
        if contents.unit.is_none() {
            let word = if unit == 1.0 { "metres" } else { "millimetres" };
            findings.push(Marked::remark(
                "mesh.unit",
                format!("the file does not say its unit of length: {word} are taken by its size"),
            ));
        }
        let of = contents.triangles();
        let shown = shown(&contents.parts, unit);
        if shown.1.is_empty() {
            findings.push(Marked::remark(
                "mesh.not_shown",
                "the mesh is not shown: it has no size, or numbers of single precision do not hold it"
                    .to_owned(),
            ));
        }
        findings.sort_by_key(|found| rank(found.finding.severity));
        if findings.len() > LISTED {
            let all = findings.len();
            findings.truncate(LISTED);
            findings.push(Marked::remark("mesh.more", format!("{LISTED} of {all} findings are listed")));
        }
        Ok(Self {
            name: document.name.clone(),
            vertices: f32s(shown.0.into_flattened()),
            triangles: u32s(shown.1.into_flattened()),
            of,
            findings: findings.iter().map(|found| found.in_metres(unit)).collect(),
        })
    }
}

/// A finding and what it marks, in the file's unit.
#[derive(Debug)]
struct Marked {
    finding: Finding,
    edges: Vec<[[f64; 3]; 2]>,
    faces: Vec<Triangle>,
}

impl Marked {
    const fn unmarked(finding: Finding) -> Self {
        Self { finding, edges: Vec::new(), faces: Vec::new() }
    }

    fn remark(code: &'static str, message: String) -> Self {
        Self::unmarked(Finding { code, severity: Severity::Info, message, place: None })
    }

    /// Marks edges, of so many.
    fn edges(mut self, places: &[EdgePlace], of: usize) -> Self {
        self.edges.extend(places.iter().take(MARKS).map(|place| place.ends));
        let marked = self.edges.len();
        self.says_how_many(marked, of, "edges")
    }

    /// Marks triangles, of so many.
    fn triangles(mut self, places: &[TrianglePlace], of: usize) -> Self {
        self.faces.extend(places.iter().take(MARKS).map(|place| place.corners));
        let marked = self.faces.len();
        self.says_how_many(marked, of, "triangles")
    }

    /// Marks both triangles of each pair, of so many pairs.
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
            // Pairs are not counted to their end.
            let of = if of > 10_000 && what == "pairs" { "them".to_owned() } else { format!("{of}") };
            self.finding.message += &format!("; {marked} {what} of {of} are marked");
        }
        self
    }

    fn in_metres(&self, unit: f64) -> MeshFinding {
        let metres = |points: &mut dyn Iterator<Item = [f64; 3]>, size: usize| {
            let points: Vec<f32> = points.flatten().map(|x| (x * unit) as f32).collect();
            let whole = points.chunks(size).filter(|mark| mark.iter().all(|x| x.is_finite()));
            f32s(whole.flatten().copied())
        };
        let Finding { code, severity, message, place } = &self.finding;
        MeshFinding {
            code,
            severity: severity.name(),
            message: match place {
                Some(place) => format!("{place}: {message}"),
                None => message.clone(),
            },
            edges: metres(&mut self.edges.iter().flatten().copied(), 6),
            faces: metres(&mut self.faces.iter().flatten().copied(), 9),
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

/// The corners of a triangle by its number, from 1.
fn corners(mesh: &TriangleMesh, number: usize) -> Option<Triangle> {
    let corners = mesh.triangles().get(number.checked_sub(1)?)?;
    let at = |k: u32| mesh.coordinates().get(k as usize).copied();
    let [a, b, c] = corners.map(at);
    Some([a?, b?, c?])
}

/// All that is wrong with the parts; with all of them as one surface, where that closes edges that are open in the parts.
fn found(contents: &MeshContents, stop: &AtomicBool) -> Result<Vec<Marked>, Refusal> {
    let begun = Instant::now();
    let mut all = Vec::new();
    let mut open = 0;
    for (k, MeshPart { name, mesh }) in contents.parts.iter().enumerate() {
        if stop.load(Ordering::Relaxed) {
            return Err(Refusal::new(StatusCode::REQUEST_TIMEOUT, "nobody waits for the answer"));
        }
        if begun.elapsed() > limits::INSPECTION {
            let seconds = limits::INSPECTION.as_secs();
            let message = format!("{k} of {} parts were looked at in {seconds} s", contents.parts.len());
            all.push(Marked::remark("mesh.unfinished", message));
            return Ok(all);
        }
        let (diagnosis, places) = MeshDiagnosis::with_places(mesh, MARKS);
        open += diagnosis.boundary.count;
        all.extend(wrong(mesh, &diagnosis, &places, name));
    }
    if contents.parts.len() > 1
        && open > 0
        && let Some(one) = joined(&contents.parts)
    {
        let (diagnosis, places) = MeshDiagnosis::with_places(&one, MARKS);
        if diagnosis.boundary.count < open {
            let mut together = wrong(&one, &diagnosis, &places, "");
            let count = contents.parts.len();
            let message = format!(
                "the {count} parts of the file are taken as one surface: triangles are numbered through all of them"
            );
            together.push(Marked::remark("mesh.joined", message));
            return Ok(together);
        }
    }
    Ok(all)
}

/// What is wrong with one surface.
fn wrong(mesh: &TriangleMesh, diagnosis: &MeshDiagnosis, places: &MeshPlaces, part: &str) -> Vec<Marked> {
    let mut errors = diagnosis.errors();
    if errors.is_empty() {
        errors.extend(ClosedMesh::of(mesh).err());
    }
    let named = |finding: Finding| match part {
        "" => finding,
        part => Finding { message: format!("part {part:?}: {}", finding.message), ..finding },
    };
    let mut found: Vec<Marked> = errors
        .iter()
        .map(|error| {
            let finding = Finding {
                code: code(error),
                severity: Severity::Error,
                message: error.to_string(),
                place: None,
            };
            of_error(Marked::unmarked(named(finding)), error, mesh, diagnosis, places)
        })
        .collect();
    let findings = diagnosis.findings().into_iter();
    found.extend(
        findings.map(|finding| of_finding(Marked::unmarked(named(finding)), mesh, diagnosis, places)),
    );
    found
}

fn of_error(
    marked: Marked,
    error: &BodyError,
    mesh: &TriangleMesh,
    diagnosis: &MeshDiagnosis,
    places: &MeshPlaces,
) -> Marked {
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

fn of_finding(marked: Marked, mesh: &TriangleMesh, diagnosis: &MeshDiagnosis, places: &MeshPlaces) -> Marked {
    match marked.finding.code {
        "mesh.flipped" => {
            let of = diagnosis.components.iter().map(|part| part.flipped).sum();
            marked.triangles(&places.flipped, of)
        }
        // They have no area to be seen.
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

/// The name of an error for programs, as those of findings are.
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
        BodyError::FlatMesh { .. } => "mesh.flat",
        _ => "mesh.no_solid",
    }
}

/// All parts as one; `None` for more vertices than can be numbered.
fn joined(parts: &[MeshPart]) -> Option<Cow<'_, TriangleMesh>> {
    match parts {
        [only] => Some(Cow::Borrowed(&only.mesh)),
        parts => {
            let joined = parts.iter().try_fold(TriangleMesh::default(), |all, part| all.joined(&part.mesh));
            joined.ok().map(Cow::Owned)
        }
    }
}

/// Vertices in metres, each once, and triangles between them; none if f32 does not hold them.
fn shown(parts: &[MeshPart], unit: f64) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let Some(mesh) = joined(parts) else { return Default::default() };
    let mesh = if mesh.triangles().len() > SHOWN { Cow::Owned(decimated(&mesh, SHOWN)) } else { mesh };
    let mut numbers: HashMap<[u32; 3], u32> = HashMap::with_capacity(mesh.triangles().len() / 2);
    let mut vertices: Vec<[f32; 3]> = Vec::new();
    let mut number = |point: [f64; 3]| {
        let vertex = point.map(|x| (x * unit) as f32 + 0.0);
        *numbers.entry(vertex.map(f32::to_bits)).or_insert_with(|| {
            vertices.push(vertex);
            (vertices.len() - 1) as u32 // fewer than the vertices of the mesh
        })
    };
    let triangles: Vec<[u32; 3]> = mesh.corners().map(|corners| corners.map(&mut number)).collect();
    let is_held = vertices.as_flattened().iter().all(|x| x.is_finite());
    if is_held { (vertices, triangles) } else { Default::default() }
}
