//! Quantities in text: a number and a unit, without ambiguity.
//!
//! Every quantity written by a user is read by [`parse`] with the required [`Dimension`], such as
//! `"982 slug ft^2"` for a moment of inertia or `"30 deg/s"` for an angular velocity. A unit of
//! another dimension is an error. A number without a unit is in SI. In a list with units, a number
//! without one is refused ([`bare_beside_units`]).
//!
//! Numbers may be typeset, as polhode prints them: `8.273 333e-5`, `−4.5×10⁻⁵`.
//!
//! A unit is a product: names joined by a space, `*`, `·` or nothing, divided by `/`, raised by
//! `^2`, `^-1`, `²` or `⁻¹`, grouped by parentheses. A slash divides by the one factor after it,
//! left to right: `kg/m/s` and `kg/(m s)` are the same, `kg/m s` is kg s/m.
//!
//! Conversion adds no rounding error. The result is the double nearest to the exact product of the
//! decimal number and the definition of the unit, so `"25.4 mm"` and `"1 in"` are both `0.0254`.

mod dimension;
mod exact;
mod number;
mod scale;
mod table;

use std::error::Error;
use std::fmt;

use crate::text::cut;
use exact::Exact;
use number::{Split, split};
use table::Unit;

pub use dimension::Dimension;
pub use scale::Scale;

/// Reads a number with an optional unit as a value in SI units: m, kg, s, rad and their products.
///
/// ```
/// use polhode_source::unit::{Dimension, UnitError, parse};
///
/// assert_eq!(parse("3 in", Dimension::LENGTH), Ok(0.0762)); // m
/// assert_eq!(parse("2.7 g/cm³", Dimension::DENSITY), Ok(2700.0)); // kg/m³
/// assert_eq!(parse("-6 rpm", Dimension::ANGULAR_VELOCITY), Ok(-std::f64::consts::PI / 5.0)); // rad/s
/// assert_eq!(parse("0.25", Dimension::MASS), Ok(0.25)); // a bare number is SI
///
/// let error = parse("30 deg", Dimension::LENGTH).unwrap_err();
/// assert_eq!(error.to_string(), "\"deg\" is an angle where a length belongs");
/// assert_eq!(error.hint().unwrap(), "write a length, such as \"25 mm\"");
/// ```
///
/// # Errors
///
/// Text that does not start with a decimal number, a number outside the range of a double, an
/// unknown or misspelt unit, and a unit of another dimension than `expected`.
pub fn parse(text: &str, expected: Dimension) -> Result<f64, UnitError> {
    let accepts = |unit: &str, found| match expected.accepts(found) {
        true => Ok(()),
        false => Err(UnitError::WrongDimension { unit: unit.to_owned(), found, expected }),
    };
    read(text, accepts).map(|(value, _)| value)
}

/// Returns the value of one unit in SI units, such as 0.001 for `mm`.
///
/// ```
/// use polhode_source::unit::{Dimension, factor};
/// assert_eq!(factor("mm", Dimension::LENGTH), Ok(0.001));
/// assert!(factor("kg", Dimension::LENGTH).is_err());
/// ```
///
/// # Errors
///
/// Same as [`parse`], for the unit.
pub fn factor(unit: &str, expected: Dimension) -> Result<f64, UnitError> {
    let accepts = |unit: &str, found| match expected.accepts(found) {
        true => Ok(()),
        false => Err(UnitError::WrongDimension { unit: unit.to_owned(), found, expected }),
    };
    let unit = unit.trim();
    if unit.is_empty() {
        return Err(UnitError::Malformed { unit: String::new(), rule: "it has no name" });
    }
    value("1", unit, unit, accepts).map(|(value, _)| value)
}

