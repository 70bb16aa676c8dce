//! Derivatives of mass properties. Ten rows: mass, centre of mass, and tensor about it, xx yy zz xy
//! xz yz.

use numpy::{PyArray1, PyArray2, PyArray3, PyReadonlyArray1, PyReadonlyArray2};
use polhode::body::mesh::{ClosedMesh, MeshDerivatives, TriangleMesh};
use polhode::body::shape::{Shape as _, Substance};
use polhode::body::{
    AssemblyDerivatives, BodyError, MassProperties, MassPropertiesDerivative, MassPropertiesGradient,
    PartDerivatives, Particle, ParticleDerivatives, PlacedPart,
};
use polhode::math::{Body, Direction, Part, Position, Rotation};
use polhode_document::SourceInfo;
use polhode_shape::report::InertiaReport;
use pyo3::prelude::*;

use crate::arrays::{cube, numbers, room, rows, table};
use crate::error::{Raise, refused};
use crate::interrupt::{copied, watched_apart};
use crate::mass_properties::PyMassProperties;
use crate::substance::Given;

/// Derivatives with respect to each particle: arrays (10, n) and (10, n, 3).
#[derive(Debug, IntoPyObject)]
pub(crate) struct ByParticles<'py> {
    by_masses: Bound<'py, PyArray2<f64>>,
    by_positions: Bound<'py, PyArray3<f64>>,
}

/// Returns derivatives with respect to the masses and positions of particles.
///
/// # Errors
/// `PolhodeError` without particles, or if a derivative is not finite.
#[pyfunction]
pub(crate) fn particle_derivatives<'py>(
    py: Python<'py>,
    masses: PyReadonlyArray1<'py, f64>,
    positions: PyReadonlyArray2<'py, f64>,
) -> PyResult<ByParticles<'py>> {
    let (masses, positions) = (numbers(&masses)?, rows::<3>(&positions)?);
    room::<f64>("the derivatives", masses.len().checked_mul(80))?;
    let n = masses.len();
    let [by_masses, by_positions] = py
        .detach(|| {
            let each = masses.iter().zip(positions);
            let particles = each.map(|(&mass, &place)| Particle::new(mass, Position::from_array(place)));
            let by = ParticleDerivatives::<Body>::of(&particles.collect::<Result<Vec<_>, _>>()?)?;
            Ok([columns(by.iter().map(|of| of.by_mass)), columns(by.iter().flat_map(|of| of.by_position))])
        })
        .map_err(|error: BodyError| error.raise())?;
    Ok(ByParticles {
        by_masses: table(py, finite(by_masses)?, n)?,
        by_positions: cube(py, finite(by_positions)?, [10, n, 3])?,
    })
}

/// Derivatives with respect to each part of a body: arrays (10, n), (10, n, 3), (10, n, 3) and (10,
/// n, 10).
#[derive(Debug, IntoPyObject)]
pub(crate) struct ByParts<'py> {
    by_masses: Bound<'py, PyArray2<f64>>,
    by_positions: Bound<'py, PyArray3<f64>>,
    by_rotations: Bound<'py, PyArray3<f64>>,
    by_parts: Bound<'py, PyArray3<f64>>,
}

