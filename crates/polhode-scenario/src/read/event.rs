//! `[[event]]`: events to detect during the motion.

use std::f64::consts::PI;

use polhode::math::Direction;
use polhode::motion::{Event, EventAction, Measure, Reference, Sense};
use polhode_source::expression::formula_of_state;
use polhode_source::nearest;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::{Dimension, UnitError};
use polhode_source::{FormatError, FormatErrorKind};

use super::pointing::{NAMED, References, direction};
use super::torque::Torques;

/// Names of measures in a file.
const MEASURES: [&str; 16] = [
    "time",
    "omega_body_x",
    "omega_body_y",
    "omega_body_z",
    "omega_space_x",
    "omega_space_y",
    "omega_space_z",
    "omega",
    "momentum",
    "kinetic_energy",
    "total_energy",
    "angle",
    "nutation",
    "precession",
    "spin",
    "formula",
];

/// Reads all events; torques to switch are identified by name.
pub(crate) fn events(
    root: &Table<'_>,
    torques: &Torques,
    references: &References<'_>,
) -> Result<Vec<Event>, FormatError> {
    let list = root.get("event").filter(|_| root.get("run").is_none());
    if let Some(list) = list {
        let hint =
            "an event needs a run: add [run] with duration = \"10 s\" and samples = 101, or delete [[event]]";
        return Err(list.invalid("used with [run]").with_hint(hint));
    }
    events_of(root, torques, references)
}

/// Reads all events of bodies whose run is defined elsewhere.
pub(crate) fn events_of(
    root: &Table<'_>,
    torques: &Torques,
    references: &References<'_>,
) -> Result<Vec<Event>, FormatError> {
    let Some(list) = root.get("event") else { return Ok(Vec::new()) };
    list.tables("event")?.iter().enumerate().map(|(k, table)| event(k, table, torques, references)).collect()
}

/// Reads `name`, `measure`, `value`, `direction`, `then`.
fn event(
    index: usize,
    table: &Table<'_>,
    torques: &Torques,
    references: &References<'_>,
) -> Result<Event, FormatError> {
    let given = table.require("measure", "measure = \"omega_body_z\"")?;
    let name = given.choice(&MEASURES)?;
    let (measure, dimension) = match name {
        "angle" => {
            table.allow(&["name", "measure", "between", "value", "direction", "then"])?;
            (angle(table, references)?, Dimension::ANGLE)
        }
        "formula" => {
            table.allow(&["name", "measure", "formula", "value", "direction", "then"])?;
            formula(table)?
        }
        _ => {
            table.allow(&["name", "measure", "value", "direction", "then"])?;
            plain(name)
        }
    };
    let given_value = table.require("value", "value = \"3 rad/s\"")?;
    let value = match measure {
        Measure::KineticEnergy | Measure::TotalEnergy => energy(&given_value)?,
        // A dimensionless value may be an angle, such as that of acos.
        Measure::Formula(_) if dimension == Dimension::NONE => given_value
            .quantity(dimension)
            .or_else(|error| given_value.quantity(Dimension::ANGLE).map_err(|_| error))?,
        _ => given_value.quantity(dimension)?,
    };
    let between = matches!(name, "angle" | "nutation");
    if between && !(value > 0.0 && value < PI) {
        let hint =
            "this angle reaches 0 and 180 deg without crossing them: measure from a perpendicular direction";
        return Err(given_value.invalid("above 0 and below 180 deg").with_hint(hint));
    }
    let sense = match table
        .get("direction")
        .map(|value| value.choice(&["rising", "falling", "either"]))
        .transpose()?
    {
        Some("rising") => Sense::Rising,
        Some("falling") => Sense::Falling,
        _ => Sense::Either,
    };
    let action = table.get("then").map_or(Ok(EventAction::Record), |value| action(&value, torques))?;
    let name = match table.get("name") {
        Some(name) => name.string()?.to_owned(),
        None => format!("event {}", index + 1),
    };
    Event::new(name, measure, value, sense, action).map_err(|error| given_value.motion(error))
}

/// Reads an energy, which has the dimension of a torque.
fn energy(value: &Value<'_>) -> Result<f64, FormatError> {
    value.quantity(Dimension::TORQUE).map_err(|error| match error.kind() {
        FormatErrorKind::Unit(UnitError::WrongDimension { .. }) => {
            value.invalid("an energy").with_hint("write an energy, such as \"3 J\"")
        }
        _ => error,
    })
}

