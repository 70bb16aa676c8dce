//! Shapes with closed-form mass properties, and their keys.

use std::sync::Arc;

use polhode::body::density::{Parametrised, Solid};
use polhode::body::mesh::{ClosedMesh, MeshUnion};
use polhode::body::shape::{
    BoxShape, BoxShell, Capsule, Cone, ConeShell, Cylinder, CylinderShell, Disk, Ellipsoid, Plate, Rod,
    Shape, Sphere, SphereShell, Tetrahedron, Torus, TriangularPlate, TriangularPrism,
};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value, each};
use polhode_source::unit::Dimension;

/// Name of each shape, with its own keys.
pub const SHAPES: [(&str, &[&str]); 17] = [
    ("box", &["size"]),
    ("sphere", &["radius", "inner_radius"]),
    ("ellipsoid", &["semi_axes"]),
    ("cylinder", &["radius", "length", "inner_radius"]),
    ("capsule", &["radius", "length"]),
    ("cone", &["radius", "height", "top_radius"]),
    ("torus", &["ring_radius", "tube_radius"]),
    ("tetrahedron", &["vertices"]),
    ("triangular_prism", &["vertices", "length"]),
    ("rod", &["length"]),
    ("disk", &["radius", "thickness"]),
    ("plate", &["size", "thickness"]),
    ("triangular_plate", &["vertices", "thickness"]),
    ("sphere_shell", &["radius", "thickness"]),
    ("box_shell", &["size", "thickness"]),
    ("cylinder_shell", &["radius", "length", "ends", "thickness"]),
    ("cone_shell", &["radius", "height", "top_radius", "ends", "thickness"]),
];

/// Shape, classified by the kind of density that it accepts.
pub(crate) enum Geometry {
    /// Solid; the density may vary.
    Solid(Box<dyn Parametrised>),
    /// Polyhedron; the density may vary.
    Mesh(Arc<ClosedMesh>),
    /// Union of the parts of a mesh; the density is uniform.
    Union(Box<MeshUnion>),
    /// Thin shell, plate or rod; the density is uniform.
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

    /// Returns the solid if a variable density can be integrated over it.
    pub(crate) fn as_solid(&self) -> Option<Solid<'_>> {
        match self {
            Self::Solid(shape) => Some(Solid::Shape(shape.as_ref())),
            Self::Mesh(mesh) => Some(Solid::Mesh(mesh)),
            Self::Union(_) | Self::Thin(_) => None,
        }
    }
}

