//! The axis of a body that gravity turns about a pivot: what its path in space is measured from.

use std::f64::consts::TAU;

use polhode::motion::{HeavyTop, TopPath};
use polhode_document::json::{finite, numbers};
use serde_json::{Value, json};

use super::PageSubject;
use crate::plot::axis_path::TopAxis;

/// Null where `--plot axis` does not exist.
pub(super) fn json(subject: &PageSubject<'_>) -> Value {
    let PageSubject::Scenario(scenario) = subject else { return Value::Null };
    let Some(top) = TopAxis::of(scenario, scenario.rotor()) else { return Value::Null };
    json!({
        "axis": numbers(&top.axis.to_array().map(finite)),
        "up": numbers(&top.up.to_array().map(finite)),
        "across": top.across.iter().map(|axis| numbers(&axis.to_array().map(finite))).collect::<Value>(),
        "bounds": top.bounds.map(|bounds| numbers(&bounds.map(finite))),
    })
}

/// The mean time in which the axis goes round the vertical, s. `None` where it passes through it: there its azimuth jumps by half a turn,
/// which the mean precession does not count.
pub(super) fn time_round(top: &HeavyTop) -> Option<f64> {
    let goes_round = !matches!(top.path(), TopPath::Planar | TopPath::ThroughVertical);
    top.mean_precession().filter(|rate| goes_round && *rate != 0.0).map(|rate| TAU / rate.abs())
}
