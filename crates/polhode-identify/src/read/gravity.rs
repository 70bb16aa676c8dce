//! Gravity in the sensor's axes.

use polhode::infer::judge::AttitudeSense;
use polhode::math::{Acceleration, Space};
use polhode_source::toml::reader::Value;

/// Where gravity comes from.
pub(crate) enum Gravity<'a> {
    /// Columns, along the sensor's axes.
    Logged,
    /// There is none.
    None,
    /// Told along axes of space, and turned to the sensor's by logged attitudes.
    Turned { value: Box<Value<'a>>, told: Acceleration<Space>, sense: AttitudeSense },
}
