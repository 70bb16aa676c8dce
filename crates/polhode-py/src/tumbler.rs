//! Spin states of tumbling bodies with two given periods.

use polhode::body::{InertiaTensor, PrincipalFrame};
use polhode::observe::{AxisConvention, TumblingPeriods};
use polhode_scenario::report::TumblerReport;
use pyo3::prelude::*;

use crate::error::{Raise, refused};

/// Returns all spin states of a body with these periods of precession and rotation, s, as JSON and
/// as text.
///
/// # Errors
/// `PolhodeError` for an unphysical body, or if no spin state has these periods.
#[pyfunction]
pub(crate) fn tumbling_spins(
    py: Python<'_>,
    tensor: [[f64; 3]; 3],
    periods: [f64; 2],
    is_long: bool,
) -> PyResult<(String, String)> {
    let inertia = InertiaTensor::from_matrix(tensor).map_err(Raise::raise)?;
    let [precession, rotation] = periods;
    let periods = TumblingPeriods { precession, rotation };
    let convention = if is_long { AxisConvention::LongAxis } else { AxisConvention::ShortAxis };
    py.detach(|| {
        let report = TumblerReport::new(None, PrincipalFrame::of(&inertia), periods, convention);
        let report = report.map_err(|error| {
            let hint = "try the other convention, or twice or half the period: a light curve can show either";
            refused(error, Some(hint))
        })?;
        Ok((report.to_json().to_string(), report.to_text()))
    })
}
