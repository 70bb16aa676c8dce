//! Mass properties of a mesh whose density is a formula.

use std::cell::RefCell;

use polhode::body::density::{Cubature, DensityField, FieldError, Solid, mass_properties_of_field};
use polhode_document::Extra;
use polhode_source::expression::Expression;

use super::host::Host;
use super::in_body;
use super::mesh_error::MeshBodyError;
use crate::mesh::SolidPart;
use crate::report::{PartRow, error_estimate};

/// Parts with their masses, and their error estimates.
pub(super) struct Found {
    pub(super) rows: Vec<PartRow>,
    pub(super) error: Extra,
}

/// Integrates the density formula over each part: kg/m³ as a function of x, y and z in the file's
/// axes, m.
pub(super) fn found(
    parts: &[SolidPart],
    formula: &Expression,
    tolerance: Option<f64>,
    host: &mut dyn Host,
) -> Result<Found, MeshBodyError> {
    let cubature =
        Cubature { tolerance: tolerance.unwrap_or(Cubature::default().tolerance), ..Cubature::default() };
    let mut total = FieldError { mass: 0.0, center_of_mass: 0.0, inertia: 0.0 };
    let mut rows = Vec::new();
    for part in parts {
        host.begin_cubature(part.mesh.surface().triangles().len());
        let watched = Watched { formula, host: RefCell::new(&mut *host) };
        let body = mass_properties_of_field(Solid::Mesh(&part.mesh), &watched, cubature)
            .map_err(MeshBodyError::Density)?;
        let FieldError { mass, center_of_mass, inertia } = body.error_estimate;
        // Errors of the mass are added; for the other quantities the largest error of a part is
        // used.
        total.mass += mass;
        total.center_of_mass = total.center_of_mass.max(center_of_mass);
        total.inertia = total.inertia.max(inertia);
        let properties = in_body(body.properties).map_err(MeshBodyError::Density)?;
        rows.push(PartRow { name: part.name.clone(), properties, volume: Some(body.volume) });
    }
    Ok(Found { rows, error: error_estimate(&total, "from the cubature of the formula") })
}

/// Density formula that reports its evaluations to the host.
struct Watched<'a> {
    formula: &'a Expression,
    host: RefCell<&'a mut dyn Host>,
}

impl DensityField for Watched<'_> {
    fn density(&self, point: [f64; 3]) -> f64 {
        self.formula.density(point)
    }

    fn densities(&self, points: &[[f64; 3]], densities: &mut [f64]) {
        self.formula.densities(points, densities);
        self.host.borrow_mut().sampled(points.len());
    }
}
