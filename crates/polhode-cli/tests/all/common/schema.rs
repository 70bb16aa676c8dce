//! Validation of reports against their schemas.

use polhode_scenario::request::{explain, simulate, spin, stability, torque};
use serde_json::Value;

use crate::schema::misfit;

/// Checks a report if its subject has a schema.
pub fn check(report: &Value) {
    let has = |key: &str| report.get(key).is_some();
    let schema = match report {
        _ if matches!(report["kind"].as_str(), Some("budget" | "budget diff")) => {
            polhode_budget::REPORT_SCHEMA
        }
        _ if has("estimate") => polhode_identify::REPORT_SCHEMA,
        _ if has("order_of_accuracy") || has("suite") => polhode_judge::REPORT_SCHEMA,
        _ if has("sampling") && has("outcomes") => polhode_sweep::REPORT_SCHEMA,
        _ if has("turns_about") && has("run") => &simulate::REPORT_SCHEMA,
        _ if has("turns_about") => &torque::REPORT_SCHEMA,
        _ if has("possible") || has("spins") => &spin::REPORT_SCHEMA,
        _ if has("permanent_rotations") || has("on_ground") => &stability::REPORT_SCHEMA,
        _ if has("answer") && has("sections") => &explain::REPORT_SCHEMA,
        _ => return,
    };
    let found = misfit(schema, report);
    assert_eq!(found, None);
}
