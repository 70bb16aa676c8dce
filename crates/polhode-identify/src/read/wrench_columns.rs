//! Columns of a log of wrenches, and their units: identified by name, or specified in the plan.

use std::ops::Range;

use polhode_source::FormatError;
use polhode_source::csv::missing;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit;
use polhode_source::unit::{Dimension, UnitError};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::gravity::Gravity;
use super::wrench_quantity::{
    ATTITUDE, GRAVITY, MEASURED, Quantity, TIME, rest, trailing_unit, written_unit,
};

const COLUMN_KEYS: [&str; 8] =
    ["time", "omega", "alpha", "acceleration", "gravity", "force", "torque", "attitude"];
const UNIT_KEYS: [&str; 7] = ["time", "omega", "alpha", "acceleration", "gravity", "force", "torque"];

/// Columns and units specified in the plan.
pub(crate) struct Told<'a> {
    pub columns: Option<Table<'a>>,
    pub units: Option<Table<'a>>,
}

/// Error in the plan or in the log.
pub(crate) enum Wrong {
    Plan(FormatError),
    Log(ContentError),
}

impl Wrong {
    pub(crate) fn into_error(self, of_log: impl Fn(ContentError) -> FormatError) -> FormatError {
        match self {
            Self::Plan(error) => error,
            Self::Log(error) => of_log(error),
        }
    }
}

impl From<FormatError> for Wrong {
    fn from(error: FormatError) -> Self {
        Self::Plan(error)
    }
}

impl From<ContentError> for Wrong {
    fn from(error: ContentError) -> Self {
        Self::Log(error)
    }
}

/// Identified columns with their factors to SI units. Order: time, ω, α, a, f, τ, then gravity or
/// the quaternion.
#[derive(Default)]
pub(crate) struct Columns {
    pub places: Vec<usize>,
    pub units: Vec<f64>,
    pub read: Vec<String>,
    pub ignored: Vec<String>,
}

impl Columns {
    /// Identifies the columns of a header.
    pub(crate) fn find(header: &Header<'_>, told: &Told<'_>, gravity: &Gravity<'_>) -> Result<Self, Wrong> {
        if let Some(columns) = &told.columns {
            columns.allow(&COLUMN_KEYS)?;
        }
        if let Some(units) = &told.units {
            units.allow(&UNIT_KEYS)?;
        }
        let mut found = Self::default();
        found.add(&TIME, header, told)?;
        for quantity in &MEASURED {
            found.add(quantity, header, told)?;
        }
        let unused = |quantity: &Quantity, rule: &str| {
            let told = [&told.columns, &told.units].into_iter().flatten();
            match told.filter_map(|table| table.get(quantity.key)).next() {
                Some(value) => Err(Wrong::Plan(value.invalid(rule))),
                None => Ok(()),
            }
        };
        match gravity {
            Gravity::Logged => {
                unused(
                    &ATTITUDE,
                    "omitted if gravity is logged: it transforms gravity = [...] to the sensor's axes",
                )?;
                found.add(&GRAVITY, header, told).map_err(|wrong| match wrong {
                    Wrong::Log(error) if matches!(error.kind, ContentErrorKind::Missing { .. }) => Wrong::Log(
                        error.hint(
                            "log it along the sensor's axes, gx_m_s2 …, or log quaternions and write gravity = \
                             [0, 0, \"-9.80665 m/s^2\"] along axes of space",
                        ),
                    ),
                    wrong => wrong,
                })?;
            }
            Gravity::None => unused(&GRAVITY, "omitted if the plan states gravity")?,
            Gravity::Turned { value, .. } => {
                unused(&GRAVITY, "omitted if the plan states gravity")?;
                found.add(&ATTITUDE, header, told).map_err(|wrong| match wrong {
                    Wrong::Log(error) if matches!(error.kind, ContentErrorKind::Missing { .. }) => {
                        Wrong::Plan(
                            value
                                .invalid("transformed to the sensor's axes by attitudes, but the log has none")
                                .with_hint("log quaternions, qw, qx, qy, qz, or name their columns: columns = { attitude = [...] }"),
                        )
                    }
                    wrong => wrong,
                })?;
            }
        }
        found.ignore_others(header);
        Ok(found)
    }

    /// Records all other columns as ignored.
    pub(crate) fn ignore_others(&mut self, header: &Header<'_>) {
        let others = header.names.iter().enumerate().filter(|(k, _)| !self.places.contains(k));
        self.ignored = others.map(|(_, name)| (*name).to_owned()).collect();
    }

    /// Adds the columns of a quantity.
    pub(crate) fn add(
        &mut self,
        quantity: &Quantity,
        header: &Header<'_>,
        told: &Told<'_>,
    ) -> Result<(), Wrong> {
        let places = match told.columns.as_ref().and_then(|columns| columns.get(quantity.key)) {
            Some(value) => header.told(quantity, &value)?,
            None => header.named(quantity)?,
        };
        let told_unit = told.units.as_ref().and_then(|units| units.get(quantity.key));
        for place in &places {
            if let Some(twice) = self.places.iter().find(|known| *known == place) {
                let name = header.names.get(*twice).copied().unwrap_or_default();
                let rule = "used for one quantity only: state which in columns = { … }";
                return Err(header.refused(*place, "the column", name, rule).into());
            }
            self.units.push(header.unit(*place, quantity, told_unit.as_ref())?);
            self.places.push(*place);
        }
        let names: Vec<&str> = places.iter().filter_map(|place| header.names.get(*place).copied()).collect();
        self.read.push(format!("{}: {}", quantity.what, names.join(", ")));
        Ok(())
    }
}

