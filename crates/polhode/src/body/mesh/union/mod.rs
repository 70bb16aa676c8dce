//! What the parts of a mesh enclose together, each place once.
//!
//! The union is where the mesh's winding number is 1 or more. Its boundary is those pieces of triangles that have this on their inner side and not
//! on their outer one. It is not made as a mesh: for the integrals it is enough to know the pieces, one triangle after the other.
//!
//! 1. Triangles that nothing meets are whole, and those that hang together have the same winding numbers beside them, which one ray finds
//!    exactly (`contact.rs`, `boundary.rs`).
//! 2. Each of the others is a plane of its own (`face.rs`): what the mesh is just above the plane, and just below it, are closed lines there. Which
//!    edges go through the plane is decided exactly, so the lines are closed though their corners are rounded. The winding number at a place of
//!    the plane is what the lines sum to from far below (`region.rs`).
//! 3. Of triangles in one plane, the first one stands for all where they lie on each other.
//!
//! So all that is inexact is where lines lie, by some last digits. How well the pieces fit is measured (`measure.rs`): a surface with gaps or
//! overlaps has not the same volume along the three axes.

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

/// The solid that the parts of a mesh are together: what lies in several of them, or twice in one that goes through itself, is there once.
///
/// A place belongs to it if the mesh winds about it once or more often. So solids within solids are part of these; what is wound inward within a
/// solid is a cavity, unless another solid fills it. What it winds about negatively does not belong to it: of a part that is wound inward, or if
/// it is more than a thousandth of the whole, the mesh is refused ([`BodyError::NegativeUnion`]); of small folds, where a surface goes through itself,
/// it is left out, and is part of the error.
///
/// The mesh has to be closed: every edge is run along as often one way as the other. Corners are the same vertex when their coordinates are equal,
/// exactly, and which triangles meet is decided exactly; where they meet is rounded. What that may mean for the volume is measured on the surface
/// that was found: [`MeshUnion::error`].
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
    /// What is drawn.
    surface: TriangleMesh,
    findings: Vec<Finding>,
    /// The mesh itself, if nothing of it overlaps.
    solid: Option<Box<ClosedMesh>>,
}

impl MeshUnion {
    /// The union of what the mesh bounds; on all threads of the machine, with the same result on any number of them.
    ///
    /// # Errors
    /// Why the mesh bounds nothing, as [`ClosedMesh::of`] says, if it is not closed; [`BodyError::NegativeUnion`];
    /// [`BodyError::UnionUndecided`] if too many triangles are too near each other; [`BodyError::UnionUnclear`] if the pieces of the surface
    /// do not fit together to a billionth of the volume; [`BodyError::FlatMesh`], and [`BodyError::Parameter`] if f64 does not hold the
    /// volume.
    pub fn of(mesh: &TriangleMesh) -> Result<Self, BodyError> {
        Self::watched(mesh, &|| true)
    }

    /// The same as long as it `goes_on`, which is asked often: what would take longer is undecided.
    ///
    /// # Errors
    /// As [`MeshUnion::of`].
    pub fn watched(mesh: &TriangleMesh, goes_on: &(dyn Fn() -> bool + Sync)) -> Result<Self, BodyError> {
        match ClosedMesh::or_flaws(mesh, 0, goes_on) {
            Ok((solid, _)) if is_apart(solid.diagnosis()) => Ok(Self::of_solid(solid)),
            Ok((solid, _)) => {
                let unclear = BodyError::UnionUnclear { volume: solid.volume(), error: solid.volume() };
                Self::found(mesh, solid.diagnosis(), unclear, goes_on)
            }
            Err(flaws) => {
                // Whatever is there twice, what is open is to be closed first.
                let is_open = |error: &&BodyError| matches!(error, BodyError::OpenMesh { .. });
                let why_not = flaws.errors().find(is_open).unwrap_or(&flaws.first).clone();
                Self::found(mesh, &flaws.diagnosis, why_not, goes_on)
            }
        }
    }

    /// Is a mesh closed, so that what its parts enclose together can be found?
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

    /// Of a mesh of which something overlaps, or `why_not`, if it is not closed.
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
        // Slivers of rounded lines may be wound any way, and folds are turned inside out; a part that is has hollowed out others, too.
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

    /// The same in another unit of length: every coordinate is times a positive number.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] for a number that is not positive and finite, and if f64 does not hold the volume then.
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

    /// Enclosed volume, m³.
    pub const fn volume(&self) -> f64 {
        self.spread.extent.measure()
    }

    /// The volume that lies in more than one part, or more than once in one, and is counted once, m³.
    pub const fn shared(&self) -> f64 {
        self.shared
    }

    /// Parts that hang together by their edges, cavities apart.
    pub const fn parts(&self) -> usize {
        self.parts
    }

    /// The volume of folds that the mesh winds about the wrong way round, and that was left out, m³.
    pub const fn left_out(&self) -> f64 {
        self.left_out
    }

    /// What the volume may be off, m³: how much it differs between the axes along which the surface is summed over, some rounding, and what was
    /// left out. Nothing if no parts overlap.
    pub const fn error(&self) -> f64 {
        self.error
    }

    /// How far the mass properties may be off if so much volume may belong to the union or not, as [`ClosedMesh::effect`] says: of
    /// [`MeshUnion::error`], what is rounded.
    pub fn effect(&self, volume: f64, beyond: f64) -> MeshEffect {
        MeshEffect::of(&self.spread, self.surface.coordinates(), volume, beyond)
    }

    /// All triangles of the mesh, each once, normals outward: what is inside is there, too.
    pub const fn surface(&self) -> &TriangleMesh {
        &self.surface
    }

    /// The mesh itself, if nothing overlaps.
    pub fn solid(&self) -> Option<&ClosedMesh> {
        self.solid.as_deref()
    }

    /// What was corrected besides, and what is worth a remark.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }
}

impl Shape for MeshUnion {
    fn spread(&self) -> Spread {
        self.spread
    }

    /// Area of the boundary, m².
    fn surface_area(&self) -> f64 {
        self.area
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Mesh(self.surface.clone()))
    }
}

/// Whether all of a solid's surface is between what is in it and what is not.
fn is_apart(diagnosis: &MeshDiagnosis) -> bool {
    diagnosis.self_overlaps.is_empty() && diagnosis.contacts.is_empty() && diagnosis.back_to_back.is_empty()
}

/// Components that are no cavities.
fn parts(diagnosis: &MeshDiagnosis) -> usize {
    let is_part = |role| !matches!(role, ComponentRole::Cavity | ComponentRole::Flat);
    diagnosis.components.iter().filter(|part| is_part(part.role)).count()
}

/// The largest error that is let through, of the volume.
const CLEAR: f64 = 1e-9;

/// The most that folds may enclose the wrong way round, of the volume.
const FOLDS: f64 = 1e-3;

/// Steps for a mesh, and more for each of its triangles, as for its diagnosis.
const STEPS: u64 = 300_000_000;
const STEPS_EACH: u64 = 2_000;
