//! Shapes with closed-form integrals, selected by name.

use polhode::body::BodyError;
use polhode::body::shape::{
    BoxShape, BoxShell, Capsule, Cone, ConeShell, Cylinder, CylinderShell, Disk, Ellipsoid, Plate, Rod,
    Shape, Sphere, SphereShell, Tetrahedron, Torus, TriangularPlate, TriangularPrism,
};
use polhode_document::SourceInfo;
use polhode_shape::in_body;
use polhode_shape::report::InertiaReport;
use pyo3::prelude::*;

use crate::error::{Raise, refused};
use crate::mass_properties::PyMassProperties;
use crate::substance::Given;

/// Returns the mass properties of a shape from its name, its lengths (m) in the order of the
/// function of that name in `shapes.py`, and its substance.
///
/// # Errors
/// `PolhodeError` for an unknown shape.
#[pyfunction]
pub(crate) fn shape(kind: &str, lengths: Vec<f64>, ends: bool, given: Given) -> PyResult<PyMassProperties> {
    let shape = of_name(kind, &lengths, ends)?.map_err(Raise::raise)?;
    let part = shape.mass_properties(given.required()?).map_err(Raise::raise)?;
    let extent = shape.spread().extent();
    let properties = in_body(part).map_err(Raise::raise)?;
    let volume = extent.volume();
    Ok(PyMassProperties::of(InertiaReport {
        surface_area: Some(shape.surface_area()).filter(|area| *area > 0.0),
        ..InertiaReport::new(SourceInfo::new(kind, "shape"), properties).with_volume(volume)
    }))
}

fn of_name(kind: &str, lengths: &[f64], ends: bool) -> PyResult<Result<Box<dyn Shape>, BodyError>> {
    fn boxed<S: Shape + 'static>(shape: Result<S, BodyError>) -> Result<Box<dyn Shape>, BodyError> {
        shape.map(|shape| Box::new(shape) as Box<dyn Shape>)
    }
    Ok(match (kind, lengths) {
        ("box", &[a, b, c]) => boxed(BoxShape::new([a, b, c])),
        ("box_shell", &[a, b, c]) => boxed(BoxShell::new([a, b, c])),
        ("capsule", &[radius, length]) => boxed(Capsule::new(radius, length)),
        ("cone", &[base, top, height]) => boxed(Cone::new(base, top, height)),
        ("cone_shell", &[base, top, height]) => boxed(ConeShell::new(base, top, height, ends)),
        ("cylinder", &[radius, inner, length]) => boxed(Cylinder::hollow(radius, inner, length)),
        ("cylinder_shell", &[radius, length]) => boxed(CylinderShell::new(radius, length, ends)),
        ("disk", &[radius]) => boxed(Disk::new(radius)),
        ("ellipsoid", &[a, b, c]) => boxed(Ellipsoid::new([a, b, c])),
        ("plate", &[a, b]) => boxed(Plate::new([a, b])),
        ("rod", &[length]) => boxed(Rod::new(length)),
        ("sphere", &[radius, inner]) => boxed(Sphere::hollow(radius, inner)),
        ("sphere_shell", &[radius]) => boxed(SphereShell::new(radius)),
        ("tetrahedron", lengths) => match lengths.as_chunks().0 {
            &[a, b, c, d] => boxed(Tetrahedron::new([a, b, c, d])),
            _ => return Err(refused("a tetrahedron has four vertices", None)),
        },
        ("triangular_plate", &[a, b, c, d, e, f]) => boxed(TriangularPlate::new([[a, b], [c, d], [e, f]])),
        ("triangular_prism", &[a, b, c, d, e, f, length]) => {
            boxed(TriangularPrism::new([[a, b], [c, d], [e, f]], length))
        }
        ("torus", &[ring, tube]) => boxed(Torus::new(ring, tube)),
        _ => return Err(refused(format!("the shape {kind} does not have {} lengths", lengths.len()), None)),
    })
}
