//! States at the requested times.

use polhode::math::{AngularVelocity, Body};
use polhode::motion::{State, StateError};
use polhode_document::json::{numbers, vector};
use polhode_document::layout::columns;
use polhode_document::number::{error, exact};
use serde_json::{Value, json};

use crate::report::global_error;

/// State with the sign of its quaternion for output.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Printed {
    time: f64,
    omega: AngularVelocity<Body>,
    wxyz: [f64; 4],
    /// Errors due to the computation, and due to input rounding.
    errors: [StateError; 2],
}

impl Printed {
    /// Chooses the sign of the quaternion: w ≥ 0 for a single state or the first of a list, else
    /// the sign nearest to the previous state.
    pub(crate) fn new(state: &State, errors: [StateError; 2], before: Option<&Self>) -> Self {
        let q = state.attitude.canonical_quaternion();
        let cosine = before.map_or(1.0, |before| q.iter().zip(before.wxyz).map(|(a, b)| a * b).sum());
        let wxyz = if cosine < 0.0 { q.map(|c| 0.0 - c) } else { q };
        Self { time: state.time, omega: state.omega, wxyz, errors }
    }
}

pub(crate) fn to_json(states: &[Printed]) -> Value {
    let one = |s: &Printed| {
        let [mut error, inputs] = s.errors.map(global_error::state_json);
        error["inputs"] = inputs;
        json!({ "time_s": s.time, "omega_body": vector(s.omega), "attitude_wxyz": numbers(&s.wxyz), "error": error })
    };
    states.iter().map(one).collect()
}

/// Returns two tables, because a row of all eight numbers is wider than a terminal. Each number
/// reads back bit for bit.
pub(crate) fn to_text(states: &[Printed]) -> String {
    if states.is_empty() {
        return String::new();
    }
    let table = |numbers: &dyn Fn(&Printed) -> Vec<f64>| {
        let row = |s: &Printed| [s.time].into_iter().chain(numbers(s)).map(exact).collect();
        let rows: Vec<Vec<String>> = states.iter().map(row).collect();
        columns(&rows).into_iter().map(|line| format!("    {line}\n")).collect::<String>()
    };
    let omega = table(&|s| s.omega.to_array().to_vec());
    let attitude = table(&|s| s.wxyz.to_vec());
    let row = |s: &Printed| {
        [exact(s.time)].into_iter().chain(s.errors.map(|e| error(e.attitude))).collect::<Vec<String>>()
    };
    let rows: Vec<Vec<String>> = states.iter().map(row).collect();
    let errors: String = columns(&rows).into_iter().map(|line| format!("    {line}\n")).collect();
    format!(
        "\nt in s, ω in body axes in rad/s: t, x, y, z\n{omega}\nt in s, attitude R_space_body: t, w, x, y, z\n{attitude}\n\
         t in s, estimated error of the attitude in rad: t, of the computation, of input rounding\n{errors}"
    )
}
