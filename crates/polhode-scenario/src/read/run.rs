//! `[run]`: duration, sample times and integration method.

use polhode::motion::{LOOSEST_TOLERANCE, Method, Orbit, Run, SplittingOrder, TIGHTEST_TOLERANCE};
use polhode_source::times;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_source::{FormatError, FormatErrorKind};

/// Default number of samples, without `samples` or `every`.
const SAMPLES: usize = 1001;

/// Default tolerance.
const TOLERANCE: f64 = 1e-13;

/// Reads `[run]`; `None` if it is absent.
pub(crate) fn run(root: &Table<'_>, orbit: Option<&Orbit>) -> Result<Option<Run>, FormatError> {
    let Some(value) = root.get("run") else { return Ok(None) };
    let table = value.table()?;
    table.allow(&["duration", "samples", "every", "method", "tolerance", "order", "step", "table"])?;
    if (root.get("prescribed").is_some() || root.get("shaft").is_some())
        && let Some(value) = ["method", "tolerance", "order", "step"].iter().find_map(|key| table.get(key))
    {
        let hint = "a prescribed motion is not computed, so this has no effect";
        return Err(value.invalid("left out").with_hint(hint));
    }
    let duration = time(&table.require("duration", "duration = \"20 s\"")?, orbit)?;
    let given = table.at_most_one(&["samples", "every"], "both define the sample times")?;
    let method = method(&table)?;
    let tolerance = table.get("tolerance").map_or(Ok(TOLERANCE), |value| tolerance(&value))?;
    Ok(Some(match given {
        None => Run::evenly(duration, SAMPLES, method, tolerance),
        Some(value) if value.key() == "samples" => Run::evenly(duration, samples(&value)?, method, tolerance),
        Some(value) => Run { times: sampled_every(duration, &value, orbit)?, method, tolerance },
    }))
}

/// File format of the table of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TableFormat {
    /// Apache Parquet.
    Parquet,
    /// Comma-separated text.
    Csv,
}

/// Returns the formats requested in `[run]`: `table = "csv"`, or `["csv", "parquet"]`; empty if
/// none are.
pub(crate) fn tables(root: &Table<'_>) -> Result<Vec<TableFormat>, FormatError> {
    let value = root.get("run").map(|run| run.table()).transpose()?.and_then(|table| table.get("table"));
    let Some(value) = value else { return Ok(Vec::new()) };
    let format = |value: &Value<'_>| {
        value.choice(&["parquet", "csv"]).map(|name| match name {
            "csv" => TableFormat::Csv,
            _ => TableFormat::Parquet,
        })
    };
    match value.is_array() {
        false => Ok(vec![format(&value)?]),
        true => value.elements("formats, \"csv\" or \"parquet\"")?.iter().map(format).collect(),
    }
}

/// Reads a positive time, s, or a number of `"orbits"`.
fn time(value: &Value<'_>, orbit: Option<&Orbit>) -> Result<f64, FormatError> {
    let text = value.string().unwrap_or_default().trim_end();
    let Some(number) = text.strip_suffix("orbits").or_else(|| text.strip_suffix("orbit")) else {
        return value.positive(Dimension::TIME);
    };
    let Some(orbit) = orbit else {
        let hint = "write [orbit] on a line of its own, and under it altitude = \"500 km\"";
        return Err(value.invalid("a time, since there is no [orbit]").with_hint(hint));
    };
    let Some(period) = orbit.period() else {
        let rule = "a time: a parabolic or hyperbolic orbit has no period";
        return Err(value.invalid(rule).with_hint("write duration = \"3 h\""));
    };
    let count = unit::parse(number, Dimension::NONE);
    let count = count.map_err(|error| value.error(FormatErrorKind::Unit(error)))?;
    match count * period {
        time if time > 0.0 && time.is_finite() => Ok(time),
        _ => Err(value.invalid("positive").with_hint("time runs forward from 0")),
    }
}

fn samples(value: &Value<'_>) -> Result<usize, FormatError> {
    match value.count()? {
        count @ 2..=times::MOST => Ok(count as usize),
        0 | 1 => {
            Err(value.invalid("at least 2").with_hint("the first sample is the start, the last one the end"))
        }
        _ => Err(too_many(value)),
    }
}

/// Returns 0, every, 2 every, … and the end.
fn sampled_every(duration: f64, value: &Value<'_>, orbit: Option<&Orbit>) -> Result<Vec<f64>, FormatError> {
    let every = time(value, orbit)?;
    if every > duration {
        let rule = format!("at most the duration, {duration} s");
        return Err(value
            .invalid(rule)
            .with_hint("give a shorter interval, or samples = 2 for start and end"));
    }
    times::every(every, duration).ok_or_else(|| too_many(value))
}

fn too_many(value: &Value<'_>) -> FormatError {
    let rule = format!("such that there are at most {} samples", times::MOST);
    value.invalid(rule).with_hint("all samples are held in memory: use a longer interval, or divide the run")
}

/// Reads the method and its own keys. A method with fixed steps has no tolerance, and only it has
/// an order.
fn method(table: &Table<'_>) -> Result<Method, FormatError> {
    let named =
        table.get("method").map(|value| value.choice(&["auto", "exact", "taylor", "dop853", "splitting"]));
    let name = named.transpose()?.unwrap_or("auto");
    if name == "splitting" {
        if let Some(value) = table.get("tolerance") {
            let hint = match table.get("step") {
                Some(_) => "the step determines the accuracy: leave out tolerance",
                None => "splitting uses a fixed step: write step = \"10 ms\" in place of tolerance",
            };
            return Err(value.invalid("left out of a run by splitting").with_hint(hint));
        }
        let order = table.get("order").map_or(Ok(SplittingOrder::default()), |value| order(&value))?;
        let step = table.require("step", "step = \"10 ms\"")?.positive(Dimension::TIME)?;
        return Ok(Method::Splitting { order, step });
    }
    if let Some(value) = table.get("order").or_else(|| table.get("step")) {
        let hint = match (table.get("method"), value.key()) {
            (None, _) => "other methods choose their steps from the tolerance: add method = \"splitting\"",
            (Some(_), "step") => "this method chooses its steps from the tolerance: leave out step",
            (Some(_), _) => "this method has its own order: leave out order",
        };
        return Err(value.invalid("left out without method = \"splitting\"").with_hint(hint));
    }
    Ok(match name {
        "exact" => Method::Exact,
        "taylor" => Method::Taylor,
        "dop853" => Method::Dop853,
        _ => Method::Auto,
    })
}

fn order(value: &Value<'_>) -> Result<SplittingOrder, FormatError> {
    let number = value.count()?;
    let order = SplittingOrder::ALL.into_iter().find(|order| u64::from(order.number()) == number);
    order.ok_or_else(|| {
        value
            .invalid("2, 4 or 6")
            .with_hint("halving the step divides the error by 2 to this power; 4 is the default")
    })
}

fn tolerance(value: &Value<'_>) -> Result<f64, FormatError> {
    let tolerance = value.number()?;
    if (TIGHTEST_TOLERANCE..=LOOSEST_TOLERANCE).contains(&tolerance) {
        return Ok(tolerance);
    }
    let rule = format!("from {TIGHTEST_TOLERANCE:e} to {LOOSEST_TOLERANCE:e}");
    Err(value
        .invalid(rule)
        .with_hint(format!("it bounds the error of a step, in rad; {TOLERANCE:e} is the default")))
}
