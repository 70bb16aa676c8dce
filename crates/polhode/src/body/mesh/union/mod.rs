//! Union of the parts of a mesh, in which each region counts once.
//!
//! The union is the region where the mesh's winding number is 1 or more. Its boundary consists of
//! the pieces of triangles with such a number on their inner side and not on their outer side. It
//! is not built as a mesh, because the integrals need only the pieces, one triangle at a time.
//!
//! 1. A triangle that no other triangle intersects is used whole. Connected triangles of this kind
//!    have the same winding numbers on their sides, which one ray determines exactly (`contact.rs`,
//!    `boundary.rs`).
//! 2. Every other triangle is processed in its own plane (`face.rs`). The intersections of the mesh
//!    with planes just above and just below it are closed lines. Exact signs decide which edges
//!    cross the plane, so the lines are closed although their corners are rounded. The winding
//!    number at a place of the plane is the sum over the lines from far below (`region.rs`).
//! 3. Of coincident triangles in one plane, the first represents all.
//!
//! Only the positions of the lines are inexact, by a few last digits. `measure.rs` measures how
//! well the pieces fit: a surface with gaps or overlaps has different volumes along the three axes.

mod boundary;
mod contact;
mod face;
mod measure;
mod region;
mod weighted;

use super::closed::ClosedMesh;
use super::diagnosis::MeshDiagnosis;
use super::effect::MeshEffect;
use super::integral::Polyhedron;
use super::threads::Threads;
use super::work::{GoesOn, Work};
use super::{ComponentRole, TriangleMesh};
use crate::body::error::{BodyError, positive};
use crate::body::finding::{Finding, Severity};
use crate::body::form::Form;
use crate::body::shape::{Extent, Shape, Spread};
use boundary::Boundaries;
use measure::Closure;
use weighted::Weighted;

/// Union of the parts of a mesh: a region that lies in several parts, or twice in a
/// self-intersecting part, counts once.
///
/// A place belongs to the union if the winding number of the mesh is 1 or more. Solids inside
/// solids are therefore merged with them. An inward-oriented part inside a solid is a cavity,
/// unless another solid fills it. A place with negative winding number does not belong to the
/// union. If the cause is an inward-oriented part, or if the negative volume exceeds a thousandth
/// of the whole, the result is an error ([`BodyError::NegativeUnion`]). Small folds, where a
/// surface intersects itself, are omitted and added to the error estimate.
///
/// The mesh must be closed: every edge is traversed equally often in both directions. Corners are
/// the same vertex if their coordinates are exactly equal. Exact signs decide which triangles
/// intersect; the points of intersection are rounded. The effect on the volume is measured on the
/// computed surface: [`MeshUnion::error`].
///
/// ```
/// use polhode::body::mesh::{MeshUnion, Triangle, TriangleMesh};
/// use polhode::math::Position;
/// let tetrahedron = |size: f64, by: f64| {
///     let [o, x, y, z] = [[by; 3], [by + size, by, by], [by, by + size, by], [by, by, by + size]];
///     [[o, y, x], [o, x, z], [o, z, y], [x, y, z]]
/// };
/// let both: Vec<Triangle> = [tetrahedron(1.0, 0.0), tetrahedron(1.0, 0.25)].concat();
/// let union = MeshUnion::of(&TriangleMesh::of_triangles(&both)?)?;
/// let shared = 0.25_f64.powi(3) / 6.0; // a tetrahedron again
/// assert!((union.volume() - (2.0 / 6.0 - shared)).abs() < 1e-15);
/// assert!((union.shared() - shared).abs() < 1e-15 && union.error() < 1e-14);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct MeshUnion {
    spread: Spread,
    area: f64,
    parts: usize,
    shared: f64,
    left_out: f64,
    error: f64,
    /// Surface for drawing.
    surface: TriangleMesh,
    findings: Vec<Finding>,
    /// The mesh itself, if no parts overlap.
    solid: Option<Box<ClosedMesh>>,
}

impl MeshUnion {
    /// Computes the union of the parts that the mesh bounds. It uses all threads of the machine;
    /// the result does not depend on their number.
    ///
    /// # Errors
    /// The error of [`ClosedMesh::of`] if the mesh is not closed. [`BodyError::NegativeUnion`] if
    /// regions with negative winding number are too large. [`BodyError::UnionUndecided`] if too
    /// many triangles are too close together. [`BodyError::UnionUnclear`] if the pieces of the
    /// surface do not fit together to a billionth of the volume. [`BodyError::FlatMesh`] if the
    /// union has no volume. [`BodyError::Parameter`] if the volume overflows f64.
    pub fn of(mesh: &TriangleMesh) -> Result<Self, BodyError> {
        Self::watched(mesh, &|| true)
    }