/// Names of columns, and their places in a text.
pub(crate) struct Header<'a> {
    pub names: Vec<&'a str>,
    pub places: &'a [Range<usize>],
}

impl Header<'_> {
    fn place(&self, column: usize) -> ContentPlace {
        self.places.get(column).map_or(ContentPlace::Whole, |place| ContentPlace::Text(place.clone()))
    }

    fn refused(&self, column: usize, what: &str, value: &str, rule: &str) -> ContentError {
        let (what, value, rule) = (what.to_owned(), value.to_owned(), rule.to_owned());
        ContentError::new(ContentErrorKind::Value { what, value, rule }, self.place(column))
    }

    /// Returns the columns that the plan names.
    fn told(&self, quantity: &Quantity, value: &Value<'_>) -> Result<Vec<usize>, Wrong> {
        let names = match (quantity.axes.len(), value.is_array()) {
            (1, false) => vec![*value],
            (3, _) => value.fixed::<3>("names of columns")?.to_vec(),
            (4, _) => value.fixed::<4>("names of columns, the scalar first")?.to_vec(),
            _ => value.fixed::<1>("name of a column")?.to_vec(),
        };
        let mut places = Vec::new();
        for name in names {
            let wanted = name.string()?;
            let mut found = (0..self.names.len()).filter(|&k| self.names[k] == wanted);
            let Some(place) = found.next() else {
                let hint = format!("the columns are {}", self.names.join(", "));
                return Err(name.invalid("a column of the log").with_hint(hint).into());
            };
            if let Some(second) = found.next() {
                return Err(self.refused(second, "the column", wanted, "named once").into());
            }
            if places.contains(&place) {
                return Err(name.invalid("a different column for each axis").into());
            }
            places.push(place);
        }
        Ok(places)
    }

    /// Returns the columns whose names identify the quantity.
    fn named(&self, quantity: &Quantity) -> Result<Vec<usize>, ContentError> {
        let mut places = Vec::new();
        for axis in quantity.axes {
            let mut found = None;
            let mut nearly = None;
            for (k, name) in self.names.iter().enumerate() {
                match rest(name, quantity, axis).map(|rest| written_unit(rest, quantity.dimension)) {
                    None => {}
                    // After an underscore the text need not be a unit.
                    Some(Err((unit, error))) if !name.ends_with([']', ')']) => {
                        nearly = Some((k, unit, error));
                    }
                    Some(_) if found.is_some() => {
                        let rule = format!(
                            "the only column of {}: choose one by columns = {{ {} = … }}",
                            quantity.what, quantity.key
                        );
                        return Err(self.refused(k, "the column", name, &rule));
                    }
                    Some(_) => found = Some(k),
                }
            }
            match (found, nearly) {
                (Some(k), _) => places.push(k),
                (None, Some((k, unit, error))) => return Err(self.bad_unit(k, quantity, &unit, &error)),
                (None, None) => {
                    let what = match axis.is_empty() {
                        true => format!("column of {}", quantity.what),
                        false => format!("column of {} along {axis}", quantity.what),
                    };
                    return Err(missing(&what).hint(format!(
                        "name it in the header, for example {}, or state it in the plan: columns = {{ {} = … }}",
                        quantity.example, quantity.key
                    )));
                }
            }
        }
        Ok(places)
    }

    fn bad_unit(&self, column: usize, quantity: &Quantity, unit: &str, error: &UnitError) -> ContentError {
        let refused = self.refused(
            column,
            &format!("the unit of {}", quantity.what),
            unit,
            &format!("another: {error}"),
        );
        match error.hint_for_name() {
            Some(hint) => refused.hint(hint),
            None => refused,
        }
    }

    /// Returns the factor from a column's unit to SI.
    fn unit(&self, column: usize, quantity: &Quantity, told: Option<&Value<'_>>) -> Result<f64, Wrong> {
        if quantity.dimension == Dimension::NONE {
            return Ok(1.0);
        }
        let name = self.names.get(column).copied().unwrap_or_default();
        let own = match quantity.axes.iter().find_map(|axis| rest(name, quantity, axis)) {
            Some(rest) => written_unit(rest, quantity.dimension),
            None => trailing_unit(name, quantity.dimension),
        }
        .map_err(|(unit, error)| self.bad_unit(column, quantity, &unit, &error))?;
        let told = match told {
            None => None,
            Some(value) => {
                let unit = unit::factor(value.string()?, quantity.dimension).map_err(|error| {
                    let hint = error.hint_for_name();
                    let refused = value.invalid(format!("a unit: {error}"));
                    hint.map_or(refused.clone(), |hint| refused.with_hint(hint))
                })?;
                Some((unit, value))
            }
        };
        match (own, told) {
            (Some(own), Some((told, value))) if own != told => {
                Err(value.invalid(format!("the unit in the name of the column {name}")).into())
            }
            (Some(unit), _) | (None, Some((unit, _))) => Ok(unit),
            (None, None) => {
                let kind = ContentErrorKind::Unclear {
                    question: format!("in which unit is {name}?"),
                    found: String::new(),
                };
                let hint = format!(
                    "state it in the header, for example {}, or in the plan: units = {{ {} = \"…\" }}",
                    quantity.example, quantity.key
                );
                Err(ContentError::new(kind, self.place(column)).hint(hint).into())
            }
        }
    }
}
