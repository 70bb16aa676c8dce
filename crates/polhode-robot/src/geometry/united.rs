//! Solid of a link: its shapes with one role, in which each region counts once.
//!
//! Two shapes are apart if a plane separates their convex hulls; then their moments add. The plane
//! may cut `TOUCHING` of their sizes off, so that shapes may touch. Other shapes form clusters. The
//! union of boxes and closed meshes is exact ([`MeshUnion`]). A round shape is replaced by an inner
//! and an outer polyhedron. The volume that belongs to several shapes, and its second moments, are
//! between those of both, so
//!
//! union = Σ shapes − ½ (overlap_inner + overlap_outer),  error ≤ ½ (overlap_outer − overlap_inner).

use std::sync::Arc;

use polhode::body::BodyError;
use polhode::body::mesh::{ClosedMesh, MeshUnion, TriangleMesh};
use polhode::body::shape::{Shape, Substance};
use polhode_source::text::counted;

use super::mesh::Mesh;
use super::moments::RegionMoments;
use super::outside::farthest;
use super::polyhedron::Polyhedra;
use super::primitive::Primitive;
use super::separation::distance;
use super::{MeshReading, ShapeMesh, Shapes, Solid, Volume, VolumeKind};
use crate::model::{Geometry, Link, Pose, Role, Span};
use crate::pose::{dot, sum};

/// Part of the size of two shapes by which they may overlap and still count as touching.
const TOUCHING: f64 = 1e-12;

/// Relative rounding error of a primitive's moments, and of a mesh's.
const OF_PRIMITIVE: f64 = 1e-14;
const OF_MESH: f64 = 1e-13;

/// Largest number of shapes of a link that are united.
const MOST_SHAPES: usize = 2000;

/// Solid of a link, as pieces without common volume.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinkSolid {
    /// Pieces, in the order of their first shapes.
    pub pieces: Vec<SolidPiece>,
    /// Volume that belongs to several shapes and counts once, m³.
    pub shared: f64,
    /// Bound on the error of volume and moments, relative to those of the whole.
    pub error: f64,
    /// Number of triangles of the meshes; 0 if all shapes are primitives.
    pub triangles: usize,
}

/// Piece of a link's solid: a shape, a part of a mesh, or several of them united.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidPiece {
    /// Indices of its shapes in [`Link::geometry`].
    pub shapes: Vec<usize>,
    /// Names of its mesh parts; empty for a shape that is not divided.
    pub parts: Vec<String>,
    /// Volume and moments.
    pub volume: Volume,
}

impl LinkSolid {
    /// Returns the total volume, m³.
    pub fn volume(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.volume.volume).sum()
    }

    /// Returns volume and moments of all pieces; `None` if there are none.
    pub fn whole(&self) -> Option<Volume> {
        let mut volumes = self.pieces.iter().map(|piece| piece.volume.clone());
        let first = volumes.next()?;
        Some(volumes.fold(first, |whole, volume| whole.joined(&volume)))
    }
}

/// Shape before the union.
struct Candidate {
    shape: usize,
    form: Form,
    /// Pieces, if no other shape meets it.
    pieces: Vec<(String, Volume)>,
    whole: Volume,
}

enum Form {
    Primitive(Primitive, Pose),
    Mesh(Arc<Mesh>, [f64; 3], Pose),
}

