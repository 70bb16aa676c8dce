//! `[[torque]]` of model `gravity`, for a body with a pivot.

use polhode::math::Acceleration;
use polhode::motion::torque::{TorqueModel, UniformGravity};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::allow;
use crate::read::body::Pivot;

/// Reads `pivot = [3]`, body axes, and `acceleration = [3]`, space axes; the default is standard
/// gravity along −z.
pub(crate) fn gravity<'a>(
    table: &Table<'a>,
    pivot: &mut Option<Pivot<'a>>,
) -> Result<TorqueModel, FormatError> {
    allow(table, &["pivot", "acceleration"])?;
    match (table.get("pivot"), pivot.as_ref()) {
        (None, Some(_)) => {}
        (None, None) => return Err(no_pivot(table)),
        (Some(value), None) => *pivot = Some(Pivot::read(value)?),
        (Some(value), Some(held)) => agree(&value, held)?,
    }
    let gravity = match table.get("acceleration") {
        None => UniformGravity::STANDARD,
        Some(g) => {
            UniformGravity { acceleration: Acceleration::from_array(g.quantities(Dimension::ACCELERATION)?) }
        }
    };
    Ok(TorqueModel::Gravity(gravity))
}

fn no_pivot(table: &Table<'_>) -> FormatError {
    let hint = "write pivot = [\"0 mm\", \"0 mm\", \"0 mm\"]: uniform gravity has no torque on a free body, so the body needs a pivot";
    table.missing("pivot", "").with_hint(hint)
}

fn agree(value: &Value<'_>, held: &Pivot<'_>) -> Result<(), FormatError> {
    if Pivot::read(*value)?.point == held.point {
        return Ok(());
    }
    let place = held.value.place();
    let rule = format!("the pivot of line {}: a body is held at one point", place.line);
    Err(value.invalid(rule).with_hint("leave one of them out"))
}
