//! `Mesh` prims: points, and polygons between them.
//!
//! The polygons themselves are measured. A subdivision surface, which is the default of the schema
//! and a relic in most files, would round them; physics engines use the polygons, too.
//!
//! A transform with perpendicular axes is a pose and a scale, so that instances share their mesh. Any
//! other is applied to the points.
//!
//! Source: openusd.org, `UsdGeomMesh`, `UsdGeomImageable`, `UsdPhysicsMeshCollisionAPI`.

use std::collections::HashMap;
use std::sync::Arc;

use polhode::body::mesh::TriangleMesh;
use polhode_shape::mesh::Polygons;

use super::layer::Prim;
use super::xform::Affine;
use super::{Stage, applies, changing};
use crate::model::{Geometry, GeometryShape, InlineMesh, Note, Pose, Role, Span};

/// Cosine between axes above which they are not perpendicular.
const SKEW: f64 = 1e-12;

/// Maximum number of points of all meshes to which a transform is applied: instances multiply them.
const MOST_POINTS: usize = 20_000_000;

/// Mesh, or the reason in words why there is none.
type Mesh = Result<Arc<InlineMesh>, String>;

/// Meshes of a stage. Prims with the same arrays share one mesh.
#[derive(Default)]
pub(super) struct Meshes {
    known: HashMap<Content, Mesh>,
    /// Number of points to which a transform was applied.
    moved: usize,
    /// Position, scheme and path of the first mesh with an authored subdivision.
    smooth: Option<(Span, String, String)>,
    /// Number of these meshes.
    smooth_count: usize,
}

/// Addresses of the arrays of a mesh, true if it is left-handed, and true if its hull counts.
type Content = ([*const f64; 4], bool, bool);

impl Meshes {
    /// Returns the note about subdivision, if a mesh states one.
    pub(super) fn note(self) -> Option<Note> {
        let (span, scheme, path) = self.smooth?;
        let others = match self.smooth_count {
            1 => String::new(),
            count => format!(" (and of {} more)", count - 1),
        };
        let message = format!(
            "subdivisionScheme = {scheme} of {path}{others} is not applied: the polygons are measured"
        );
        Some(Note::new("read.left_out", "", span, message))
    }

    /// Returns the mesh of a prim, in the layer's unit.
    fn mesh(&mut self, prim: &Prim, is_hull: bool) -> Mesh {
        let is_left_handed = match word(prim, "orientation") {
            None | Some("rightHanded") => false,
            Some("leftHanded") => true,
            Some(other) => return Err(format!("orientation = {other:?}: write rightHanded or leftHanded")),
        };
        let [points, counts, indices] =
            [stated(prim, "points")?, stated(prim, "faceVertexCounts")?, stated(prim, "faceVertexIndices")?];
        let holes = stated(prim, "holeIndices").unwrap_or_default();
        let arrays = [points, counts, indices, holes];
        let read = || {
            let surface = surface(arrays, is_left_handed)?;
            Ok(Arc::new(InlineMesh::new(surface, is_hull)))
        };
        let content = (arrays.map(<[f64]>::as_ptr), is_left_handed, is_hull);
        self.known.entry(content).or_insert_with(read).clone()
    }

    /// Returns a mesh to whose points a transform is applied.
    fn moved(&mut self, mesh: &InlineMesh, place: &Affine) -> Mesh {
        let (points, triangles) = (mesh.surface().coordinates(), mesh.surface().triangles());
        self.moved += points.len();
        if self.moved > MOST_POINTS {
            return Err(format!("meshes with skew axes have more than {MOST_POINTS} points in total"));
        }
        let is_mirrored = place.is_mirrored();
        let turn = |&[a, b, c]: &[u32; 3]| if is_mirrored { [a, c, b] } else { [a, b, c] };
        let points: Vec<[f64; 3]> = points.iter().map(|point| place.placed(*point)).collect();
        let surface = TriangleMesh::new(points, triangles.iter().map(turn).collect());
        let surface = surface.map_err(|error| error.to_string())?;
        Ok(Arc::new(InlineMesh::new(surface, mesh.is_hull())))
    }
}