impl Shapes<'_> {
    /// Returns the solid that the shapes of a link with this role form.
    ///
    /// # Errors
    /// Shapes that bound no solid, each with the reason in words: open meshes, planes, unreadable
    /// sizes or poses, meshes whose up axis is ambiguous. If shapes overlap and have no union, the
    /// reason is about the first of them. The list is empty if the link has no shapes.
    pub fn solid(&self, link: &Link, role: Role) -> Result<LinkSolid, Vec<(Span, String)>> {
        let shapes = link.geometry.iter().enumerate().filter(|(_, geometry)| geometry.role == role);
        let mut solid = LinkSolid { error: OF_PRIMITIVE, ..LinkSolid::default() };
        let (mut candidates, mut faults) = (Vec::new(), Vec::new());
        for (k, geometry) in shapes {
            match self.candidate(k, geometry, &mut solid) {
                Ok(candidate) => candidates.push(candidate),
                Err(why) => faults.push((geometry.span.clone(), why)),
            }
        }
        if !faults.is_empty() || candidates.is_empty() {
            return Err(faults);
        }
        let span_of = |candidate: &Candidate| {
            link.geometry.get(candidate.shape).map_or(0..0, |geometry| geometry.span.clone())
        };
        if candidates.len() > MOST_SHAPES {
            let why = format!(
                "the link has {} of this kind: at most {MOST_SHAPES} are united",
                counted(candidates.len(), "shape")
            );
            return Err(candidates.first().map(|first| (span_of(first), why)).into_iter().collect());
        }
        let mut sum_of_errors = solid.error;
        for cluster in clusters(candidates, &mut sum_of_errors) {
            match cluster.as_slice() {
                [only] => solid.pieces.extend(only.pieces.iter().map(|(part, volume)| SolidPiece {
                    shapes: vec![only.shape],
                    parts: Some(part.clone()).filter(|part| !part.is_empty()).into_iter().collect(),
                    volume: volume.clone(),
                })),
                several => {
                    let united = self.united(several).map_err(|error| {
                        let why = format!(
                            "{} overlap, and their union cannot be computed: {error}",
                            counted(several.len(), "shape")
                        );
                        several.first().map(|first| (span_of(first), why)).into_iter().collect::<Vec<_>>()
                    })?;
                    let Union { piece, shared, error } = united;
                    solid.shared += shared;
                    sum_of_errors = sum_of_errors.max(error);
                    solid.pieces.push(piece);
                }
            }
        }
        solid.error = sum_of_errors;
        Ok(solid)
    }

    fn candidate(&self, k: usize, geometry: &Geometry, solid: &mut LinkSolid) -> Result<Candidate, String> {
        if let Some(number) = geometry.pose.unreadable.first() {
            return Err(format!("its pose has {:?}, which is not a finite number", number.text));
        }
        let pose = Pose::new(geometry.pose.position, geometry.pose.rotation);
        let Some(found) = self.mesh_of(&geometry.shape) else {
            let whole = self.geometry(geometry)?;
            let primitive = Primitive::of(&geometry.shape).map_err(|error| error.to_string())?;
            let pieces = vec![(String::new(), whole.clone())];
            return Ok(Candidate { shape: k, form: Form::Primitive(primitive, pose), pieces, whole });
        };
        let ShapeMesh { mesh, name, scale } = found?;
        let named = |why: String| format!("{name:?}: {why}");
        if mesh.turned_in.is_some() {
            return Err(named("programs disagree on its up axis; export it as STL or OBJ".to_owned()));
        }
        if mesh.mixes_winding {
            let why = "some of its parts are wound inward: put a cavity into the part that it is in";
            return Err(named(why.to_owned()));
        }
        solid.triangles += mesh.usual.triangles().len();
        solid.error = solid.error.max(OF_MESH);
        let whole = self.geometry_as(geometry, MeshReading::Usual)?;
        let form = Form::Mesh(Arc::clone(&mesh), scale, pose);
        if whole.kind == VolumeKind::Closed && mesh.parts.len() < 2 {
            let pieces = vec![(String::new(), whole.clone())];
            return Ok(Candidate { shape: k, form, pieces, whole });
        }
        // Parts that may overlap, or a surface that meets itself.
        let union =
            MeshUnion::watched(&mesh.usual, self.goes_on).map_err(|error| named(error.to_string()))?;
        if union.solid().is_some() && mesh.parts.len() > 1 {
            let placed = |(name, part): &(String, Solid)| {
                let solid = part.scaled(scale)?;
                Ok((name.clone(), whole.with_solid(&solid, &geometry.pose)))
            };
            let pieces = mesh.parts.iter().map(placed).collect::<Result<_, String>>()?;
            return Ok(Candidate { shape: k, form, pieces, whole });
        }
        solid.error = solid.error.max(union.effect(union.error(), 0.0).inertia);
        solid.shared += union.shared() * scale.iter().product::<f64>().abs();
        let body =
            union.mass_properties(Substance::Density(1.0)).map_err(|error| named(error.to_string()))?;
        let united = Solid::of(&body).scaled(scale)?;
        let whole = Volume { kind: VolumeKind::Closed, ..whole.with_solid(&united, &geometry.pose) };
        let pieces = vec![(String::new(), whole.clone())];
        Ok(Candidate { shape: k, form, pieces, whole })
    }

    /// Returns the union of shapes that may overlap.
    fn united(&self, shapes: &[Candidate]) -> Result<Union, BodyError> {
        let reference = shapes.first().map_or([0.0; 3], |shape| shape.whole.centroid);
        let mut sum_of_shapes = RegionMoments::default();
        let (mut inner, mut outer) = (Polyhedral::default(), Polyhedral::default());
        let mut is_exact = true;
        for shape in shapes {
            let whole = &shape.whole;
            let solid =
                Solid { volume: whole.volume, centroid: whole.centroid, tensor: whole.tensor_per_density };
            sum_of_shapes = sum_of_shapes.plus(1.0, &RegionMoments::of(&solid, reference));
            let Polyhedra { inner: inside, outer: around } = shape.form.polyhedra()?;
            is_exact &= around.is_none();
            outer.add(around.as_ref().unwrap_or(&inside), reference, self)?;
            inner.add(&inside, reference, self)?;
        }
        let (inside, error_inside) = inner.overlap(reference, self)?;
        let (overlap, error) = if is_exact {
            (inside, error_inside)
        } else {
            let (around, error_around) = outer.overlap(reference, self)?;
            let gap = around.plus(-1.0, &inside);
            let mean = inside.plus(0.5, &gap);
            let whole = sum_of_shapes.plus(-1.0, &mean);
            let of_volume = 0.5 * gap.volume.abs() / whole.volume;
            let of_spread = 0.5 * gap.spread().abs() / whole.spread();
            (mean, of_volume.max(of_spread) + error_inside.max(error_around))
        };
        let solid = sum_of_shapes.plus(-1.0, &overlap).solid(reference);
        let reach = shapes.iter().map(|shape| shape.whole.clone()).reduce(|all, next| all.joined(&next));
        let none = BodyError::Empty { what: "shapes" };
        let around = reach.ok_or(none)?;
        let mut parts: Vec<String> =
            shapes.iter().flat_map(|shape| &shape.pieces).map(|(part, _)| part.clone()).collect();
        parts.retain(|part| !part.is_empty());
        let piece = SolidPiece {
            shapes: shapes.iter().map(|shape| shape.shape).collect(),
            parts,
            volume: around.with_solid(&solid, &Pose::IDENTITY),
        };
        Ok(Union { piece, shared: overlap.volume.max(0.0), error })
    }
}