    /// Works like [`MeshUnion::of`] while `goes_on` returns true. It is called often; when it
    /// returns false, the result is undecided.
    ///
    /// # Errors
    /// The errors of [`MeshUnion::of`].
    pub fn watched(mesh: &TriangleMesh, goes_on: &(dyn Fn() -> bool + Sync)) -> Result<Self, BodyError> {
        match ClosedMesh::or_flaws(mesh, 0, goes_on) {
            Ok((solid, _)) if is_apart(solid.diagnosis()) => Ok(Self::of_solid(solid)),
            Ok((solid, _)) => {
                let unclear = BodyError::UnionUnclear { volume: solid.volume(), error: solid.volume() };
                Self::found(mesh, solid.diagnosis(), unclear, goes_on)
            }
            Err(flaws) => {
                // A boundary must be reported first, even if the mesh also has duplicate triangles.
                let is_open = |error: &&BodyError| matches!(error, BodyError::OpenMesh { .. });
                let why_not = flaws.errors().find(is_open).unwrap_or(&flaws.first).clone();
                Self::found(mesh, &flaws.diagnosis, why_not, goes_on)
            }
        }
    }

    /// Returns true if a mesh is closed, so that its union can be computed.
    pub fn is_possible(diagnosis: &MeshDiagnosis) -> bool {
        let is_closed = |part: &super::MeshComponent| part.role.is_closed();
        diagnosis.boundary.is_empty()
            && diagnosis.components.iter().all(is_closed)
            && diagnosis.components.iter().any(|part| part.role != ComponentRole::Flat)
    }

    fn of_solid(solid: ClosedMesh) -> Self {
        let parts = parts(solid.diagnosis());
        Self {
            spread: solid.spread(),
            area: solid.surface_area(),
            parts,
            shared: 0.0,
            left_out: 0.0,
            error: 0.0,
            surface: solid.surface().clone(),
            findings: solid.findings().to_vec(),
            solid: Some(Box::new(solid)),
        }
    }

    /// Computes the union of a mesh with overlaps; returns `why_not` if it is not closed.
    fn found(
        mesh: &TriangleMesh,
        diagnosis: &MeshDiagnosis,
        why_not: BodyError,
        goes_on: &GoesOn<'_>,
    ) -> Result<Self, BodyError> {
        let threads = Threads::of_machine();
        let undecided = |steps| BodyError::UnionUndecided { triangles: diagnosis.triangles, steps };
        let inward = diagnosis.components.iter().map(|part| part.volume).sum::<f64>() < 0.0;
        let Some(weighted) =
            Self::is_possible(diagnosis).then(|| Weighted::of(mesh, inward, threads)).flatten()
        else {
            return Err(why_not);
        };
        let work = Work::of(STEPS + STEPS_EACH * diagnosis.triangles as u64, goes_on);
        let boundaries = Boundaries::of(&weighted, &work, threads);
        let boundaries = boundaries.ok_or_else(|| undecided(work.not_enough().unwrap_or(0)))?;
        let unit = weighted.welded.unit;
        let [once, twice, negative] = &boundaries.levels;
        let polyhedron = Polyhedron { points: &once.points, corners: &once.corners, threads };
        let cubed = unit * unit * unit;
        let integrals = polyhedron.integrate().map_err(|error| match error {
            BodyError::FlatMesh { volume } => BodyError::FlatMesh { volume: volume * cubed },
            other => other,
        })?;
        let [once, twice, negative] = [once, twice, negative].map(Closure::of);
        let volume = integrals.spread.extent.measure();
        let error = once.defect + (volume - once.volume).abs() + 4.0 * f64::EPSILON * volume.abs();
        if !(volume > 0.0 && error <= CLEAR * volume) {
            return Err(BodyError::UnionUnclear { volume: volume * cubed, error: error * cubed });
        }
        // Slivers between rounded lines may have any orientation, and folds are inverted. An
        // inverted part also removes volume from others.
        let below = (-negative.volume).max(0.0);
        let is_rounding = below <= negative.defect.max(error).max(CLEAR * 1e-3 * volume);
        let mut parts_of_it = diagnosis.components.iter();
        let has_inverted = match inward {
            true => parts_of_it.any(|part| part.volume > 0.0),
            false => parts_of_it.any(|part| part.role == ComponentRole::Inverted),
        };
        if !is_rounding && (has_inverted || below > FOLDS * volume) {
            return Err(BodyError::NegativeUnion { volume: below * cubed, whole: volume * cubed });
        }
        let error = error + below;
        let Spread { centroid, covariance, .. } = integrals.spread;
        let centroid: [f64; 3] =
            core::array::from_fn(|k| (centroid.to_array()[k] + boundaries.reference[k]) * unit);
        let spread = Spread {
            extent: Extent::Volume(volume * cubed),
            centroid: centroid.into(),
            covariance: covariance * unit * unit,
        };
        let (spread, error) = (spread.representable()?, error * cubed);
        let surface = TriangleMesh {
            vertices: weighted.welded.points.iter().map(|p| weighted.welded.place(*p)).collect(),
            triangles: weighted.welded.corners,
            is_hull: false,
        };
        let parts = parts(diagnosis);
        let mut findings = diagnosis.findings();
        findings.retain(|finding| matches!(finding.code, "mesh.flipped" | "mesh.degenerate" | "mesh.cavity"));
        if inward {
            let message = "the normals of the mesh pointed inward and were turned".to_owned();
            findings.push(Finding {
                code: "mesh.inverted",
                severity: Severity::Warning,
                message,
                place: None,
            });
        }
        Ok(Self {
            spread,
            area: integrals.area * unit * unit,
            parts,
            shared: twice.volume.max(0.0) * cubed,
            left_out: if is_rounding { 0.0 } else { below * cubed },
            error,
            surface,
            findings,
            solid: None,
        })
    }

