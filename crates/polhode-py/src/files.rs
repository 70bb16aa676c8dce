//! Bodies in files other than meshes, each kind with the options that it may need.

use std::path::{Path, PathBuf};

use polhode::body::BodyError;
use polhode_document::Extra;
use polhode_document::SourceInfo;
use polhode_scenario::read as scenario;
use polhode_scenario::report::{error_estimate, sign_proof};
use polhode_shape::cad;
use polhode_shape::cad::{CadOptions, CadReport, DecimalMark, ProductConvention};
use polhode_shape::molecule;
use polhode_shape::molecule::{Isotopes, MoleculeFormat};
use polhode_shape::particles;
use polhode_shape::particles::ParticleOptions;
use polhode_shape::report::InertiaReport;
use polhode_shape::report::MoleculeReport;
use polhode_shape::voxel;
use polhode_shape::voxel::VoxelOptions;
use polhode_source::FormatError;
use polhode_source::files::Disk;
use polhode_source::{read_file, read_text_file};
use pyo3::prelude::*;

use crate::error::{Raise, refused};
use crate::interrupt::watched_apart;
use crate::mass_properties::PyMassProperties;
use crate::shape::in_body;

/// The body of a scenario.
#[pyfunction]
pub(crate) fn scenario_file(py: Python<'_>, path: PathBuf) -> PyResult<PyMassProperties> {
    let (scenario, path) = watched_apart(py, move |_| (scenario::read(&path), path))?;
    let scenario = scenario.map_err(Raise::raise)?;
    let title = scenario.title().unwrap_or("scenario");
    let source = of_file(&path, "scenario")
        .described(title)
        .with("title", scenario.title().map(str::to_owned))
        .with("parts", scenario.parts().len());
    Ok(PyMassProperties::of(InertiaReport::of_scenario(source, &scenario)))
}

/// A table of particles.
#[pyfunction]
pub(crate) fn particle_file(
    py: Python<'_>,
    path: PathBuf,
    mass: Option<f64>,
    length_unit: Option<f64>,
    mass_unit: Option<f64>,
) -> PyResult<PyMassProperties> {
    let options = ParticleOptions { mass_unit, length_unit, total_mass: mass };
    let (read, path) = watched_apart(py, move |_| {
        let table = read_file(&Disk, &path, |bytes| particles::read(bytes, &options));
        (table.map(|table| (table.mass_properties(), table)), path)
    })?;
    let (properties, table) = read.map_err(Raise::raise)?;
    let properties = properties.map_err(Raise::raise)?;
    let source = of_file(&path, "particles")
        .described(table.described())
        .with("particles", table.particles.len())
        .with("tensors", !table.tensors.is_empty());
    let report = InertiaReport { findings: table.findings, ..InertiaReport::new(source, properties) };
    Ok(PyMassProperties::of(report))
}

/// A CAD program's report.
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
    let CadReport { product, properties, volume, surface_area, density, proof, findings } =
        py.detach(|| read_text_file(&Disk, &path, |text| cad::read(text, &options))).map_err(Raise::raise)?;
    let source = of_file(&path, "cad")
        .described(format!("mass properties by {}", product.name()))
        .with("product", product.name());
    let proof = sign_proof(
        proof.convention.name(),
        proof.by.name(),
        [proof.residual_negative, proof.residual_positive],
        proof.rounding,
    );
    let report = InertiaReport::new(source, properties);
    Ok(PyMassProperties::of(InertiaReport {
        volume,
        surface_area,
        density,
        extras: vec![proof],
        findings,
        ..report
    }))
}

/// The molecules of a file.
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
    let report = |(number, molecule): (usize, &molecule::Molecule)| {
        let block = MoleculeReport {
            formula: molecule.formula(),
            atoms: molecule.atoms.len(),
            isotopes: isotopes.name(),
            constants: molecule.rotational_constants(isotopes)?,
        };
        let name = if molecule.name.is_empty() { &block.formula } else { &molecule.name };
        let source = of_file(&path, format.name())
            .with("name", molecule.name.clone())
            .with("atoms", molecule.atoms.len());
        // Reports count from 1.
        let source = match molecules.len() {
            1 => source.described(format!("molecule {name}")),
            _ => source.described(format!("molecule {}, {name}", number + 1)).with("molecule", number + 1),
        };
        let extra = Extra { key: "molecule", json: block.to_json(), text: block.to_text() };
        let report = InertiaReport::new(source, molecule.mass_properties(isotopes)?);
        let findings = molecule.findings_with(isotopes);
        Ok(PyMassProperties::of(InertiaReport { extras: vec![extra], findings, ..report }))
    };
    let reports = || molecules.iter().enumerate().map(report).collect::<Result<Vec<_>, BodyError>>();
    py.detach(reports).map_err(Raise::raise)
}

/// A voxel grid; `per_value` is the density that a value of 1 stands for, kg/m³.
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
    let of_file_at = path.clone();
    let read = watched_apart(py, move |_| {
        let misread = |error| FormatError::of_content(&of_file_at, &[], error);
        let mut voxels = voxel::open(&Disk, &of_file_at)?;
        let grid = voxels.grid(&options).map_err(misread)?;
        let kind = voxels.type_name();
        Ok::<_, FormatError>((
            voxels.counts(),
            kind,
            voxels.mass_properties(&grid, per_value).map_err(misread)?,
        ))
    })?;
    let (counts, kind, body) = read.map_err(Raise::raise)?;
    let body = body.map_err(Raise::raise)?;
    let properties = in_body(body.properties).map_err(Raise::raise)?;
    let is_npy = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("npy"));
    let [a, b, c] = counts;
    let source = of_file(&path, if is_npy { "npy" } else { "nrrd" })
        .described(format!("voxels, {a} × {b} × {c} of {kind}, {} filled", body.filled))
        .with("voxels", counts.to_vec())
        .with("type", kind)
        .with("filled", body.filled);
    Ok(PyMassProperties::of(InertiaReport {
        extras: vec![error_estimate(&body.error_estimate, "what a voxel's value leaves open within it")],
        ..InertiaReport::new(source, properties).with_volume(Some(body.volume))
    }))
}

/// A file of a format, in the words of reports.
pub(crate) fn of_file(path: &Path, format: &str) -> SourceInfo {
    SourceInfo::new(path.display().to_string(), format)
}
