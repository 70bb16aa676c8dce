//! Checks that every entry of a plan has an effect; an entry without effect is probably a mistake.

use polhode_source::FormatError;
use polhode_source::toml::reader::Table;

use crate::tumble::Flight;

/// Checks that `[tumble]` has no options for readings that no flight has.
pub(crate) fn require(tumble: &Table<'_>, flights: &[Flight]) -> Result<(), FormatError> {
    let has_gyro = flights.iter().any(|flight| !flight.gyro().is_empty());
    let has_attitudes = flights.iter().any(|flight| !flight.attitudes().is_empty());
    if let Some(gyro) = tumble.get("gyro") {
        if !has_gyro {
            return Err(gyro.invalid("omitted: the logs have no rates of a gyro, only attitudes"));
        }
        let has_both = flights.iter().any(|f| !f.gyro().is_empty() && !f.attitudes().is_empty());
        if let Some(clock) = gyro.table()?.get("clock").filter(|_| !has_both)
            && clock.boolean()?
        {
            let rule = "omitted: the clock offset is between gyro and attitudes, and no flight has both";
            return Err(clock.invalid(rule));
        }
    }
    match tumble.get("attitude").filter(|_| !has_attitudes) {
        Some(attitude) => Err(attitude.invalid("omitted: the logs have no attitudes, only rates of a gyro")),
        None => Ok(()),
    }
}
