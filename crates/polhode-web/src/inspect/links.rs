//! Shapes of a robot's links: visual shapes, or collision shapes of a link without visual ones.

use std::collections::HashMap;
use std::sync::Arc;

use polhode::body::mesh::TriangleMesh;
use polhode::body::{BodyError, Form, PlacedForm};
use polhode::math::{Position, Rotation};
use polhode_robot::geometry::Shapes;
use polhode_robot::model::{Geometry, GeometryShape, Link, Name, RobotModel, Role, Span};
use polhode_scenario::report::display::{decimated, shape_of};
use serde_json::{Value, json};

/// Maximum number of triangles of a robot. A robot with more is shown with coarser meshes.
const TRIANGLES: usize = 150_000;

/// Shapes of all links, in the order of the model's links.
pub(super) struct LinkShapes {
    /// Shapes of each link as `Shape` of `viewer/src/data.ts`, in the link's frame.
    pub(super) shapes: Vec<Vec<Value>>,
    pub(super) not_shown: Vec<NotShown>,
}

/// A shape that cannot be shown.
pub(super) struct NotShown {
    pub(super) link: usize,
    pub(super) span: Span,
    pub(super) why: String,
}

impl LinkShapes {
    /// Makes the shapes of a model whose mesh files `measured` has read, or reads now.
    pub(super) fn of(model: &RobotModel, measured: &Shapes<'_>) -> Self {
        let mut meshes = Meshes { measured, triangles: 0, coarse: HashMap::new() };
        meshes.triangles = model.links.iter().flat_map(seen).map(|geometry| meshes.count(geometry)).sum();
        let mut all = Self { shapes: Vec::with_capacity(model.links.len()), not_shown: Vec::new() };
        for (k, link) in model.links.iter().enumerate() {
            let mut shapes = Vec::new();
            for geometry in seen(link) {
                match meshes.shape(geometry, &link.name.text) {
                    Ok(shape) => shapes.push(shape),
                    Err(why) => all.not_shown.push(NotShown { link: k, span: geometry.span.clone(), why }),
                }
            }
            all.shapes.push(shapes);
        }
        all
    }
}

/// Returns the visual shapes of a link, or its collision shapes if it has no visual ones.
fn seen(link: &Link) -> impl Iterator<Item = &Geometry> {
    let is_seen = link.geometry.iter().any(|geometry| geometry.role == Role::Visual);
    let role = if is_seen { Role::Visual } else { Role::Collision };
    link.geometry.iter().filter(move |geometry| geometry.role == role)
}

/// Meshes of a robot, each read once and made coarser once.
struct Meshes<'a, 'b> {
    measured: &'a Shapes<'b>,
    /// Number of triangles of all meshes, counted as often as the robot has them.
    triangles: usize,
    /// Coarser meshes by the address of the surface, which `measured` keeps.
    coarse: HashMap<*const TriangleMesh, Arc<TriangleMesh>>,
}

impl<'a> Meshes<'a, '_> {
    /// Returns the number of triangles of a shape.
    fn count(&mut self, geometry: &Geometry) -> usize {
        let surface = self.measured.surface(&geometry.shape).and_then(Result::ok);
        surface.map_or(0, |surface| surface.triangles().len())
    }

    /// Returns a shape in its link's frame, or the reason why it is not shown.
    fn shape(&mut self, geometry: &'a Geometry, name: &str) -> Result<Value, String> {
        let (form, of) = self.form(&geometry.shape)?;
        let no_place = || "its position is too large for a double".to_owned();
        let position = geometry.pose.position;
        let rotation = Rotation::from_quaternion(geometry.pose.rotation).map_err(|_| no_place())?;
        if !position.iter().all(|x| x.is_finite()) {
            return Err(no_place());
        }
        let placed = PlacedForm { form, position: Position::from_array(position), rotation };
        let shape = shape_of(&placed, name, TRIANGLES);
        let mut shape = shape.ok_or("its size is zero or beyond single precision")?;
        if let Some(count) = shape.get_mut("of") {
            *count = json!(of); // number before simplification
        }
        Ok(shape)
    }

    /// Returns a shape in its own frame, and its number of triangles.
    fn form(&mut self, shape: &'a GeometryShape) -> Result<(Form, usize), String> {
        let (form, sizes) = match *shape {
            GeometryShape::Box(size) => (Form::Box { size }, size.to_vec()),
            GeometryShape::Sphere(radius) => (Form::Ellipsoid { semi_axes: [radius; 3] }, vec![radius]),
            GeometryShape::Cylinder { radius, length } => {
                (Form::Cylinder { radius, inner_radius: 0.0, length }, vec![radius, length])
            }
            GeometryShape::Capsule { radius, length } => {
                (Form::Capsule { radius, length }, vec![radius, length])
            }
            GeometryShape::Ellipsoid(semi_axes) => (Form::Ellipsoid { semi_axes }, semi_axes.to_vec()),
            GeometryShape::Mesh { uri: Name { text: ref name, .. }, scale, .. }
            | GeometryShape::Inline { ref name, scale, .. } => {
                let surface = self.measured.surface(shape).unwrap_or_else(|| Err("not a mesh".to_owned()));
                let surface = surface?;
                let mesh = scaled(self.coarse(&surface).as_ref(), scale);
                let mesh = mesh.map_err(|error| format!("{name:?}: {error}"))?;
                return Ok((Form::Mesh(mesh), surface.triangles().len()));
            }
            GeometryShape::Cone { .. } => return Err("cones are not supported".to_owned()),
            GeometryShape::Other(ref what) => return Err(format!("{what} has no size")),
        };
        match sizes.iter().all(|size| *size > 0.0 && size.is_finite()) {
            true => Ok((form, 0)),
            false => Err("its sizes are not positive finite numbers".to_owned()),
        }
    }

    /// Returns a mesh with its share of the triangles.
    fn coarse(&mut self, surface: &Arc<TriangleMesh>) -> Arc<TriangleMesh> {
        if self.triangles <= TRIANGLES {
            return surface.clone();
        }
        let part = surface.triangles().len() as f64 / self.triangles as f64;
        let coarse = || Arc::new(decimated(surface, (part * TRIANGLES as f64) as usize));
        self.coarse.entry(Arc::as_ptr(surface)).or_insert_with(coarse).clone()
    }
}

/// Scales every vertex along the axes. For a mirror image, it reverses the triangles so that
/// normals remain outward.
fn scaled(mesh: &TriangleMesh, scale: [f64; 3]) -> Result<TriangleMesh, BodyError> {
    let mirrors = scale.iter().filter(|factor| **factor < 0.0).count() % 2 == 1;
    let place = |vertex: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|k| scale[k] * vertex[k]) };
    let turn = |&[a, b, c]: &[u32; 3]| if mirrors { [a, c, b] } else { [a, b, c] };
    let vertices: Vec<[f64; 3]> = mesh.coordinates().iter().map(place).collect();
    TriangleMesh::new(vertices, mesh.triangles().iter().map(turn).collect())
}
