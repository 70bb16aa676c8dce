//! Volume, centroid and tensor of the shapes of a link, at density 1, in the link's frame.
//!
//! Volumes of several shapes are added; overlaps count once per shape. A mesh that does not bound a
//! solid is replaced by its convex hull, and the result states this. Scale is applied to the
//! moments. With S = diag(s), x' = S x,
//!
//! V' = |det S| V,  c' = S c,  ∫x'x'ᵀ dV' = |det S| S (∫x xᵀ dV) S.
//!
//! A mirror therefore changes the sign of two products and leaves the volume positive. The hull of
//! a scaled mesh is the scaled hull.
//!
//! glTF has +y up and +z forward (glTF 2.0, 3.4); robots have +z up. Drake, Genesis and RViz (since
//! 2025) rotate such a mesh by 90° about x, (x, y, z) → (x, −z, y), before scaling and placing it.
//! Other programs, and RViz before 2025, use it as it is. COLLADA's `<up_axis>` is ignored by
//! Gazebo and RViz, and applied by others. [`MeshReading`] names both conventions.

mod inline_meshes;
mod mesh;
mod mesh_files;
mod moments;
mod outside;
mod polyhedron;
mod primitive;
mod separation;
mod shape_box;
mod united;

use std::fmt;
use std::path::Path;
use std::sync::Arc;
use std::thread;

use polhode::body::MassProperties;
use polhode::body::mesh::TriangleMesh;
use polhode::math::Part;
use polhode_source::files::{Disk, Files};

use crate::model::{Geometry, GeometryShape, InlineMesh, Link, Role, Span};
use crate::pose::{dot, sum};
use inline_meshes::InlineMeshes;
use mesh::{Measured, Mesh};
use mesh_files::MeshFiles;
use primitive::Primitive;

pub use mesh_files::mesh_files;
pub use shape_box::ShapeBox;
pub use united::{LinkSolid, SolidPiece};

/// Volume and moments of one or several shapes, in the link's frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    /// Volume, m³; positive.
    pub volume: f64,
    /// Centroid, m.
    pub centroid: [f64; 3],
    /// Tensor about the centroid, link axes, at 1 kg/m³, kg·m². Elements of the tensor (−∫xy dV).
    pub tensor_per_density: [[f64; 3]; 3],
    /// Distance of the farthest point from the link's origin, m; for an ellipsoid an upper bound.
    pub extent: f64,
    /// Lower and upper bounds of x, y, z, m.
    pub bounds: [[f64; 3]; 2],
    /// Kind of the shapes that were measured.
    pub kind: VolumeKind,
}

/// Kind of the shapes behind a volume, the most reliable first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum VolumeKind {
    /// Closed meshes only.
    Closed,
    /// Primitives (boxes, spheres, cylinders …), possibly with closed meshes; no hulls.
    Primitives,
    /// Convex hulls, at least one, of meshes that do not bound a solid.
    Hull,
}

/// Volume of the shapes of one role of a link: all visual shapes, or all collision shapes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinkVolume {
    /// Total of the shapes that could be measured; `None` if there are none.
    pub volume: Option<Volume>,
    /// Shapes that could not be measured, with the reason. If there are any, the volume and its
    /// bounds are incomplete.
    pub left_out: Vec<(Span, String)>,
}

/// Convention for the up axis of mesh formats that programs read in two ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshReading {
    /// Most common convention: glTF rotated from y up to z up, COLLADA as it is.
    Usual,
    /// Opposite convention: glTF as it is, COLLADA rotated.
    Other,
}

