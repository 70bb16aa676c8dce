//! Bodies from files other than meshes, each format with its options.

use std::path::PathBuf;

use polhode_scenario::read::ScenarioFile;
use polhode_shape::cad;
use polhode_shape::cad::{CadOptions, DecimalMark, ProductConvention};
use polhode_shape::molecule;
use polhode_shape::molecule::{Isotopes, MoleculeFormat};
use polhode_shape::particles;
use polhode_shape::particles::ParticleOptions;
use polhode_shape::voxel::VoxelOptions;
use polhode_shape::voxel_report;
use polhode_source::files::Disk;
use polhode_source::{read_file, read_text_file};
use pyo3::prelude::*;

use crate::error::{Raise, refused};
use crate::interrupt::watched_apart;
use crate::mass_properties::PyMassProperties;

/// Returns the body of a scenario.
#[pyfunction]
pub(crate) fn scenario_file(py: Python<'_>, path: PathBuf) -> PyResult<PyMassProperties> {
    let scenario = watched_apart(py, move |_| ScenarioFile::read(&Disk, &path))?;
    Ok(PyMassProperties::of(scenario.map_err(Raise::raise)?.inertia()))
}

/// Reads a table of particles.
#[pyfunction]
pub(crate) fn particle_file(
    py: Python<'_>,
    path: PathBuf,
    mass: Option<f64>,
    length_unit: Option<f64>,
    mass_unit: Option<f64>,
) -> PyResult<PyMassProperties> {
    let options = ParticleOptions { mass_unit, length_unit, total_mass: mass };
    let report = watched_apart(py, move |_| {
        let table = read_file(&Disk, &path, |bytes| particles::read(bytes, &options));
        table.map(|table| table.into_report(&path))
    })?;
    Ok(PyMassProperties::of(report.map_err(Raise::raise)?.map_err(Raise::raise)?))
}

/// Reads the mass property report of a CAD program.
#[pyfunction]
pub(crate) fn cad_file(
    py: Python<'_>,
    path: PathBuf,
    products: Option<&str>,
    decimal: Option<&str>,
    length_unit: Option<f64>,
    mass_unit: Option<f64>,
) -> PyResult<PyMassProperties> {
    let choice = |what: &str, given: Option<&str>, [first, second]: [&str; 2]| match given {
        None => Ok(None),
        Some(given) if given == first => Ok(Some(false)),
        Some(given) if given == second => Ok(Some(true)),
        Some(given) => Err(refused(format!("{what} = {given:?} must be {first:?} or {second:?}"), None)),
    };
    let positive = choice("products", products, ["negative", "positive"])?;
    let comma = choice("decimal", decimal, ["point", "comma"])?;
    let options = CadOptions {
        decimal: comma.map(|comma| if comma { DecimalMark::Comma } else { DecimalMark::Point }),
        products: positive
            .map(|positive| if positive { ProductConvention::Positive } else { ProductConvention::Negative }),
        mass_unit,
        length_unit,
    };
    let report = py.detach(|| read_text_file(&Disk, &path, |text| cad::read(text, &options)));
    Ok(PyMassProperties::of(report.map_err(Raise::raise)?.into_report(&path)))
}

/// Reads the molecules of a file.
#[pyfunction]
pub(crate) fn molecule_file(py: Python<'_>, path: PathBuf, average: bool) -> PyResult<Vec<PyMassProperties>> {
    let isotopes = if average { Isotopes::Average } else { Isotopes::Abundant };
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let format = match ending.to_ascii_lowercase().as_str() {
        "xyz" | "extxyz" => MoleculeFormat::Xyz,
        "pdb" | "ent" => MoleculeFormat::Pdb,
        "mol" => MoleculeFormat::Mol,
        _ => MoleculeFormat::Sdf,
    };
    let (molecules, path) = watched_apart(py, move |_| (molecule::read(&Disk, &path, format), path))?;
    let molecules = molecules.map_err(Raise::raise)?;
    let reports = py.detach(|| molecule::reports(&molecules, isotopes, &path, format));
    Ok(reports.map_err(Raise::raise)?.into_iter().map(PyMassProperties::of).collect())
}

/// Reads a voxel grid; `per_value` is the density for a value of 1, kg/m³.
#[pyfunction]
pub(crate) fn voxel_file(
    py: Python<'_>,
    path: PathBuf,
    spacing: Option<[f64; 3]>,
    origin: Option<[f64; 3]>,
    unit: Option<f64>,
    per_value: f64,
) -> PyResult<PyMassProperties> {
    let options = VoxelOptions { spacing, unit, origin };
    let report = watched_apart(py, move |_| {
        let is_npy = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("npy"));
        voxel_report(&Disk, &path, if is_npy { "npy" } else { "nrrd" }, &options, per_value)
    })?;
    Ok(PyMassProperties::of(report.map_err(Raise::raise)?.map_err(Raise::raise)?))
}
