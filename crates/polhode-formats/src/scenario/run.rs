//! The `[run]`: for how long, at which times, and how.

use polhode::{LOOSEST_TOLERANCE, Method, Run, TIGHTEST_TOLERANCE};

use super::reader::{Table, Value};
use crate::error::FormatError;
use crate::times;
use crate::unit::Dimension;

/// Samples of a run that says neither `samples` nor `every`.
const SAMPLES: usize = 1001;

/// Tolerance of a run that says none.
const TOLERANCE: f64 = 1e-13;

/// Reads `[run]`; `None` without one.
pub(crate) fn run(root: &Table<'_>) -> Result<Option<Run>, FormatError> {
    let Some(value) = root.get("run") else { return Ok(None) };
    let table = value.table()?;
    table.allow(&["duration", "samples", "every", "method", "tolerance"])?;
    if (root.get("prescribed").is_some() || root.get("shaft").is_some())
        && let Some(value) = table.get("method").or_else(|| table.get("tolerance"))
    {
        let hint = "a prescribed motion is given, not computed: nothing depends on it";
        return Err(value.invalid("left out").with_hint(hint));
    }
    let duration = table.require("duration", "duration = \"20 s\"")?.positive(Dimension::TIME)?;
    let given = table.at_most_one(&["samples", "every"], "each of them alone says when to sample")?;
    let method = table.get("method").map_or(Ok(Method::Auto), |value| method(&value))?;
    let tolerance = table.get("tolerance").map_or(Ok(TOLERANCE), |value| tolerance(&value))?;
    Ok(Some(match given {
        None => Run::evenly(duration, SAMPLES, method, tolerance),
        Some(value) if value.key() == "samples" => Run::evenly(duration, samples(&value)?, method, tolerance),
        Some(value) => Run { times: sampled_every(duration, &value)?, method, tolerance },
    }))
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

/// 0, every, 2 every, … and the end.
fn sampled_every(duration: f64, value: &Value<'_>) -> Result<Vec<f64>, FormatError> {
    let every = value.positive(Dimension::TIME)?;
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
    value.invalid(rule).with_hint("all samples are held in memory: sample less often, or run in pieces")
}

fn method(value: &Value<'_>) -> Result<Method, FormatError> {
    if let name @ ("taylor" | "splitting") = value.string()? {
        let hint = "write method = \"auto\" or \"dop853\"";
        return Err(value.invalid(format!("another method: {name} is not available yet")).with_hint(hint));
    }
    Ok(match value.choice(&["auto", "exact", "taylor", "dop853"])? {
        "exact" => Method::Exact,
        "taylor" => Method::Taylor,
        "dop853" => Method::Dop853,
        _ => Method::Auto,
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
