//! The shapes with closed forms, and what each is measured by.

use std::sync::Arc;

use polhode::body::density::{Parametrised, Solid};
use polhode::body::mesh::{ClosedMesh, MeshUnion};
use polhode::body::shape::{
    BoxShape, BoxShell, Capsule, Cone, Cylinder, CylinderShell, Disk, Ellipsoid, Plate, Rod, Shape, Sphere,
    SphereShell, Tetrahedron, Torus,
};

use super::reader::{Table, Value, each};
use crate::error::FormatError;
use crate::unit::Dimension;

/// Each shape's name and its own keys.
pub(crate) const SHAPES: [(&str, &[&str]); 14] = [
    ("box", &["size"]),
    ("sphere", &["radius"]),
    ("ellipsoid", &["semi_axes"]),
    ("cylinder", &["radius", "length"]),
    ("capsule", &["radius", "length"]),
    ("cone", &["radius", "height", "top_radius"]),
    ("torus", &["ring_radius", "tube_radius"]),
    ("tetrahedron", &["vertices"]),
    ("rod", &["length"]),
    ("disk", &["radius", "thickness"]),
    ("plate", &["size", "thickness"]),
    ("sphere_shell", &["radius", "thickness"]),
    ("box_shell", &["size", "thickness"]),
    ("cylinder_shell", &["radius", "length", "ends", "thickness"]),
];

/// A shape, by what its density may be.
pub(crate) enum Geometry {
    /// A solid whose density may vary.
    Solid(Box<dyn Parametrised>),
    /// A polyhedron, whose density may vary too.
    Mesh(Arc<ClosedMesh>),
    /// What the parts of a mesh enclose together, of one density.
    Union(Box<MeshUnion>),
    /// A thin shell, plate or rod.
    Thin(Box<dyn Shape>),
}

impl Geometry {
    fn solid(shape: impl Parametrised + 'static) -> Self {
        Self::Solid(Box::new(shape))
    }

    fn thin(shape: impl Shape + 'static) -> Self {
        Self::Thin(Box::new(shape))
    }

    pub(crate) fn as_shape(&self) -> &dyn Shape {
        match self {
            Self::Solid(shape) => shape.as_ref(),
            Self::Mesh(mesh) => mesh.as_ref(),
            Self::Union(union) => union.as_ref(),
            Self::Thin(shape) => shape.as_ref(),
        }
    }

    /// What a density can be spread over that is not the same everywhere.
    pub(crate) fn as_solid(&self) -> Option<Solid<'_>> {
        match self {
            Self::Solid(shape) => Some(Solid::Shape(shape.as_ref())),
            Self::Mesh(mesh) => Some(Solid::Mesh(mesh)),
            Self::Union(_) | Self::Thin(_) => None,
        }
    }
}

/// The shape of that name, as its table measures it.
pub(crate) fn shape(name: &str, table: &Table<'_>) -> Result<Geometry, FormatError> {
    let radius = || table.require("radius", "radius = \"4 mm\"");
    let length = || table.require("length", "length = \"40 mm\"");
    let size = || table.require("size", "size = [\"30 mm\", \"20 mm\", \"10 mm\"]");
    Ok(match name {
        "box" => {
            let size = size()?;
            Geometry::solid(BoxShape::new(size.positives(Dimension::LENGTH)?).map_err(|e| size.body(e))?)
        }
        "box_shell" => {
            let size = size()?;
            Geometry::thin(BoxShell::new(size.positives(Dimension::LENGTH)?).map_err(|e| size.body(e))?)
        }
        "plate" => {
            let size = table.require("size", "size = [\"30 mm\", \"20 mm\"]")?;
            Geometry::thin(Plate::new(size.positives(Dimension::LENGTH)?).map_err(|e| size.body(e))?)
        }
        "sphere" => Geometry::solid(measured(&radius()?, Sphere::new)?),
        "sphere_shell" => Geometry::thin(measured(&radius()?, SphereShell::new)?),
        "disk" => Geometry::thin(measured(&radius()?, Disk::new)?),
        "rod" => Geometry::thin(measured(&length()?, Rod::new)?),
        "cylinder" => Geometry::solid(measured_by_two(&radius()?, &length()?, Cylinder::new)?),
        "capsule" => Geometry::solid(measured_by_two(&radius()?, &length()?, Capsule::new)?),
        "cylinder_shell" => {
            let ends = table.get("ends").map_or(Ok(false), |ends| ends.boolean())?;
            Geometry::thin(measured_by_two(&radius()?, &length()?, |r, l| CylinderShell::new(r, l, ends))?)
        }
        "torus" => {
            let ring = table.require("ring_radius", "ring_radius = \"30 mm\"")?;
            let tube = table.require("tube_radius", "tube_radius = \"5 mm\"")?;
            Geometry::solid(measured_by_two(&ring, &tube, Torus::new)?)
        }
        "ellipsoid" => {
            let axes = table.require("semi_axes", "semi_axes = [\"30 mm\", \"20 mm\", \"10 mm\"]")?;
            Geometry::solid(Ellipsoid::new(axes.positives(Dimension::LENGTH)?).map_err(|e| axes.body(e))?)
        }
        "tetrahedron" => {
            let corners =
                table.require("vertices", "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]")?;
            let mut vertices = [[0.0; 3]; 4];
            for (vertex, values) in vertices.iter_mut().zip(corners.rows::<4>()?) {
                *vertex = each(values, |value| value.quantity(Dimension::LENGTH))?;
            }
            Geometry::solid(Tetrahedron::new(vertices).map_err(|e| corners.body(e))?)
        }
        _ => {
            let (base, height) = (radius()?, table.require("height", "height = \"40 mm\"")?);
            let top = table.get("top_radius");
            // A cone's tip has the radius zero, on either side.
            let width = |value: &Value<'_>| {
                let width = value.quantity(Dimension::LENGTH)?;
                match width >= 0.0 {
                    true => Ok(width),
                    false => Err(value.invalid("zero or positive").with_hint("a radius has no sign")),
                }
            };
            let top_radius = top.as_ref().map_or(Ok(0.0), width)?;
            let cone = Cone::new(width(&base)?, top_radius, height.positive(Dimension::LENGTH)?);
            Geometry::solid(cone.map_err(|e| base.body(e))?)
        }
    })
}

fn measured<S>(
    value: &Value<'_>,
    new: impl Fn(f64) -> Result<S, polhode::body::BodyError>,
) -> Result<S, FormatError> {
    new(value.positive(Dimension::LENGTH)?).map_err(|e| value.body(e))
}

/// If the two do not fit together, the second is to blame.
fn measured_by_two<S>(
    first: &Value<'_>,
    second: &Value<'_>,
    new: impl Fn(f64, f64) -> Result<S, polhode::body::BodyError>,
) -> Result<S, FormatError> {
    new(first.positive(Dimension::LENGTH)?, second.positive(Dimension::LENGTH)?).map_err(|e| second.body(e))
}