/// Returns the value in SI of one unit named by a symbol or a word, such as 0.001 for `millimeters`
/// or `MM`; `None` for other labels.
pub fn spelt(label: &str, expected: Dimension) -> Option<f64> {
    let label = label.trim();
    let lower = label.to_lowercase();
    let names = [Some(label), Some(&*lower), table::word(&lower)];
    let symbol = names.into_iter().flatten().find_map(|name| factor(name, expected).ok());
    // Labels such as 1mm.
    symbol.or_else(|| parse(label, expected).ok().filter(|_| has_unit(label)))
}

/// Finds, among the numbers of a list, the first nonzero one without a unit and the first one with
/// a unit. `None` unless both exist: the author meant one unit for all, or forgot it. Texts that
/// are not quantities are skipped.
///
/// ```
/// use polhode_source::unit::bare_beside_units;
/// assert_eq!(bare_beside_units(["0 mm", "0", "150"]), Some(("150", "0 mm")));
/// assert_eq!(bare_beside_units(["0", "2 deg", "−3.5 rad"]), None);
/// ```
pub fn bare_beside_units<'a>(texts: impl IntoIterator<Item = &'a str> + Clone) -> Option<(&'a str, &'a str)> {
    let is_bare = |text: &&str| {
        split(text.trim()).is_some_and(|split| {
            split.unit.is_empty() && !Exact::new(split.number.trim_start_matches('-')).is_zero()
        })
    };
    let bare = texts.clone().into_iter().find(is_bare)?;
    Some((bare, texts.into_iter().find(|text| has_unit(text))?))
}

/// Parses a number without a unit, also a typeset one: `8.273 333e-5`, `−2.5`.
pub fn bare(text: &str) -> Option<f64> {
    split(text.trim()).filter(|split| split.unit.is_empty()).and_then(|split| split.number.parse().ok())
}

/// Returns the unit after a number; empty if there is none.
pub fn unit_of(text: &str) -> &str {
    split(text.trim()).map_or("", |split| split.unit)
}

/// Returns the number before a unit without digit grouping; `None` if the text does not begin with
/// a number.
pub fn number_of(text: &str) -> Option<String> {
    split(text.trim()).map(|split| split.number)
}

/// Returns the usual units of a dimension, the SI unit first.
pub fn units_of(dimension: Dimension) -> Vec<&'static str> {
    let compound = COMPOUND.iter().copied().filter(|unit| {
        measured_apart("1", unit).is_ok_and(|(_, found)| found == dimension && dimension != Dimension::NONE)
    });
    table::names_of(dimension).chain(compound).collect()
}

/// Usual products of units.
const COMPOUND: [&str; 37] = [
    "m^3",
    "cm^3",
    "mm^3",
    "in^3",
    "m/s",
    "km/h",
    "ft/s",
    "m/s^2",
    "rad/s",
    "deg/s",
    "rev/s",
    "deg/h",
    "rad/s^2",
    "deg/s^2",
    "kg/m^3",
    "g/cm^3",
    "lb/in^3",
    "kg/m^2",
    "g/m^2",
    "kg/m",
    "g/m",
    "kg m^2",
    "g cm^2",
    "kg mm^2",
    "slug ft^2",
    "lb in^2",
    "kg m^2/s",
    "N m",
    "mN m",
    "lbf ft",
    "m^3/s^2",
    "A m^2",
    "mA m^2",
    "N m/rad",
    "N m s/rad",
    "N m s^2/rad^2",
    "N s/m",
];

/// Returns true for a number with a unit; false for a formula such as `3*t`.
fn has_unit(text: &str) -> bool {
    split(text.trim()).is_some_and(|Split { unit, .. }| {
        !unit.is_empty() && !unit.starts_with(['*', '·', '⋅']) && Product::read(unit).is_ok()
    })
}

/// Returns true if ordinary spaces group the digits so that they may be several numbers: `100 200`,
/// but not `8.273 333e-5`.
///
/// Such a text is one number where exactly one is required. In a list it is ambiguous.
pub fn may_be_several(text: &str) -> bool {
    split(text.trim()).is_some_and(|Split { number, unit, spaced }| {
        spaced && (!number.contains('.') || unit.is_empty() && !number.contains('e'))
    })
}