/// Returns the mesh of a prim in a body's frame; `None` for a guide, which is not part of the body
/// unless it is a collider.
pub(super) fn geometry(
    stage: &Stage<'_>,
    k: usize,
    prim: &Prim,
    body: &Pose,
    meshes: &mut Meshes,
) -> Option<Geometry> {
    let is_collider = applies(prim, "PhysicsCollisionAPI");
    if !is_collider && purpose(stage, prim) == Some("guide") {
        return None;
    }
    if let Some(scheme @ ("catmullClark" | "loop")) = word(prim, "subdivisionScheme") {
        meshes.smooth_count += 1;
        let span = || prim.properties.get("subdivisionScheme").map_or(0..0, |value| value.span.clone());
        meshes.smooth.get_or_insert_with(|| (span(), scheme.to_owned(), prim.path.clone()));
    }
    let approximation = Some("physics:approximation")
        .filter(|_| is_collider && applies(prim, "PhysicsMeshCollisionAPI"))
        .and_then(|name| word(prim, name));
    let mesh = match approximation {
        Some(fitted @ ("boundingCube" | "boundingSphere")) => Err(format!(
            "physics:approximation = {fitted} is not measured: programs fit it differently; a Cube or a Sphere is unambiguous"
        )),
        _ => meshes.mesh(prim, approximation == Some("convexHull")),
    };
    let place = stage.place(k);
    let metres = stage.units.metres;
    let (mesh, scale, pose) = match place.scaled_pose_within(SKEW) {
        Some(([x, y, z], pose)) => {
            let z = if place.is_mirrored() { -z } else { z };
            (mesh, [x, y, z], pose)
        }
        None => {
            let inner = Affine { shift: [0.0; 3], unreadable: Vec::new(), ..place };
            let mesh = mesh.and_then(|mesh| meshes.moved(&mesh, &inner));
            (mesh, [1.0; 3], Pose::new(place.shift, Pose::IDENTITY.rotation))
        }
    };
    Some(Geometry {
        span: prim.span.clone(),
        role: if is_collider { Role::Collision } else { Role::Visual },
        pose: Pose { unreadable: place.unreadable, ..body.inverse().then(&pose) },
        shape: GeometryShape::Inline {
            name: prim.path.clone(),
            mesh,
            scale: scale.map(|factor| metres * factor),
        },
    })
}

/// Returns the word that an attribute states.
fn word<'p>(prim: &'p Prim, name: &str) -> Option<&'p str> {
    prim.properties.get(name).and_then(|value| value.words.first()).map(String::as_str)
}

/// Returns the purpose that a prim or its nearest ancestor states.
fn purpose<'l>(stage: &Stage<'l>, prim: &'l Prim) -> Option<&'l str> {
    let mut around = Some(prim);
    while let Some(prim) = around {
        if let Some(purpose) = word(prim, "purpose") {
            return Some(purpose);
        }
        around = prim.parent.and_then(|parent| stage.layer.prims.get(parent));
    }
    None
}

/// Returns an array that a prim states, or the reason why it has none.
fn stated<'p>(prim: &'p Prim, name: &str) -> Result<&'p [f64], String> {
    if let Some(array) = prim.properties.get(name).and_then(|value| value.array.as_deref()) {
        return Ok(array);
    }
    Err(match changing::of_mesh(prim, name) {
        Some(other) => format!("{other} is not read: write one value, or flatten the stage at one time"),
        None => format!("it has no {name}"),
    })
}

/// Returns the triangles of points, counts of corners, indices of corners, and indices of holes.
///
/// # Errors
/// The reason in words why the arrays are not those of a mesh.
fn surface(
    [points, counts, indices, holes]: [&[f64]; 4],
    is_left_handed: bool,
) -> Result<TriangleMesh, String> {
    let (points, rest) = points.as_chunks::<3>();
    if !rest.is_empty() {
        return Err(format!("points has {} numbers, which are not triples", 3 * points.len() + rest.len()));
    }
    let is_finite = |point: &[f64; 3]| point.iter().all(|c| c.is_finite());
    if let Some((k, point)) = points.iter().enumerate().find(|(_, point)| !is_finite(point)) {
        return Err(format!("points[{k}] = {point:?}: coordinates are finite numbers"));
    }
    require_indices("faceVertexIndices", indices, points.len(), "points")?;
    require_indices("holeIndices", holes, counts.len(), "faces")?;
    let mut is_hole = vec![false; counts.len()];
    for &hole in holes {
        is_hole.get_mut(hole as usize).into_iter().for_each(|is_hole| *is_hole = true);
    }
    let (mut polygons, mut triangles) = (Polygons::default(), Vec::with_capacity(indices.len()));
    let (mut at, mut corners) = (0_usize, Vec::new());
    for (face, (&count, is_hole)) in counts.iter().zip(is_hole).enumerate() {
        if !(count >= 3.0 && count.fract() == 0.0) {
            return Err(format!("faceVertexCounts[{face}] = {count}: a face has at least 3 corners"));
        }
        let end = at.saturating_add(count as usize);
        let Some(own) = indices.get(at..end) else { break };
        at = end;
        corners.clear();
        corners.extend(own.iter().map(|&k| k as u32));
        if is_left_handed {
            corners.reverse();
        }
        if !is_hole {
            polygons.split(points, &corners, &mut triangles);
        }
    }
    let total: f64 = counts.iter().sum();
    if total != indices.len() as f64 {
        let count = indices.len();
        return Err(format!("faceVertexCounts add up to {total}, but faceVertexIndices has {count} numbers"));
    }
    if triangles.is_empty() {
        return Err("it has no faces".to_owned());
    }
    TriangleMesh::new(points.to_vec(), triangles).map_err(|error| error.to_string())
}

/// Refuses an index beyond a list.
fn require_indices(name: &str, indices: &[f64], count: usize, what: &str) -> Result<(), String> {
    let is_right = |index: f64| index >= 0.0 && index < count as f64 && index.fract() == 0.0;
    let wrong = indices.iter().enumerate().find(|(_, index)| !is_right(**index));
    let Some((k, index)) = wrong else { return Ok(()) };
    Err(format!(
        "{name}[{k}] = {index}: indices start at 0, and there are {count} {what}; export the mesh again"
    ))
}