    /// Returns the union in another unit of length: every coordinate is multiplied by a positive
    /// `factor`.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] for a factor that is not positive and finite, or if the scaled
    /// volume overflows f64.
    pub fn scaled(self, factor: f64) -> Result<Self, BodyError> {
        let factor = positive("the factor of a mesh", factor)?;
        if let Some(solid) = self.solid {
            return Ok(Self::of_solid(solid.scaled(factor)?));
        }
        let (squared, cubed) = (factor * factor, factor * factor * factor);
        let Spread { centroid, covariance, .. } = self.spread;
        let spread = Spread {
            extent: Extent::Volume(self.volume() * cubed),
            centroid: centroid.to_array().map(|c| c * factor).into(),
            covariance: covariance * squared,
        };
        Ok(Self {
            spread: spread.representable()?,
            area: self.area * squared,
            shared: self.shared * cubed,
            left_out: self.left_out * cubed,
            error: self.error * cubed,
            surface: self.surface.scaled(factor),
            ..self
        })
    }

    /// Returns the enclosed volume, m³.
    pub const fn volume(&self) -> f64 {
        self.spread.extent.measure()
    }

    /// Returns the volume, m³, that lies in more than one part, or more than once in one, and is
    /// counted once.
    pub const fn shared(&self) -> f64 {
        self.shared
    }

    /// Returns the number of components, without cavities.
    pub const fn parts(&self) -> usize {
        self.parts
    }

    /// Returns the volume of folds with negative winding number, which was omitted, m³.
    pub const fn left_out(&self) -> f64 {
        self.left_out
    }

    /// Returns the estimated error of the volume, m³: its variation between the axes of summation,
    /// rounding, and the omitted volume. Zero if no parts overlap.
    pub const fn error(&self) -> f64 {
        self.error
    }

    /// Returns bounds of the errors of the mass properties if `volume` may or may not belong to the
    /// union, as in [`ClosedMesh::effect`]. For the rounding error, pass [`MeshUnion::error`].
    pub fn effect(&self, volume: f64, beyond: f64) -> MeshEffect {
        MeshEffect::of(&self.spread, self.surface.coordinates(), volume, beyond)
    }

    /// Returns all triangles of the mesh, each once, with outward normals, including those inside
    /// other parts.
    pub const fn surface(&self) -> &TriangleMesh {
        &self.surface
    }

    /// Returns the mesh itself, if no parts overlap.
    pub fn solid(&self) -> Option<&ClosedMesh> {
        self.solid.as_deref()
    }

    /// Returns the other corrections and remarks.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }
}

impl Shape for MeshUnion {
    fn spread(&self) -> Spread {
        self.spread
    }

    /// Returns the area of the union's boundary, m².
    fn surface_area(&self) -> f64 {
        self.area
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Mesh(self.surface.clone()))
    }
}

/// Returns true if the whole surface of a solid separates its inside from its outside.
fn is_apart(diagnosis: &MeshDiagnosis) -> bool {
    diagnosis.self_overlaps.is_empty() && diagnosis.contacts.is_empty() && diagnosis.back_to_back.is_empty()
}

/// Returns the number of components that are neither cavities nor flat.
fn parts(diagnosis: &MeshDiagnosis) -> usize {
    let is_part = |role| !matches!(role, ComponentRole::Cavity | ComponentRole::Flat);
    diagnosis.components.iter().filter(|part| is_part(part.role)).count()
}

/// Largest accepted error, relative to the volume.
const CLEAR: f64 = 1e-9;

/// Largest accepted negative volume of folds, relative to the volume.
const FOLDS: f64 = 1e-3;

/// Step limit for a mesh, and its increment per triangle, as for the diagnosis.
const STEPS: u64 = 300_000_000;
const STEPS_EACH: u64 = 2_000;
