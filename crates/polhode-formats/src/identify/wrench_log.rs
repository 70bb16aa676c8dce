//! The log of a force–torque sensor and its motion: CSV, a column for each number, found by its name or told.

use std::ops::Range;

use polhode::infer::judge::AttitudeSense;
use polhode::math::{Acceleration, AngularAcceleration, AngularVelocity, Attitude, Body, Force, Torque};
use polhode_identify::payload::{PayloadRow, gravity_along};

use super::gravity::Gravity;
use super::tumble::ReadLog;
use super::wrench_columns::{Columns, Told};
use crate::content::{ContentError, ContentErrorKind, ContentPlace};
use crate::error::FormatError;
use crate::scenario::csv::{self, fields, missing};
use crate::scenario::reader::{Table, Value};

/// A log that was read.
pub(super) struct Read {
    pub(super) rows: Vec<PayloadRow>,
    pub(super) source: ReadLog,
}

/// A number of each column at most: the time, six vectors or five and a quaternion.
const MOST: usize = 20;

/// Reads the file that a value names.
pub(super) fn read(
    log: &Value<'_>,
    columns: Option<Table<'_>>,
    units: Option<Table<'_>>,
    gravity: &Gravity<'_>,
) -> Result<Read, FormatError> {
    let path = log.path()?;
    let bytes = csv::bytes(log, &path)?;
    let refused = |error: ContentError| {
        FormatError::of_content(&path, &bytes, error).named_in(log.source().path, log.place())
    };
    if bytes.starts_with(b"PAR1") {
        let kind = ContentErrorKind::Unsupported { what: "Parquet for logs of wrenches".to_owned() };
        return Err(refused(ContentError::new(kind, ContentPlace::Whole).hint("write it as CSV")));
    }
    let text = csv::text(&bytes).map_err(refused)?;
    let mut lines = fields(text);
    let Some((_, header)) = lines.next() else {
        return Err(refused(missing("lines").hint("write a header, and a row for each time")));
    };
    let told = Told { columns, units };
    let columns = Columns::find(text, &header, &told, gravity).map_err(|wrong| wrong.into_error(refused))?;
    let mut rows = Vec::new();
    let mut times = Vec::new();
    for (line, fields) in lines {
        let numbers = csv::numbers::<MOST>(text, &line, &fields, header.len(), &columns.places);
        let mut numbers = numbers.map_err(refused)?;
        for (number, unit) in numbers.iter_mut().zip(&columns.units) {
            *number *= unit;
        }
        csv::ascending(&times, numbers[0], line.clone()).map_err(refused)?;
        times.push(numbers[0]);
        rows.push(row(&numbers, gravity, text, line).map_err(refused)?);
    }
    let source = ReadLog { path: path.clone(), read: columns.read, ignored: columns.ignored };
    Ok(Read { rows, source })
}

fn row(
    numbers: &[f64; MOST],
    gravity: &Gravity<'_>,
    text: &str,
    line: Range<usize>,
) -> Result<PayloadRow, ContentError> {
    let three = |first: usize| [numbers[first], numbers[first + 1], numbers[first + 2]];
    let gravity: Acceleration<Body> = match gravity {
        Gravity::None => Acceleration::ZERO,
        Gravity::Logged => Acceleration::from_array(three(16)),
        Gravity::Turned { told, sense, .. } => {
            let [w, x, y, z] = [numbers[16], numbers[17], numbers[18], numbers[19]];
            let body_to_space = match sense {
                AttitudeSense::BodyToSpace => [w, x, y, z],
                AttitudeSense::SpaceToBody => [w, -x, -y, -z],
            };
            let attitude = Attitude::from_quaternion(body_to_space).map_err(|_| {
                csv::value("the attitude", &text[line.clone()], "a quaternion that is not zero", line)
            })?;
            gravity_along(attitude, *told)
        }
    };
    Ok(PayloadRow {
        time: numbers[0],
        omega: AngularVelocity::from_array(three(1)),
        alpha: AngularAcceleration::from_array(three(4)),
        acceleration: Acceleration::from_array(three(7)),
        gravity,
        force: Force::from_array(three(10)),
        torque: Torque::from_array(three(13)),
    })
}
