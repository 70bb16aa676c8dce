//! Logs of a free body at a generic point, as a program writes them.

use std::fmt::Write as _;

use polhode::math::{AngularVelocity, Attitude, Body, Direction, Rotation};
use polhode::motion::{FreeMotion, State};
use polhode_document::Report as _;
use polhode_judge::{Judged, Request, run};
use polhode_source::Failure;
use polhode_source::files::Memory;
use serde_json::Value;

pub(crate) const MOMENTS: [f64; 3] = [1.3, 2.9, 2.1];
pub(crate) const OMEGA: [f64; 3] = [0.7, -0.4, 1.1];
pub(crate) const HEAD: &str = "t,qw,qx,qy,qz,omega_body_x,omega_body_y,omega_body_z";
/// Time between rows, s.
pub(crate) const STEP: f64 = 0.02;

/// Row of a log: time, quaternion w, x, y, z, and ω along body axes.
pub(crate) type Row = (f64, [f64; 4], [f64; 3]);

fn start() -> State {
    let attitude = Attitude::from_quaternion([0.6, -0.3, 0.5, 0.2]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::from_array(OMEGA) }
}

/// Returns the exact motion, from time 0.
pub(crate) fn exact(rows: u32) -> Vec<Row> {
    let motion = FreeMotion::of_moments(MOMENTS, start()).unwrap();
    let state = |k: u32| motion.at(STEP * f64::from(k));
    (0..rows).map(state).map(|s| (s.time, s.attitude.quaternion(), s.omega.to_array())).collect()
}

/// Returns the motion by semi-implicit Euler steps: ω by the rates at the old ω, and the attitude
/// by the new ω.
pub(crate) fn euler(rows: u32) -> Vec<Row> {
    let State { mut attitude, omega, .. } = start();
    let mut w = omega.to_array();
    let mut written = Vec::new();
    for k in 0..rows {
        written.push((STEP * f64::from(k), attitude.quaternion(), w));
        let [a, b, c] = MOMENTS;
        let rates = [(b - c) * w[1] * w[2] / a, (c - a) * w[2] * w[0] / b, (a - b) * w[0] * w[1] / c];
        w = [0, 1, 2].map(|i| w[i] + STEP * rates[i]);
        let turn = Direction::<Body>::from_array(w.map(|c| STEP * c));
        attitude = attitude * Rotation::<Body, Body>::exp(turn).unwrap();
    }
    written
}

/// Returns ω of a row along space axes: R ω for the quaternion w, u.
pub(crate) fn in_space((_, [w, x, y, z], v): &Row) -> [f64; 3] {
    let u = [*x, *y, *z];
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let uv = cross(u, *v);
    let uuv = cross(u, uv);
    [0, 1, 2].map(|i| v[i] + 2.0 * (w * uv[i] + uuv[i]))
}

/// Returns the numbers of a row with the conjugate quaternion.
pub(crate) fn conjugate((_, [w, x, y, z], v): &Row) -> Vec<f64> {
    [&[*w, -x, -y, -z][..], v].concat()
}

/// Returns the text of a log. `cells` are the numbers of a row after its time.
pub(crate) fn text(head: &str, rows: &[Row], cells: impl Fn(&Row) -> Vec<f64>) -> String {
    let mut text = format!("{head}\n");
    for row in rows {
        write!(text, "{:?}", row.0).unwrap();
        cells(row).iter().for_each(|cell| write!(text, ",{cell:?}").unwrap());
        text.push('\n');
    }
    text
}

/// Returns the numbers of a row as they are.
pub(crate) fn plain((_, q, w): &Row) -> Vec<f64> {
    [&q[..], &w[..]].concat()
}

fn report(request: &Value, files: &[(&str, String)]) -> Result<Judged, Failure> {
    let request: Request = serde_json::from_value(request.clone()).unwrap();
    let mut memory = Memory::default();
    files.iter().for_each(|(path, text)| memory.insert(path, text.as_bytes()));
    run(&request, &memory)
}

/// Judges files in memory.
pub(crate) fn judged(request: &Value, files: &[(&str, String)]) -> Result<Value, Failure> {
    report(request, files).map(|report| report.to_json())
}

/// Returns whether the exit status is 1, and the answer.
pub(crate) fn answer(request: &Value, files: &[(&str, String)]) -> (bool, String) {
    let report = report(request, files).unwrap();
    (report.has_failed(), report.to_document().answer.join("\n"))
}

/// Returns the message and the hint of a refusal.
pub(crate) fn refused(request: &Value, files: &[(&str, String)]) -> String {
    let failure = judged(request, files).unwrap_err();
    format!("{} ({})", failure.message(), failure.hint().unwrap_or_default())
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}
