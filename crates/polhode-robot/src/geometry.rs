//! What the shapes of a link enclose: volume, centroid and tensor at a density of 1, in the link's frame.
//!
//! Volumes of several shapes add; what they share counts for each of them. A mesh that bounds no solid stands for its convex hull, and
//! says so. Scale is applied to the moments, once: with S = diag(s), x' = S x,
//!
//! V' = |det S| V,  c' = S c,  ∫x'x'ᵀ dV' = |det S| S (∫x xᵀ dV) S,
//!
//! so a mirror turns the signs of two products and leaves the volume positive. The hull of a scaled mesh is the scaled hull.
//!
//! glTF has +y up and +z forward (glTF 2.0, 3.4), and robots have +z up. Drake, Genesis and RViz (from 2025 on) turn such a mesh by a
//! quarter about x, (x, y, z) → (x, −z, y), before it is scaled and placed; others, and RViz before, take it as it is. COLLADA's
//! `<up_axis>` is ignored by Gazebo and RViz, and applied by others. [`MeshReading`] names both.

mod mesh;
mod mesh_files;
mod outside;
mod primitive;
mod separation;

use std::fmt;
use std::path::Path;
use std::sync::Arc;
use std::thread;

use polhode::body::MassProperties;
use polhode::body::mesh::TriangleMesh;
use polhode::math::Part;
use polhode_source::files::{Disk, Files};

use crate::model::{Geometry, GeometryShape, Link, Role, Span};
use crate::pose::{dot, sum};
use mesh::{Measured, Mesh};
use mesh_files::MeshFiles;
use primitive::Primitive;

pub use mesh_files::mesh_files;

/// What a shape, or several, enclose. All of it is in the link's frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    /// m³, positive.
    pub volume: f64,
    /// m
    pub centroid: [f64; 3],
    /// About the centroid, along the link's axes, at 1 kg/m³: kg·m² for a volume in m³. Elements of the tensor (−∫xy dV).
    pub tensor_per_density: [[f64; 3]; 3],
    /// The distance of the farthest point from the link's origin, m; of an ellipsoid, a bound of it.
    pub extent: f64,
    /// The least and the greatest x, y, z, m.
    pub bounds: [[f64; 3]; 2],
    /// How it was found.
    pub kind: VolumeKind,
}

/// How a volume was found, in the order of trust.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum VolumeKind {
    /// All of it is bounded by closed meshes.
    Closed,
    /// At least some of it is boxes, spheres, cylinders …, and nothing is a hull.
    Primitives,
    /// At least some of it is the convex hull of a mesh that bounds no solid.
    Hull,
}

/// The volume of one set of a link's shapes: all that is seen, or all that is touched.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinkVolume {
    /// The shapes that could be measured, as one; `None` if there are none.
    pub volume: Option<Volume>,
    /// Those that could not, and why: then the volume and its bounds are not those of the whole set.
    pub left_out: Vec<(Span, String)>,
}

/// How a mesh is read whose up axis programs treat in two ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshReading {
    /// glTF turned from y up to z up, COLLADA as it is.
    Usual,
    /// glTF as it is, COLLADA turned.
    Other,
}

/// Measures shapes, for several threads at once; each mesh file is read once.
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
    threads: usize,
    goes_on: &'a (dyn Fn() -> bool + Sync),
}

/// Of what nobody waits for any more.
const ENDED: &str = "it was not looked at: that would take too long";

/// Volume and moments of a solid in its own frame.
#[derive(Clone, Copy, Debug)]
struct Solid {
    volume: f64,
    centroid: [f64; 3],
    /// About the centroid at a density of 1.
    tensor: [[f64; 3]; 3],
}

