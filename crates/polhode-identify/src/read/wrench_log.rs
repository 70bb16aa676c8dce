//! Log of a force–torque sensor and its motion, one column per number.

use polhode::infer::judge::AttitudeSense;
use polhode::math::{Acceleration, AngularAcceleration, AngularVelocity, Attitude, Body, Force, Torque};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::gravity::Gravity;
use super::number_log::{self, Row};
use super::read_log::ReadLog;
use super::wrench_columns::{Columns, Told};
use crate::payload::{PayloadRow, gravity_along};

/// Rows of a log, with its summary.
pub(crate) struct Read {
    pub rows: Vec<PayloadRow>,
    pub source: ReadLog,
}

/// Reads the log that a value names.
pub(crate) fn read(
    log: &Value<'_>,
    columns: Option<Table<'_>>,
    units: Option<Table<'_>>,
    gravity: &Gravity<'_>,
) -> Result<Read, FormatError> {
    let told = Told { columns, units };
    let mut rows = Vec::new();
    let source = number_log::read(
        log,
        |header| Columns::find(header, &told, gravity),
        |numbers, place| {
            rows.push(row(numbers, gravity, place)?);
            Ok(())
        },
    )?;
    Ok(Read { rows, source })
}

fn row(numbers: &Row, gravity: &Gravity<'_>, place: ContentPlace) -> Result<PayloadRow, ContentError> {
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
                let (what, value) = ("attitude".to_owned(), format!("{w}, {x}, {y}, {z}"));
                let rule = "a quaternion that is not zero".to_owned();
                ContentError::new(ContentErrorKind::Value { what, value, rule }, place)
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
