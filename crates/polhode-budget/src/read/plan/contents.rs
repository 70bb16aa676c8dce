//! Amount of liquid in a tank and its errors: `mass = "12 ± 0.3 kg"`, `fill = "75 % ± 2 %"`,
//! `density = "0.9 g/cm^3 ± 1 %"`, and `mass_sd`, `fill_sd`, `density_sd`.

use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::fraction;
use crate::read::cells::{MOST_DEVIATION, too_uncertain};
use crate::read::measured::{MARKS, measured, percent};
use crate::read::number::{Amount, Unit, Wrong};
use crate::{LiquidErrors, Measured};

/// Number with its standard deviation, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Known {
    pub value: f64,
    pub sd: f64,
    /// True if the error is after ±.
    pub is_after_mark: bool,
}

impl Known {
    /// Exact number in place of one that is not given.
    pub(crate) const EXACT: Self = Self { value: 1.0, sd: 0.0, is_after_mark: false };
}

/// Reads the contents of a tank: its mass, kg, its errors, and the number that gives it. `capacity`
/// is in kg, and `density` is the relative error of the density.
pub(crate) fn contents<'a>(
    table: &Table<'a>,
    capacity: f64,
    density: f64,
    coverage_factor: f64,
) -> Result<(f64, LiquidErrors, Known, Value<'a>), FormatError> {
    let given = table.at_most_one(
        &["mass", "fill"],
        "mass is the mass of the contents, fill their share of the capacity",
    )?;
    let given = given.ok_or_else(|| table.missing("mass", "mass = \"12 kg\", or fill = \"80 %\""))?;
    let (own, other) = if given.key() == "mass" { ("mass_sd", "fill_sd") } else { ("fill_sd", "mass_sd") };
    if let Some(value) = table.get(other) {
        return Err(value.invalid(format!("left out, because {} is given", given.key())));
    }
    let beside = table.get(own);
    let (known, mass, amount, measured) = if given.key() == "mass" {
        let known = quantity(&given, beside.as_ref(), Dimension::MASS, coverage_factor)?;
        // A rounded mass may slightly exceed the computed capacity.
        if !(known.value >= 0.0 && known.value <= capacity * (1.0 + 1e-9)) {
            return Err(given.invalid(format!("from 0 to the capacity of the tank, {capacity} kg")));
        }
        (known, known.value.min(capacity), known.sd, Measured::Mass)
    } else {
        let known = part(&given, beside.as_ref(), coverage_factor)?;
        if !(0.0..=1.0).contains(&known.value) {
            return Err(given.invalid("from 0 to 100 %"));
        }
        (known, known.value * capacity, known.sd * capacity, Measured::Fill)
    };
    if mass == 0.0 && amount > 0.0 {
        let error = beside.unwrap_or(given).invalid("without an error, because the tank is empty");
        return Err(error.with_hint("the contents cannot be negative: enter their mean"));
    }
    Ok((mass, LiquidErrors { measured, amount, density }, known, given))
}

/// Reads a quantity with its error, from its own value or from a separate key.
pub(crate) fn quantity(
    value: &Value<'_>,
    beside: Option<&Value<'_>>,
    dimension: Dimension,
    coverage_factor: f64,
) -> Result<Known, FormatError> {
    let (number, own) = match marked(value) {
        Some(text) => {
            let read = measured(text, &Unit::SI, dimension, value.key()).map_err(|w| wrong(value, w))?;
            (read.value, read.error)
        }
        None => (value.quantity(dimension)?, None),
    };
    let of = |at: &Value<'_>, amount: Amount| {
        let none = || {
            at.invalid("an absolute value: a percentage of zero is zero").with_hint("write it with a unit")
        };
        amount.of(number).ok_or_else(none)
    };
    let own = own.map(|amount| of(value, amount)).transpose()?;
    let beside = match beside {
        Some(at) => {
            let fraction = at.string().ok().and_then(percent);
            let amount = match fraction {
                Some(fraction) => Amount::Relative(fraction.map_err(|w| wrong(at, w))?),
                None => Amount::Absolute(at.quantity(dimension)?),
            };
            Some((at, of(at, amount)?))
        }
        None => None,
    };
    known(value, number, own, beside, coverage_factor)
}

/// Reads the relative error of a number that is not given, in percent.
pub(crate) fn relative(value: &Value<'_>) -> Result<Known, FormatError> {
    let Some(fraction) = value.string().ok().and_then(percent) else {
        return Err(value.invalid("in percent: a table has no density").with_hint("write \"1 %\""));
    };
    let fraction = fraction.map_err(|w| wrong(value, w))?;
    known(value, 1.0, None, Some((value, fraction)), 1.0)
}

/// Reads a fraction of a full tank, with its error as such a fraction.
fn part(value: &Value<'_>, beside: Option<&Value<'_>>, coverage_factor: f64) -> Result<Known, FormatError> {
    let beside = beside.map(|at| Ok::<_, FormatError>((at, fraction(at)?))).transpose()?;
    let Some(text) = marked(value) else {
        return known(value, fraction(value)?, None, beside, coverage_factor);
    };
    // (75 ± 2) %
    let (text, all) = match text.trim().strip_prefix('(').and_then(|text| text.split_once(')')) {
        Some((inside, unit)) => (inside, unit),
        None => (text, ""),
    };
    let (left, right) = MARKS.iter().find_map(|mark| text.split_once(mark)).unwrap_or((text, ""));
    let [left, right] = [left, right].map(|number| format!("{}{}", number.trim(), all.trim()));
    if left.ends_with('%') != right.ends_with('%') {
        let error = value.invalid("in percent on both sides of ±, or on neither");
        return Err(error.with_hint("write \"75 % ± 2 %\", or \"0.75 ± 0.02\""));
    }
    let read = |text: &str| match percent(text) {
        Some(fraction) => fraction,
        None => Ok(Unit::SI.read(text, Dimension::NONE)?.value),
    };
    let [number, error] = [read(&left), read(&right)].map(|read| read.map_err(|w| wrong(value, w)));
    known(value, number?, Some(error?), beside, coverage_factor)
}

fn known(
    value: &Value<'_>,
    number: f64,
    own: Option<f64>,
    beside: Option<(&Value<'_>, f64)>,
    coverage_factor: f64,
) -> Result<Known, FormatError> {
    let (at, sd) = match (own, beside) {
        (Some(_), Some((at, _))) => {
            return Err(at.invalid(format!("left out, because {} already has an error", value.key())));
        }
        (Some(amount), None) => (value, amount / coverage_factor),
        (None, Some((at, sd))) => (at, sd),
        (None, None) => (value, 0.0),
    };
    if !(sd >= 0.0) {
        return Err(at.invalid("with an error that is zero or positive").with_hint("an error has no sign"));
    }
    // The limit is also relative to the number, because liquids are drawn by their relative errors.
    let most = MOST_DEVIATION * number.abs().min(1.0);
    if sd > most && number != 0.0 {
        let error = at.invalid(format!("with a standard deviation of {most:e} at most, in SI: it is {sd:e}"));
        return Err(too_uncertain(error, coverage_factor));
    }
    Ok(Known { value: number, sd, is_after_mark: own.is_some() })
}

/// Returns a text that has an error after its number.
fn marked<'a>(value: &Value<'a>) -> Option<&'a str> {
    value.string().ok().filter(|text| MARKS.iter().any(|mark| text.contains(mark)))
}

fn wrong(value: &Value<'_>, wrong: Wrong) -> FormatError {
    wrong.at(|kind| value.error(kind))
}