/// Measures shapes; thread-safe. Each mesh is read and measured once.
///
/// ```
/// use polhode_robot::{geometry::Shapes, model::Role, read};
/// let text = r#"<robot><link name="a"><collision><origin xyz="1 0 0"/>
///     <geometry><box size="1 2 3"/></geometry></collision></link></robot>"#;
/// let model = read::read_text(text, "a.urdf".as_ref(), &read::ReadOptions::default())?;
/// let solid = Shapes::default().link(&model.links[0], Role::Collision).volume.unwrap();
/// assert_eq!((solid.volume, solid.centroid), (6.0, [1.0, 0.0, 0.0]));
/// assert_eq!(solid.tensor_per_density[2][2], 6.0 * (1.0 + 4.0) / 12.0);
/// assert_eq!(solid.bounds, [[0.5, -1.0, -1.5], [1.5, 1.0, 1.5]]);
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
pub struct Shapes<'a> {
    files: &'a dyn Files,
    meshes: MeshFiles,
    inline: InlineMeshes,
    threads: usize,
    goes_on: &'a (dyn Fn() -> bool + Sync),
}

/// Mesh of a shape.
struct ShapeMesh<'s> {
    mesh: Arc<Mesh>,
    /// Name for messages.
    name: &'s str,
    scale: [f64; 3],
}

/// Reason given for meshes that are not measured after cancellation.
const ENDED: &str = "it was not measured, because that would take too long";

/// Volume and moments of a solid in its own frame.
#[derive(Clone, Copy, Debug)]
struct Solid {
    volume: f64,
    centroid: [f64; 3],
    /// Tensor about the centroid, at density 1.
    tensor: [[f64; 3]; 3],
}

impl Default for Shapes<'_> {
    /// Measures each mesh on all threads of the machine.
    fn default() -> Self {
        Self::watched(&|| true)
    }
}

impl fmt::Debug for Shapes<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Shapes").field("meshes", &self.meshes).finish_non_exhaustive()
    }
}

impl<'a> Shapes<'a> {
    /// Measures meshes while `goes_on` returns true. The function is called often; after it returns
    /// false, no mesh is measured.
    pub fn watched(goes_on: &'a (dyn Fn() -> bool + Sync)) -> Self {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        Self { files: &Disk, meshes: MeshFiles::default(), inline: InlineMeshes::default(), threads, goes_on }
    }

    /// Limits the number of threads for each mesh. One is best if several threads call.
    pub fn with_threads(threads: usize) -> Self {
        Self { threads, ..Self::default() }
    }

    /// Sets the file system for mesh files, instead of the disk.
    #[must_use]
    pub fn from_files(self, files: &'a dyn Files) -> Self {
        Self { files, ..self }
    }

    /// Measures a mesh file before a link needs it.
    pub fn read_ahead(&self, path: &Path) {
        // The error is reported when a link needs the mesh.
        let _ = self.mesh(path);
    }

    /// Returns the total of all shapes of a link with this role.
    pub fn link(&self, link: &Link, role: Role) -> LinkVolume {
        self.link_as(link, role, MeshReading::Usual)
    }

    /// Returns true if programs disagree on the up axis of one of these shapes.
    pub fn is_turned_by_some(&self, link: &Link, role: Role) -> bool {
        let mut shapes = link.geometry.iter().filter(|geometry| geometry.role == role);
        shapes.any(|geometry| match &geometry.shape {
            GeometryShape::Mesh { path: Ok(path), .. } => {
                self.mesh(path).is_ok_and(|mesh| mesh.measured.is_ok() && mesh.turned_in.is_some())
            }
            _ => false,
        })
    }

    /// Returns the total of all shapes of a link with this role, with meshes read in this
    /// convention.
    pub fn link_as(&self, link: &Link, role: Role, reading: MeshReading) -> LinkVolume {
        let mut set = LinkVolume::default();
        for geometry in link.geometry.iter().filter(|geometry| geometry.role == role) {
            match self.geometry_as(geometry, reading) {
                Ok(volume) => {
                    set.volume = Some(match set.volume.take() {
                        Some(others) => others.joined(&volume),
                        None => volume,
                    });
                }
                Err(why) => set.left_out.push((geometry.span.clone(), why)),
            }
        }
        set
    }

    /// Measures one shape.
    ///
    /// # Errors
    /// Returns the reason in words why the shape has no volume: an unreadable size, a missing,
    /// unreadable or flat mesh, or a plane.
    pub fn geometry(&self, geometry: &Geometry) -> Result<Volume, String> {
        self.geometry_as(geometry, MeshReading::Usual)
    }