/// Reads a number with an optional unit of any dimension; returns its value in SI units and its
/// dimension.
///
/// ```
/// use polhode_source::unit::{Dimension, measured};
/// assert_eq!(measured("3 in"), Ok((0.0762, Dimension::LENGTH)));
/// assert_eq!(measured("3"), Ok((3.0, Dimension::NONE)));
/// ```
///
/// # Errors
///
/// Same as [`parse`], except that any dimension is accepted.
pub fn measured(text: &str) -> Result<(f64, Dimension), UnitError> {
    read(text, |_, _| Ok(()))
}

/// Reads a number and a unit given separately, otherwise as [`measured`] does.
pub fn measured_apart(number: &str, unit: &str) -> Result<(f64, Dimension), UnitError> {
    value(number, unit.trim(), &format!("{number} {unit}"), |_, _| Ok(()))
}

/// Reads a number and the dimension of its unit, if `accepts` accepts it; a number without a unit
/// is accepted.
fn read(
    text: &str,
    accepts: impl FnOnce(&str, Dimension) -> Result<(), UnitError>,
) -> Result<(f64, Dimension), UnitError> {
    let text = text.trim();
    let split = split(text).ok_or_else(|| UnitError::NotANumber { text: text.to_owned() })?;
    value(&split.number, split.unit, text, accepts)
}

/// Returns the value of a number without digit grouping and its unit; messages quote `text`.
fn value(
    number: &str,
    unit: &str,
    text: &str,
    accepts: impl FnOnce(&str, Dimension) -> Result<(), UnitError>,
) -> Result<(f64, Dimension), UnitError> {
    let mut exact = Exact::new(number.trim_start_matches(['+', '-']));
    let nonzero = !exact.is_zero();
    let mut dimension = Dimension::NONE;
    if !unit.is_empty() {
        let factors = Product::read(unit)?;
        dimension = factors.iter().fold(dimension, |found, f| found.times(f.unit.dimension, f.power));
        accepts(unit, dimension)?;
        factors.iter().for_each(|f| exact.scale(f.unit.factor, f.power));
    }
    match exact.nearest() {
        magnitude if !magnitude.is_finite() => Err(UnitError::NotFinite { text: text.to_owned() }),
        magnitude if magnitude == 0.0 && nonzero => Err(UnitError::Underflow { text: text.to_owned() }),
        magnitude if number.starts_with('-') => Ok((-magnitude, dimension)),
        magnitude => Ok((magnitude, dimension)),
    }
}

/// Error of parsing a quantity.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum UnitError {
    /// The text does not start with a decimal number, or other characters follow the number
    /// directly.
    NotANumber {
        /// The whole text.
        text: String,
    },
    /// The value is larger than the largest double.
    NotFinite {
        /// The whole text.
        text: String,
    },
    /// The value is not zero, but smaller than the smallest double.
    Underflow {
        /// The whole text.
        text: String,
    },
    /// An unknown unit.
    UnknownUnit {
        /// The unknown name.
        unit: String,
        /// Closest known unit, if one is close.
        suggestion: Option<String>,
    },
    /// Unit names that do not form a valid product.
    Malformed {
        /// The whole unit.
        unit: String,
        /// Rule that the product breaks.
        rule: &'static str,
    },
    /// A unit of another dimension than required.
    WrongDimension {
        /// The whole unit.
        unit: String,
        /// Dimension of the unit.
        found: Dimension,
        /// Required dimension.
        expected: Dimension,
    },
}

