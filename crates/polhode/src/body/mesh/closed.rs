//! Solids bounded by triangles.

use std::collections::HashMap;

use super::component::{ComponentRole, MeshComponent};
use super::diagnosis::{Analysis, MeshDiagnosis};
use super::flaws::MeshFlaws;
use super::integral::{Integrals, Polyhedron};
use super::places::MeshPlaces;
use super::sought::Sought;
use super::threads::Threads;
use super::weld::NONE;
use super::work::GoesOn;
use super::{Triangle, TriangleMesh};
use crate::body::error::{BodyError, counted, positive};
use crate::body::finding::{Finding, Severity};
use crate::body::form::Form;
use crate::body::shape::{Shape, Spread};

/// Solid bounded by triangles: closed, consistently oriented, with outward normals.
///
/// [`ClosedMesh::of`] constructs it and returns an error for any other mesh. Corners are the same
/// vertex if their coordinates are exactly equal.
///
/// Corrections, reported by [`ClosedMesh::findings`]:
///
/// | code | correction |
/// |---|---|
/// | `mesh.inverted` | all normals pointed inward: all triangles are reversed |
/// | `mesh.flipped` | a clear minority of a component's triangles is reversed |
/// | `mesh.degenerate` | triangles with two equal corners are omitted |
///
/// Remarks without correction:
///
/// - `mesh.cavity`: an inward-oriented shell inside a solid is subtracted;
/// - `mesh.components`: the mesh has several parts;
/// - `mesh.touching`: parts or folds touch back to back;
/// - `mesh.overlap`: a part intersects itself (a warning: volume enclosed twice counts twice);
/// - `mesh.unchecked`: intersections were not searched ([`ClosedMesh::unchecked`]).
///
/// Errors:
///
/// - an *outward*-oriented shell inside a solid, which may be a cavity with wrong orientation or a
///   solid that counts twice ([`BodyError::NestedSolid`]);
/// - parts that intersect each other ([`BodyError::OverlappingMesh`]);
/// - inward-oriented parts next to outward-oriented ones ([`BodyError::InvertedPart`]);
/// - open, one-sided or flat meshes, and duplicate triangles;
/// - too many triangles close together to decide this ([`BodyError::OverlapsUndecided`]).
///
/// ```
/// use polhode::body::mesh::ClosedMesh;
/// use polhode::body::shape::{Shape, Substance};
/// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
/// let corner = ClosedMesh::from_triangles(vec![[o, y, x], [o, x, z], [o, z, y], [x, y, z]])?;
/// assert_eq!(corner.volume(), 1.0);
/// let body = corner.mass_properties(Substance::Density(4.0))?;
/// assert!((body.center_of_mass() - polhode::math::Position::new(0.5, 0.75, 0.25)).norm() < 1e-15);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct ClosedMesh {
    surface: TriangleMesh,
    diagnosis: MeshDiagnosis,
    findings: Vec<Finding>,
    inverted: bool,
    integrals: Integrals,
}

impl ClosedMesh {
    /// Returns the solid that the mesh bounds. For a large mesh it uses all threads of the machine;
    /// the result does not depend on their number.
    ///
    /// # Errors
    /// [`BodyError::Empty`], [`BodyError::OpenMesh`], [`BodyError::Unorientable`],
    /// [`BodyError::InconsistentWinding`], [`BodyError::DuplicateTriangle`],
    /// [`BodyError::NestedSolid`], [`BodyError::InvertedPart`], [`BodyError::OverlappingMesh`],
    /// [`BodyError::OverlapsUndecided`] or [`BodyError::FlatMesh`]; [`BodyError::Parameter`] if the
    /// volume overflows f64.
    pub fn of(mesh: &TriangleMesh) -> Result<Self, BodyError> {
        Self::watched(mesh, &|| true)
    }

