//! Which columns of a log of wrenches are what, and in which units.
//!
//! A name is a quantity, an axis and a unit: `fx_n`, `force_x_n`, `Fx [N]`. Whatever has no unit in its name has it in `units`.

use std::ops::Range;

use super::wrench_log::Gravity;
use crate::content::{ContentError, ContentErrorKind, ContentPlace};
use crate::error::FormatError;
use crate::scenario::csv::missing;
use crate::scenario::reader::{Table, Value};
use crate::unit::{self, Dimension, UnitError};

/// What is logged.
struct Quantity {
    /// Its key in `columns` and `units`.
    key: &'static str,
    what: &'static str,
    dimension: Dimension,
    axes: &'static [&'static str],
    /// Names that it has before the axis.
    names: &'static [&'static str],
    /// Names of a header that would do.
    example: &'static str,
}

const XYZ: &[&str] = &["x", "y", "z"];

const TIME: Quantity = Quantity {
    key: "time",
    what: "the time",
    dimension: Dimension::TIME,
    axes: &[""],
    names: &["time", "t"],
    example: "time_s",
};
const MEASURED: [Quantity; 5] = [
    Quantity {
        key: "omega",
        what: "the angular velocity",
        dimension: Dimension::ANGULAR_VELOCITY,
        axes: XYZ,
        names: &["w", "omega", "omega_body", "gyro", "angular_velocity"],
        example: "wx_rad_s,wy_rad_s,wz_rad_s",
    },
    Quantity {
        key: "alpha",
        what: "the angular acceleration",
        dimension: Dimension::ANGULAR_ACCELERATION,
        axes: XYZ,
        names: &["alpha", "alpha_body", "angular_acceleration"],
        example: "alphax_rad_s2,alphay_rad_s2,alphaz_rad_s2",
    },
    Quantity {
        key: "acceleration",
        what: "the acceleration",
        dimension: Dimension::ACCELERATION,
        axes: XYZ,
        names: &["a", "acc", "acceleration"],
        example: "ax_m_s2,ay_m_s2,az_m_s2",
    },
    Quantity {
        key: "force",
        what: "the force",
        dimension: Dimension::FORCE,
        axes: XYZ,
        names: &["f", "force"],
        example: "fx_n,fy_n,fz_n",
    },
    Quantity {
        key: "torque",
        what: "the torque",
        dimension: Dimension::TORQUE,
        axes: XYZ,
        names: &["t", "tau", "torque"],
        example: "tx_n_m,ty_n_m,tz_n_m",
    },
];
const GRAVITY: Quantity = Quantity {
    key: "gravity",
    what: "gravity",
    dimension: Dimension::ACCELERATION,
    axes: XYZ,
    names: &["g", "gravity"],
    example: "gx_m_s2,gy_m_s2,gz_m_s2",
};
const ATTITUDE: Quantity = Quantity {
    key: "attitude",
    what: "the attitude",
    dimension: Dimension::NONE,
    axes: &["w", "x", "y", "z"],
    names: &["q", "quaternion", "attitude"],
    example: "qw,qx,qy,qz",
};

const COLUMN_KEYS: [&str; 8] =
    ["time", "omega", "alpha", "acceleration", "gravity", "force", "torque", "attitude"];
const UNIT_KEYS: [&str; 7] = ["time", "omega", "alpha", "acceleration", "gravity", "force", "torque"];

/// Units as names of columns have them.
const SUFFIXES: [(&str, &str); 7] = [
    ("rad_s", "rad/s"),
    ("deg_s", "deg/s"),
    ("rad_s2", "rad/s^2"),
    ("deg_s2", "deg/s^2"),
    ("m_s2", "m/s^2"),
    ("n", "N"),
    ("n_m", "N m"),
];

/// What the plan says of columns.
pub(super) struct Told<'a> {
    pub(super) columns: Option<Table<'a>>,
    pub(super) units: Option<Table<'a>>,
}

/// An error in the plan, or in the log.
pub(super) enum Wrong {
    Plan(FormatError),
    Log(ContentError),
}

