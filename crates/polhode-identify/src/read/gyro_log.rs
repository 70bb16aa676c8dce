//! Logs of gyros and of tracked attitudes that a plan names.

use std::path::PathBuf;

use polhode::infer::judge::{AttitudeSense, OmegaAxes};
use polhode::math::{AngularVelocity, Attitude};
use polhode_source::toml::reader::Value;
use polhode_source::{FormatError, FormatErrorKind};
use polhode_table::log::{Columns, MeasuredLog, ReadColumns, read_measured};

use super::read_log::ReadLog;
use crate::tumble::{AttitudeReading, Flight, GyroReading};

/// Logs of a plan, each read once.
#[derive(Default)]
pub(crate) struct Logs {
    pub read: Vec<ReadLog>,
    pub measured: Vec<Measured>,
    keys: Vec<(PathBuf, Option<String>)>,
}

/// Readings of a log.
pub(crate) struct Measured {
    pub gyro: Vec<GyroReading>,
    pub attitudes: Vec<AttitudeReading>,
}

impl Measured {
    pub(crate) fn flight(&self, name: String, [from, to]: [f64; 2]) -> Result<Flight, crate::IdentifyError> {
        let inside = |time: f64| (from..=to).contains(&time);
        let gyro = self.gyro.iter().copied().filter(|r| inside(r.time)).collect();
        Flight::new(name, gyro, self.attitudes.iter().copied().filter(|r| inside(r.time)).collect())
    }
}

impl Logs {
    /// Returns the index of a log, which is read on first use.
    pub(crate) fn read(
        &mut self,
        log: &Value<'_>,
        columns: Option<&Value<'_>>,
    ) -> Result<usize, FormatError> {
        let path = log.path()?;
        let told = columns.map(Value::string).transpose()?;
        let key = (path.clone(), told.map(str::to_owned));
        if let Some(number) = self.keys.iter().position(|known| *known == key) {
            return Ok(number);
        }
        let parsed = match (columns, told) {
            (Some(value), Some(text)) => Some(Columns::parse(text).map_err(|error| {
                value.invalid(format!("a list of columns: {error}")).with_hint(error.hint())
            })?),
            _ => None,
        };
        let measured = read_measured(log.files(), &path, parsed.as_ref())?;
        let made = readings(log, &measured)?;
        let said = |read: &ReadColumns| format!("{}: {}", read.what, read.columns.join(", "));
        self.read.push(ReadLog {
            path,
            read: measured.read.iter().map(said).collect(),
            ignored: measured.ignored,
        });
        self.measured.push(made);
        self.keys.push(key);
        Ok(self.keys.len() - 1)
    }
}

/// Converts a log to readings. An unspecified quaternion convention is an error.
fn readings(log: &Value<'_>, measured: &MeasuredLog) -> Result<Measured, FormatError> {
    if measured.omega_axes == Some(OmegaAxes::Space) {
        return Err(log
            .invalid("a log of rates along body axes, as a gyro on the body measures them")
            .with_hint("its column names state space axes"));
    }
    let times = measured.times.iter();
    let gyro = measured
        .omega
        .iter()
        .flatten()
        .zip(times.clone())
        .map(|(omega, &time)| GyroReading { time, omega: AngularVelocity::from_array(*omega) });
    let mut attitudes = Vec::new();
    if let Some(numbers) = &measured.attitude {
        let (Some(order), Some(sense)) = (measured.order, measured.sense) else {
            let rule = "a log that states the order of the components of its quaternion and its direction";
            let hint = "state them: columns = \"quaternion wxyz body-to-space = qw qx qy qz\"";
            return Err(log.invalid(rule).with_hint(hint));
        };
        for (four, &time) in numbers.iter().zip(times) {
            let [w, x, y, z] = order.scalar_first(*four);
            let turned: Attitude = Attitude::from_quaternion([w, x, y, z])
                .map_err(|error| log.error(FormatErrorKind::Rotation(error)))?;
            let attitude = match sense {
                AttitudeSense::BodyToSpace => turned,
                AttitudeSense::SpaceToBody => Attitude::from_quaternion([w, -x, -y, -z])
                    .map_err(|error| log.error(FormatErrorKind::Rotation(error)))?,
            };
            attitudes.push(AttitudeReading { time, attitude });
        }
    }
    Ok(Measured { gyro: gyro.collect(), attitudes })
}
