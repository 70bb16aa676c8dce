//! Logs of motions by other programs: each form is read back and compared with polhode's own
//! rotations.

mod forms;
mod mistakes;
mod names;
mod parquet;
mod written;

use polhode::prelude::*;
use polhode_source::ContentError;
use polhode_source::FormatError;
use polhode_table::log as run_log;
use polhode_table::log::{Columns, RunLog};

/// Returns attitudes at generic places: continuous, with no small numbers.
fn attitudes(rows: usize) -> Vec<Attitude> {
    let turn = |k: usize| {
        let t = k as f64;
        let first = Attitude::from_axis_angle(Direction::new(0.3, -0.8, 0.5), 0.7 + 0.37 * t).unwrap();
        first * Rotation::from_axis_angle(Direction::new(-0.6, 0.2, 0.9), 1.1 - 0.21 * t).unwrap()
    };
    (0..rows).map(turn).collect()
}

fn omega(k: usize) -> [f64; 3] {
    let t = k as f64;
    [1.25 - 0.1 * t, -0.375 + 0.2 * t, 2.5 + 0.03 * t]
}

fn time(k: usize) -> f64 {
    0.125 * k as f64 - 0.3
}

/// Returns text with a line for each row.
fn table(header: &str, rows: usize, numbers: impl Fn(usize, Attitude) -> Vec<f64>) -> String {
    let lines = attitudes(rows).into_iter().enumerate().map(|(k, attitude)| {
        let fields: Vec<String> = numbers(k, attitude).iter().map(|n| format!("{n:?}")).collect();
        fields.join(",") + "\n"
    });
    format!("{header}\n{}", lines.collect::<String>())
}

fn read(text: impl AsRef<[u8]>) -> RunLog {
    let text = text.as_ref();
    run_log::from_bytes(text, None)
        .unwrap_or_else(|e| panic!("{e}, {:?}: {}", e.hint, String::from_utf8_lossy(text)))
}

fn told(text: impl AsRef<[u8]>, columns: &str) -> Result<RunLog, ContentError> {
    run_log::from_bytes(text.as_ref(), Some(&Columns::parse(columns).unwrap()))
}

fn refused(text: impl AsRef<[u8]>) -> FormatError {
    let text = text.as_ref();
    let error = run_log::from_bytes(text, None).expect_err(&String::from_utf8_lossy(text));
    FormatError::of_content("log.csv".as_ref(), text, error)
}

/// Returns the largest angle between the attitudes of a log and those that were written.
fn angle(log: &RunLog) -> f64 {
    let own = attitudes(log.log.times().len());
    let angle = |(own, read): (&Attitude, &[f64; 4])| own.angle_to(Attitude::from_quaternion(*read).unwrap());
    own.iter().zip(log.log.attitude()).map(angle).fold(0.0, f64::max)
}
