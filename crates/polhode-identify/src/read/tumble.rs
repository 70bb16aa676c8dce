//! Table `[tumble]`: free motion of a thrown body, measured by a gyro on it or by tracked
//! attitudes.

use polhode::motion::torque::DragLaw;
use polhode::motion::{Motor, Wheel};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::gyro_log::{Logs, Measured};
use super::read_log::ReadLog;
use super::{at, effect};
use crate::tumble::{Flight, FlightSearch, GyroErrors, GyroRange, GyroReading, TumbleOptions, find_flights};

/// Tumble measurement, ready to be identified.
#[derive(Clone, Debug, PartialEq)]
pub struct TumblePlan {
    /// Readings of each flight.
    pub flights: Vec<Flight>,
    /// Options of the estimation.
    pub options: TumbleOptions,
    /// Logs with the readings.
    pub logs: Vec<ReadLog>,
    /// True if the flights were detected in the logs.
    pub found: bool,
    /// Sentences on flights that begin or end outside a log.
    pub cut_off: Vec<String>,
}

const KEYS: [&str; 9] =
    ["log", "columns", "flights", "flight", "gyro", "attitude", "drag", "outliers", "search"];
const FLIGHT_KEYS: [&str; 7] = ["name", "log", "columns", "from", "to", "added", "wheel"];

/// Reads the table `[tumble]`.
pub(crate) fn plan(table: &Table<'_>) -> Result<TumblePlan, FormatError> {
    table.allow(&KEYS)?;
    let mut options = options(table)?;
    let search = FlightSearch { gyro_range: options.gyro_range, ..search(table)? };
    let mut logs = Logs::default();
    let mut cut_off = Vec::new();
    let mut flights = Vec::new();
    let given = table.at_most_one(
        &["flight", "flights"],
        "flights are either listed ([[tumble.flight]]) or found (flights)",
    )?;
    let found = match &given {
        Some(value) if value.key() == "flight" => {
            let tables = value.tables("tumble.flight")?;
            let mut spans = Vec::new();
            for flight in &tables {
                flights.push(one(flight, table, &mut logs, &mut spans)?);
            }
            for key in ["log", "columns"] {
                let is_own = !tables.is_empty() && tables.iter().all(|flight| flight.get(key).is_some());
                if let Some(value) = table.get(key).filter(|_| is_own) {
                    return Err(value.invalid("omitted if each flight has its own"));
                }
            }
            false
        }
        Some(value) => value.choice(&["find", "whole"])? == "find",
        None => false,
    };
    // An entry without effect is probably a mistake.
    if let Some(value) = table.get("search").filter(|_| !found) {
        return Err(value
            .invalid("used with flights = \"find\"")
            .with_hint("add flights = \"find\", or remove search"));
    }
    if let Some(value) = given.filter(|value| value.key() == "flight" && flights.is_empty()) {
        return Err(value
            .invalid("a list of at least one flight")
            .with_hint("remove it to read the whole log as one flight"));
    }
    if flights.is_empty() {
        let log = table.require("log", "log = \"gyro.csv\"")?;
        let each = if log.is_array() { log.elements("paths of logs")? } else { vec![log] };
        for log in &each {
            let known = logs.measured.len();
            let number = logs.read(log, table.get("columns").as_ref())?;
            if number < known {
                return Err(log.invalid("different from the previous logs: each log is used once"));
            }
            let measured = &logs.measured[number];
            let several = if each.len() > 1 { format!("{}: ", log.string()?) } else { String::new() };
            flights.extend(of_log(log, &several, measured, found.then_some(&search), &mut cut_off)?);
        }
        // Handling before and after a flight also reveals the gyro's range.
        let readings: Vec<GyroReading> =
            logs.measured.iter().flat_map(|log| log.gyro.iter().copied()).collect();
        options.gyro_range = options.gyro_range.or(found.then(|| GyroRange::shown_by(&readings)));
        if flights.is_empty() {
            let rule = "a log with flights: the body never rotates fast and freely in this one";
            let hint = "check the unit of the rates, or search for slower flights: search = { slowest = \"1 rad/s\" }";
            return Err(log.invalid(rule).with_hint(hint));
        }
    }
    effect::require(table, &flights)?;
    Ok(TumblePlan { flights, options, logs: logs.read, found, cut_off })
}