/// Returns derivatives with respect to the mass, position, rotation about a point, and ten mass
/// properties of each part.
///
/// # Errors
/// `PolhodeError` if a derivative is not finite.
#[pyfunction]
pub(crate) fn body_derivatives<'py>(
    py: Python<'py>,
    parts: Vec<PyRef<'py, PyMassProperties>>,
    about: Vec<[f64; 3]>,
) -> PyResult<ByParts<'py>> {
    let placed = |(part, point): (&PyRef<'py, PyMassProperties>, &[f64; 3])| {
        let (body, point) = (part.properties(), Position::from_array(*point));
        let arm = (body.center_of_mass() - point).to_array();
        let tensor = body.inertia().in_frame::<Part>(Rotation::identity());
        let own = MassProperties::new(body.mass(), Position::from_array(arm), tensor)?;
        PlacedPart::new(own, point, Rotation::identity())
    };
    let placed: Result<Vec<_>, BodyError> = parts.iter().zip(&about).map(placed).collect();
    let (placed, n) = (placed.map_err(Raise::raise)?, parts.len());
    let [masses, positions, rotations, own] = py
        .detach(|| {
            let AssemblyDerivatives { parts, .. } = AssemblyDerivatives::of(&placed)?;
            let units = unit_changes();
            Ok([
                columns(parts.iter().map(PartDerivatives::by_mass)),
                columns(parts.iter().flat_map(PartDerivatives::by_position)),
                columns(parts.iter().flat_map(PartDerivatives::by_rotation)),
                columns(parts.iter().flat_map(|part| units.map(|unit| part.by_part_change(&unit)))),
            ])
        })
        .map_err(|error: BodyError| error.raise())?;
    Ok(ByParts {
        by_masses: table(py, finite(masses)?, n)?,
        by_positions: cube(py, finite(positions)?, [10, n, 3])?,
        by_rotations: cube(py, finite(rotations)?, [10, n, 3])?,
        by_parts: cube(py, finite(own)?, [10, n, 10])?,
    })
}

/// Closed mesh, with the mapping from given vertices to its vertices.
#[pyclass(frozen, name = "MeshDerivatives", module = "polhode._native")]
#[derive(Debug)]
pub(crate) struct PyMeshDerivatives {
    solid: ClosedMesh,
    substance: Substance,
    vertices: Vec<Vertex>,
}

/// Mapping of a given vertex: number of the mesh vertex, and share of its derivatives. `None` for a
/// vertex outside all triangles.
type Vertex = Option<(u32, f64)>;

#[pymethods]
impl PyMeshDerivatives {
    /// Creates a mesh from vertices (n, 3), m, and triangles (m, 3) as vertex numbers.
    #[staticmethod]
    fn of(
        py: Python<'_>,
        vertices: PyReadonlyArray2<'_, f64>,
        triangles: PyReadonlyArray2<'_, u32>,
        given: Given,
    ) -> PyResult<Self> {
        let substance = given.required()?;
        let points = copied(py, rows::<3>(&vertices)?)?;
        let corners = triangles.as_slice().map_err(|error| refused(error.to_string(), None))?;
        let corners = copied(py, corners.as_chunks().0)?;
        watched_apart(py, move |goes_on| {
            let mesh = TriangleMesh::new(points, corners).map_err(Raise::raise)?;
            let solid = ClosedMesh::watched(&mesh, goes_on).map_err(Raise::raise)?;
            solid.mass_properties(substance).map_err(Raise::raise)?;
            let vertices = found(&solid, mesh.coordinates(), mesh.triangles())?;
            Ok(Self { solid, substance, vertices })
        })?
    }

    #[getter]
    fn mass_properties(&self) -> PyResult<PyMassProperties> {
        let properties = self.derivatives()?.properties().into_body();
        let words = format!("arrays, {} triangles", self.solid.surface().triangles().len());
        Ok(PyMassProperties::of(InertiaReport {
            surface_area: Some(self.solid.surface_area()),
            findings: self.solid.findings().to_vec(),
            ..InertiaReport::new(SourceInfo::new("arrays", "python").described(words), properties)
                .with_volume(Some(self.solid.volume()))
        }))
    }

    /// Derivatives with respect to the mass, (10,).
    #[getter]
    fn by_mass<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(PyArray1::from_vec(py, finite(columns([self.derivatives()?.by_mass()]))?))
    }

    /// Derivatives with respect to the density, (10,).
    #[getter]
    fn by_density<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(PyArray1::from_vec(py, finite(columns([self.derivatives()?.by_density()]))?))
    }

    /// Returns derivatives (k, n, 3) of k functions of the mass properties with respect to the
    /// vertices; `of_numbers` (k, 10) has the derivatives of these functions with respect to the
    /// mass properties.
    fn gradient<'py>(
        &self,
        py: Python<'py>,
        of_numbers: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let of_numbers = rows::<10>(&of_numbers)?;
        let derivatives = self.derivatives()?;
        let count = of_numbers.len().checked_mul(3 * self.vertices.len());
        room::<f64>("the derivatives", count)?;
        let mut gradients = Vec::with_capacity(count.unwrap_or_default());
        for of_number in of_numbers {
            py.check_signals()?;
            py.detach(|| {
                let gradient = derivatives.gradient(&gradient_of(of_number));
                gradients.extend(self.vertices.iter().flat_map(|vertex| {
                    vertex.map_or([0.0; 3], |(number, share)| gradient[number as usize].map(|by| by * share))
                }));
            });
        }
        cube(py, finite(gradients)?, [of_numbers.len(), self.vertices.len(), 3])
    }
}

