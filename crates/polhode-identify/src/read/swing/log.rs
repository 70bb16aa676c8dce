//! Entry `logged = { log = "swing.csv", … }`: angle or rate of a swing against time; or
//! `{ times = […], values = […], … }`.

use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::super::number_log;
use super::super::read_log::ReadLog;
use super::super::wrench_columns::{Columns, Header, Told, Wrong};
use super::super::wrench_quantity::{Quantity, TIME};
use super::damping;
use crate::swing::{Damping, Logged, Signal};

const ANGLE: Quantity = Quantity {
    key: "angle",
    what: "angle",
    dimension: Dimension::ANGLE,
    axes: &[""],
    names: &["angle", "theta", "twist"],
    example: "angle_deg",
};
const RATE: Quantity = Quantity {
    key: "rate",
    what: "rate",
    dimension: Dimension::ANGULAR_VELOCITY,
    axes: &[""],
    names: &["rate", "omega", "gyro"],
    example: "rate_rad_s",
};

/// Keys for a file only.
const OF_FILE: [&str; 4] = ["columns", "units", "from", "to"];

/// Reads `logged = { log, signal, sd, columns, units, from, to, damping }`, or `times` and `values`
/// instead of a file.
pub(crate) fn logged(value: &Value<'_>) -> Result<(Logged, Option<ReadLog>), FormatError> {
    let table = value.table()?;
    table.allow(&[&["log", "times", "values", "signal", "sd", "damping"], &OF_FILE[..]].concat())?;
    let signal = table.require("signal", "signal = \"angle\", or \"rate\" of a gyro along the axis")?;
    let (signal, quantity) = match signal.choice(&["angle", "rate"])? {
        "angle" => (Signal::Angle, &ANGLE),
        _ => (Signal::Rate, &RATE),
    };
    let sd = table.require(
        "sd",
        "sd = \"0.2 deg\", or \"0.01 rad/s\" for a rate; the standard deviation of each value",
    )?;
    let sd = sd.positive(quantity.dimension)?;
    let damping = table.get("damping").map_or(Ok(Damping::Viscous), |value| damping(&value))?;
    let given =
        table.at_most_one(&["log", "times"], "a log is either a file (log) or part of the plan (times)")?;
    if let Some(times) = given.as_ref().filter(|given| given.key() == "times") {
        if let Some(key) = OF_FILE.into_iter().find_map(|key| table.get(key)) {
            return Err(key
                .invalid("omitted: it applies to a log file")
                .with_hint("remove it, or write log = \"swing.csv\""));
        }
        let (times, values) = lists(times, &table, quantity)?;
        return Ok((Logged { times, values, sd, signal, damping }, None));
    }
    let values = table.get("values");
    if let Some(values) = values.filter(|_| given.is_some()) {
        return Err(values
            .invalid("omitted: the log is a file")
            .with_hint("remove it, or write times = [...] instead of the file"));
    }
    let log = table.require("log", "log = \"swing.csv\", with time_s and angle_deg or rate_rad_s")?;
    let told = Told {
        columns: table.get("columns").map(|columns| columns.table()).transpose()?,
        units: table.get("units").map(|units| units.table()).transpose()?,
    };
    let time = |key, or| table.get(key).map_or(Ok(or), |value| value.quantity(Dimension::TIME));
    let (from, to) = (time("from", f64::NEG_INFINITY)?, time("to", f64::INFINITY)?);
    let (mut times, mut values) = (Vec::new(), Vec::new());
    let read = number_log::read(
        &log,
        |header| columns(header, &told, quantity),
        |row, _| {
            if (from..=to).contains(&row[0]) {
                times.push(row[0]);
                values.push(row[1]);
            }
            Ok(())
        },
    )?;
    if let (true, Some(value)) = (times.is_empty(), table.get("from").or_else(|| table.get("to"))) {
        return Err(value.invalid("within the log: it has no row in this interval"));
    }
    Ok((Logged { times, values, sd, signal, damping }, Some(read)))
}

/// Reads ascending times and an equal number of values.
fn lists(
    times: &Value<'_>,
    table: &Table<'_>,
    signal: &Quantity,
) -> Result<(Vec<f64>, Vec<f64>), FormatError> {
    let values = table.require("values", "values = [\"12 deg\", ...], one at each time")?;
    let mut ascending: Vec<f64> = Vec::new();
    for time in times.elements("times")? {
        let at = time.quantity(Dimension::TIME)?;
        if ascending.last().is_some_and(|&last| at <= last) {
            return Err(time.invalid("later than the previous time"));
        }
        ascending.push(at);
    }
    let each = values.elements("values of the signal")?;
    if each.len() != ascending.len() {
        return Err(values.invalid(format!("as many as the times: {}, not {}", ascending.len(), each.len())));
    }
    let values = each.iter().map(|value| value.quantity(signal.dimension)).collect::<Result<_, _>>()?;
    Ok((ascending, values))
}

fn columns(header: &Header<'_>, told: &Told<'_>, signal: &Quantity) -> Result<Columns, Wrong> {
    let keys: [&'static str; 2] = [TIME.key, signal.key];
    for table in [&told.columns, &told.units].into_iter().flatten() {
        table.allow(&keys)?;
    }
    let mut found = Columns::default();
    found.add(&TIME, header, told)?;
    found.add(signal, header, told)?;
    found.ignore_others(header);
    Ok(found)
}
