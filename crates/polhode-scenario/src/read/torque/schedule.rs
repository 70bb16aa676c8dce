//! Schedule of a `[[torque]]`: keys common to all models.

use polhode::motion::torque::{Schedule, Scheduled, TorqueModel};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

/// Keys of the schedule, allowed for every torque.
pub(crate) const KEYS: [&str; 3] = ["from", "until", "pulses"];

/// Returns the torque with its schedule; without `from`, `until` and `pulses` it always acts.
pub(crate) fn scheduled(table: &Table<'_>, torque: TorqueModel) -> Result<TorqueModel, FormatError> {
    Ok(match schedule(table)? {
        None => torque,
        Some(schedule) => TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule })),
    })
}

/// Reads `from` and `until`, or `pulses = { first, width, period, count }`.
pub(crate) fn schedule(table: &Table<'_>) -> Result<Option<Schedule>, FormatError> {
    const TWICE: &str = "pulses alone define when the torque acts";
    let (from, until) = (table.get("from"), table.get("until"));
    for key in ["from", "until"] {
        table.at_most_one(&[key, "pulses"], TWICE)?;
    }
    if let Some(value) = table.get("pulses") {
        return pulses(&value).map(Some);
    }
    // An error refers to the end of the window, or to its start if it has none.
    let Some(value) = until.or(from) else { return Ok(None) };
    let time = |value: Option<Value<'_>>, or: f64| value.map_or(Ok(or), |v| v.quantity(Dimension::TIME));
    let (from, until) = (time(from, f64::NEG_INFINITY)?, time(until, f64::INFINITY)?);
    Schedule::window(from, until).map(Some).map_err(|error| value.motion(error))
}

fn pulses(value: &Value<'_>) -> Result<Schedule, FormatError> {
    let table = value.table()?;
    table.allow(&["first", "width", "period", "count"])?;
    let first = table.get("first").map_or(Ok(0.0), |first| first.quantity(Dimension::TIME))?;
    let width = table.require("width", "width = \"0.2 s\"")?.positive(Dimension::TIME)?;
    let count = table.get("count").map(|count| count.count()).transpose()?;
    let period = table.require("period", "period = \"5 s\"")?.positive(Dimension::TIME)?;
    Schedule::pulses(first, width, period, count).map_err(|error| value.motion(error))
}