impl Wrong {
    pub(super) fn into_error(self, of_log: impl Fn(ContentError) -> FormatError) -> FormatError {
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

/// Where numbers stand, and what one of each unit is in SI: the time, ω, α, a, f, τ, then gravity or the quaternion.
#[derive(Default)]
pub(super) struct Columns {
    pub(super) places: Vec<usize>,
    pub(super) units: Vec<f64>,
    pub(super) read: Vec<String>,
    pub(super) ignored: Vec<String>,
}

impl Columns {
    /// In a header.
    pub(super) fn find(
        text: &str,
        header: &[Range<usize>],
        told: &Told<'_>,
        gravity: &Gravity<'_>,
    ) -> Result<Self, Wrong> {
        if let Some(columns) = &told.columns {
            columns.allow(&COLUMN_KEYS)?;
        }
        if let Some(units) = &told.units {
            units.allow(&UNIT_KEYS)?;
        }
        let names: Vec<&str> =
            header.iter().map(|field| text[field.clone()].trim_matches('"').trim()).collect();
        let header = Header { names, places: header };
        let mut found = Self::default();
        found.add(&TIME, &header, told)?;
        for quantity in &MEASURED {
            found.add(quantity, &header, told)?;
        }
        let unused =
            |quantity: &Quantity, rule: &str| match told.columns.as_ref().and_then(|t| t.get(quantity.key)) {
                Some(value) => Err(Wrong::Plan(value.invalid(rule))),
                None => Ok(()),
            };
        match gravity {
            Gravity::Logged => {
                unused(
                    &ATTITUDE,
                    "left out where gravity is logged: it turns gravity = [...] to the sensor",
                )?;
                found.add(&GRAVITY, &header, told).map_err(|wrong| match wrong {
                    Wrong::Log(error) if matches!(error.kind, ContentErrorKind::Missing { .. }) => Wrong::Log(
                        error.hint(
                            "log it along the sensor's axes, gx_m_s2 …, or log quaternions and write gravity = \
                             [0, 0, \"-9.80665 m/s^2\"] along axes of space",
                        ),
                    ),
                    wrong => wrong,
                })?;
            }
            Gravity::None => unused(&GRAVITY, "left out where gravity is told")?,
            Gravity::Turned { value, .. } => {
                unused(&GRAVITY, "left out where gravity is told")?;
                found.add(&ATTITUDE, &header, told).map_err(|wrong| match wrong {
                    Wrong::Log(error) if matches!(error.kind, ContentErrorKind::Missing { .. }) => {
                        Wrong::Plan(
                            value
                                .invalid("turned to the sensor's axes by attitudes, and the log has none")
                                .with_hint("log quaternions, qw, qx, qy, qz, or say which columns they are"),
                        )
                    }
                    wrong => wrong,
                })?;
            }
        }
        let others = header.names.iter().enumerate().filter(|(k, _)| !found.places.contains(k));
        found.ignored = others.map(|(_, name)| (*name).to_owned()).collect();
        Ok(found)
    }

    /// The columns of a quantity.
    fn add(&mut self, quantity: &Quantity, header: &Header<'_>, told: &Told<'_>) -> Result<(), Wrong> {
        let places = match told.columns.as_ref().and_then(|columns| columns.get(quantity.key)) {
            Some(value) => header.told(quantity, &value)?,
            None => header.named(quantity)?,
        };
        let told_unit = match told.units.as_ref().filter(|_| UNIT_KEYS.contains(&quantity.key)) {
            Some(units) => units.get(quantity.key),
            None => None,
        };
        for place in &places {
            if let Some(twice) = self.places.iter().find(|known| *known == place) {
                let name = header.names.get(*twice).copied().unwrap_or_default();
                let rule = "of one quantity: say by columns = { … } which it is";
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

/// Names of columns, and where they stand.
struct Header<'a> {
    names: Vec<&'a str>,
    places: &'a [Range<usize>],
}

impl Header<'_> {
    fn place(&self, column: usize) -> ContentPlace {
        ContentPlace::Text(self.places.get(column).cloned().unwrap_or_default())
    }

    fn refused(&self, column: usize, what: &str, value: &str, rule: &str) -> ContentError {
        let (what, value, rule) = (what.to_owned(), value.to_owned(), rule.to_owned());
        ContentError::new(ContentErrorKind::Value { what, value, rule }, self.place(column))
    }

    /// Columns that the plan names.
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
                return Err(name.invalid("another column for each axis").into());
            }
            places.push(place);
        }
        Ok(places)
    }

    /// Columns whose names say what they are.
    fn named(&self, quantity: &Quantity) -> Result<Vec<usize>, ContentError> {
        let mut places = Vec::new();
        for axis in quantity.axes {
            let mut found = None;
            let mut nearly = None;
            for (k, name) in self.names.iter().enumerate() {
                match rest(name, quantity, axis).map(|rest| written_unit(rest, quantity.dimension)) {
                    None => {}
                    // with an underscore it may be anything
                    Some(Err((unit, error))) if !name.ends_with([']', ')']) => {
                        nearly = Some((k, unit, error))
                    }
                    Some(_) if found.is_some() => {
                        let rule = format!(
                            "the only one of {}: say which by columns = {{ {} = … }}",
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
                        "name it in the header as in {}, or say which it is by columns = {{ {} = … }}",
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

    /// What one of a column's unit is in SI.
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
                Err(value.invalid(format!("the unit that the column {name} has in its name")).into())
            }
            (Some(unit), _) | (None, Some((unit, _))) => Ok(unit),
            (None, None) => {
                let kind = ContentErrorKind::Unclear {
                    question: format!("in which unit is {name}?"),
                    found: String::new(),
                };
                let hint = format!(
                    "name it in the header, as in {}, or in the plan: units = {{ {} = \"…\" }}",
                    quantity.example, quantity.key
                );
                Err(ContentError::new(kind, self.place(column)).hint(hint).into())
            }
        }
    }
}

/// What stands behind the quantity and the axis in a name, if it begins with them.
fn rest<'a>(name: &'a str, quantity: &Quantity, axis: &str) -> Option<&'a str> {
    quantity.names.iter().find_map(|own| {
        let (head, rest) = (name.get(..own.len())?, name.get(own.len()..)?);
        // t is a time, and T a temperature
        let is_own =
            if *own == "t" && axis.is_empty() { head == *own } else { head.eq_ignore_ascii_case(own) };
        let rest = if axis.is_empty() { rest } else { rest.strip_prefix('_').unwrap_or(rest) };
        let (letter, rest) = (rest.get(..axis.len())?, rest.get(axis.len()..)?);
        let ends = rest.is_empty() || rest.starts_with(['_', ' ', '[', '(']);
        (is_own && letter.eq_ignore_ascii_case(axis) && ends).then_some(rest)
    })
}

type Written = Result<Option<f64>, (String, UnitError)>;

/// The unit at the end of a name: `_rad_s`, ` [rad/s]`; none if there is nothing.
fn written_unit(rest: &str, dimension: Dimension) -> Written {
    let rest = rest.trim();
    let unit = match (rest.strip_prefix(['[', '(']), rest.strip_prefix('_')) {
        (Some(inner), _) => inner.trim_end_matches([']', ')']).trim().to_owned(),
        (None, Some(suffix)) => {
            let known = SUFFIXES.iter().find(|(known, _)| *known == suffix);
            known.map_or_else(|| suffix.replace('_', " "), |(_, unit)| (*unit).to_owned())
        }
        (None, None) if rest.is_empty() => return Ok(None),
        (None, None) => rest.to_owned(),
    };
    if dimension == Dimension::NONE {
        return Ok(None);
    }
    unit::factor(&unit, dimension).map(Some).map_err(|error| (unit, error))
}

/// The same of a name that may begin with anything.
fn trailing_unit(name: &str, dimension: Dimension) -> Written {
    if let Some(open) = name.find(['[', '(']) {
        return written_unit(&name[open..], dimension);
    }
    let ends = name.match_indices('_').map(|(at, _)| &name[at..]);
    Ok(ends.filter_map(|end| written_unit(end, dimension).ok()).flatten().next())
}