/// Returns the shape of that name with the sizes in its table.
pub(crate) fn shape(name: &str, table: &Table<'_>) -> Result<Geometry, FormatError> {
    let radius = || table.require("radius", "radius = \"4 mm\"");
    let length = || table.require("length", "length = \"40 mm\"");
    let size = || table.require("size", "size = [\"30 mm\", \"20 mm\", \"10 mm\"]");
    let ends = || table.get("ends").map_or(Ok(false), |ends| ends.boolean());
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
        "sphere" => {
            let (radius, inner) = (radius()?, inner_radius(table)?);
            let outer = radius.positive(Dimension::LENGTH)?;
            let sphere = Sphere::hollow(outer, inner.as_ref().map_or(0.0, |(_, inner)| *inner));
            Geometry::solid(sphere.map_err(|e| inner.map_or(radius, |(value, _)| value).body(e))?)
        }
        "sphere_shell" => Geometry::thin(measured(&radius()?, SphereShell::new)?),
        "disk" => Geometry::thin(measured(&radius()?, Disk::new)?),
        "rod" => Geometry::thin(measured(&length()?, Rod::new)?),
        "cylinder" => {
            let (radius, length, inner) = (radius()?, length()?, inner_radius(table)?);
            let [outer, long] = [&radius, &length].map(|value| value.positive(Dimension::LENGTH));
            let cylinder = Cylinder::hollow(outer?, inner.as_ref().map_or(0.0, |(_, inner)| *inner), long?);
            Geometry::solid(cylinder.map_err(|e| inner.map_or(length, |(value, _)| value).body(e))?)
        }
        "capsule" => Geometry::solid(measured_by_two(&radius()?, &length()?, Capsule::new)?),
        "cylinder_shell" => {
            let ends = ends()?;
            Geometry::thin(measured_by_two(&radius()?, &length()?, |r, l| CylinderShell::new(r, l, ends))?)
        }
        "torus" => {
            let ring = table.require("ring_radius", "ring_radius = \"30 mm\"")?;
            let tube = table.require("tube_radius", "tube_radius = \"5 mm\"")?;
            Geometry::solid(measured_by_two(&ring, &tube, Torus::new)?)
        }
        "triangular_plate" => {
            let corners = table.require("vertices", TRIANGLE)?;
            let plate = TriangularPlate::new(points(&corners)?);
            Geometry::thin(plate.map_err(|e| corners.body(e))?)
        }
        "triangular_prism" => {
            let (corners, length) = (table.require("vertices", TRIANGLE)?, length()?);
            let prism = TriangularPrism::new(points(&corners)?, length.positive(Dimension::LENGTH)?);
            Geometry::solid(prism.map_err(|e| corners.body(e))?)
        }
        "ellipsoid" => {
            let axes = table.require("semi_axes", "semi_axes = [\"30 mm\", \"20 mm\", \"10 mm\"]")?;
            Geometry::solid(Ellipsoid::new(axes.positives(Dimension::LENGTH)?).map_err(|e| axes.body(e))?)
        }
        "tetrahedron" => {
            let corners =
                table.require("vertices", "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]")?;
            let vertices = points(&corners)?;
            Geometry::solid(Tetrahedron::new(vertices).map_err(|e| corners.body(e))?)
        }
        _ => {
            let (base, height) = (radius()?, table.require("height", "height = \"40 mm\"")?);
            // Either radius of a cone may be zero, at its tip.
            let top_radius = table.get("top_radius").as_ref().map_or(Ok(0.0), not_negative)?;
            let (base_radius, long) = (not_negative(&base)?, height.positive(Dimension::LENGTH)?);
            if name == "cone_shell" {
                let shell = ConeShell::new(base_radius, top_radius, long, ends()?);
                Geometry::thin(shell.map_err(|e| base.body(e))?)
            } else {
                Geometry::solid(Cone::new(base_radius, top_radius, long).map_err(|e| base.body(e))?)
            }
        }
    })
}

const TRIANGLE: &str = "vertices = [[0, 0], [\"30 mm\", 0], [0, \"20 mm\"]]";

/// Reads the inner radius, if given; the shape checks that it is less than the outer one.
fn inner_radius<'a>(table: &Table<'a>) -> Result<Option<(Value<'a>, f64)>, FormatError> {
    let Some(value) = table.get("inner_radius") else { return Ok(None) };
    let inner = not_negative(&value)?;
    Ok(Some((value, inner)))
}

/// Reads a radius that may be zero, m.
fn not_negative(value: &Value<'_>) -> Result<f64, FormatError> {
    let radius = value.quantity(Dimension::LENGTH)?;
    if radius >= 0.0 {
        return Ok(radius);
    }
    Err(value.invalid("zero or positive").with_hint("a radius has no sign"))
}

/// Reads an array of N points with K coordinates, m.
fn points<const N: usize, const K: usize>(corners: &Value<'_>) -> Result<[[f64; K]; N], FormatError> {
    let mut points = [[0.0; K]; N];
    for (point, values) in points.iter_mut().zip(corners.rows::<N, K>()?) {
        *point = each(values, |value| value.quantity(Dimension::LENGTH))?;
    }
    Ok(points)
}

fn measured<S>(
    value: &Value<'_>,
    new: impl Fn(f64) -> Result<S, polhode::body::BodyError>,
) -> Result<S, FormatError> {
    new(value.positive(Dimension::LENGTH)?).map_err(|e| value.body(e))
}

/// Creates a shape from two lengths; an error that concerns both is reported at the second.
fn measured_by_two<S>(
    first: &Value<'_>,
    second: &Value<'_>,
    new: impl Fn(f64, f64) -> Result<S, polhode::body::BodyError>,
) -> Result<S, FormatError> {
    new(first.positive(Dimension::LENGTH)?, second.positive(Dimension::LENGTH)?).map_err(|e| second.body(e))
}
