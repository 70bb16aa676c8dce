//! Law of a `[[sweep.vary]]`: distribution of a number, direction, rotation, mass properties, or
//! numbers drawn together.

use polhode::infer::correlated::Correlated;
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::Sampling;
use super::correlated::Numbers;
use super::distribution::{Distribution, FORMS, distribution};
use crate::read::target::{Catalogue, Target};

/// Law of variation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Law {
    /// Distribution of a number.
    Number(Distribution),
    /// Distribution of a vector by direction and length.
    Vector {
        /// Spread of the direction.
        direction: Spread,
        /// Distribution of the length; `None` keeps the length as written.
        magnitude: Option<Distribution>,
    },
    /// Spread of a rotation.
    Rotation(Spread),
    /// Dispersion of mass properties.
    MassProperties(Dispersion),
    /// Joint normal distribution of several numbers, or of mass properties.
    Correlated(Correlated),
}

impl Law {
    /// Returns the number of listed values.
    pub const fn listed(&self) -> usize {
        match self {
            Self::Number(Distribution::List(list))
            | Self::Vector { magnitude: Some(Distribution::List(list)), .. } => list.len(),
            _ => 0,
        }
    }

    /// Returns the number of independent random numbers needed for `columns` values.
    pub const fn coordinates(&self, columns: usize) -> usize {
        match self {
            Self::Number(_) => 1,
            Self::Vector { magnitude: None, .. } => 2,
            Self::Vector { .. } | Self::Rotation(_) => 3,
            // A 3 × 3 matrix; a 4 × 4 matrix; mass, centre and 3 × 3 matrix.
            Self::MassProperties(Dispersion::Together(_)) if columns == 6 => 9,
            Self::MassProperties(Dispersion::Together(_)) => 16,
            Self::MassProperties(Dispersion::Apart { .. }) => 13,
            Self::Correlated(law) => law.variables(),
        }
    }
}

/// Spread of directions or rotations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spread {
    /// Uniform over all directions or rotations.
    Uniform,
    /// Directions only: uniform within this angle, rad, of the direction as written.
    Within(f64),
    /// Rotations only: the rotation as written, rotated by a random vector. Its components along
    /// the axes of the second frame are normal with this standard deviation, rad.
    Normal(f64),
}

/// Dispersion of mass properties.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dispersion {
    /// All second moments together, each with this relative standard deviation. For a tensor these
    /// are three; a body or part also has its mass and centre of mass.
    Together(f64),
    /// Mass, centre of mass and tensor independently; zero means no dispersion.
    Apart {
        /// Relative standard deviation of the mass.
        mass: f64,
        /// Standard deviation of each coordinate of the centre of mass, m.
        center_of_mass: f64,
        /// Relative standard deviation of the tensor's second moments.
        inertia: f64,
    },
}

/// Keys of laws for targets that are not single numbers.
const OTHERS: [&str; 4] = ["random", "direction", "dispersion", CORRELATED];

/// Key of a law for several keys, or for mass properties.
const CORRELATED: &str = "correlated";

/// Largest relative dispersion; beyond it the standard deviation is no longer accurate.
const MOST_DISPERSION: f64 = 0.5;

/// Reads the law of a table, and its target.
pub(crate) fn law(
    table: &Table<'_>,
    key: &Value<'_>,
    catalogue: &Catalogue<'_>,
    sampling: Sampling,
) -> Result<(Target, Law), FormatError> {
    let forms = [&FORMS[..], &OTHERS[..]].concat();
    table.allow(&[&["key", "magnitude"], &forms[..]].concat())?;
    let Some(form) = table.at_most_one(&forms, "give each number one distribution only")? else {
        return Err(
            table.missing("normal", "normal = { mean = 3, sd = 0.1 }, or uniform = { from = 0, to = 1 }")
        );
    };
    if form.key() != "direction" {
        table.at_most_one(&[form.key(), "magnitude"], "magnitude is used only with direction")?;
    }
    if sampling == Sampling::Grid && !["list", "grid"].contains(&form.key()) {
        let error = form.invalid("list or grid: a grid has no distributions");
        return Err(error.with_hint("write grid = { from = 0, to = 1, count = 11 }, or another sampling"));
    }
    let keys = keys(key)?;
    if form.key() == CORRELATED {
        let (target, numbers) = together(key, &keys, catalogue)?;
        let law = numbers.law(&form)?;
        return Ok((target, Law::Correlated(law)));
    }
    let [key, others @ ..] = keys.as_slice() else { return Err(key.invalid("the key of a number")) };
    if let Some(other) = others.first().filter(|_| OTHERS.contains(&form.key())) {
        let error = other.invalid(format!("one key: {} does not apply to numbers", form.key()));
        return Err(error.with_hint("give each [[sweep.vary]] its own key"));
    }
    Ok(match form.key() {
        "random" => (catalogue.rotation(key)?, Law::Rotation(rotation(&form)?)),
        "direction" => {
            let target = catalogue.vector(key)?;
            let direction = direction(&form)?;
            let magnitude = table.get("magnitude").map(|value| magnitude(&value, &target)).transpose()?;
            let is_zero = target.nominal().iter().all(|value| *value == 0.0);
            if is_zero && (magnitude.is_none() || direction != Spread::Uniform) {
                let error =
                    form.invalid("\"uniform\", with a magnitude, since the vector is written as zero");
                return Err(error.with_hint("magnitude = { uniform = { from = 0, to = 1 } }"));
            }
            (target, Law::Vector { direction, magnitude })
        }
        "dispersion" => {
            let target = catalogue.mass_properties(key)?;
            let dispersion = dispersion(&form, &target)?;
            (target, Law::MassProperties(dispersion))
        }
        _ => {
            let mut target = catalogue.number(key)?;
            for other in others {
                target = target.joined(catalogue.number(other)?, other)?;
            }
            let nominal = target.nominal().first().copied().unwrap_or_default();
            let law = distribution(&form, target.dimension(), nominal)?;
            (target, Law::Number(law))
        }
    })
}

