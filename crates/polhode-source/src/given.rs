//! Numbers in arguments of a command or function: quantities with units, and lists of them. Errors
//! are strings without a place; the caller adds the name of the argument.

use std::fmt;
use std::marker::PhantomData;
use std::str::FromStr;

use polhode::math::{Body, Frame, Position, Rotation};
use serde_core::de::{self, Visitor};
use serde_core::{Deserialize, Deserializer, Serialize, Serializer};

use crate::times;
use crate::unit;
use crate::unit::Dimension;

/// Argument as the user wrote it, with its parsed value.
///
/// It serializes as its text. When deserializing, a number is accepted as a value in SI units.
///
/// ```
/// use polhode_source::given::{Given, Positive, Time};
/// let step: Given<Positive<Time>> = "2 ms".parse()?;
/// assert_eq!((step.text.as_str(), step.value.0.0), ("2 ms", 2e-3));
/// assert_eq!("0 s".parse::<Given<Positive<Time>>>(), Err("it must be positive".to_owned()));
/// assert!("3 kg".parse::<Given<Time>>().is_err());
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Given<T> {
    /// Text as the user wrote it.
    pub text: String,
    /// Parsed value.
    pub value: T,
}

impl<T: FromStr<Err = String>> FromStr for Given<T> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Ok(Self { value: text.parse()?, text: text.to_owned() })
    }
}

impl<T> Serialize for Given<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.text)
    }
}

impl<'de, T: FromStr<Err = String>> Deserialize<'de> for Given<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Text<T>(PhantomData<T>);
        impl<T: FromStr<Err = String>> Visitor<'_> for Text<T> {
            type Value = Given<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a string with a unit, or a number in SI units")
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Given<T>, E> {
                text.parse().map_err(E::custom)
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<Given<T>, E> {
                self.visit_str(&number.to_string())
            }

            fn visit_u64<E: de::Error>(self, number: u64) -> Result<Given<T>, E> {
                self.visit_str(&number.to_string())
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Given<T>, E> {
                self.visit_str(&number.to_string())
            }
        }
        deserializer.deserialize_any(Text(PhantomData))
    }
}

/// Defines quantities from their names, dimensions and SI units.
macro_rules! quantities {
    ($($name:ident: $dimension:ident, $about:literal;)*) => {$(
        #[doc = $about]
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
        pub struct $name(pub f64);

        impl FromStr for $name {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                quantity(text, Dimension::$dimension).map(Self)
            }
        }

        impl From<$name> for f64 {
            fn from(given: $name) -> Self {
                given.0
            }
        }
    )*};
}

quantities! {
    Angle: ANGLE, "Angle, rad.";
    Density: DENSITY, "Density, kg/m³.";
    Inertia: INERTIA, "Moment of inertia, kg m².";
    Length: LENGTH, "Length, m.";
    Mass: MASS, "Mass, kg.";
    Number: NONE, "Number without a unit.";
    Time: TIME, "Time, s.";
}

/// Quantity that is positive.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Positive<T>(pub T);

impl<T: FromStr<Err = String> + Into<f64> + Copy> FromStr for Positive<T> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let value: T = text.parse()?;
        positive(value.into())?;
        Ok(Self(value))
    }
}

/// Point of a body, parsed from `x,y,z`: position from the origin, body axes, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point(pub Position<Body>);

impl FromStr for Point {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        point(text).map(Self)
    }
}

/// Rotation, parsed from a quaternion `w,x,y,z`, scalar first, of any nonzero length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<A: Frame, B: Frame>(pub Rotation<A, B>);

impl<A: Frame, B: Frame> FromStr for Turn<A, B> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        rotation(text).map(Self)
    }
}

/// Parses a number with a unit, or without one in SI; returns it in SI.
pub fn quantity(text: &str, dimension: Dimension) -> Result<f64, String> {
    unit::parse(text, dimension).map_err(|error| match error.hint() {
        Some(hint) => format!("{error} (hint: {hint})"),
        None => error.to_string(),
    })
}

