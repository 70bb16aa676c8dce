//! The suite that programs are graded by: scenarios, and what a program has to know to run them.

use std::path::Path;

use serde_json::{Map, Value, json};

use crate::error::FormatError;
use crate::scenario::ScenarioFile;

/// A case of the suite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SuiteCase {
    /// Its name, which is that of its files.
    pub name: &'static str,
    /// The scenario.
    pub text: &'static str,
}

/// A case of `suite/` by its name.
macro_rules! cases {
    ($($name:literal)*) => {
        &[$(SuiteCase { name: $name, text: include_str!(concat!("../suite/", $name, ".toml")) }),*]
    };
}

/// The cases: free motion of every kind, then motion under torque.
pub const CASES: &[SuiteCase] = cases! {
    "free-long-axis" "free-short-axis" "free-separatrix-long" "free-separatrix-short" "free-flips"
    "permanent-least" "permanent-intermediate" "permanent-greatest"
    "near-symmetric" "symmetric-prolate" "symmetric-oblate" "spherical" "needle" "plate"
    "huge" "tiny" "fast-spin" "long-run" "identity-start"
    "torque-constant-body" "torque-constant-space" "torque-of-time" "damping"
    "pivoted" "top-fast" "top-slow" "top-sleeping" "gravity-gradient" "gyrostat-held" "gyrostat-motor"
};

impl SuiteCase {
    /// The scenario.
    ///
    /// # Errors
    /// [`FormatError`] as of every scenario; the suite's own have none.
    pub fn scenario(&self) -> Result<ScenarioFile, FormatError> {
        ScenarioFile::parse(self.text.to_owned(), Path::new(&format!("{}.toml", self.name)))
    }

    /// What it tests: the comment that its file begins with.
    pub fn what(&self) -> &'static str {
        self.text.lines().next().unwrap_or_default().trim_start_matches(['#', ' '])
    }

    /// The case as data: the body, its start and its times as numbers, and `scenario`, the file as it is. All bare numbers are SI; components
    /// are along body axes, tensors about the centre of mass, and a held body has its centre of mass from the pivot.
    ///
    /// # Errors
    /// As [`SuiteCase::scenario`].
    pub fn to_json(&self) -> Result<Value, FormatError> {
        let ScenarioFile { scenario, .. } = self.scenario()?;
        let (body, start) = (scenario.body(), scenario.start());
        let times = scenario.run().map(|run| run.times.as_slice()).unwrap_or_default();
        let duration = times.last().map_or(0.0, |last| last - start.time);
        let mut case = json!({
            "name": self.name,
            "title": scenario.title(),
            "what": self.what(),
            "file": format!("{}.toml", self.name),
            "mass_kg": body.mass(),
            "inertia_kg_m2": body.inertia().matrix(),
            "attitude": start.attitude.quaternion(),
            "omega_body_rad_s": start.omega.to_array(),
            "duration_s": duration,
            "rows": times.len(),
            "rows_every_s": duration / times.len().saturating_sub(1).max(1) as f64,
            "scenario": self.text.parse::<toml::Table>().map(from_table).unwrap_or_default(),
        });
        if let (Some(pivot), Some(object)) = (scenario.pivot(), case.as_object_mut()) {
            let from_pivot = body.center_of_mass() - pivot;
            object.insert("center_of_mass_m".to_owned(), json!(from_pivot.to_array()));
        }
        Ok(case)
    }
}

/// All cases as data: `{"suite": "polhode", "version": 1, "cases": […]}`
///
/// # Errors
/// As [`SuiteCase::scenario`].
pub fn to_json() -> Result<Value, FormatError> {
    let cases = CASES.iter().map(SuiteCase::to_json).collect::<Result<Vec<_>, _>>()?;
    Ok(json!({ "suite": "polhode", "version": 1, "cases": cases }))
}

fn from_table(table: toml::Table) -> Value {
    Value::Object(table.into_iter().map(|(key, value)| (key, from_toml(value))).collect::<Map<_, _>>())
}

fn from_toml(value: toml::Value) -> Value {
    match value {
        toml::Value::String(text) => text.into(),
        toml::Value::Integer(number) => number.into(),
        toml::Value::Float(number) => number.into(),
        toml::Value::Boolean(is) => is.into(),
        toml::Value::Datetime(when) => when.to_string().into(),
        toml::Value::Array(items) => items.into_iter().map(from_toml).collect(),
        toml::Value::Table(table) => from_table(table),
    }
}