    fn geometry_as(&self, geometry: &Geometry, reading: MeshReading) -> Result<Volume, String> {
        let (solid, reach, kind) = match (&geometry.shape, self.mesh_of(&geometry.shape)) {
            (GeometryShape::Other(what), _) => return Err(format!("{what} has no volume")),
            (_, Some(found)) => {
                let ShapeMesh { mesh, name, scale } = found?;
                let Measured { solid, kind, .. } =
                    mesh.measured.as_ref().map_err(|why| format!("{name:?}: {why}"))?;
                let turns = mesh.turned_in == Some(reading);
                let scaled = |v: &[f64; 3]| {
                    let v = if turns { z_up(*v) } else { *v };
                    geometry.pose.placed([0, 1, 2].map(|k| scale[k] * v[k]))
                };
                let reach = Reach::of(mesh.outline().iter().map(scaled));
                let solid = if turns { solid.z_up() } else { *solid };
                (solid.scaled(scale)?, reach, *kind)
            }
            (shape, None) => {
                let primitive = Primitive::of(shape).map_err(|error| error.to_string())?;
                let reach = primitive.reach(&geometry.pose);
                let body = primitive.mass_properties().map_err(|error| error.to_string())?;
                (Solid::of(&body), reach, VolumeKind::Primitives)
            }
        };
        let volume = Volume {
            volume: solid.volume,
            centroid: geometry.pose.placed(solid.centroid),
            tensor_per_density: geometry.pose.turned_tensor(solid.tensor),
            extent: reach.extent,
            bounds: reach.bounds,
            kind,
        };
        let numbers = volume.tensor_per_density.as_flattened().iter().chain(volume.bounds.as_flattened());
        if numbers.chain(&volume.centroid).all(|x| x.is_finite()) && volume.volume.is_finite() {
            Ok(volume)
        } else {
            Err("its moments are too large for a double".to_owned())
        }
    }

    /// Returns the triangles of a mesh for display: in the most common convention, before scaling and
    /// placing. They need not bound a solid. Returns `None` if the shape is not a mesh.
    ///
    /// # Errors
    /// Returns the reason in words why the mesh cannot be read.
    pub fn surface(&self, shape: &GeometryShape) -> Option<Result<Arc<TriangleMesh>, String>> {
        Some(self.mesh_of(shape)?.map(|found| found.mesh.usual.clone()))
    }

    /// Returns the mesh of a shape; `None` if the shape is not a mesh.
    fn mesh_of<'s>(&self, shape: &'s GeometryShape) -> Option<Result<ShapeMesh<'s>, String>> {
        let (name, scale, mesh) = match shape {
            GeometryShape::Mesh { uri, path, scale } => {
                let path = path.as_ref().map_err(String::clone);
                (&uri.text, scale, path.and_then(|path| self.mesh(path)))
            }
            GeometryShape::Inline { name, mesh, scale } => {
                let mesh = mesh.as_ref().map_err(String::clone);
                (name, scale, mesh.and_then(|mesh| self.inline_mesh(mesh)))
            }
            _ => return None,
        };
        let found = mesh.map(|mesh| ShapeMesh { mesh, name, scale: *scale });
        Some(found.map_err(|why| format!("{name:?}: {why}")))
    }

    fn inline_mesh(&self, inline: &Arc<InlineMesh>) -> Result<Arc<Mesh>, String> {
        if !(self.goes_on)() {
            return Err(ENDED.to_owned());
        }
        self.inline.mesh(inline, |inline| Mesh::of_inline(inline, self.threads, self.goes_on))
    }

    fn mesh(&self, path: &Path) -> Result<Arc<Mesh>, String> {
        if !(self.goes_on)() {
            return Err(ENDED.to_owned());
        }
        self.meshes.mesh(self.files, path, |path| Mesh::read(self.files, path, self.threads, self.goes_on))
    }
}

