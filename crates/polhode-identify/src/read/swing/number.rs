//! Measured numbers, and numbers that tests share by name.

use polhode::math::Direction;
use polhode_source::nearest;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_source::{FormatError, FormatErrorKind};

use crate::swing::{Linear, Measured, NumberId, Point, SwingPlan};

/// Dimensions of shared numbers, with their SI units.
const UNITS: [(Dimension, &str); 4] = [
    (Dimension::LENGTH, "m"),
    (Dimension::STIFFNESS, "N·m/rad"),
    (Dimension::MASS, "kg"),
    (Dimension::INERTIA, "kg·m²"),
];

/// Reserved names: parameters of every result.
const OWN: [&str; 8] = ["mass", "gravity", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"];

/// Reads `"3.2 kg"`, exact; `{ value = "3.2 kg", sd = "1 g" }`; or `{ about = "3 kg" }`, to be
/// estimated.
pub(crate) fn measured(value: &Value<'_>, dimension: Dimension) -> Result<Measured, FormatError> {
    let measured = read(value, dimension)?;
    let is_plausible = measured.value.abs() <= LARGEST && !(measured.sd.is_finite() && measured.sd > LARGEST);
    match is_plausible {
        true => Ok(measured),
        false => Err(value.invalid("at most 1e12 in SI units; otherwise the equations of the rig overflow")),
    }
}

/// Upper bound on the numbers of a rig and a body, SI.
const LARGEST: f64 = 1e12;

fn read(value: &Value<'_>, dimension: Dimension) -> Result<Measured, FormatError> {
    let Ok(table) = value.table() else { return Ok(Measured::exact(value.quantity(dimension)?)) };
    table.allow(&["value", "sd", "about"])?;
    table.at_most_one(&["about", "sd"], "an unknown number has no standard deviation")?;
    match table.at_most_one(&["value", "about"], "a number is either measured (value) or unknown (about)")? {
        Some(about) if about.key() == "about" => Ok(Measured::unknown(about.quantity(dimension)?)),
        Some(number) => {
            let sd = table.require(
                "sd",
                "sd = \"1 mm\", in a unit of the same kind; or write only the value if it is exact",
            )?;
            Ok(Measured::new(number.quantity(dimension)?, sd.positive(dimension)?))
        }
        None => Err(table
            .missing("value", "value = \"0.2 m\", sd = \"0.5 mm\"; or about = \"0.2 m\" if it is unknown")),
    }
}

/// Plan under construction, with its shared numbers by name.
pub(crate) struct Numbers<'a> {
    pub plan: SwingPlan,
    named: Vec<Named<'a>>,
}

struct Named<'a> {
    name: &'a str,
    id: NumberId,
    dimension: Dimension,
    value: Value<'a>,
    is_used: bool,
}