/// Returns the flights of a log: those detected, or the whole log as one.
fn of_log(
    log: &Value<'_>,
    prefix: &str,
    measured: &Measured,
    search: Option<&FlightSearch>,
    cut_off: &mut Vec<String>,
) -> Result<Vec<Flight>, FormatError> {
    let Some(search) = search else {
        let whole = [f64::NEG_INFINITY, f64::INFINITY];
        let flight = measured.flight(format!("{prefix}flight"), whole).map_err(|error| at(log, &error))?;
        return Ok(vec![flight]);
    };
    if measured.gyro.is_empty() {
        return Err(log
            .invalid("a log of a gyro: the search for flights needs rates")
            .with_hint("state the times of each flight: [[tumble.flight]] with from and to"));
    }
    let spans = find_flights(&measured.gyro, search).map_err(|error| at(log, &error))?;
    let [begins, ends] = [measured.gyro.first(), measured.gyro.last()].map(|r| r.map(|r| r.time));
    let mut flights = Vec::new();
    for (k, span) in spans.iter().enumerate() {
        let name = format!("{prefix}flight {}, {:.2} s", k + 1, span[0]);
        for (is_cut, what) in [(begins == Some(span[0]), "begins"), (ends == Some(span[1]), "ends")] {
            if is_cut {
                cut_off.push(format!("The log {what} during a flight: {name}"));
            }
        }
        flights.push(measured.flight(name, *span).map_err(|error| at(log, &error))?);
    }
    Ok(flights)
}

fn options(table: &Table<'_>) -> Result<TumbleOptions, FormatError> {
    let mut options = TumbleOptions::default();
    if let Some(gyro) = table.get("gyro") {
        let gyro = gyro.table()?;
        gyro.allow(&["bias", "scale", "skew", "clock", "noise", "range"])?;
        let flag = |key, or| gyro.get(key).map_or(Ok(or), |value| value.boolean());
        options.gyro = GyroErrors {
            bias: flag("bias", true)?,
            scale: flag("scale", false)?,
            skew: flag("skew", false)?,
            clock: flag("clock", false)?,
        };
        let rate = |key| gyro.get(key).map(|rate| rate.positive(Dimension::ANGULAR_VELOCITY)).transpose();
        options.gyro_noise = rate("noise")?;
        options.gyro_range = rate("range")?.map(GyroRange::within);
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
    let search = FlightSearch::default();
    let Some(value) = table.get("search") else { return Ok(search) };
    let given = value.table()?;
    given.allow(&["slowest", "shortest", "torque"])?;
    let positive = |key, dimension, or| given.get(key).map_or(Ok(or), |value| value.positive(dimension));
    Ok(FlightSearch {
        slowest: positive("slowest", Dimension::ANGULAR_VELOCITY, search.slowest)?,
        shortest: positive("shortest", Dimension::TIME, search.shortest)?,
        torque: positive("torque", Dimension::NONE, search.torque)?,
        ..search
    })
}

/// Reads a table `[[tumble.flight]]`.
fn one(
    flight: &Table<'_>,
    plan: &Table<'_>,
    logs: &mut Logs,
    spans: &mut Vec<(usize, [f64; 2])>,
) -> Result<Flight, FormatError> {
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
    if spans.iter().any(|(of, span)| *of == number && from.max(span[0]) < to.min(span[1])) {
        let place = flight.get("from").or(flight.get("to")).unwrap_or(log);
        return Err(place.invalid("after the end of the previous flights: each reading is used once"));
    }
    spans.push((number, [from, to]));
    let name = match flight.get("name") {
        Some(name) => name.string()?.to_owned(),
        None if from.is_finite() => format!("from {from} s"),
        None => log.string()?.to_owned(),
    };
    let place = flight.get("from").or(own).unwrap_or(log);
    let mut made = logs.measured[number].flight(name, [from, to]).map_err(|error| at(&place, &error))?;
    if let Some(added) = flight.get("added") {
        made = made.with_added(self::added(&added)?);
    }
    if let Some(wheel) = flight.get("wheel") {
        made = made.with_wheels(vec![self::wheel(&wheel)?]);
    }
    Ok(made)
}

/// Reads `added = { moments = […], products = […] }`: increase of the tensor about the common
/// centre of mass, along the sensor's axes.
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
    if [xx, yy, zz, xy, xz, yz] == [0.0; 6] {
        return Err(value
            .invalid("a tensor that is not zero")
            .with_hint("remove it if nothing was added in this flight"));
    }
    Ok([xx, yy, zz, xy, xz, yz])
}

/// Reads `wheel = { axis = […], momentum = … }`: a wheel at constant speed in the body.
fn wheel(value: &Value<'_>) -> Result<Wheel, FormatError> {
    let table = value.table()?;
    table.allow(&["axis", "momentum"])?;
    let axis = table.require("axis", "axis = [0, 0, 1]")?;
    let given = table.require("momentum", "momentum = \"0.02 kg m^2/s\"")?;
    let momentum = given.quantity(Dimension::ANGULAR_MOMENTUM)?;
    if momentum == 0.0 {
        return Err(given
            .invalid("different from zero")
            .with_hint("remove the wheel: at rest, it is a part of the body"));
    }
    let direction = polhode::math::Direction::from_array(axis.numbers()?);
    Wheel::new(direction, momentum, Motor::HeldSpeed).map_err(|error| axis.motion(error))
}
