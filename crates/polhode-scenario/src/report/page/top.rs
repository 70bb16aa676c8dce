//! Axis of a body that gravity turns about a pivot, with the reference directions of its path.

use polhode_document::json::{finite, numbers};
use serde_json::{Value, json};

use super::PageSubject;
use crate::report::plot::axis_path::TopAxis;

/// Returns the JSON of the axis; null if the figure `axis` does not apply.
pub(crate) fn json(subject: &PageSubject<'_>) -> Value {
    let PageSubject::Scenario(scenario) = subject else { return Value::Null };
    let Some(top) = TopAxis::of(scenario, scenario.rotor()) else { return Value::Null };
    json!({
        "axis": numbers(&top.axis.to_array().map(finite)),
        "up": numbers(&top.up.to_array().map(finite)),
        "across": top.across.iter().map(|axis| numbers(&axis.to_array().map(finite))).collect::<Value>(),
        "bounds": top.bounds.map(|bounds| numbers(&bounds.map(finite))),
    })
}