/// Union of a cluster of shapes.
struct Union {
    piece: SolidPiece,
    shared: f64,
    error: f64,
}

/// Polyhedra of a cluster.
#[derive(Default)]
struct Polyhedral {
    surface: TriangleMesh,
    sum: RegionMoments,
}

impl Polyhedral {
    fn add(
        &mut self,
        mesh: &TriangleMesh,
        reference: [f64; 3],
        shapes: &Shapes<'_>,
    ) -> Result<(), BodyError> {
        let union = match ClosedMesh::without_remarks(mesh, shapes.threads, shapes.goes_on) {
            Ok(solid) => solid.mass_properties(Substance::Density(1.0))?,
            // A surface that meets itself counts as its own union.
            Err(_) => MeshUnion::watched(mesh, shapes.goes_on)?.mass_properties(Substance::Density(1.0))?,
        };
        self.sum = self.sum.plus(1.0, &RegionMoments::of(&Solid::of(&union), reference));
        self.surface = std::mem::take(&mut self.surface).joined(mesh)?;
        Ok(())
    }

    /// Returns Σ polyhedra − union, and the relative error of the union.
    fn overlap(&self, reference: [f64; 3], shapes: &Shapes<'_>) -> Result<(RegionMoments, f64), BodyError> {
        let union = MeshUnion::watched(&self.surface, shapes.goes_on)?;
        let body = union.mass_properties(Substance::Density(1.0))?;
        let error = union.effect(union.error(), 0.0).inertia.max(OF_MESH);
        Ok((self.sum.plus(-1.0, &RegionMoments::of(&Solid::of(&body), reference)), error))
    }
}

