//! Substance of a body, given by keyword arguments.

use polhode::body::Material;
use polhode::body::shape::Substance;
use polhode_shape::material;
use polhode_shape::material::UnknownMaterial;
use pyo3::prelude::*;

use crate::error::refused;

/// Returns the known materials with their densities, kg/m³.
#[pyfunction]
pub(crate) fn materials() -> Vec<(&'static str, f64)> {
    Material::ALL.iter().map(|material| (material.name, material.density)).collect()
}

/// Keyword arguments `density=`, `mass=`, `material=`, `area_density=` and `line_density=`; at most
/// one is set.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Given {
    density: Option<f64>,
    mass: Option<f64>,
    material: Option<String>,
    area_density: Option<f64>,
    line_density: Option<f64>,
}

impl Given {
    /// Returns the substance, if one is given.
    ///
    /// # Errors
    /// `PolhodeError` if two arguments are set, or for an unknown material.
    pub(crate) fn substance(&self) -> PyResult<Option<Substance>> {
        let material = self.material.as_deref().map(density_of).transpose()?;
        let all = [
            ("density", self.density.map(Substance::Density)),
            ("mass", self.mass.map(Substance::Mass)),
            ("material", material.map(Substance::Density)),
            ("area_density", self.area_density.map(Substance::AreaDensity)),
            ("line_density", self.line_density.map(Substance::LineDensity)),
        ];
        let mut given = all.into_iter().filter_map(|(name, substance)| Some((name, substance?)));
        match (given.next(), given.next()) {
            (Some((a, _)), Some((b, _))) => {
                Err(refused(format!("{a} and {b} are both given: give only one of them"), None))
            }
            (first, _) => Ok(first.map(|(_, substance)| substance)),
        }
    }

    /// Returns the substance.
    ///
    /// # Errors
    /// Same as [`Self::substance`], and an error if none is given.
    pub(crate) fn required(&self) -> PyResult<Substance> {
        self.substance()?
            .ok_or_else(|| refused("no density, mass or material is given", Some("give one of them")))
    }
}

fn density_of(name: &str) -> PyResult<f64> {
    material::named(name).map(|material| material.density).map_err(|unknown| {
        let hint = format!("{} (known: {})", unknown.hint_or("give its density"), UnknownMaterial::known());
        refused(format!("unknown material {name:?}"), Some(&hint))
    })
}
