//! Table `[swing]`: periods of a body on wires or about an axis.

mod log;
mod number;
mod rig;

use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::read_log::ReadLog;
use crate::swing::{
    AmplitudeReading, Counted, Damping, Interval, Measured, Measurement, SwingPlan, SwingTest,
};
use number::{Numbers, measured};

/// Reads the table `[swing]`.
pub(crate) fn plan(table: &Table<'_>, logs: &mut Vec<ReadLog>) -> Result<SwingPlan, FormatError> {
    table.allow(&["mass", "center", "gravity", "numbers", "test"])?;
    let mass = table.require("mass", "mass = { value = \"3.2 kg\", sd = \"1 g\" }")?;
    let mass_measured = measured(&mass, Dimension::MASS)?;
    if !(mass_measured.value > 0.0) {
        return Err(mass.invalid("above zero"));
    }
    let center =
        table.require("center", "center = [\"1.2 mm\", 0, { value = \"31 mm\", sd = \"0.3 mm\" }]")?;
    let center = self::center(&center)?;
    let mut plan = SwingPlan::new(mass_measured, center);
    if let Some(value) = table.get("gravity") {
        let gravity = measured(&value, Dimension::ACCELERATION)?;
        if !(gravity.value > 0.0) {
            return Err(value.invalid("above zero"));
        }
        plan = plan.with_gravity(gravity);
    }
    let named = table.get("numbers").map(|numbers| numbers.table()).transpose()?;
    let mut numbers = Numbers::new(plan, named.as_ref())?;
    let tests = table.require("test", "[[swing.test]], with rig = \"bifilar\"")?;
    let mut names: Vec<&str> = Vec::new();
    for test in tests.tables("swing.test")? {
        let value = test.require("name", "name = \"about x\"")?;
        let name = value.string()?;
        if names.contains(&name) {
            return Err(value.invalid("different from the names of the other tests"));
        }
        names.push(name);
        let made = self::test(&test, name, &mut numbers, logs)?;
        rig::hangs(&test, &made, center)?;
        numbers.plan.add(made);
    }
    if names.is_empty() {
        return Err(tests.invalid("at least one test"));
    }
    let is_upright = |test: &Table<'_>| Ok(test.require("rig", "")?.string()? == "spindle");
    if let Some(gravity) = table.get("gravity")
        && tests
            .tables("swing.test")?
            .iter()
            .map(is_upright)
            .collect::<Result<Vec<_>, _>>()?
            .iter()
            .all(|is| *is)
    {
        return Err(gravity.invalid("omitted: the weight has no effect on swings about vertical axes"));
    }
    numbers.all_used()?;
    Ok(numbers.plan)
}

fn center(value: &Value<'_>) -> Result<[Measured; 3], FormatError> {
    let mut center = [Measured::exact(0.0); 3];
    for (slot, element) in center.iter_mut().zip(value.fixed::<3>("lengths")?) {
        *slot = measured(&element, Dimension::LENGTH)?;
    }
    Ok(center)
}

/// Reads a table `[[swing.test]]`.
fn test<'a>(
    table: &Table<'a>,
    name: &str,
    numbers: &mut Numbers<'a>,
    logs: &mut Vec<ReadLog>,
) -> Result<SwingTest, FormatError> {
    let (rig, body) = rig::rig(table, name, numbers)?;
    let fixture = rig::fixture(table, name, numbers)?;
    if let (None, None, Some(value)) = (&body, &fixture, table.get("body")) {
        return Err(value.invalid("true, unless the test has a fixture = { ... }"));
    }
    let air = rig::air(table, name, numbers)?;
    let given = table.at_most_one(&["counted", "logged"], "a test has either counted swings or a log")?;
    if let Some(logged) = given.filter(|given| given.key() == "logged") {
        let (logged, read) = log::logged(&logged)?;
        logs.extend(read);
        let measurement = Measurement::Logged(logged);
        return Ok(SwingTest { name: name.to_owned(), body, fixture, rig, air, measurement });
    }
    let counted = table.require(
        "counted",
        "counted = { swings = 20, time = \"31.4 s\", sd = \"0.05 s\", amplitude = [\"12 deg\", \"9 deg\"], amplitude_sd = \"0.5 deg\" }",
    )?;
    let measurement = Measurement::Counted(self::counted(&counted)?);
    Ok(SwingTest { name: name.to_owned(), body, fixture, rig, air, measurement })
}