/// Returns the target of numbers drawn together: mass properties by one key, or several numbers.
fn together(
    key: &Value<'_>,
    keys: &[Value<'_>],
    catalogue: &Catalogue<'_>,
) -> Result<(Target, Numbers), FormatError> {
    if let [only] = keys {
        let hint = "write key = \"body\" or \"body.inertia\", or an array of the keys of numbers";
        let is_number = || catalogue.number(only).is_ok();
        let target = catalogue
            .mass_properties(only)
            .map_err(|error| if is_number() { error.with_hint(hint) } else { error })?;
        let numbers = Numbers::of_body(&target);
        return Ok((target, numbers));
    }
    let targets = keys.iter().map(|key| Ok((catalogue.number(key)?, *key)));
    Numbers::of_keys(key, targets.collect::<Result<_, FormatError>>()?)
}

/// Reads one key, or the keys of several numbers that vary as one or are drawn together.
fn keys<'a>(key: &Value<'a>) -> Result<Vec<Value<'a>>, FormatError> {
    if !key.is_array() {
        return Ok(vec![*key]);
    }
    let keys = key.elements("a key, or an array of keys")?;
    if keys.len() < 2 {
        let error = key.invalid("one key, or an array of the keys of several numbers that vary as one");
        return Err(error.with_hint("write key = \"body.part[0].mass\""));
    }
    Ok(keys)
}

/// Reads `random = "uniform"`, or `{ sd = "2 deg" }`.
fn rotation(value: &Value<'_>) -> Result<Spread, FormatError> {
    if value.string().is_ok() {
        return value.choice(&["uniform"]).map(|_| Spread::Uniform);
    }
    let table = value.table()?;
    table.allow(&["sd"])?;
    let sd = table.require("sd", "sd = \"2 deg\"")?;
    sd.positive(Dimension::ANGLE).map(Spread::Normal)
}

/// Reads `direction = "uniform"`, or `{ within = "5 deg" }`.
fn direction(value: &Value<'_>) -> Result<Spread, FormatError> {
    if value.string().is_ok() {
        return value.choice(&["uniform"]).map(|_| Spread::Uniform);
    }
    let table = value.table()?;
    table.allow(&["within"])?;
    let within = table.require("within", "within = \"5 deg\"")?;
    let angle = within.positive(Dimension::ANGLE)?;
    if angle > std::f64::consts::PI {
        return Err(within.invalid("at most 180 deg").with_hint("which is direction = \"uniform\""));
    }
    Ok(Spread::Within(angle))
}

/// Reads `magnitude = { log_normal = { … } }`.
fn magnitude(value: &Value<'_>, target: &Target) -> Result<Distribution, FormatError> {
    let table = value.table()?;
    table.allow(&FORMS)?;
    let Some(form) = table.at_most_one(&FORMS, "give each number one distribution only")? else {
        return Err(table.missing("uniform", "magnitude = { uniform = { from = 0, to = 1 } }"));
    };
    // The nominal value is |v|.
    let norm = target.nominal().iter().fold(0.0, |norm: f64, c| norm.hypot(*c));
    let magnitude = distribution(&form, target.dimension(), norm)?;
    if magnitude.least() < 0.0 {
        return Err(form
            .invalid("nonnegative: a magnitude has no sign")
            .with_hint("add from = 0 to a normal distribution, or take a log_normal one"));
    }
    Ok(magnitude)
}

/// Reads `dispersion = "10 %"`, or `{ mass = "2 %", center_of_mass = "5 mm", inertia = "10 %" }`.
fn dispersion(value: &Value<'_>, target: &Target) -> Result<Dispersion, FormatError> {
    let Ok(table) = value.table() else {
        return share(value).map(Dispersion::Together);
    };
    table.allow(&["mass", "center_of_mass", "inertia"])?;
    if target.columns().len() == 6 {
        let error = value.invalid("one number, for a tensor");
        return Err(
            error.with_hint("write dispersion = \"10 %\", or the body's or the part's key without .inertia")
        );
    }
    let relative = |key| table.get(key).map_or(Ok(0.0), |value| share(&value));
    let center = table.get("center_of_mass");
    let dispersion = Dispersion::Apart {
        mass: relative("mass")?,
        center_of_mass: center.map_or(Ok(0.0), |value| value.positive(Dimension::LENGTH))?,
        inertia: relative("inertia")?,
    };
    if dispersion == (Dispersion::Apart { mass: 0.0, center_of_mass: 0.0, inertia: 0.0 }) {
        return Err(table.missing("inertia", "dispersion = { mass = \"2 %\", inertia = \"10 %\" }"));
    }
    Ok(dispersion)
}

/// Reads a positive fraction, `"10 %"` or 0.1.
fn share(value: &Value<'_>) -> Result<f64, FormatError> {
    let share = super::distribution::percentage(value)?;
    if share > 0.0 && share <= MOST_DISPERSION {
        return Ok(share);
    }
    Err(value.invalid("above 0 and at most 50 %").with_hint("a standard deviation, relative: \"10 %\""))
}
