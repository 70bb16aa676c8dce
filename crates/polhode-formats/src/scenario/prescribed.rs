//! A `[prescribed]` motion.

use polhode::{Direction, Prescribed};

use super::reader::Table;
use super::start::Start;
use crate::error::FormatError;
use crate::unit::Dimension;

/// Reads `[prescribed]`: `axis` with `rate` and `acceleration`, or `euler313` with `rates`.
pub(crate) fn prescribed(root: &Table<'_>, start: &Start<'_>) -> Result<Option<Prescribed>, FormatError> {
    let Some(value) = root.get("prescribed") else { return Ok(None) };
    let table = value.table()?;
    table.allow(&["axis", "rate", "acceleration", "euler313", "rates"])?;
    let Some(form) = table.at_most_one(&["axis", "euler313"], "the motion is given once")? else {
        return Err(table.missing("axis", "axis = [0, 0, 1] and rate = \"3 rad/s\""));
    };
    if let Some(spin) = &start.spin {
        return Err(spin
            .invalid("left out, since the prescribed motion has its own")
            .with_hint("leave out spin"));
    }
    if form.key() == "axis" {
        table.at_most_one(&["axis", "rates"], "rates are those of euler313")?;
        let rate = table.require("rate", "rate = \"3 rad/s\"")?.quantity(Dimension::ANGULAR_VELOCITY)?;
        let acceleration = table.get("acceleration");
        let acceleration = acceleration.map_or(Ok(0.0), |a| a.quantity(Dimension::ANGULAR_ACCELERATION))?;
        let axis = Direction::from_array(form.numbers()?);
        let motion = Prescribed::fixed_axis(start.state.attitude, axis, rate, acceleration);
        return motion
            .map(Some)
            .map_err(|e| form.motion(e).with_hint("the z axis is [0, 0, 1]; any length will do"));
    }
    for other in ["rate", "acceleration"] {
        table.at_most_one(&["euler313", other], "Euler angles change by their rates")?;
    }
    if let Some(attitude) = &start.attitude {
        let rule = "left out, since the Euler angles of the prescribed motion are the attitude";
        return Err(attitude.invalid(rule).with_hint("leave out attitude"));
    }
    let rates = table.require("rates", "rates = [\"2 rad/s\", 0, \"30 rad/s\"]")?;
    let rates = rates.quantities(Dimension::ANGULAR_VELOCITY)?;
    Prescribed::euler_rates(form.quantities(Dimension::ANGLE)?, rates).map(Some).map_err(|e| form.motion(e))
}
