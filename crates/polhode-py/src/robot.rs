//! Bodies in robot models: one link, joined links, or a table of all links.

use std::path::{Path, PathBuf};

use polhode_document::Report as _;
use polhode_robot::LinkError;
use polhode_robot::inertia::{of_link, of_lumps};
use polhode_robot::inertials::{InertialsRequest, write_inertials};
use polhode_robot::line_index::{FilePlace, Places};
use polhode_robot::link_table::LinkTable;
use polhode_robot::lump::{Lumping, slides};
use polhode_robot::model::RobotModel;
use polhode_robot::read::{ReadOptions, format_of, read_model};
use polhode_shape::report::InertiaReport;
use polhode_source::files::Disk;
use polhode_source::read_file;
use polhode_source::unit;
use polhode_source::unit::Dimension;
use pyo3::prelude::*;
use serde_json::Value;

use crate::error::{PolhodeError, Raise, refused};
use crate::finding::{Remark, remarks};
use crate::mass_properties::PyMassProperties;

/// Value of a joint: a number, rad or m, or a text with its unit.
#[derive(Debug, FromPyObject)]
pub(crate) enum JointValue {
    Number(f64),
    Text(String),
}

/// Returns a link of a robot, a link with all links attached to it, or all links, at these joint
/// values.
#[pyfunction]
pub(crate) fn robot_file(
    py: Python<'_>,
    path: PathBuf,
    link: Option<&str>,
    subtree: Option<&str>,
    joints: Vec<(String, JointValue)>,
) -> PyResult<PyMassProperties> {
    py.detach(|| {
        let model = read(&path)?;
        let report = match (link, subtree) {
            (Some(link), _) => of_link(&model, link).map_err(|error| raised(&model, &error))?,
            (None, subtree) => one(&model, subtree.map_or(Lumping::All, Lumping::Subtree), &joints)?,
        };
        Ok(PyMassProperties::of(report))
    })
}

/// Returns a body for each group of links joined by fixed joints, with the link whose frame it
/// uses.
#[pyfunction]
pub(crate) fn robot_groups(py: Python<'_>, path: PathBuf) -> PyResult<Vec<(String, PyMassProperties)>> {
    let reports = py.detach(|| {
        let model = read(&path)?;
        of_lumps(&model, Lumping::Fixed, &[], false).map_err(|error| raised(&model, &error))
    })?;
    let frame = |report: &InertiaReport| {
        report.source.fields.get("link").and_then(|link| link.as_str()).unwrap_or_default().to_owned()
    };
    Ok(reports.into_iter().map(|report| (frame(&report), PyMassProperties::of(report))).collect())
}

/// Returns all links of a robot as JSON, as text and as CSV, with the findings.
#[pyfunction]
pub(crate) fn robot_table(
    py: Python<'_>,
    path: PathBuf,
    joints: Vec<(String, JointValue)>,
) -> PyResult<(String, String, String, Vec<Remark>)> {
    py.detach(|| {
        let model = read(&path)?;
        let positions = positions(&model, &joints)?;
        let table = LinkTable::of(&model, &positions).map_err(|error| raised(&model, &error))?;
        let csv = LinkTable::csv_head() + &table.to_csv();
        Ok((table.to_json().to_string(), table.to_text(), csv, remarks(table.findings())))
    })
}

fn read(path: &Path) -> PyResult<RobotModel> {
    read_model(path, &ReadOptions::default()).map_err(Raise::raise)
}

/// Returns the single body of the selected links.
fn one(model: &RobotModel, lumping: Lumping<'_>, joints: &[(String, JointValue)]) -> PyResult<InertiaReport> {
    let positions = positions(model, joints)?;
    let mut reports = of_lumps(model, lumping, &positions, false).map_err(|error| raised(model, &error))?;
    reports.pop().ok_or_else(|| refused(format!("no link of {} has mass", model.path.display()), None))
}

/// Converts joint values to rad or m.
fn positions(model: &RobotModel, joints: &[(String, JointValue)]) -> PyResult<Vec<(String, f64)>> {
    let value = |(name, value): &(String, JointValue)| match value {
        JointValue::Number(value) => Ok((name.clone(), *value)),
        JointValue::Text(text) => {
            let slides = slides(model, name).map_err(|error| raised(model, &error))?;
            let dimension = if slides { Dimension::LENGTH } else { Dimension::ANGLE };
            let parsed = unit::parse(text, dimension).map_err(|error| {
                let hint = if slides {
                    "the joint slides: write a length, such as \"20 mm\""
                } else {
                    "the joint rotates: write an angle, such as \"30 deg\""
                };
                refused(format!("joints[{name:?}]: {error}"), Some(hint))
            });
            Ok((name.clone(), parsed?))
        }
    };
    joints.iter().map(value).collect()
}

/// Returns the exception with its place in the model, if the error has one.
fn raised(model: &RobotModel, error: &LinkError) -> PyErr {
    let (message, hint) = (error.to_string(), Some(error.hint().to_owned()));
    match error.span() {
        Some(span) => {
            let FilePlace { file, line, column, .. } = Places::of(model).place(&span);
            PolhodeError::new_err((message, hint, file.display().to_string(), line, column))
        }
        None => PolhodeError::new_err((message, hint, model.path.display().to_string())),
    }
}

/// Returns the names of the links of a robot, in the order of the file.
#[pyfunction]
pub(crate) fn robot_links(py: Python<'_>, path: PathBuf) -> PyResult<Vec<String>> {
    let model = py.detach(|| read(&path))?;
    Ok(model.links.iter().map(|link| link.name.text.clone()).collect())
}

/// Returns true if the root element or first word of the file is that of a robot model, or if it is
/// binary USD.
#[pyfunction]
pub(crate) fn is_robot(py: Python<'_>, path: PathBuf) -> PyResult<bool> {
    let is_robot = |bytes: &[u8]| {
        let start = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
        let is_text = start.first() == Some(&b'<') || start.starts_with(b"#usda");
        let is_package = bytes.starts_with(b"PK") && path.extension().is_some_and(|ending| ending == "usdz");
        let is_model = || format_of(&String::from_utf8_lossy(bytes)).is_some();
        Ok(is_package || bytes.starts_with(b"PXR-USDC") || is_text && is_model())
    };
    py.detach(|| read_file(&Disk, &path, is_robot)).map_err(Raise::raise)
}

/// Computes the inertials of a robot's links from their geometry. `request` is an
/// [`InertialsRequest`] as JSON. Returns the new text of the model, the report as JSON and as text,
/// and true if a link is left without an inertial.
#[pyfunction]
pub(crate) fn robot_inertials(py: Python<'_>, request: &str) -> PyResult<(String, String, String, bool)> {
    py.detach(|| {
        let value: Value = serde_json::from_str(request).map_err(|error| refused(error, None))?;
        // From a value, errors have no line and column of the JSON text.
        let request: InertialsRequest =
            serde_json::from_value(value).map_err(|error| refused(error, None))?;
        let inertials = write_inertials(&request, &Disk).map_err(Raise::raise)?;
        let report = inertials.to_json().to_string();
        Ok((inertials.text().to_owned(), report, inertials.to_text(None), inertials.has_failed()))
    })
}