/// Returns the value of one unit of this name in SI.
pub fn unit_named(name: &str, dimension: Dimension) -> Result<f64, String> {
    unit::factor(name, dimension).map_err(|error| match error.hint_for_name() {
        Some(hint) => format!("{error} (hint: {hint})"),
        None => error.to_string(),
    })
}

/// Parses numbers separated by commas, each with its unit; `(1, 2, 3) deg/s` gives one unit to all.
pub fn list(text: &str, dimension: Dimension) -> Result<Vec<f64>, String> {
    let without = text.trim().trim_start_matches('(').replace(')', " ");
    match without.split(',').find(|part| unit::may_be_several(part)) {
        Some(part) => Err(format!(
            "{part:?} is ambiguous: one number or several (hint: separate numbers by commas, without spaces inside a number)"
        )),
        None => each(text, dimension),
    }
}

/// Times in s, parsed from a list such as `1 s, 2 s` or a range such as `0:1:0.1`.
#[derive(Clone, Debug, PartialEq)]
pub struct Times(pub Vec<f64>);

impl FromStr for Times {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        times(text)
    }
}

/// Parses times separated by commas, each with its unit. `0:1:0.1` means 0 to 1 in steps of 0.1.
pub fn times(text: &str) -> Result<Times, String> {
    if !text.contains(':') {
        return list(text, Dimension::TIME).map(Times);
    }
    let parts: Vec<&str> = text.split([',', ':']).map(str::trim).collect();
    if let Some(part) = parts.iter().find(|part| unit::may_be_several(part)) {
        return Err(format!(
            "{part:?} is ambiguous: one number or several (hint: write numbers without spaces)"
        ));
    }
    if let Some((without, with)) = unit::bare_beside_units(parts) {
        return Err(format!(
            "{with:?} has a unit, but {without:?} has none (hint: give every number a unit, or none)"
        ));
    }
    let mut all = Vec::new();
    for part in text.split(',') {
        let numbers = part.split(':').map(|number| quantity(number.trim(), Dimension::TIME));
        match numbers.collect::<Result<Vec<_>, _>>()?[..] {
            [time] => all.push(time),
            [from, to, step] => all.extend(times::range(from, to, step).ok_or_else(|| {
                format!(
                    "{:?} is not a range with at most {} times (hint: from:to:step, such as 0:1:0.1)",
                    part.trim(),
                    times::MOST
                )
            })?),
            _ => {
                return Err(format!(
                    "{:?} is not a range (hint: from:to:step, such as 0:1:0.1)",
                    part.trim()
                ));
            }
        }
    }
    Ok(Times(all))
}

/// Parses the numbers of a list. Refuses a list with units on some of its nonzero numbers only: the
/// author often means the last unit for all of them.
fn each(text: &str, dimension: Dimension) -> Result<Vec<f64>, String> {
    let (inside, unit) = match text.trim().strip_prefix('(').and_then(|rest| rest.split_once(')')) {
        Some((inside, unit)) => (inside, unit),
        None => (text, ""),
    };
    let parts: Vec<_> = inside.split(',').map(|part| format!("{part} {unit}").trim().to_owned()).collect();
    let numbers = parts.iter().map(|part| quantity(part, dimension)).collect::<Result<Vec<_>, _>>()?;
    match unit::bare_beside_units(parts.iter().map(String::as_str)) {
        Some((without, with)) => Err(format!(
            "{with:?} has a unit, but {without:?} has none (hint: give every number a unit, or one unit for all: \"(1, 2) unit\")"
        )),
        None => Ok(numbers),
    }
}

