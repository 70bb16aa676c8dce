//! Source of gravity in the sensor's axes.

use polhode::infer::judge::AttitudeSense;
use polhode::math::{Acceleration, Space};
use polhode_source::toml::reader::Value;

/// Source of gravity.
pub(crate) enum Gravity<'a> {
    /// Columns along the sensor's axes.
    Logged,
    /// No gravity.
    None,
    /// Vector of the plan along axes of space, rotated to the sensor's axes by logged attitudes.
    Turned { value: Box<Value<'a>>, told: Acceleration<Space>, sense: AttitudeSense },
}