impl UnitError {
    /// Returns advice for the user, if there is any.
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::NotANumber { text } => Some(number_hint(text)),
            Self::UnknownUnit { unit, .. } if unit == "Hz" => Some("write rev/s or rad/s".to_owned()),
            Self::UnknownUnit { suggestion, .. } => suggestion.as_ref().map(|s| format!("did you mean {s}?")),
            Self::WrongDimension { unit, expected: Dimension::ACCELERATION, .. } if unit == "g" => {
                Some("g is the gram; for standard gravity write g0".to_owned())
            }
            Self::WrongDimension { found, expected, .. } if expected.is_weight_of(*found) => {
                Some("lb, oz and kg are units of mass; units of force are lbf, ozf, kgf and N".to_owned())
            }
            Self::WrongDimension { expected, .. } => {
                expected.example().map(|example| format!("write {expected}, such as \"{example}\""))
            }
            Self::NotFinite { .. } | Self::Underflow { .. } | Self::Malformed { .. } => None,
        }
    }

    /// Returns the advice for a place that requires the name of a unit without a number, as in
    /// [`factor`].
    pub fn hint_for_name(&self) -> Option<String> {
        match self {
            Self::WrongDimension { expected, .. } => expected.example().map(|example| {
                let name = expected.to_string();
                let name = name.trim_start_matches("a ").trim_start_matches("an ");
                format!("write a unit of {name}, such as {}", unit_of(example))
            }),
            _ => self.hint(),
        }
    }
}

impl fmt::Display for UnitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotANumber { text } => write!(f, "{} is not a number", quoted(text)),
            Self::NotFinite { text } => write!(f, "{} is larger than any double", quoted(text)),
            Self::Underflow { text } => {
                write!(f, "{} is smaller than any double and would become zero", quoted(text))
            }
            Self::UnknownUnit { unit, .. } => write!(f, "unknown unit {}", quoted(unit)),
            Self::Malformed { unit, rule } => write!(f, "{} is not a unit: {rule}", quoted(unit)),
            // N m and J are the same unit, of a torque and of an energy.
            Self::WrongDimension { unit, found: Dimension::TORQUE, expected } => {
                write!(f, "{} is an energy or a torque where {expected} belongs", quoted(unit))
            }
            Self::WrongDimension { unit, found, expected } => {
                write!(f, "{} is {found} where {expected} belongs", quoted(unit))
            }
        }
    }
}

impl Error for UnitError {}

/// Returns the text in quotes, escaped, and cut to the length of a message.
fn quoted(text: &str) -> String {
    format!("{:?}", cut(text))
}

fn number_hint(text: &str) -> String {
    let replaced = |mark| text.replacen(',', mark, 1);
    match (split(&replaced(".")), split(&replaced(""))) {
        (Some(pointed), joined) => {
            // A comma is a thousands separator in some countries and a decimal mark in others.
            let decimals = text
                .split_once(',')
                .map_or(0, |(_, rest)| rest.bytes().take_while(u8::is_ascii_digit).count());
            let thousands = joined.filter(|_| decimals == 3);
            let or = thousands.map_or(String::new(), |joined| format!(" or {:.60}", joined.number));
            format!(
                "write {:.60}{or}: the decimal sign is a point, and no comma parts thousands",
                pointed.number
            )
        }
        _ => "write a decimal number and a unit, such as \"25.4 mm\" or \"-3.5e-2 rad/s\"".to_owned(),
    }
}

/// Returns the rest of a unit such as `1/s` after the 1: `/s`.
fn inverse(unit: &str) -> Option<&str> {
    unit.strip_prefix('1').map(str::trim_start).filter(|rest| rest.starts_with('/'))
}

/// A unit raised to a power.
struct Factor {
    unit: Unit,
    power: i8,
}

/// Parser of a unit; `rest` is the unread text, `factors` the factors read so far.
struct Product<'a> {
    unit: &'a str,
    rest: &'a str,
    factors: Vec<Factor>,
}

impl<'a> Product<'a> {
    /// These limits keep every exponent of a dimension within an `i8`: 7 × 9 × 2 (J contains m²) =
    /// 126. The exponent of many `cc` saturates; no dimension that polhode requires is near that
    /// value.
    const MAX_FACTORS: usize = 7;
    const MAX_POWER: i8 = 9;

