//! `[tumble]`: the free motion of a thrown body, by a gyro on it or by tracked attitudes.

use std::path::PathBuf;

use polhode::infer::judge::{AttitudeSense, OmegaAxes};
use polhode::math::{AngularVelocity, Attitude};
use polhode::motion::torque::DragLaw;
use polhode::motion::{Motor, Wheel};
use polhode_identify::tumble::{
    AttitudeReading, Flight, FlightSearch, GyroErrors, GyroReading, TumbleOptions, find_flights,
};

use super::at;
use crate::error::{FormatError, FormatErrorKind};
use crate::run_log::{Columns, MeasuredLog, read_measured};
use crate::scenario::reader::{Table, Value};
use crate::unit::Dimension;

/// Tumbles of a body, ready to be identified.
#[derive(Clone, Debug, PartialEq)]
pub struct TumblePlan {
    /// What was measured.
    pub flights: Vec<Flight>,
    /// How it is read.
    pub options: TumbleOptions,
    /// The logs that it was read from.
    pub logs: Vec<ReadLog>,
    /// True if the flights were found in the logs.
    pub found: bool,
}

/// A log that was read, and what of it.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadLog {
    /// Where it is.
    pub path: PathBuf,
    /// Columns, and as what they were read: `"time, s: Time (s)"`.
    pub read: Vec<String>,
    /// Columns that were not read.
    pub ignored: Vec<String>,
}

const KEYS: [&str; 9] =
    ["log", "columns", "flights", "flight", "gyro", "attitude", "drag", "outliers", "search"];
const FLIGHT_KEYS: [&str; 7] = ["name", "log", "columns", "from", "to", "added", "wheel"];

/// Reads `[tumble]`.
pub(super) fn plan(table: &Table<'_>) -> Result<TumblePlan, FormatError> {
    table.allow(&KEYS)?;
    let options = options(table)?;
    let search = search(table)?;
    let mut logs = Logs::default();
    let mut flights = Vec::new();
    let given = table.at_most_one(&["flight", "flights"], "flights are given one by one, or found")?;
    let found = match &given {
        Some(value) if value.key() == "flight" => {
            for flight in value.tables("tumble.flight")? {
                flights.push(one(&flight, table, &mut logs)?);
            }
            false
        }
        Some(value) => value.choice(&["find", "whole"])? == "find",
        None => false,
    };
    // What would have no effect is a slip.
    if let Some(value) = table.get("search").filter(|_| !found) {
        return Err(value.invalid("beside flights = \"find\"").with_hint("nothing else is searched for"));
    }
    if let Some(value) = given.filter(|value| value.key() == "flight" && flights.is_empty()) {
        return Err(value.invalid("a list with a flight in it").with_hint("leave it out for the whole log"));
    }
    if flights.is_empty() {
        let log = table.require("log", "log = \"gyro.csv\"")?;
        let each = if log.is_array() { log.elements("paths of logs")? } else { vec![log] };
        for log in &each {
            let number = logs.read(log, table.get("columns").as_ref())?;
            let measured = &logs.measured[number];
            let several = if each.len() > 1 { format!("{}: ", log.string()?) } else { String::new() };
            flights.extend(of_log(log, &several, measured, found.then_some(&search))?);
        }
        if flights.is_empty() {
            let rule = "a log with flights: nowhere in it does the body turn fast and freely";
            let hint = "are the rates in rad/s? Slow ones are found by search = { slowest = \"1 rad/s\" }";
            return Err(log.invalid(rule).with_hint(hint));
        }
    }
    Ok(TumblePlan { flights, options, logs: logs.read, found })
}

/// The flights of a log: those that are found, or all of it.
fn of_log(
    log: &Value<'_>,
    prefix: &str,
    measured: &Measured,
    search: Option<&FlightSearch>,
) -> Result<Vec<Flight>, FormatError> {
    let Some(search) = search else {
        let whole = [f64::NEG_INFINITY, f64::INFINITY];
        let flight = measured.flight(format!("{prefix}flight"), whole).map_err(|error| at(log, error))?;
        return Ok(vec![flight]);
    };
    if measured.gyro.is_empty() {
        return Err(log
            .invalid("a log of a gyro: flights are found in its rates")
            .with_hint("say when each flight was: [[tumble.flight]] with from and to"));
    }
    let spans = find_flights(&measured.gyro, search);
    let flight = |(k, span): (usize, &[f64; 2])| {
        let name = format!("{prefix}flight {}, {:.2} s", k + 1, span[0]);
        measured.flight(name, *span).map_err(|error| at(log, error))
    };
    spans.iter().enumerate().map(flight).collect()
}

fn options(table: &Table<'_>) -> Result<TumbleOptions, FormatError> {
    let mut options = TumbleOptions::default();
    if let Some(gyro) = table.get("gyro") {
        let gyro = gyro.table()?;
        gyro.allow(&["bias", "scale", "skew", "clock", "noise"])?;
        let flag = |key, or| gyro.get(key).map_or(Ok(or), |value| value.boolean());
        options.gyro = GyroErrors {
            bias: flag("bias", true)?,
            scale: flag("scale", false)?,
            skew: flag("skew", false)?,
            clock: flag("clock", false)?,
        };
        let noise = gyro.get("noise").map(|noise| noise.positive(Dimension::ANGULAR_VELOCITY));
        options.gyro_noise = noise.transpose()?;
    }
    if let Some(attitude) = table.get("attitude") {
        let attitude = attitude.table()?;
        attitude.allow(&["noise"])?;
        let noise = attitude.require("noise", "noise = \"0.2 deg\"")?;
        options.attitude_noise = Some(noise.positive(Dimension::ANGLE)?);
    }
    if let Some(drag) = table.get("drag") {
        options.drag = match drag.choice(&["none", "linear", "quadratic"])? {
            "linear" => Some(DragLaw::Linear),
            "quadratic" => Some(DragLaw::Quadratic),
            _ => None,
        };
    }
    if let Some(outliers) = table.get("outliers") {
        options.outlier = outliers.positive(Dimension::NONE)?;
    }
    Ok(options)
}