/// Returns a measure that needs only its name, with its dimension.
fn plain(name: &str) -> (Measure, Dimension) {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let body = |n| (Measure::OmegaBody(Direction::from_array(n)), Dimension::ANGULAR_VELOCITY);
    let space = |n| (Measure::OmegaSpace(Direction::from_array(n)), Dimension::ANGULAR_VELOCITY);
    match name {
        "omega_body_x" => body(x),
        "omega_body_y" => body(y),
        "omega_body_z" => body(z),
        "omega_space_x" => space(x),
        "omega_space_y" => space(y),
        "omega_space_z" => space(z),
        "omega" => (Measure::Rate, Dimension::ANGULAR_VELOCITY),
        "momentum" => (Measure::Momentum, Dimension::ANGULAR_MOMENTUM),
        // Energy and torque have the same dimension in SI.
        "kinetic_energy" => (Measure::KineticEnergy, Dimension::TORQUE),
        "total_energy" => (Measure::TotalEnergy, Dimension::TORQUE),
        "nutation" => (Measure::Nutation, Dimension::ANGLE),
        "precession" => (Measure::Precession, Dimension::ANGLE),
        "spin" => (Measure::Spin, Dimension::ANGLE),
        _ => (Measure::Time, Dimension::TIME),
    }
}

/// Reads `between = [what, { body = [3] }]`. The first element is `"omega"`, `"momentum"`, a named
/// direction, or `{ space = [3] }`; the order is arbitrary.
fn angle(table: &Table<'_>, references: &References<'_>) -> Result<Measure, FormatError> {
    let example = "between = [{ body = [0, 0, 1] }, { space = [0, 0, 1] }]";
    let value = table.require("between", example)?;
    let [first, second] = value.fixed("directions")?;
    let [first, second] = [Line::read(&first, references)?, Line::read(&second, references)?];
    Ok(match (first, second) {
        (Line::Body(body), Line::Space(space)) | (Line::Space(space), Line::Body(body)) => {
            Measure::Tilt { body, space }
        }
        (Line::Omega, Line::Body(body)) | (Line::Body(body), Line::Omega) => Measure::OmegaAngle(body),
        (Line::Momentum, Line::Body(body)) | (Line::Body(body), Line::Momentum) => {
            Measure::MomentumAngle(body)
        }
        _ => {
            let rule = "a direction of the body, and one of space, \"nadir\", \"velocity\", \"orbit_normal\", \"field\", \"omega\" or \"momentum\"";
            return Err(value.invalid(rule).with_hint(format!("write {example}")));
        }
    })
}

/// Reads `formula = "…"`, a formula of the state; returns it with the dimension of its value.
fn formula(table: &Table<'_>) -> Result<(Measure, Dimension), FormatError> {
    let value = table.require("formula", "formula = \"hypot(wx, wy)\"")?;
    let (formula, dimension) = formula_of_state(value.string()?, None).map_err(|error| {
        let fail = value.invalid(format!("a formula of the state ({error})"));
        match error.hint() {
            Some(hint) => fail.with_hint(hint),
            None => fail,
        }
    })?;
    Ok((Measure::Formula(formula), dimension))
}

/// One side of an angle.
enum Line {
    Body(Direction<polhode::math::Body>),
    Space(Reference),
    Omega,
    Momentum,
}

impl Line {
    fn read(value: &Value<'_>, references: &References<'_>) -> Result<Self, FormatError> {
        if value.string().is_ok() {
            let names = ["omega", "momentum"].into_iter().chain(NAMED).collect::<Vec<_>>();
            return Ok(match value.choice(&names)? {
                "omega" => Self::Omega,
                "momentum" => Self::Momentum,
                name => Self::Space(references.named(value, name)?),
            });
        }
        let table = value.table()?;
        table.allow(&["body", "space"])?;
        let Some(given) =
            table.at_most_one(&["body", "space"], "a direction is fixed either in the body or in space")?
        else {
            return Err(table.missing("body", "{ body = [0, 0, 1] }"));
        };
        Ok(match given.key() {
            "body" => Self::Body(direction(&given)?),
            _ => Self::Space(Reference::Space(direction(&given)?)),
        })
    }
}

/// Reads `"record"`, `"stop"` or `{ switch = "a torque", on = false }`.
fn action(value: &Value<'_>, torques: &Torques) -> Result<EventAction, FormatError> {
    if value.string().is_ok() {
        return Ok(match value.choice(&["record", "stop"])? {
            "stop" => EventAction::Stop,
            _ => EventAction::Record,
        });
    }
    let table = value.table()?;
    table.allow(&["switch", "on"])?;
    let torque = table.require("switch", "{ switch = \"thruster\", on = false }")?;
    let on = table.require("on", "{ switch = \"thruster\", on = false }")?.boolean()?;
    let name = torque.string()?;
    match torques.names.iter().position(|other| other.as_deref() == Some(name)) {
        Some(torque) => Ok(EventAction::Switch { torque, on }),
        None => {
            let known: Vec<&str> = torques.names.iter().flatten().map(String::as_str).collect();
            let hint = match (known.is_empty(), nearest(name, known.iter().copied())) {
                (true, _) => format!("give the [[torque]] name = \"{name}\""),
                (false, Some(near)) => format!("did you mean \"{near}\"?"),
                (false, None) => format!("the names are {}", known.join(", ")),
            };
            Err(torque.invalid("the name of a torque").with_hint(hint))
        }
    }
}