    fn read(unit: &'a str) -> Result<Vec<Factor>, UnitError> {
        let mut product = Self { unit, rest: inverse(unit).unwrap_or(unit), factors: Vec::new() };
        product.product(false)?;
        match product.rest {
            "" => Ok(product.factors),
            _ => Err(product.malformed("unmatched closing parenthesis")),
        }
    }

    fn product(&mut self, inside: bool) -> Result<(), UnitError> {
        let mut sign = self.operator().unwrap_or(1);
        loop {
            let first = self.factors.len();
            self.factor(inside)?;
            let power = self.exponent()?.saturating_mul(sign);
            for factor in &mut self.factors[first..] {
                factor.power = factor.power.saturating_mul(power);
            }
            if self.factors.iter().any(|f| f.power.saturating_abs() > Self::MAX_POWER) {
                return Err(self.malformed("powers are from -9 to 9"));
            }
            if self.factors.len() > Self::MAX_FACTORS {
                return Err(self.malformed("a product has at most seven factors"));
            }
            let operator = self.operator();
            if self.rest.is_empty() || self.rest.starts_with(')') {
                return match operator {
                    Some(_) => Err(self.malformed("a factor is missing at its end")),
                    None => Ok(()),
                };
            }
            sign = operator.unwrap_or(1);
        }
    }

    /// Reads the operator between two factors, if there is one: −1 for a slash, 1 for a
    /// multiplication.
    fn operator(&mut self) -> Option<i8> {
        self.rest = self.rest.trim_start();
        let rest = self.rest.strip_prefix(['/', '*', '·', '⋅'])?;
        let sign = if self.rest.starts_with('/') { -1 } else { 1 };
        self.rest = rest.trim_start();
        Some(sign)
    }

    fn factor(&mut self, inside: bool) -> Result<(), UnitError> {
        if let Some(rest) = self.rest.strip_prefix('(') {
            if inside {
                return Err(self.malformed("parentheses cannot be nested"));
            }
            self.rest = rest;
            self.product(true)?;
            let Some(rest) = self.rest.strip_prefix(')') else {
                return Err(self.malformed("unclosed parenthesis"));
            };
            self.rest = rest;
            return Ok(());
        }
        match self.take(|c| c.is_alphabetic() || c.is_ascii_digit() || c == '°') {
            "" => Err(self.malformed("write unit names joined by a space, \"*\", \"·\" or \"/\"")),
            name => {
                let unit = Unit::named(name).ok_or_else(|| UnitError::UnknownUnit {
                    unit: name.to_owned(),
                    suggestion: table::suggestion(name),
                })?;
                self.factors.push(Factor { unit, power: 1 });
                Ok(())
            }
        }
    }

    /// Reads an exponent such as `^2`, `^-1`, `²` or `⁻¹`; 1 if there is none.
    fn exponent(&mut self) -> Result<i8, UnitError> {
        const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
        let lowered = |c: char| match RAISED.iter().position(|&r| r == c) {
            Some(digit) => char::from(b'0' + digit as u8),
            None => '-', // ⁻
        };
        let digits = match self.rest.strip_prefix('^') {
            Some(rest) => {
                self.rest = rest;
                self.take(|c| c.is_ascii_digit() || matches!(c, '-' | '\u{2212}')).replace('\u{2212}', "-")
            }
            None => match self.take(|c| RAISED.contains(&c) || c == '⁻') {
                "" => return Ok(1),
                raised => raised.chars().map(lowered).collect(),
            },
        };
        digits.parse().map_err(|_| self.malformed("a power is an integer, such as ^2 or ^-1"))
    }

    /// Reads the characters that satisfy a condition.
    fn take(&mut self, condition: impl Fn(char) -> bool) -> &'a str {
        let end = self.rest.find(|c| !condition(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest;
        taken
    }

    fn malformed(&self, rule: &'static str) -> UnitError {
        UnitError::Malformed { unit: self.unit.to_owned(), rule }
    }
}
