//! Bodies in files other than meshes, each kind with the options that it may need.

use std::path::{Path, PathBuf};

use polhode::{Body, BodyError, Rotation};
use polhode_formats::cad::{self, CadOptions, CadReport, DecimalMark, ProductConvention};
use polhode_formats::molecule::{self, Isotopes, MoleculeFormat};
use polhode_formats::particles::{self, ParticleOptions};
use polhode_formats::voxel::{self, VoxelOptions};
use polhode_formats::{FormatError, read_file, read_text_file, scenario};
use polhode_report::{Extra, InertiaReport, MoleculeReport, SourceInfo, error_estimate, sign_proof};
use pyo3::prelude::*;

use crate::error::{Raise, refused};
use crate::mass_properties::PyMassProperties;
use crate::shape::in_body;

/// The body of a scenario.
#[pyfunction]
pub(crate) fn scenario_file(py: Python<'_>, path: PathBuf) -> PyResult<PyMassProperties> {
    let scenario = py.detach(|| scenario::read(&path)).map_err(Raise::raise)?;
    let title = scenario.title.as_deref().unwrap_or("scenario");
    let source = of_file(&path, "scenario").described(title).with("title", scenario.title.clone());
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
    let read = py.detach(|| read_file(&path, |bytes| particles::read(bytes, &options)));
    let table = read.map_err(Raise::raise)?;
    let properties = table.mass_properties().map_err(Raise::raise)?;
    let source = of_file(&path, "particles").described(table.described());
    let report = InertiaReport { findings: table.findings, ..InertiaReport::new(source, properties) };
    Ok(PyMassProperties::of(report))
}

/// A CAD program's report.
#[pyfunction]
pub(crate) fn cad_file(
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
        read_text_file(&path, |text| cad::read(text, &options)).map_err(Raise::raise)?;
    let source = of_file(&path, "cad").described(format!("mass properties by {}", product.name()));
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
pub(crate) fn molecule_file(path: PathBuf, average: bool) -> PyResult<Vec<PyMassProperties>> {
    let isotopes = if average { Isotopes::Average } else { Isotopes::Abundant };
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let format = match ending.to_ascii_lowercase().as_str() {
        "xyz" | "extxyz" => MoleculeFormat::Xyz,
        "pdb" | "ent" => MoleculeFormat::Pdb,
        "mol" => MoleculeFormat::Mol,
        _ => MoleculeFormat::Sdf,
    };
    let report = |molecule: &molecule::Molecule| {
        let block = MoleculeReport {
            formula: molecule.formula(),
            atoms: molecule.atoms.len(),
            isotopes: isotopes.name(),
            constants: molecule.rotational_constants(isotopes)?,
        };
        let name = if molecule.name.is_empty() { &block.formula } else { &molecule.name };
        let source = of_file(&path, format.name()).described(format!("molecule {name}"));
        let extra = Extra { key: "molecule", json: block.to_json(), text: block.to_text() };
        let report = InertiaReport::new(source, molecule.mass_properties(isotopes)?);
        let findings = molecule.findings_with(isotopes);
        Ok(PyMassProperties::of(InertiaReport { extras: vec![extra], findings, ..report }))
    };
    let molecules = molecule::read(&path, format).map_err(Raise::raise)?;
    let reports: Result<Vec<_>, BodyError> = molecules.iter().map(report).collect();
    reports.map_err(Raise::raise)
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
    let read = py.detach(|| {
        let misread = |error| FormatError::of_content(&path, &[], error);
        let mut voxels = voxel::open(&path)?;
        let grid = voxels.grid(&options).map_err(misread)?;
        Ok::<_, FormatError>((voxels.counts(), voxels.mass_properties(&grid, per_value).map_err(misread)?))
    });
    let ([a, b, c], body) = read.map_err(Raise::raise)?;
    let body = body.map_err(Raise::raise)?;
    let properties = in_body(body.properties).map_err(Raise::raise)?;
    let source = of_file(&path, "voxels")
        .described(format!("voxels, {a} × {b} × {c}, {} filled", body.filled))
        .with("filled", body.filled);
    Ok(PyMassProperties::of(InertiaReport {
        volume: Some(body.volume),
        density: Some(properties.mass() / body.volume),
        extras: vec![error_estimate(&body.error_estimate, "what a voxel's value leaves open within it")],
        ..InertiaReport::new(source, properties)
    }))
}

/// A link of a robot, or all its links at some values of its joints.
#[pyfunction]
pub(crate) fn robot_file(
    path: PathBuf,
    link: Option<&str>,
    joints: Vec<(String, f64)>,
) -> PyResult<PyMassProperties> {
    use polhode_robot::body::{LinkMass, link_mass};
    use polhode_robot::lump::{Lumping, lump};
    use polhode_robot::read::{ReadOptions, read_model};
    let model = read_model(&path, &ReadOptions::default()).map_err(Raise::raise)?;
    let source = of_file(&path, "robot");
    let findings =
        polhode_robot::remarks::remarks(&model, link).map_err(|twice| refused(&twice, Some(twice.hint())))?;
    let Some(name) = link else {
        let lumps =
            lump(&model, Lumping::All, &joints).map_err(|error| refused(&error, Some(&error.hint())))?;
        let Some(whole) = lumps.first() else {
            return Err(refused(format!("no link of {} has a mass", path.display()), None));
        };
        let source = source.described(format!("all {} links", whole.links.len()));
        let report = InertiaReport { findings, ..InertiaReport::new(source, whole.properties) };
        return Ok(PyMassProperties::of(report));
    };
    let Some(link) = model.links.iter().find(|link| link.name.text == name) else {
        let names: Vec<_> = model.links.iter().map(|link| link.name.text.as_str()).collect();
        return Err(refused(
            format!("{} has no link {name:?}", path.display()),
            Some(&format!("its links are {}", names.join(", "))),
        ));
    };
    match link_mass(model.format, link) {
        Ok(LinkMass::Body(body)) => {
            // The link's axes are the body's.
            let properties = body.properties.in_frame::<Body>(Rotation::identity());
            let source = source.described(format!("link {name}, in the link's frame"));
            Ok(PyMassProperties::of(InertiaReport { findings, ..InertiaReport::new(source, properties) }))
        }
        Ok(LinkMass::None) => Err(refused(format!("the link {name:?} has no mass"), None)),
        Err(error) => Err(refused(format!("the link {name:?} is no body: {error}"), Some(error.hint()))),
    }
}

/// The links of a robot, in the file's order.
#[pyfunction]
pub(crate) fn robot_links(path: PathBuf) -> PyResult<Vec<String>> {
    use polhode_robot::read::{ReadOptions, read_model};
    let model = read_model(&path, &ReadOptions::default()).map_err(Raise::raise)?;
    Ok(model.links.iter().map(|link| link.name.text.clone()).collect())
}

/// True if the file's root element is that of URDF, SDF or MJCF.
#[pyfunction]
pub(crate) fn is_robot(path: PathBuf) -> PyResult<bool> {
    let is_robot = |bytes: &[u8]| {
        let start = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
        let is_xml = start.first() == Some(&b'<');
        Ok(is_xml && polhode_robot::read::format_of(&String::from_utf8_lossy(bytes)).is_some())
    };
    read_file(&path, is_robot).map_err(Raise::raise)
}

/// A file of a format, in the words of reports.
fn of_file(path: &Path, format: &str) -> SourceInfo {
    SourceInfo::new(path.display().to_string(), format)
}
