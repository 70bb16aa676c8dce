//! Mass, centre of mass and inertia, with the report on their source.

use numpy::{PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use polhode::body::{
    InertiaAbout, InertiaTensor, MassProperties, Particle, PrincipalFrame, mass_properties_of_particles,
};
use polhode::math::{Body, Part, Position, Rotation};
use polhode_document::SourceInfo;
use polhode_shape::export;
use polhode_shape::report::InertiaReport;
use polhode_shape::{ExportBody, ExportFormat};
use pyo3::prelude::*;

use crate::arrays::{finite_matrix, matrix, numbers, row, rows};
use crate::error::{Raise, refused};
use crate::finding::{Remark, remarks};
use crate::pickle;

/// Mass properties of a body, with the report about it.
#[pyclass(frozen, name = "MassProperties", module = "polhode._native")]
#[derive(Clone, Debug)]
pub(crate) struct PyMassProperties {
    report: InertiaReport,
}

impl PyMassProperties {
    pub(crate) const fn of(report: InertiaReport) -> Self {
        Self { report }
    }

    fn plain(what: &str, properties: MassProperties<Body>) -> Self {
        Self::of(InertiaReport::new(SourceInfo::new(what, "python"), properties))
    }

    /// Returns the mass properties without the report.
    pub(crate) const fn properties(&self) -> &MassProperties<Body> {
        &self.report.properties
    }
}

#[pymethods]
impl PyMassProperties {
    /// Creates mass properties from numbers; the tensor is about the centre of mass, or about a
    /// point.
    #[staticmethod]
    fn of_tensor(
        mass: f64,
        center: [f64; 3],
        tensor: [[f64; 3]; 3],
        about: Option<[f64; 3]>,
    ) -> PyResult<Self> {
        let center = Position::<Body>::from_array(center);
        let properties = match about {
            None => InertiaTensor::from_matrix(tensor)
                .and_then(|tensor| MassProperties::new(mass, center, tensor)),
            Some(point) => InertiaAbout::from_matrix(Position::from_array(point), tensor)
                .and_then(|about| MassProperties::from_inertia_about(mass, center, &about)),
        };
        Ok(Self::plain("mass properties", properties.map_err(Raise::raise)?))
    }

    /// Creates the mass properties of point masses.
    #[staticmethod]
    fn of_particles(
        py: Python<'_>,
        masses: PyReadonlyArray1<'_, f64>,
        positions: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<Self> {
        let (masses, positions) = (numbers(&masses)?, rows::<3>(&positions)?);
        let properties = py.detach(|| {
            let each = masses.iter().zip(positions);
            let particles = each.map(|(&mass, &place)| Particle::new(mass, Position::from_array(place)));
            mass_properties_of_particles::<Body>(&particles.collect::<Result<Vec<_>, _>>()?)
        });
        let properties = properties.map_err(Raise::raise)?;
        Ok(Self::plain(&format!("{} particles", masses.len()), properties))
    }

    /// Returns the mass properties of rigidly joined bodies.
    #[staticmethod]
    fn combined(parts: Vec<PyRef<'_, Self>>) -> PyResult<Self> {
        let bodies: Vec<_> = parts.iter().map(|part| *part.properties()).collect();
        let volumes: Option<Vec<f64>> = parts.iter().map(|part| part.report.volume).collect();
        let properties = MassProperties::combined(&bodies).map_err(Raise::raise)?;
        let volume = volumes.map(|volumes| volumes.iter().sum::<f64>());
        let mut whole = Self::plain(&format!("{} parts", parts.len()), properties);
        whole.report.volume = volume;
        whole.report.density = volume.map(|volume| properties.mass() / volume);
        whole.report.findings = parts.iter().flat_map(|part| part.report.findings.clone()).collect();
        Ok(whole)
    }

    /// Returns the complete state by value, for [`Self::of_state`].
    fn state(&self) -> pickle::Values {
        pickle::values(&self.report)
    }

    /// Restores the object from [`Self::state`].
    #[staticmethod]
    fn of_state(state: pickle::Values) -> PyResult<Self> {
        pickle::report(state).map(Self::of)
    }

    /// Returns the body placed at a position and rotated; the quaternion takes its components to
    /// the new axes.
    fn placed(&self, position: [f64; 3], wxyz: [f64; 4]) -> PyResult<Self> {
        let turn = Rotation::<Part, Body>::from_quaternion(wxyz).map_err(Raise::raise)?;
        let placed = self.properties().placed(Position::<Part>::from_array(position), turn);
        // The new axes are the body axes from now on.
        let properties = placed.map_err(Raise::raise)?.in_frame::<Body>(Rotation::identity());
        let mut report = InertiaReport { properties, about: None, axes: None, ..self.report.clone() };
        // Rotational constants do not depend on axes; the other blocks refer to the old axes and
        // are dropped.
        report.extras.retain(|extra| extra.key == "molecule");
        Ok(Self::of(report))
    }

    #[getter]
    fn mass(&self) -> f64 {
        self.properties().mass()
    }

    #[getter]
    fn center_of_mass<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        row(py, self.properties().center_of_mass().to_array())
    }

    #[getter]
    fn inertia<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(py, &self.properties().inertia().matrix())
    }

    /// Returns the tensor about a point, body axes, kg·m².
    fn about<'py>(&self, py: Python<'py>, point: [f64; 3]) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let about = self.properties().inertia_about(Position::from_array(point)).matrix();
        finite_matrix(py, &about, "the tensor about that point is too large for a double", "check point")
    }

    /// Returns the tensor about the centre of mass along rotated axes; the quaternion takes their
    /// components to the body axes.
    fn along<'py>(&self, py: Python<'py>, wxyz: [f64; 4]) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let turn = Rotation::<Body, Part>::from_quaternion(wxyz).map_err(Raise::raise)?;
        let along = self.properties().inertia().in_frame(turn.inverse()).matrix();
        finite_matrix(py, &along, "the tensor along those axes is too large for a double", "check the body")
    }

    #[getter]
    fn moments<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        row(py, self.properties().principal().moments())
    }

    #[getter]
    fn axes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        principal_axes(py, &self.properties().principal())
    }

    #[getter]
    fn symmetry(&self) -> &'static str {
        self.properties().principal().symmetry().name()
    }

    #[getter]
    fn gyration_radii<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        row(py, self.properties().gyration_radii())
    }

    #[getter]
    const fn volume(&self) -> Option<f64> {
        self.report.volume
    }

    #[getter]
    const fn surface_area(&self) -> Option<f64> {
        self.report.surface_area
    }

    #[getter]
    const fn density(&self) -> Option<f64> {
        self.report.density
    }

    /// Findings: code, severity, message, place.
    #[getter]
    fn findings(&self) -> Vec<Remark> {
        remarks(&self.report.findings)
    }

    /// Returns the JSON that `polhode inertia --json` prints.
    fn json(&self) -> String {
        self.report.to_json().to_string()
    }

    /// Returns the text that `polhode inertia` prints.
    fn text(&self) -> String {
        self.report.to_text()
    }

    /// Returns the body in the format of another program.
    fn export(&self, format: &str, name: &str) -> PyResult<String> {
        let Some(format) = ExportFormat::named(format) else {
            let names: Vec<_> = ExportFormat::ALL.iter().map(|format| format.name()).collect();
            return Err(refused(
                format!("unknown format {format:?}"),
                Some(&format!("known formats: {}", names.join(", "))),
            ));
        };
        export(format, &[ExportBody::of_report(name, &self.report)])
            .map_err(|error| refused(&error, Some(error.hint())))
    }
}

/// Returns the principal axes (3, 3), one per row, in body components.
pub(crate) fn principal_axes<'py>(
    py: Python<'py>,
    principal: &PrincipalFrame<Body>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    matrix(py, &principal.axes().map(polhode::math::Vector::to_array))
}