impl Form {
    fn support(&self, direction: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Primitive(primitive, pose) => primitive.support(pose, direction),
            Self::Mesh(mesh, scale, pose) => farthest(mesh.outline(), false, *scale, pose, direction),
        }
    }

    fn polyhedra(&self) -> Result<Polyhedra, BodyError> {
        match self {
            Self::Primitive(primitive, pose) => Polyhedra::of(primitive, pose),
            Self::Mesh(mesh, scale, pose) => {
                let placed = |v: &[f64; 3]| pose.placed([0, 1, 2].map(|k| scale[k] * v[k]));
                let vertices: Vec<[f64; 3]> = mesh.usual.coordinates().iter().map(placed).collect();
                // A mirror turns the triangles inside out.
                let is_mirrored = scale.iter().product::<f64>() < 0.0;
                let turned = |&[a, b, c]: &[u32; 3]| if is_mirrored { [a, c, b] } else { [a, b, c] };
                let triangles = mesh.usual.triangles().iter().map(turned).collect();
                Ok(Polyhedra { inner: TriangleMesh::new(vertices, triangles)?, outer: None })
            }
        }
    }
}

impl Volume {
    /// Returns a volume with the moments of a solid in a frame of this pose, and the bounds of this
    /// one.
    fn with_solid(&self, solid: &Solid, pose: &Pose) -> Self {
        Self {
            volume: solid.volume,
            centroid: pose.placed(solid.centroid),
            tensor_per_density: pose.turned_tensor(solid.tensor),
            ..self.clone()
        }
    }
}

/// Groups shapes that are not proved to be apart, in the order of their first shapes.
fn clusters(shapes: Vec<Candidate>, error: &mut f64) -> Vec<Vec<Candidate>> {
    let mut group: Vec<usize> = (0..shapes.len()).collect();
    for (k, shape) in shapes.iter().enumerate() {
        for (j, other) in shapes.iter().enumerate().take(k) {
            if are_apart(shape, other, error) {
                continue;
            }
            let ends = [group.get(k), group.get(j)].map(|end| end.copied().unwrap_or(0));
            let [one, two] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            group.iter_mut().filter(|end| **end == two).for_each(|end| *end = one);
        }
    }
    let mut clusters: Vec<(usize, Vec<Candidate>)> = Vec::new();
    for (shape, group) in shapes.into_iter().zip(group) {
        match clusters.iter_mut().find(|(other, _)| *other == group) {
            Some((_, cluster)) => cluster.push(shape),
            None => clusters.push((group, vec![shape])),
        }
    }
    clusters.into_iter().map(|(_, cluster)| cluster).collect()
}

/// Returns true if a plane separates two shapes, or cuts off at most `TOUCHING` of their sizes;
/// then `error` includes that part.
fn are_apart(a: &Candidate, b: &Candidate, error: &mut f64) -> bool {
    let ([low, high], [other_low, other_high]) = (a.whole.bounds, b.whole.bounds);
    if (0..3).any(|k| high[k] < other_low[k] || other_high[k] < low[k]) {
        return true;
    }
    let middle = a.whole.centroid;
    let size = [low, high, other_low, other_high]
        .into_iter()
        .map(|corner| [0, 1, 2].map(|k| corner[k] - middle[k]))
        .fold(0.0, |size: f64, d| size.max(dot(d, d).sqrt()));
    // The farthest point of a shape that is smaller by a factor about its centroid.
    let end = |shape: &Candidate, direction: [f64; 3], factor: f64| {
        let (point, center) = (shape.form.support(direction), shape.whole.centroid);
        [0, 1, 2].map(|k| (center[k] + factor * (point[k] - center[k]) - middle[k]) / size)
    };
    // Both are apart if the origin is not one of the differences of their points.
    let gap = |factor: f64| {
        distance([0.0; 3], |direction| {
            sum(end(a, direction, factor), end(b, direction.map(|c| -c), factor).map(|c| -c))
        })
    };
    if gap(1.0) > 0.0 {
        return true;
    }
    let is_touching = gap(1.0 - TOUCHING) > 0.0;
    if is_touching {
        *error = error.max(3.0 * TOUCHING);
    }
    is_touching
}
