//! Time axis and its unit.

use polhode_document::figure::axes::Axis;
use polhode_document::unit::longer;

/// Returns the axis for a time interval, and its unit in s.
pub(crate) fn time_axis(times: [f64; 2], width: f64) -> (Axis, f64) {
    let (unit, scale) = unit_of_time(times.into_iter().map(f64::abs).fold(0.0, f64::max));
    let marks = (width / 76.0).clamp(2.0, 10.0);
    (Axis::linear(times.map(|t| t / scale), 0.0, marks, "time t", unit), scale)
}

/// Returns the unit for times up to `largest`, s: its name and its length, s.
pub(crate) fn unit_of_time(largest: f64) -> (&'static str, f64) {
    longer(largest).unwrap_or(("s", 1.0))
}