impl<'a> Numbers<'a> {
    /// Reads the table `[swing.numbers]`.
    pub(crate) fn new(plan: SwingPlan, table: Option<&Table<'a>>) -> Result<Self, FormatError> {
        let mut numbers = Self { plan, named: Vec::new() };
        for (name, value) in table.into_iter().flat_map(|table| table.each("a number")) {
            let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic())
                && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
            if !is_name || OWN.contains(&name) {
                let rule = "made of a letter, then letters, digits, _ or -, and different from the body's own parameters";
                return Err(value.invalid(rule).with_hint(format!("rename \"{name}\"")));
            }
            let (dimension, unit) = dimension_of(&value)?;
            let id = numbers.plan.number(name, unit, measured(&value, dimension)?);
            numbers.named.push(Named { name, id, dimension, value, is_used: false });
        }
        Ok(numbers)
    }

    /// Checks that every shared number is used in a test.
    pub(crate) fn all_used(&self) -> Result<(), FormatError> {
        match self.named.iter().find(|named| !named.is_used) {
            Some(Named { name, value, .. }) => Err(value
                .invalid("used in a test")
                .with_hint(format!("write \"{name}\" in a test that uses this number, or remove it"))),
            None => Ok(()),
        }
    }

    /// Reads a quantity of a test: a number (exact, measured or to be estimated); the name of a
    /// shared number, with an optional minus sign; or
    /// `{ number = "r", times = 0.5, plus = "1 cm" }`.
    pub(crate) fn linear(
        &mut self,
        value: &Value<'a>,
        dimension: Dimension,
        called: &str,
    ) -> Result<Linear, FormatError> {
        if let Ok(table) = value.table() {
            let Some(number) = table.get("number") else {
                let measured = measured(value, dimension)?;
                if measured.sd == 0.0 {
                    return Ok(measured.value.into());
                }
                let unit = UNITS.iter().find(|(of, _)| *of == dimension).map_or("1", |(_, unit)| unit);
                return Ok(self.plan.number(called, unit, measured).into());
            };
            table.allow(&["number", "times", "plus"])?;
            let id = self.named(&number, number.string()?, dimension)?;
            let times = table.get("times").map_or(Ok(1.0), |times| times.number())?;
            let plus = table.get("plus").map_or(Ok(0.0), |plus| plus.quantity(dimension))?;
            return Ok(Linear::from(plus).plus(times, id));
        }
        match value.string().ok().and_then(reference) {
            Some((sign, name)) => Ok(Linear::from(0.0).plus(sign, self.named(value, name, dimension)?)),
            None => Ok(value.quantity(dimension)?.into()),
        }
    }

    /// Reads a quantity with default 0.
    pub(crate) fn or_zero(
        &mut self,
        table: &Table<'a>,
        key: &'static str,
        dimension: Dimension,
        test: &str,
    ) -> Result<Linear, FormatError> {
        table
            .get(key)
            .map_or(Ok(Linear::default()), |value| self.linear(&value, dimension, &format!("{test}: {key}")))
    }

    /// Reads a point: `["1 cm", "r", "-r"]`, or `{ at = […], along = [0, 1, 0], distance = "r" }`.
    pub(crate) fn point(&mut self, value: &Value<'a>, called: &str) -> Result<Point, FormatError> {
        let Ok(table) = value.table() else {
            let elements = value.fixed::<3>("lengths, or names of numbers")?;
            let mut point: [Linear; 3] = Default::default();
            for ((slot, element), axis) in point.iter_mut().zip(&elements).zip(["x", "y", "z"]) {
                *slot = self.linear(element, Dimension::LENGTH, &format!("{called} {axis}"))?;
            }
            return Ok(Point::from(point));
        };
        table.allow(&["at", "along", "distance"])?;
        let at = table.get("at").map_or(Ok([0.0; 3]), |at| at.quantities(Dimension::LENGTH))?;
        let along = table.require("along", "along = [0, 1, 0]")?;
        let along = unit_vector(&along)?;
        let distance = table.require("distance", "distance = \"r\", a number of [swing.numbers]")?;
        match distance.string().ok().and_then(reference) {
            Some((sign, name)) => {
                let id = self.named(&distance, name, Dimension::LENGTH)?;
                Ok(Point::from(at).shifted(id, along.map(|x| sign * x)))
            }
            None => {
                let measured = measured(&distance, Dimension::LENGTH)?;
                let id = self.plan.number(format!("{called} distance"), "m", measured);
                Ok(Point::from(at).shifted(id, along))
            }
        }
    }

    fn named(
        &mut self,
        value: &Value<'a>,
        name: &str,
        dimension: Dimension,
    ) -> Result<NumberId, FormatError> {
        let Some(named) = self.named.iter_mut().find(|named| named.name == name) else {
            let names: Vec<&str> = self.named.iter().map(|named| named.name).collect();
            let error = value.invalid(if names.is_empty() {
                format!("{dimension}, or the name of a number: [swing.numbers] has none")
            } else {
                format!("{dimension}, or the name of a number of [swing.numbers]: {}", names.join(", "))
            });
            return Err(match nearest(name, names) {
                Some(near) => error.with_hint(format!("did you mean \"{near}\"?")),
                None => error
                    .with_hint(format!("define it under [swing.numbers]: {name} = {{ value = …, sd = … }}")),
            });
        };
        if named.dimension != dimension {
            let rule = format!("{dimension}: {name} is {}", named.dimension);
            return Err(value.invalid(rule).with_hint("a shared number has the same dimension in all tests"));
        }
        named.is_used = true;
        Ok(named.id)
    }
}

/// Splits a text into sign and name; `None` for a quantity.
fn reference(text: &str) -> Option<(f64, &str)> {
    let text = text.trim();
    let (sign, name) = match text.strip_prefix(['-', '−']) {
        Some(rest) => (-1.0, rest.trim_start()),
        None => (1.0, text),
    };
    name.starts_with(|c: char| c.is_alphabetic() || c == '_').then_some((sign, name))
}

/// Returns the dimension and SI unit of a shared number, from its unit.
fn dimension_of(value: &Value<'_>) -> Result<(Dimension, &'static str), FormatError> {
    let number = match value.table() {
        Ok(table) => table.get("value").or_else(|| table.get("about")).unwrap_or(*value),
        Err(_) => *value,
    };
    // Reading the number reports a missing entry.
    let Ok(text) = number.string() else {
        return if number.table().is_ok() {
            Err(measured(value, Dimension::LENGTH).err().unwrap_or_else(|| value.invalid("a number")))
        } else {
            Err(number.invalid("a string with a unit").with_hint("write \"0.2 m\""))
        };
    };
    let (_, found) = unit::measured(text).map_err(|error| number.error(FormatErrorKind::Unit(error)))?;
    UNITS.into_iter().find(|(dimension, _)| *dimension == found).ok_or_else(|| {
        number
            .invalid("a length, a stiffness (N m/rad), a mass or a moment of inertia")
            .with_hint("tests share no other kinds of numbers")
    })
}

/// Reads a direction and normalizes it.
pub(crate) fn unit_vector(value: &Value<'_>) -> Result<[f64; 3], FormatError> {
    let given: Direction<polhode::math::Body> = Direction::from_array(value.numbers()?);
    match given.direction() {
        Some(unit) => Ok(unit.to_array()),
        None => Err(value.invalid("a direction that is not zero").with_hint("write [0, 0, 1]")),
    }
}