    /// Works like [`ClosedMesh::of`] while `goes_on` returns true. It is called often; when it
    /// returns false, the checks that remain are undecided.
    ///
    /// # Errors
    /// The errors of [`ClosedMesh::of`].
    pub fn watched(mesh: &TriangleMesh, goes_on: &(dyn Fn() -> bool + Sync)) -> Result<Self, BodyError> {
        Self::on(mesh, Sought::All, Threads::for_triangles(mesh.triangles.len()), 0, goes_on)
            .map(|(solid, _)| solid)
            .map_err(|flaws| flaws.first)
    }

    /// Works like [`ClosedMesh::of`] on at most `threads` threads.
    ///
    /// # Errors
    /// The errors of [`ClosedMesh::of`].
    pub fn with_threads(mesh: &TriangleMesh, threads: usize) -> Result<Self, BodyError> {
        Self::on(mesh, Sought::All, Threads::of(threads), 0, &|| true)
            .map(|(solid, _)| solid)
            .map_err(|flaws| flaws.first)
    }

    /// Returns the same solid or error as [`ClosedMesh::of`], without the search for remarks: for a
    /// mesh of one part, self-intersections and contacts are not searched. It continues while
    /// `goes_on` returns true.
    ///
    /// # Errors
    /// The errors of [`ClosedMesh::of`], except for overlaps that only the search for remarks would
    /// leave undecided.
    pub fn without_remarks(
        mesh: &TriangleMesh,
        threads: usize,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, BodyError> {
        Self::on(mesh, Sought::FirstError, Threads::of(threads), 0, goes_on)
            .map(|(solid, _)| solid)
            .map_err(|flaws| flaws.first)
    }

    /// Returns the solid that triangles without indices bound, as in STL, like [`ClosedMesh::of`].
    ///
    /// # Errors
    /// [`BodyError::Vertex`] for a vertex that is not finite, and the errors of [`ClosedMesh::of`].
    pub fn from_triangles(triangles: Vec<Triangle>) -> Result<Self, BodyError> {
        Self::of(&TriangleMesh::of_soup(triangles)?)
    }

    /// Works like [`ClosedMesh::watched`] and also returns the places of corrections and remarks.
    /// If the mesh bounds no solid, it returns all errors and their places. At most `most` places
    /// of each kind are returned.
    ///
    /// # Errors
    /// [`MeshFlaws`], whose first error is that of [`ClosedMesh::of`].
    pub fn or_flaws(
        mesh: &TriangleMesh,
        most: usize,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<(Self, MeshPlaces), Box<MeshFlaws>> {
        Self::on(mesh, Sought::All, Threads::for_triangles(mesh.triangles.len()), most, goes_on)
    }

    /// Works like [`ClosedMesh::watched`], but does not search for triangles that intersect each
    /// other. It checks that edges match in pairs, orientations, and which parts lie in others. A
    /// finding, `mesh.unchecked`, says so.
    ///
    /// Use it for meshes that were checked before, or that are sound by construction: a volume that
    /// the surface encloses twice counts twice.
    ///
    /// # Errors
    /// [`MeshFlaws`], whose first error is one of [`ClosedMesh::of`], except for overlaps.
    ///
    /// ```
    /// use polhode::body::mesh::{ClosedMesh, TriangleMesh};
    /// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
    /// let mesh = TriangleMesh::of_triangles(&[[o, y, x], [o, x, z], [o, z, y], [x, y, z]])?;
    /// let corner = ClosedMesh::unchecked(&mesh, &|| true).map_err(|flaws| flaws.first)?;
    /// assert_eq!((corner.volume(), corner.findings()[0].code), (1.0, "mesh.unchecked"));
    /// # Ok::<(), polhode::body::BodyError>(())
    /// ```
    pub fn unchecked(
        mesh: &TriangleMesh,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, Box<MeshFlaws>> {
        let threads = Threads::for_triangles(mesh.triangles.len());
        Self::on(mesh, Sought::NoIntersections, threads, 0, goes_on).map(|(solid, _)| solid)
    }

    fn on(
        mesh: &TriangleMesh,
        sought: Sought,
        threads: Threads,
        most: usize,
        goes_on: &GoesOn<'_>,
    ) -> Result<(Self, MeshPlaces), Box<MeshFlaws>> {
        let analysis = Analysis::of(mesh, sought, threads, goes_on);
        let places = MeshPlaces::of(&analysis, most);
        let Analysis { welded, patches, diagnosis, .. } = analysis;
        let mut vertices = welded.points;
        vertices.as_flattened_mut().iter_mut().for_each(|c| *c *= welded.unit);
        let mut surface = TriangleMesh { vertices, triangles: welded.corners, is_hull: mesh.is_hull };
        let mut errors = diagnosis.errors().into_iter();
        if let Some(first) = errors.next() {
            return Err(Box::new(MeshFlaws { first, others: errors.collect(), diagnosis, places, surface }));
        }
        let inverted = is_inverted(&diagnosis);
        let given = surface.triangles.iter().enumerate();
        let proper = given.filter(|(t, _)| patches.component[*t] != NONE);
        let turned =
            proper.map(|(t, &[a, b, c])| if patches.against[t] == inverted { [a, b, c] } else { [a, c, b] });
        let mut triangles = Vec::with_capacity(surface.triangles.len());
        triangles.extend(turned);
        let given = core::mem::replace(&mut surface.triangles, triangles);
        match measured(&surface, threads) {
            Ok(integrals) => {
                let findings = findings(&diagnosis, inverted);
                Ok((Self { surface, diagnosis, findings, inverted, integrals }, places))
            }
            Err(first) => {
                surface.triangles = given;
                Err(Box::new(MeshFlaws { first, others: Vec::new(), diagnosis, places, surface }))
            }
        }
    }

    /// Returns the mesh in another unit of length: every coordinate is multiplied by a positive
    /// `factor`. The diagnosis is not repeated, because rounding changes each coordinate by at most
    /// one unit in its last place.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] for a factor that is not positive and finite, or if the scaled
    /// volume overflows f64.
    pub fn scaled(self, factor: f64) -> Result<Self, BodyError> {
        let factor = positive("the factor of a mesh", factor)?;
        if factor == 1.0 {
            return Ok(self);
        }
        let surface = self.surface.scaled(factor);
        let integrals = measured(&surface, Threads::for_triangles(surface.triangles.len()))?;
        let diagnosis = self.diagnosis.scaled(factor);
        let findings = findings(&diagnosis, self.inverted);
        Ok(Self { surface, diagnosis, findings, integrals, ..self })
    }

    /// Returns the surface: each vertex once, normals outward, without degenerate triangles.
    pub const fn surface(&self) -> &TriangleMesh {
        &self.surface
    }

    /// Returns the triangles, with outward normals, without degenerate ones (two equal corners).
    pub fn triangles(&self) -> impl Iterator<Item = Triangle> + '_ {
        self.surface.corners()
    }

    /// Returns the number of distinct vertices.
    pub const fn vertices(&self) -> usize {
        self.diagnosis.vertices
    }

    /// Returns the number of degenerate triangles (two equal corners), which were omitted.
    pub const fn degenerate(&self) -> usize {
        self.diagnosis.degenerate.count
    }

    /// Returns true if all normals pointed inward and were reversed.
    pub const fn inverted(&self) -> bool {
        self.inverted
    }

    /// Returns the diagnosis of the mesh before corrections.
    pub const fn diagnosis(&self) -> &MeshDiagnosis {
        &self.diagnosis
    }

    /// Returns the corrections and remarks.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// Returns the enclosed volume, m³.
    pub const fn volume(&self) -> f64 {
        self.integrals.spread.extent.measure()
    }

    /// Low word of the centroid (double-double), m.
    pub(super) const fn centroid_rest(&self) -> [f64; 3] {
        self.integrals.centroid_rest
    }

    /// Returns the index of the vertex of [`ClosedMesh::surface`] with exactly the coordinates of
    /// each point, or `None` if such a vertex does not exist.
    pub fn vertex_numbers(&self, points: &[[f64; 3]]) -> Vec<Option<u32>> {
        let bits = |point: &[f64; 3]| point.map(|c| (c + 0.0).to_bits()); // −0 is 0
        let numbers: HashMap<_, _> = self.surface.vertices.iter().map(bits).zip(0..).collect();
        points.iter().map(|point| numbers.get(&bits(point)).copied()).collect()
    }
}

impl Shape for ClosedMesh {
    fn spread(&self) -> Spread {
        self.integrals.spread
    }

    /// Returns the area of all triangles, m².
    fn surface_area(&self) -> f64 {
        self.integrals.area
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Mesh(self.surface.clone()))
    }
}

/// Computes volume, moments and area of a closed mesh with outward normals.
fn measured(surface: &TriangleMesh, threads: Threads) -> Result<Integrals, BodyError> {
    let polyhedron = Polyhedron { points: &surface.vertices, corners: &surface.triangles, threads };
    let integrals = polyhedron.integrate()?;
    let volume = integrals.spread.extent.measure();
    if volume < 0.0 {
        // The sign of a part with nearly zero volume may be wrong.
        return Err(BodyError::FlatMesh { volume });
    }
    integrals.spread.representable()?;
    Ok(integrals)
}

impl MeshDiagnosis {
    /// Returns all reasons why the mesh bounds no solid. The first is the error of
    /// [`ClosedMesh::of`]. Only [`ClosedMesh::of`] detects a closed mesh that encloses no volume.
    pub fn errors(&self) -> Vec<BodyError> {
        let mut errors = Vec::new();
        if let Some(pair) = self.duplicates.first {
            let [first, second] = pair.triangles;
            errors.push(BodyError::DuplicateTriangle { first, second, count: self.duplicates.count });
        }
        if let Some(edge) = self.boundary.first {
            errors.push(BodyError::OpenMesh {
                edges: self.boundary.count,
                loops: self.boundary_loops,
                example: edge.ends,
                triangle: edge.triangle,
            });
        }
        if errors.is_empty() && self.components.is_empty() {
            return vec![BodyError::Empty { what: "triangles" }];
        }
        errors.extend(self.winding_error());
        if let Some(steps) = self.undecided {
            errors.push(BodyError::OverlapsUndecided { triangles: self.triangles, steps });
            return errors;
        }
        if let Some(pair) = self.overlaps.first {
            errors.push(BodyError::OverlappingMesh {
                pairs: self.overlaps.count,
                triangles: pair.triangles,
                point: pair.point,
            });
        }
        // After reversing the whole mesh, an outward-oriented part inside a solid is a cavity.
        if is_inverted(self) {
            return errors;
        }
        if let Some((parts, MeshComponent { first_triangle: triangle, volume, .. })) =
            self.parts(ComponentRole::InnerSolid)
        {
            errors.push(BodyError::NestedSolid { parts, triangle: *triangle, volume: *volume });
        }
        if let Some((parts, MeshComponent { first_triangle: triangle, volume, .. })) =
            self.parts(ComponentRole::Inverted)
        {
            errors.push(BodyError::InvertedPart { parts, triangle: *triangle, volume: *volume });
        }
        errors
    }

