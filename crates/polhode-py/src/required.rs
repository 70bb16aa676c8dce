//! Torque required for a prescribed motion.

use std::path::PathBuf;

use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use polhode::body::Particle;
use polhode::math::{Body, Position};
use polhode_scenario::report::RequiredReport;
use polhode_table::output::{Column as TableColumn, Table, required};
use pyo3::prelude::*;

use crate::arrays::{numbers, rows};
use crate::error::{Raise, refused};
use crate::finding::{Remark, remarks};
use crate::scenario;
use crate::stability::source;

/// Column: name, unit, description, values.
type Column<'py> = (String, &'static str, &'static str, Bound<'py, PyArray1<f64>>);

/// Required torque of a motion, forces on points, and loads of shaft bearings.
#[derive(Debug, IntoPyObject)]
pub(crate) struct RequiredTorque<'py> {
    json: String,
    text: String,
    columns: Vec<Column<'py>>,
    findings: Vec<Remark>,
}

/// Computes the torque required for the prescribed motion of a scenario, from a file or a text.
/// Paths in a text are relative to `path`. `times` replace those of its run. `points` (n, 4) have
/// masses, kg, and positions, m.
///
/// # Errors
/// `PolhodeError` if the scenario cannot be read, or does not prescribe a motion.
#[pyfunction]
pub(crate) fn required_torque<'py>(
    py: Python<'py>,
    path: PathBuf,
    text: Option<String>,
    times: Option<PyReadonlyArray1<'py, f64>>,
    points: PyReadonlyArray2<'py, f64>,
) -> PyResult<RequiredTorque<'py>> {
    let mut file = py.detach(|| scenario::read(path.clone(), text)).map_err(Raise::raise)?;
    if file.scenario.prescribed().is_none() {
        let hint = "write [prescribed] with axis = [0, 0, 1] and rate = \"3 rad/s\", or [shaft]; simulate computes other motions";
        return Err(refused(
            "the scenario has no [prescribed] motion, so no torque can be computed",
            Some(hint),
        ));
    }
    if let Some(times) = &times {
        file.scenario = scenario::sampled(file.scenario, numbers(times)?);
    }
    let point = |&[mass, x, y, z]: &[f64; 4]| Particle::new(mass, Position::<Body>::new(x, y, z));
    let points: Vec<_> = rows(&points)?.iter().map(point).collect::<Result<_, _>>().map_err(Raise::raise)?;
    let placed = |error| file.placed(&error).map_or_else(|| Raise::raise(error), Raise::raise);
    let (report, columns) = py
        .detach(|| {
            let report = RequiredReport::new(source(&path, &file), &file.scenario, &[], &points)?;
            let columns =
                columns(&required(report.samples(), report.rotor(), report.points(), file.scenario.shaft()));
            Ok((report, columns))
        })
        .map_err(placed)?;
    let array = |(name, unit, description, values)| (name, unit, description, PyArray1::from_vec(py, values));
    Ok(RequiredTorque {
        json: report.to_json().to_string(),
        text: report.to_text(),
        columns: columns.into_iter().map(array).collect(),
        findings: remarks(file.scenario.findings()),
    })
}

/// Returns name, unit, description and values of each column.
pub(crate) fn columns(table: &Table<'_>) -> Vec<(String, &'static str, &'static str, Vec<f64>)> {
    let values = |column: &TableColumn<'_>| (0..table.rows()).map(|row| column.value(row)).collect();
    table.columns().iter().map(|c| (c.name.to_string(), c.unit, c.description, values(c))).collect()
}
