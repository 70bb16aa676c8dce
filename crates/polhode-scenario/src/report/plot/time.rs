//! Times: the unit in which they are read, and their axis.

use polhode_document::figure::axes::Axis;
use polhode_document::unit::longer;

/// Returns the axis of an interval of time, and the length of its unit, s.
pub(crate) fn time_axis(times: [f64; 2], width: f64) -> (Axis, f64) {
    let (unit, scale) = unit_of_time(times.into_iter().map(f64::abs).fold(0.0, f64::max));
    let marks = (width / 76.0).clamp(2.0, 10.0);
    (Axis::linear(times.map(|t| t / scale), 0.0, marks, "time t", unit), scale)
}

/// Returns the unit in which a time is read, and its length, s.
pub(crate) fn unit_of_time(largest: f64) -> (&'static str, f64) {
    longer(largest).unwrap_or(("s", 1.0))
}
