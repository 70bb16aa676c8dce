//! Head of a log, with the keys `scenario`, `step`, `engine`, `units`, `columns`.

use std::collections::BTreeSet;
use std::path::PathBuf;

use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::columns::{Columns, Key, unquoted};
use super::name::spelt_unit;

/// Contents of the head of a log.
#[derive(Clone, Debug, Default)]
pub(crate) struct Head {
    pub scenario: Option<PathBuf>,
    pub step: Option<f64>,
    pub engine: Option<String>,
    pub units: Units,
    pub columns: Option<Columns>,
    /// Known keys that were given, without their prefix.
    given: BTreeSet<String>,
    /// Keys that are not known here.
    pub ignored: Vec<String>,
}

/// Units of columns that have none in their names.
#[derive(Clone, Debug, Default)]
pub(crate) struct Units {
    time: Option<String>,
    angle: Option<String>,
    rate: Option<String>,
}

impl Units {
    /// Returns the unit of columns with this meaning.
    pub(crate) fn of(&self, key: Key) -> Option<String> {
        match key {
            Key::Time => self.time.clone(),
            Key::Euler => self.angle.clone(),
            Key::Omega => self.rate.clone(),
            Key::Quaternion | Key::Matrix => None,
        }
    }

    /// Parses `SI`, or units separated by commas: `ms, deg, deg/s`.
    fn parse(text: &str) -> Result<Self, String> {
        let mut units = Self::default();
        let put = |slot: &mut Option<String>, unit: String| match slot.replace(unit) {
            None => Ok(()),
            Some(other) => {
                Err(format!("units of a motion, one of each kind, and {other:?} is given besides"))
            }
        };
        for written in text.split([',', ';']).map(str::trim).filter(|unit| !unit.is_empty()) {
            let unit = spelt_unit(written);
            let is = |dimension| unit::factor(&unit, dimension).is_ok();
            if written == "SI" {
                put(&mut units.time, "s".to_owned())?;
                put(&mut units.angle, "rad".to_owned())?;
                put(&mut units.rate, "rad/s".to_owned())?;
            } else if is(Dimension::TIME) {
                put(&mut units.time, unit)?;
            } else if is(Dimension::ANGULAR_VELOCITY) {
                put(&mut units.rate, unit)?;
            } else if is(Dimension::ANGLE) {
                put(&mut units.angle, unit)?;
            } else {
                return Err(format!("units of a motion, and {written:?} is none"));
            }
        }
        Ok(units)
    }
}

impl Head {
    /// Adds the contents of `key = value` at a place.
    pub(crate) fn add(&mut self, key: &str, value: &str, place: &ContentPlace) -> Result<(), ContentError> {
        let value = unquoted(value.trim());
        let refused = |rule: String| {
            let kind = ContentErrorKind::Value { what: key.to_owned(), value: value.to_owned(), rule };
            Err(ContentError::new(kind, place.clone()))
        };
        let plain = key.strip_prefix("polhode.").unwrap_or(key);
        let is_known = ["scenario", "engine", "step", "units", "columns"].contains(&plain);
        if is_known && !self.given.insert(plain.to_owned()) {
            let error = refused("given once".to_owned());
            return error.map_err(|error| error.hint("remove one of the two lines"));
        }
        match plain {
            "scenario" if value.is_empty() => refused("the path of a scenario".to_owned())?,
            "scenario" => self.scenario = Some(PathBuf::from(value)),
            "engine" => self.engine = Some(value.to_owned()).filter(|engine| !engine.is_empty()),
            "step" => match unit::parse(value, Dimension::TIME) {
                Ok(step) if step > 0.0 => self.step = Some(step),
                Ok(_) => refused("positive: it is the engine's time step, in s".to_owned())?,
                Err(error) => refused(format!("the engine's time step, in s: {error}"))?,
            },
            // Tables of polhode have a JSON object here, and a unit in each name.
            "units" if key != plain && value.starts_with('{') => {}
            "units" => match Units::parse(value) {
                Ok(units) => self.units = units,
                Err(rule) => {
                    let hint = "units = SI, or units of time, angles and angular velocities: ms, deg, deg/s";
                    refused(rule).map_err(|error| error.hint(hint))?;
                }
            },
            "columns" => match Columns::parse(value) {
                Ok(columns) => self.columns = Some(columns),
                Err(error) => {
                    let refused = refused(format!("what columns are: {error}"));
                    refused.map_err(|refused| refused.hint(error.hint()))?;
                }
            },
            _ => self.ignored.push(key.to_owned()),
        }
        Ok(())
    }

    /// Returns the key and the value of a comment `key = value` whose key is one word.
    pub(crate) fn pair(comment: &str) -> Option<(&str, &str)> {
        let (key, value) = comment.trim_start_matches('#').split_once('=')?;
        let key = key.trim();
        let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '-');
        (!key.is_empty() && key.chars().all(is_word)).then_some((key, value))
    }
}