impl Default for Shapes<'_> {
    /// Each mesh is measured on all threads of the machine.
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
    /// Measures as long as it `goes_on`, which is asked often: after that no mesh is measured.
    pub fn watched(goes_on: &'a (dyn Fn() -> bool + Sync)) -> Self {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        Self { files: &Disk, meshes: MeshFiles::default(), threads, goes_on }
    }

    /// Measures each mesh on at most so many threads: one is best where several ask.
    pub fn with_threads(threads: usize) -> Self {
        Self { threads, ..Self::default() }
    }

    /// Takes the mesh files from `files`, and not from this machine.
    #[must_use]
    pub fn from_files(self, files: &'a dyn Files) -> Self {
        Self { files, ..self }
    }

    /// Measures a mesh file before a link asks for it.
    pub fn read_ahead(&self, path: &Path) {
        // why it cannot be measured is said to who asks
        let _ = self.mesh(path);
    }

    /// All shapes of a link that have this role, as one.
    pub fn link(&self, link: &Link, role: Role) -> LinkVolume {
        self.link_as(link, role, MeshReading::Usual)
    }

    /// True if programs disagree on how one of these shapes is turned.
    pub fn is_turned_by_some(&self, link: &Link, role: Role) -> bool {
        let mut shapes = link.geometry.iter().filter(|geometry| geometry.role == role);
        shapes.any(|geometry| match &geometry.shape {
            GeometryShape::Mesh { path: Ok(path), .. } => {
                self.mesh(path).is_ok_and(|mesh| mesh.measured.is_ok() && mesh.turned_in.is_some())
            }
            _ => false,
        })
    }

    /// All shapes of a link that have this role, as one, with its meshes read in this way.
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

    /// One shape.
    ///
    /// # Errors
    /// In words, why it has no volume: a size that is none, a mesh that cannot be found or read or is flat, a plane.
    pub fn geometry(&self, geometry: &Geometry) -> Result<Volume, String> {
        self.geometry_as(geometry, MeshReading::Usual)
    }

    fn geometry_as(&self, geometry: &Geometry, reading: MeshReading) -> Result<Volume, String> {
        let (solid, reach, kind) = match &geometry.shape {
            GeometryShape::Other(what) => return Err(format!("{what} has no volume")),
            GeometryShape::Mesh { uri, path, scale } => {
                let path = path.as_ref().map_err(|why| format!("{:?}: {why}", uri.text))?;
                let named = |why: String| format!("{:?}: {why}", uri.text);
                let mesh = self.mesh(path).map_err(named)?;
                let Measured { solid, kind, .. } =
                    mesh.measured.as_ref().map_err(|why| named(why.clone()))?;
                let turns = mesh.turned_in == Some(reading);
                let scaled = |v: &[f64; 3]| {
                    let v = if turns { z_up(*v) } else { *v };
                    geometry.pose.placed([0, 1, 2].map(|k| scale[k] * v[k]))
                };
                let reach = Reach::of(mesh.outline().iter().map(scaled));
                let solid = if turns { solid.z_up() } else { *solid };
                (solid.scaled(*scale)?, reach, *kind)
            }
            shape => {
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
            Err("its moments are beyond the largest double".to_owned())
        }
    }

    /// The triangles of a mesh file, for those who draw them: in metres, as most programs turn it, before it is scaled and placed. They need
    /// not bound a solid.
    ///
    /// # Errors
    /// In words, why the file cannot be read.
    pub fn surface(&self, path: &Path) -> Result<Arc<TriangleMesh>, String> {
        Ok(self.mesh(path)?.usual.clone())
    }

    fn mesh(&self, path: &Path) -> Result<Arc<Mesh>, String> {
        if !(self.goes_on)() {
            return Err(ENDED.to_owned());
        }
        self.meshes.mesh(self.files, path, |path| Mesh::read(self.files, path, self.threads, self.goes_on))
    }
}

impl Volume {
    /// Both as one: c = Σ V_k c_k / V,  I = Σ (I_k + V_k (d² 1 − d dᵀ)),  d = c_k − c.
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

    /// A quarter of a turn about x, R I Rᵀ.
    fn z_up(self) -> Self {
        let [row_x, row_y, row_z] = self.tensor.map(z_up);
        let [x, y, z] = [0, 1, 2].map(|k| z_up([row_x[k], row_y[k], row_z[k]]));
        let tensor = [0, 1, 2].map(|i| [x[i], y[i], z[i]]);
        Self { volume: self.volume, centroid: z_up(self.centroid), tensor }
    }

    fn scaled(self, scale: [f64; 3]) -> Result<Self, String> {
        let factor = (scale[0] * scale[1] * scale[2]).abs();
        if !(factor > 0.0 && factor.is_finite()) {
            return Err(format!("its scale {scale:?} leaves no volume"));
        }
        if scale == [1.0; 3] {
            return Ok(self);
        }
        // I = tr(C) 1 − C, so C = ½ tr(I) 1 − I
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

/// From +y up and +z forward to +z up: a quarter of a turn about x.
const fn z_up([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, -z, y]
}

/// How far something goes, in the link's frame.
#[derive(Clone, Copy, Debug)]
struct Reach {
    extent: f64,
    bounds: [[f64; 3]; 2],
}

impl Reach {
    /// Of points, and of what is convex around them.
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