fn search(table: &Table<'_>) -> Result<FlightSearch, FormatError> {
    let mut search = FlightSearch::default();
    if let Some(value) = table.get("search") {
        let given = value.table()?;
        given.allow(&["slowest", "shortest", "torque"])?;
        if let Some(slowest) = given.get("slowest") {
            search.slowest = slowest.positive(Dimension::ANGULAR_VELOCITY)?;
        }
        if let Some(shortest) = given.get("shortest") {
            search.shortest = shortest.positive(Dimension::TIME)?;
        }
        if let Some(torque) = given.get("torque") {
            search.torque = torque.positive(Dimension::NONE)?;
        }
    }
    Ok(search)
}

/// Reads `[[tumble.flight]]`.
fn one(flight: &Table<'_>, plan: &Table<'_>, logs: &mut Logs) -> Result<Flight, FormatError> {
    flight.allow(&FLIGHT_KEYS)?;
    let own = flight.get("log");
    let log = match own {
        Some(log) => log,
        None => plan.require("log", "log = \"gyro.csv\"")?,
    };
    let columns = flight.get("columns").or_else(|| plan.get("columns"));
    let number = logs.read(&log, columns.as_ref())?;
    let time = |key, or| flight.get(key).map_or(Ok(or), |value| value.quantity(Dimension::TIME));
    let (from, to) = (time("from", f64::NEG_INFINITY)?, time("to", f64::INFINITY)?);
    if let Some(value) = flight.get("to").filter(|_| !(to > from)) {
        return Err(value.invalid("later than from"));
    }
    let name = match flight.get("name") {
        Some(name) => name.string()?.to_owned(),
        None if from.is_finite() => format!("from {from} s"),
        None => log.string()?.to_owned(),
    };
    let place = flight.get("from").or(own).unwrap_or(log);
    let mut made = logs.measured[number].flight(name, [from, to]).map_err(|error| at(&place, error))?;
    if let Some(added) = flight.get("added") {
        made = made.with_added(self::added(&added)?);
    }
    if let Some(wheel) = flight.get("wheel") {
        made = made.with_wheels(vec![self::wheel(&wheel)?]);
    }
    Ok(made)
}

/// `added = { moments = […], products = […] }`: by how much the tensor about the common centre of mass is greater, along the sensor's axes.
fn added(value: &Value<'_>) -> Result<[f64; 6], FormatError> {
    let table = value.table()?;
    table.allow(&["moments", "products"])?;
    let moments =
        table.require("moments", "moments = [\"1e-4 kg m^2\", \"1e-4 kg m^2\", \"2e-4 kg m^2\"]")?;
    let [xx, yy, zz] = moments.quantities(Dimension::INERTIA)?;
    let [xy, xz, yz] = match table.get("products") {
        Some(products) => products.quantities(Dimension::INERTIA)?,
        None => [0.0; 3],
    };
    Ok([xx, yy, zz, xy, xz, yz])
}

/// `wheel = { axis = […], momentum = … }`: held at its speed in the body.
fn wheel(value: &Value<'_>) -> Result<Wheel, FormatError> {
    let table = value.table()?;
    table.allow(&["axis", "momentum"])?;
    let axis = table.require("axis", "axis = [0, 0, 1]")?;
    let momentum =
        table.require("momentum", "momentum = \"0.02 kg m^2/s\"")?.quantity(Dimension::ANGULAR_MOMENTUM)?;
    let direction = polhode::math::Direction::from_array(axis.numbers()?);
    Wheel::new(direction, momentum, Motor::HeldSpeed).map_err(|error| axis.motion(error))
}

/// Logs, each read once.
#[derive(Default)]
struct Logs {
    read: Vec<ReadLog>,
    measured: Vec<Measured>,
    keys: Vec<(PathBuf, Option<String>)>,
}

/// Readings of a log.
struct Measured {
    gyro: Vec<GyroReading>,
    attitudes: Vec<AttitudeReading>,
}

impl Measured {
    fn flight(&self, name: String, [from, to]: [f64; 2]) -> Result<Flight, polhode_identify::IdentifyError> {
        let inside = |time: f64| (from..=to).contains(&time);
        let gyro = self.gyro.iter().copied().filter(|r| inside(r.time)).collect();
        Flight::new(name, gyro, self.attitudes.iter().copied().filter(|r| inside(r.time)).collect())
    }
}

impl Logs {
    /// Its number; each log is read once.
    fn read(&mut self, log: &Value<'_>, columns: Option<&Value<'_>>) -> Result<usize, FormatError> {
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
        let measured = read_measured(&path, parsed.as_ref())?;
        let made = readings(log, &measured)?;
        let said = |read: &crate::run_log::ReadColumns| format!("{}: {}", read.what, read.columns.join(", "));
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

/// The readings of a log; what it leaves open has to be told.
fn readings(log: &Value<'_>, measured: &MeasuredLog) -> Result<Measured, FormatError> {
    if measured.omega_axes == Some(OmegaAxes::Space) {
        return Err(log
            .invalid("a log of rates along axes of the body: a gyro turns with it")
            .with_hint("its columns say that they are along axes of space"));
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
            let rule =
                "a log that says in which order the numbers of its quaternion are, and which way it turns";
            let hint = "say it: columns = \"quaternion wxyz body-to-space = qw qx qy qz\"";
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