/// Parses exactly `N` numbers, otherwise as [`list`] does.
pub fn numbers<const N: usize>(text: &str, form: &str, dimension: Dimension) -> Result<[f64; N], String> {
    let found = if text.trim().is_empty() { 0 } else { text.split(',').count() };
    if found != N {
        return Err(format!("expected {N} numbers ({form}), not {found}"));
    }
    each(text, dimension)?.try_into().map_err(|_| format!("expected {N} numbers ({form})"))
}

/// Parses a quaternion, scalar first, of any nonzero length.
pub fn rotation<A: Frame, B: Frame>(text: &str) -> Result<Rotation<A, B>, String> {
    let q = numbers(text, "w,x,y,z", Dimension::NONE)?;
    Rotation::from_quaternion(q).map_err(|e| e.to_string())
}

/// Parses a point of a body: `x,y,z` from its origin, body axes, m.
pub fn point(text: &str) -> Result<Position<Body>, String> {
    numbers(text, "x,y,z", Dimension::LENGTH).map(Position::from_array)
}

/// Returns the number if it is positive, else an error.
pub fn positive(value: f64) -> Result<f64, String> {
    if value > 0.0 { Ok(value) } else { Err("it must be positive".to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_has_a_unit_for_each_or_one_for_all() {
        let list = |text: &str| numbers::<3>(text, "x,y,z", Dimension::ANGULAR_VELOCITY);
        assert_eq!(list("1, -2e-3,3"), Ok([1.0, -2e-3, 3.0]));
        assert_eq!(list("0,0,-2 1/s"), Ok([0.0, 0.0, -2.0]));
        assert_eq!(list(" (1, 0.5, 0) rev/s"), list("1 rev/s, 0.5 rev/s, 0"));
        assert_eq!(list("12 345.6, −4.5×10⁻⁵, 8.273 333e-5"), Ok([12_345.6, -4.5e-5, 8.273_333e-5]));
        for (wrong, says) in [
            ("1,2,3 deg/s", "\"1\" has none"),
            ("1 deg/s,2,0", "\"2\" has none"),
            ("1,2", "not 2"),
            ("", "not 0"),
            ("1,,3", "not a number"),
            ("(1,2,3) m", "a length"),
            ("(1,2,3 rad/s", "not a number"),
            ("nan,0,1", "not a number"),
        ] {
            let error = list(wrong).unwrap_err();
            assert!(error.contains(says), "{wrong}: {error}");
        }
    }

    #[test]
    fn a_range_of_times_has_both_its_ends() {
        let of = |text: &str| times(text).map(|Times(times)| times);
        assert_eq!(of("0:0.3:0.1"), Ok(vec![0.0, 0.1, 0.2, 0.3]));
        assert_eq!(of("-1 min:1 min:0.5 min, 1 h"), Ok(vec![-60.0, -30.0, 0.0, 30.0, 60.0, 3600.0]));
        assert_eq!(of("3:1:-1,7"), Ok(vec![3.0, 2.0, 1.0, 7.0]));
        assert_eq!(of("0:1:0.4"), Ok(vec![0.0, 0.4, 0.8]));
        assert_eq!(of("2,5"), Ok(vec![2.0, 5.0]));
        for wrong in
            ["0:1", "0:1:0", "0:1:-1", "0:1e9:1e-3", "0:1:1:1", "0:10 s:1", ":1:0.1", "0:1 m:1 m", "0:1:nan"]
        {
            assert!(of(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_space_does_not_stand_between_the_numbers_of_a_list() {
        let times = |text: &str| super::list(text, Dimension::TIME);
        assert_eq!(times("8.273 333 h, 1 234.5 s"), Ok(vec![29_783.998_8, 1234.5]));
        assert_eq!(times("8.273 333e5, 0, 12\u{a0}345"), Ok(vec![827_333.3, 0.0, 12_345.0]));
        for wrong in ["100 200", "100 200 300", "0.125 250", "100 200 s"] {
            assert!(times(wrong).unwrap_err().contains("several"), "{wrong}");
        }
    }
}
