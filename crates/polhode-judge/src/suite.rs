//! Suite for grading programs: scenarios, and the data that a program needs to run them.

use std::path::Path;

use polhode_scenario::read::ScenarioFile;
use polhode_source::FormatError;
use polhode_source::files::Memory;
use serde_json::{Value, json};

/// Case of the suite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SuiteCase {
    /// Name of the case and of its files.
    pub name: &'static str,
    /// Text of the scenario file.
    pub text: &'static str,
}

/// Includes cases of `suite/` by name.
macro_rules! cases {
    ($($name:literal)*) => {
        &[$(SuiteCase { name: $name, text: include_str!(concat!("../suite/", $name, ".toml")) }),*]
    };
}

/// All cases: free motion of every kind, then motion under torque.
pub const CASES: &[SuiteCase] = cases! {
    "free-long-axis" "free-short-axis" "free-separatrix-long" "free-separatrix-short" "free-flips"
    "permanent-least" "permanent-intermediate" "permanent-greatest"
    "near-symmetric" "symmetric-prolate" "symmetric-oblate" "spherical" "needle" "plate"
    "huge" "tiny" "fast-spin" "long-run" "identity-start"
    "torque-constant-body" "torque-constant-space" "torque-of-time" "damping"
    "pivoted" "top-fast" "top-slow" "top-sleeping" "gravity-gradient" "gyrostat-held" "gyrostat-motor"
};

impl SuiteCase {
    /// Parses the scenario of the case.
    ///
    /// # Errors
    /// [`FormatError`] for an invalid scenario; the suite's own are valid.
    pub fn scenario(&self) -> Result<ScenarioFile, FormatError> {
        ScenarioFile::parse(
            &Memory::default(),
            self.text.to_owned(),
            Path::new(&format!("{}.toml", self.name)),
        )
    }

    /// Returns the purpose of the test: the first comment of the file.
    pub fn what(&self) -> &'static str {
        self.text.lines().next().unwrap_or_default().trim_start_matches(['#', ' '])
    }

    /// Returns the case as JSON, with numbers in SI units, for programs that do not read TOML:
    /// body, start, times, and torques. Components are along body axes unless a name says
    /// otherwise, and the tensor is about the centre of mass. For a body on a pivot, the centre of
    /// mass is relative to the pivot. The kinds in `torque` are:
    ///
    /// - `constant-body`, `constant-space`: `torque_n_m`
    /// - `formula`: `torque_n_m`, three formulas of t in s, along the axes that `axes` names
    /// - `damping`: N = −c ω, component by component, `coefficient_n_m_s`
    /// - `gravity`: `acceleration_m_s2` in space, for a body on a pivot
    /// - `gravity-gradient`: N = 3 µ/r³ u × I u, with u = cos(n t) `radial` + sin(n t) `motion` in
    ///   space, `mu_m3_s2`, `radius_m` and n, `rate_rad_s`
    /// - `wheel`: J about `axis` (`moment_kg_m2`, included in the body's tensor), with initial
    ///   speed `speed_rad_s` relative to the body; the speed is constant, or changes under
    ///   `motor_torque_n_m`
    ///
    /// # Errors
    /// Same as [`SuiteCase::scenario`].
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
            "torque": self.text.parse::<toml::Table>().map(|file| torques(&file)).unwrap_or_default(),
        });
        if let (Some(pivot), Some(object)) = (scenario.pivot(), case.as_object_mut()) {
            let from_pivot = body.center_of_mass() - pivot;
            object.insert("center_of_mass_m".to_owned(), json!(from_pivot.to_array()));
        }
        Ok(case)
    }
}

/// Returns all cases as JSON: `{"suite": "polhode", "version": 1, "cases": […]}`.
///
/// # Errors
/// Same as [`SuiteCase::scenario`].
pub fn to_json() -> Result<Value, FormatError> {
    let cases = CASES.iter().map(SuiteCase::to_json).collect::<Result<Vec<_>, _>>()?;
    Ok(json!({ "suite": "polhode", "version": 1, "cases": cases }))
}