/// Upper bound on the number of swings.
const MOST_SWINGS: f64 = 1e9;

/// Reads `counted = { swings, time, sd, amplitude, amplitude_sd, damping }`.
fn counted(value: &Value<'_>) -> Result<Counted, FormatError> {
    let table = value.table()?;
    table.allow(&["swings", "time", "sd", "amplitude", "amplitude_sd", "damping"])?;
    let counted = table.require("swings", "swings = 20")?;
    let swings = counted.positive(Dimension::NONE)?;
    if swings.fract() != 0.0 || swings > MOST_SWINGS {
        let rule = "a whole number of swings, up to a billion";
        return Err(counted.invalid(rule).with_hint("count full periods, to and fro"));
    }
    let time =
        table.require("time", "time = \"31.42 s\", of all swings together")?.positive(Dimension::TIME)?;
    let time_sd =
        table.require("sd", "sd = \"0.05 s\", of the time of all swings")?.positive(Dimension::TIME)?;
    let sd = table.require("amplitude_sd", "amplitude_sd = \"0.5 deg\"")?.positive(Dimension::ANGLE)?;
    let given =
        table.require("amplitude", "amplitude = [\"12 deg\", \"9 deg\"], at the beginning and at the end")?;
    let amplitudes = amplitudes(&given, swings, sd)?;
    let damping = table.get("damping").map_or(Ok(Damping::Viscous), |value| self::damping(&value))?;
    let needed = match damping {
        Damping::None => 1,
        Damping::Viscous | Damping::Quadratic => 2,
        Damping::Both => 3,
    };
    if amplitudes.len() < needed {
        let error = given.invalid(format!("at least {needed} amplitudes, to determine the damping"));
        return Err(error.with_hint("if damping is negligible, one is enough: damping = \"none\""));
    }
    let intervals = vec![Interval { from: 0.0, to: swings, time, sd: time_sd }];
    Ok(Counted { intervals, amplitudes, damping })
}

fn damping(value: &Value<'_>) -> Result<Damping, FormatError> {
    Ok(match value.choice(&["none", "viscous", "quadratic", "both"])? {
        "none" => Damping::None,
        "viscous" => Damping::Viscous,
        "quadratic" => Damping::Quadratic,
        _ => Damping::Both,
    })
}

/// Reads amplitudes: one for the middle; two for the beginning and the end; or
/// `{ after = 10, value = "11 deg" }` for any count.
fn amplitudes(value: &Value<'_>, swings: f64, sd: f64) -> Result<Vec<AmplitudeReading>, FormatError> {
    let reading = |at, value: &Value<'_>| {
        value.positive(Dimension::ANGLE).map(|amplitude| AmplitudeReading { at, amplitude, sd })
    };
    if !value.is_array() {
        return Ok(vec![reading(0.5 * swings, value)?]);
    }
    let all = value.elements("an array of amplitudes")?;
    match &all[..] {
        [first, last] if first.table().is_err() && last.table().is_err() => {
            return Ok(vec![reading(0.0, first)?, reading(swings, last)?]);
        }
        [] => return Err(value.invalid("at least one amplitude")),
        _ => {}
    }
    let one = |element: &Value<'_>| {
        let table = element.table().map_err(|error| {
            error.with_hint("two amplitudes are at the beginning and at the end; for others, state the count: { after = 10, value = \"11 deg\" }")
        })?;
        table.allow(&["after", "value"])?;
        let after = table.require("after", "after = 10, in swings")?;
        let at = after.number()?;
        if !(at >= 0.0 && (2.0 * at).fract() == 0.0) {
            let rule = "a number of whole or half swings, zero or more";
            return Err(after
                .invalid(rule)
                .with_hint("amplitudes are read at the turning points of the swing"));
        }
        reading(at, &table.require("value", "value = \"11 deg\"")?)
    };
    all.iter().map(one).collect()
}