    /// Returns the corrections and remarks for a mesh that bounds a solid, as in
    /// [`ClosedMesh::findings`].
    pub fn findings(&self) -> Vec<Finding> {
        findings(self, is_inverted(self))
    }

    fn winding_error(&self) -> Option<BodyError> {
        let has = |role: ComponentRole| self.components.iter().any(|component| component.role == role);
        // Without a boundary, a component is open if it has an edge with an odd number of
        // triangles.
        let is_unsound = [ComponentRole::Unorientable, ComponentRole::Inconsistent, ComponentRole::Open];
        let edge = self.inconsistent.first.or(self.unbalanced.first)?;
        if !is_unsound.into_iter().any(has) {
            return None;
        }
        let (example, triangle) = (edge.ends, edge.triangle);
        let edges = self.inconsistent.count + self.unbalanced.count;
        Some(if has(ComponentRole::Unorientable) {
            BodyError::Unorientable { edges, example, triangle }
        } else {
            BodyError::InconsistentWinding { edges, example, triangle }
        })
    }

    /// Returns the number of components with a role, and the first of them.
    fn parts(&self, role: ComponentRole) -> Option<(usize, &MeshComponent)> {
        let mut parts = self.components.iter().filter(|component| component.role == role);
        parts.next().map(|first| (1 + parts.count(), first))
    }
}

/// Returns true if the whole mesh is oriented inward.
fn is_inverted(diagnosis: &MeshDiagnosis) -> bool {
    let has = |role| diagnosis.parts(role).is_some();
    has(ComponentRole::Inverted) && !has(ComponentRole::Solid) && !has(ComponentRole::Cavity)
}

/// Returns the corrections and remarks.
fn findings(diagnosis: &MeshDiagnosis, inverted: bool) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut say = |code, severity, message: String, triangle: Option<usize>| {
        let place = triangle.map(|t| format!("triangle {t}"));
        findings.push(Finding { code, severity, message, place });
    };
    let total = diagnosis.triangles;
    if inverted {
        let message = "the normals of the mesh pointed inward and were turned".to_owned();
        say("mesh.inverted", Severity::Warning, message, None);
    }
    let flipped: usize = diagnosis.components.iter().map(|component| component.flipped).sum();
    if let Some(first) = diagnosis.components.iter().filter_map(|c| c.first_flipped).min() {
        let was = if flipped == 1 { "was" } else { "were" };
        let message =
            format!("{flipped} of {total} triangles {was} wound against the others and {was} turned");
        say("mesh.flipped", Severity::Warning, message, Some(first));
    }
    if let Some(first) = diagnosis.degenerate.first {
        let count = diagnosis.degenerate.count;
        let [has, was] = if count == 1 { ["has", "was"] } else { ["have", "were"] };
        let message = format!("{count} of {total} triangles {has} two equal corners and {was} left out");
        say("mesh.degenerate", Severity::Info, message, Some(first.triangle));
    }
    if let Some(pair) = diagnosis.self_overlaps.first {
        let message = format!(
            "the surface goes through itself at {} of triangles, first triangles {} and {} at {:?}: \
             what it encloses twice counts twice",
            counted(diagnosis.self_overlaps.count),
            pair.triangles[0],
            pair.triangles[1],
            pair.point
        );
        say("mesh.overlap", Severity::Warning, message, Some(pair.triangles[0]));
    }
    // In an inverted mesh the cavities are the outward-oriented parts.
    let role = if inverted { ComponentRole::InnerSolid } else { ComponentRole::Cavity };
    let cavities: Vec<&MeshComponent> = diagnosis.components.iter().filter(|c| c.role == role).collect();
    if let Some(first) = cavities.first() {
        let volume: f64 = cavities.iter().map(|cavity| cavity.volume.abs()).sum();
        let noun = if cavities.len() == 1 { "cavity" } else { "cavities" };
        let message = format!("{} {noun} of {volume:e} m³ in all: subtracted", cavities.len());
        say("mesh.cavity", Severity::Info, message, Some(first.first_triangle));
    }
    let parts = diagnosis.components.len() - cavities.len();
    if parts > 1 {
        let message = format!("{parts} separate parts, taken as one body");
        say("mesh.components", Severity::Info, message, None);
    }
    let touching = diagnosis.back_to_back.count + diagnosis.contacts.count;
    if let Some(pair) = diagnosis.back_to_back.first.or(diagnosis.contacts.first) {
        let message = format!("{} of triangles lie on each other, back to back", counted(touching));
        say("mesh.touching", Severity::Info, message, Some(pair.triangles[0]));
    }
    if diagnosis.unsearched {
        let message = "not checked for self-intersections: what the surface encloses twice counts twice";
        say("mesh.unchecked", Severity::Info, message.to_owned(), None);
    }
    findings
}