impl PyMeshDerivatives {
    fn derivatives(&self) -> PyResult<MeshDerivatives<'_>> {
        MeshDerivatives::of(&self.solid, self.substance).map_err(Raise::raise)
    }
}

/// Maps given vertices to mesh vertices. Vertices with equal coordinates are one mesh vertex, and
/// share its derivatives equally.
fn found(solid: &ClosedMesh, points: &[[f64; 3]], corners: &[[u32; 3]]) -> PyResult<Vec<Vertex>> {
    let mut used = vec![false; points.len()];
    for &corner in corners.as_flattened() {
        used[corner as usize] = true;
    }
    let numbers = solid.vertex_numbers(points);
    let mut count = vec![0_u32; solid.surface().coordinates().len()];
    for (number, _) in numbers.iter().zip(&used).filter(|(_, used)| **used) {
        let Some(number) = number else {
            return Err(refused(
                "the coordinates of the vertices differ too much in magnitude",
                Some("check the units and the exponents"),
            ));
        };
        count[*number as usize] += 1;
    }
    let share = |number: u32| (number, 1.0 / f64::from(count[number as usize]));
    Ok(numbers.into_iter().zip(used).map(|(number, used)| number.filter(|_| used).map(share)).collect())
}

/// Returns the changes of the ten mass properties as a row.
fn derivative_row<F>(by: &MassPropertiesDerivative<F>) -> [f64; 10] {
    let ([x, y, z], [xx, yy, zz, xy, xz, yz]) = (by.center_of_mass.to_array(), by.inertia);
    [by.mass, x, y, z, xx, yy, zz, xy, xz, yz]
}

/// Returns the derivatives of a number with respect to the ten mass properties as a row.
pub(crate) fn gradient_row<F>(of: &MassPropertiesGradient<F>) -> [f64; 10] {
    let ([x, y, z], [xx, yy, zz, xy, xz, yz]) = (of.by_center_of_mass.to_array(), of.by_inertia);
    [of.by_mass, x, y, z, xx, yy, zz, xy, xz, yz]
}

fn gradient_of(&[by_mass, x, y, z, xx, yy, zz, xy, xz, yz]: &[f64; 10]) -> MassPropertiesGradient<Part> {
    MassPropertiesGradient {
        by_mass,
        by_center_of_mass: Direction::new(x, y, z),
        by_inertia: [xx, yy, zz, xy, xz, yz],
    }
}

/// Returns unit changes of each of the ten mass properties.
fn unit_changes() -> [MassPropertiesDerivative<Part>; 10] {
    core::array::from_fn(|number| {
        let unit = |k: usize| if k == number { 1.0 } else { 0.0 };
        MassPropertiesDerivative {
            mass: unit(0),
            center_of_mass: Position::new(unit(1), unit(2), unit(3)),
            inertia: core::array::from_fn(|k| unit(4 + k)),
        }
    })
}

/// Returns ten rows with one column per change.
fn columns<F>(changes: impl IntoIterator<Item = MassPropertiesDerivative<F>>) -> Vec<f64> {
    let changes: Vec<_> = changes.into_iter().map(|by| derivative_row(&by)).collect();
    (0..10).flat_map(|number| changes.iter().map(move |by| by[number])).collect()
}

fn finite(derivatives: Vec<f64>) -> PyResult<Vec<f64>> {
    if derivatives.iter().all(|by| by.is_finite()) {
        return Ok(derivatives);
    }
    Err(refused("a derivative is too large for a double", Some("check the units and the exponents")))
}