impl Volume {
    /// Adds two volumes: c = Σ V_k c_k / V,  I = Σ (I_k + V_k (d² 1 − d dᵀ)),  d = c_k − c.
    fn joined(&self, other: &Self) -> Self {
        let volume = self.volume + other.volume;
        let weights = [self.volume / volume, other.volume / volume];
        let centroid = [0, 1, 2].map(|k| weights[0] * self.centroid[k] + weights[1] * other.centroid[k]);
        let moved = |part: &Self| {
            let d = [0, 1, 2].map(|k| part.centroid[k] - centroid[k]);
            let square = dot(d, d);
            let shift = |i: usize, j: usize| part.volume * (if i == j { square } else { 0.0 } - d[i] * d[j]);
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| part.tensor_per_density[i][j] + shift(i, j)))
        };
        let (a, b) = (moved(self), moved(other));
        let [low, high] = self.bounds;
        let [other_low, other_high] = other.bounds;
        Self {
            volume,
            centroid,
            tensor_per_density: [0, 1, 2].map(|k| sum(a[k], b[k])),
            extent: self.extent.max(other.extent),
            bounds: [
                [0, 1, 2].map(|k| low[k].min(other_low[k])),
                [0, 1, 2].map(|k| high[k].max(other_high[k])),
            ],
            kind: if self.kind == other.kind {
                self.kind
            } else {
                self.kind.max(other.kind).max(VolumeKind::Primitives)
            },
        }
    }
}

impl Solid {
    fn of(body: &MassProperties<Part>) -> Self {
        let centroid = body.center_of_mass().to_array();
        Self { volume: body.mass(), centroid, tensor: body.inertia().matrix() }
    }

    /// Rotates by 90° about x: R I Rᵀ.
    fn z_up(self) -> Self {
        let [row_x, row_y, row_z] = self.tensor.map(z_up);
        let [x, y, z] = [0, 1, 2].map(|k| z_up([row_x[k], row_y[k], row_z[k]]));
        let tensor = [0, 1, 2].map(|i| [x[i], y[i], z[i]]);
        Self { volume: self.volume, centroid: z_up(self.centroid), tensor }
    }

    fn scaled(self, scale: [f64; 3]) -> Result<Self, String> {
        let factor = (scale[0] * scale[1] * scale[2]).abs();
        if !(factor > 0.0 && factor.is_finite()) {
            return Err(format!("its scale {scale:?} makes its volume zero"));
        }
        if scale == [1.0; 3] {
            return Ok(self);
        }
        // I = tr(C) 1 − C, so C = ½ tr(I) 1 − I.
        let trace = |m: &[[f64; 3]; 3]| m[0][0] + m[1][1] + m[2][2];
        let half = 0.5 * trace(&self.tensor);
        let one = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
        let moments = [0, 1, 2].map(|i| {
            [0, 1, 2].map(|j| factor * scale[i] * scale[j] * (half * one(i, j) - self.tensor[i][j]))
        });
        let sum = trace(&moments);
        Ok(Self {
            volume: factor * self.volume,
            centroid: [0, 1, 2].map(|k| scale[k] * self.centroid[k]),
            tensor: [0, 1, 2].map(|i| [0, 1, 2].map(|j| sum * one(i, j) - moments[i][j])),
        })
    }
}

/// Rotates a vector from +y up and +z forward to +z up: 90° about x.
const fn z_up([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, -z, y]
}

/// Extent of a shape in the link's frame, m.
#[derive(Clone, Copy, Debug)]
struct Reach {
    extent: f64,
    bounds: [[f64; 3]; 2],
}

impl Reach {
    /// Returns the extent of points, which is also that of their convex hull.
    fn of(points: impl Iterator<Item = [f64; 3]>) -> Self {
        let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        let mut square = 0.0_f64;
        for point in points {
            square = square.max(dot(point, point));
            for (k, c) in point.into_iter().enumerate() {
                bounds[0][k] = bounds[0][k].min(c);
                bounds[1][k] = bounds[1][k].max(c);
            }
        }
        Self { extent: square.sqrt(), bounds }
    }
}