/// Returns the torques in a file of the suite. All its numbers are without unit, so in SI.
fn torques(file: &toml::Table) -> Value {
    let tables = |key: &str| file.get(key).and_then(toml::Value::as_array).cloned().unwrap_or_default();
    let wheels = tables("wheel").into_iter().map(|wheel| wheel_of(&wheel));
    let torques = tables("torque");
    torques.iter().map(|torque| torque_of(torque, file.get("orbit"))).chain(wheels).collect()
}

fn torque_of(torque: &toml::Value, orbit: Option<&toml::Value>) -> Value {
    let word = |key: &str| torque.get(key).and_then(toml::Value::as_str).unwrap_or_default();
    let numbers = |key: &str| json(torque.get(key));
    match word("model") {
        "constant" => {
            json!({ "kind": format!("constant-{}", word("axes")), "torque_n_m": numbers("torque") })
        }
        "formula" => {
            let formulas = torque.get("torque").and_then(toml::Value::as_array);
            let bare = |formula: &toml::Value| without_units(formula.as_str().unwrap_or_default());
            let formulas: Value = formulas.into_iter().flatten().map(bare).collect();
            json!({ "kind": "formula", "axes": word("axes"), "torque_n_m": formulas })
        }
        "drag" => json!({ "kind": "damping", "coefficient_n_m_s": numbers("coefficient") }),
        "gravity" => json!({ "kind": "gravity", "acceleration_m_s2": numbers("acceleration") }),
        "gravity_gradient" => {
            let of = |key: &str| json(orbit.and_then(|orbit| orbit.get(key)));
            let number = |key: &str| of(key).as_f64().unwrap_or(f64::NAN);
            // n² = µ/r³
            let rate = (number("mu") / number("radius").powi(3)).sqrt();
            json!({
                "kind": "gravity-gradient",
                "mu_m3_s2": of("mu"),
                "radius_m": of("radius"),
                "rate_rad_s": rate,
                "radial": of("radial"),
                "motion": of("motion"),
            })
        }
        model => json!({ "kind": model }),
    }
}

fn wheel_of(wheel: &toml::Value) -> Value {
    let axis: Vec<f64> =
        json(wheel.get("axis")).as_array().into_iter().flatten().filter_map(Value::as_f64).collect();
    let length = axis.iter().map(|c| c * c).sum::<f64>().sqrt();
    let mut found = json!({
        "kind": "wheel",
        "axis": axis.iter().map(|c| c / length).collect::<Vec<f64>>(),
        "moment_kg_m2": json(wheel.get("inertia")),
        "speed_rad_s": json(wheel.get("speed")),
    });
    if let (Some(torque), Some(object)) = (wheel.get("motor_torque"), found.as_object_mut()) {
        object.insert("motor_torque_n_m".to_owned(), json(Some(torque)));
    }
    found
}

/// Removes the units of a formula: `0.6[N m]*sin(2[rad/s]*t)` gives `0.6*sin(2*t)`. The units of
/// the suite are SI.
fn without_units(formula: &str) -> String {
    let mut depth = 0;
    let outside = |c: &char| {
        depth += i32::from(*c == '[');
        let is_outside = depth == 0;
        depth -= i32::from(*c == ']');
        is_outside
    };
    formula.chars().filter(outside).collect()
}

/// Returns numbers and lists of numbers; `null` for everything else.
fn json(value: Option<&toml::Value>) -> Value {
    match value {
        Some(toml::Value::Integer(number)) => (*number as f64).into(),
        Some(toml::Value::Float(number)) => (*number).into(),
        Some(toml::Value::Array(items)) => items.iter().map(|item| json(Some(item))).collect(),
        _ => Value::Null,
    }
}
