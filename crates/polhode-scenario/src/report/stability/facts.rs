//! Facts about the body, its wheels and its steady spins.

use std::f64::consts::TAU;

use polhode::observe::{DissipativeLimit, PermanentRotation, Stability};
use polhode_document::fact::{Fact, Facts, Quantity, object};
use polhode_document::finding;
use polhode_document::number::number;
use polhode_document::unit::time;
use polhode_shape::report::block;
use serde_json::{Map, Value, json};

use super::oscillations;
use super::words::{fact, torques};
use super::{Judged, StabilityReport};
use crate::report::VERSION;

/// Keys of the JSON that precede those of a time.
const KEYS: [&str; 5] = ["polhode", "source", "principal", "momentum", "findings"];

/// Keys of the JSON at each time.
const KEYS_AT: [&str; 7] = [
    "judged_at_s",
    "wheel_momentum_body",
    "permanent_rotations",
    "small_oscillations",
    "prevented_by",
    "small_oscillations_of_the_rest",
    "torques_that_do_not_act",
];

/// Returns the facts in sections, in the order of the text.
pub(crate) fn of(report: &StabilityReport) -> Vec<Facts> {
    let mut sections = vec![body(report)];
    sections.extend(report.judged.iter().flat_map(|judged| at(report, judged)));
    sections
}

/// Returns the JSON of the same facts; the keys of the first time are at the top level.
pub(crate) fn json(report: &StabilityReport) -> Value {
    let mut times = report.judged.iter().map(|judged| object(&KEYS_AT, &at(report, judged)));
    let mut all = object(&KEYS, &[body(report)]);
    all.extend(times.next().into_iter().flatten());
    all.extend(Map::from_iter([("later".to_owned(), times.map(Value::Object).collect())]));
    Value::Object(all)
}

fn body(report: &StabilityReport) -> Facts {
    let point = if report.rotor.is_pivoted() { "the pivot" } else { "the centre of mass" };
    let principal = report.rotor.principal();
    let moments = principal.moments().map(|moment| number(moment, 6)).join(", ") + "\u{a0}kg·m²";
    let start = match report.is_of_start {
        true => "as at the start".to_owned(),
        false => "1 rad/s about axis 3, as the start is at rest".to_owned(),
    };
    let momentum =
        fact("momentum", "|L| of the spins", Quantity::Number(report.momentum, "kg·m²/s")).note(start);
    let facts = vec![
        Fact::data("polhode", Value::from(VERSION)),
        Fact::data("source", report.source.to_json()),
        fact("principal", "principal moments", Quantity::Data(block::principal(principal), moments))
            .note(format!("of axes 1, 2 and 3, about {point}")),
        if report.judged.iter().all(|judged| judged.is_driven) { momentum.detail() } else { momentum },
        Fact::data("findings", finding::to_json(&report.findings)),
    ];
    Facts::new("Body", facts)
}

fn at(report: &StabilityReport, judged: &Judged) -> Vec<Facts> {
    let when = if report.judged.len() > 1 { format!(" {}", time_of(judged)) } else { String::new() };
    let section = |title: &str, facts| Facts::new(format!("{title}{when}"), facts);
    let mut spins = spins(report, judged);
    if judged.is_driven {
        spins = spins.into_iter().map(Fact::detail).collect();
    }
    let title = if judged.is_driven { "Steady spins without torques" } else { "Steady spins" };
    let mut sections = vec![section("Wheels", wheels(report, judged)), section(title, spins)];
    let prevented = judged.oscillations.as_ref().and_then(|found| found.as_ref().err());
    match &judged.oscillations {
        None => {}
        Some(Ok(found)) => {
            sections.extend(oscillations::facts("small_oscillations", "Small oscillations", &when, found));
        }
        Some(Err(prevented)) => sections.push(section("Equilibrium", oscillations::prevented(prevented))),
    }
    if let Some(rest) = prevented.and_then(|prevented| prevented.of_the_rest.as_ref()) {
        let title = "Small oscillations without that torque";
        sections.extend(oscillations::facts("small_oscillations_of_the_rest", title, &when, rest));
    }
    let idle = Quantity::Data(json!(judged.idle), torques(&judged.idle));
    let idle = fact("torques_that_do_not_act", "excluded", idle)
        .note(format!("not acting at t = {} s", number(judged.time, 6)))
        .shown_if(!judged.idle.is_empty());
    let by = prevented.is_none().then(|| Fact::data("prevented_by", json!([])));
    sections.push(section("Torques", by.into_iter().chain([idle]).collect()));
    sections
}

/// Describes the time: `at t = 0`, `from t = 25 s on`.
pub(crate) fn time_of(judged: &Judged) -> String {
    if judged.time > 0.0 {
        return format!("from t = {} s on", number(judged.time, 6));
    }
    "at t = 0".to_owned()
}

/// Returns the momentum of the wheels, and the times for which the other facts hold.
fn wheels(report: &StabilityReport, judged: &Judged) -> Vec<Fact> {
    let has_motor = report.rotor.wheels().iter().any(polhode::motion::Wheel::is_driven);
    let when = match () {
        () if report.is_always_driven => {
            format!("at t = {} s; a motor changes it at all times", number(judged.time, 6))
        }
        () if judged.time > 0.0 => format!("{}, after the last motor has stopped", time_of(judged)),
        () if report.judged.len() > 1 => "at t = 0, before a motor changes it".to_owned(),
        () if has_motor => "at t = 0, before a motor changes it; a motor never stops for good".to_owned(),
        () => "at all times".to_owned(),
    };
    let momentum = report.rotor.wheel_momentum(judged.time).to_array();
    vec![
        Fact::data("judged_at_s", Quantity::Duration(judged.time)),
        fact("wheel_momentum_body", "h", Quantity::Vector(momentum, "kg·m²/s"))
            .note(format!("in body axes {when}"))
            .shown_if(!report.rotor.wheels().is_empty()),
    ]
}

/// Returns the steady spins without torque, all with the same |L|.
fn spins(report: &StabilityReport, judged: &Judged) -> Vec<Fact> {
    let all = match &judged.rotations {
        Ok(all) => all,
        Err(_) if report.is_always_driven => {
            return vec![Fact::shown(
                "no steady spin",
                "the momentum of the wheels is never constant".to_owned(),
            )];
        }
        Err(error) => return vec![Fact::shown("no steady spin", error.to_string())],
    };
    let rows = all.iter().enumerate().map(|(k, one)| {
        let name = match report.rotor.wheels().is_empty() {
            true => is_forward(one).then(|| (axis_of(report, one) + 1).to_string()),
            false => Some((k + 1).to_string()),
        };
        Facts::new(name.unwrap_or_default(), spin(report, one))
    });
    let label = if report.rotor.wheels().is_empty() { "axis" } else { "spin" };
    vec![fact("permanent_rotations", label, Quantity::Table(rows.collect()))]
}

/// Returns true for one of two opposite spins.
fn is_forward(one: &PermanentRotation) -> bool {
    let largest = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
    one.omega.to_array().into_iter().fold(0.0, largest) > 0.0
}

/// Returns the index of the principal axis nearest to a spin.
pub(crate) fn axis_of(report: &StabilityReport, one: &PermanentRotation) -> usize {
    let along = (report.rotor.principal().rotation().inverse() * one.omega).to_array();
    let largest = along.iter().enumerate().max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
    largest.map_or(0, |(k, _)| k)
}

fn spin(report: &StabilityReport, one: &PermanentRotation) -> Vec<Fact> {
    let (frequency, growth_rate) = match one.stability {
        Stability::Stable { frequency, .. } => (Some(frequency), None),
        Stability::Unstable { growth_rate, .. } => (None, Some(growth_rate)),
        _ => (None, None),
    };
    let limit = report.sink.map(|sink| one.with_friction(&sink));
    let name = one.stability.name();
    let condition = if report.sink.is_none() && needs_no_friction(one) { " without dissipation" } else { "" };
    let label = if report.sink.is_some() { "without friction" } else { "stability" };
    let number = |value: Option<f64>, unit| value.map(|x| Quantity::Number(x, unit));
    let energy = report.rotor.kinetic_energy(one.omega);
    vec![
        fact("omega_body", "ω in body axes", Quantity::Vector(one.omega.to_array(), "rad/s")),
        Fact::data("momentum_body", Quantity::Vector(one.momentum.to_array(), "kg·m²/s")),
        fact("kinetic_energy_j", "T", Quantity::Energy(energy)).detail(),
        fact("stability", label, Quantity::Word(name, format!("{name}{condition}"))),
        fact("frequency", "frequency", number(frequency, "rad/s")).detail(),
        fact("", "oscillation period", frequency.map(|rate| Quantity::Duration(TAU / rate))),
        fact("growth_rate", "growth rate", number(growth_rate, "/s")),
        Fact::data("ended_by_friction", Value::from(one.is_ended_by_friction())),
        fact("with_sink", "with friction", limit.map(|limit| Quantity::Word(limit.name(), in_words(limit)))),
        Fact::data("with_sink_rate", limit.and_then(signed_rate).map(|rate| Quantity::Number(rate, "/s"))),
    ]
}

/// Returns the growth rate of a deviation under friction, 1/s; negative for decay.
fn signed_rate(limit: DissipativeLimit) -> Option<f64> {
    match limit {
        DissipativeLimit::Leaves { rate, .. } => Some(rate),
        DissipativeLimit::Settles { rate, .. } => Some(-rate),
        _ => None,
    }
}

fn in_words(limit: DissipativeLimit) -> String {
    match limit {
        DissipativeLimit::Leaves { rate, .. } => format!("unstable, e-folding time {}", time(1.0 / rate, 6)),
        DissipativeLimit::Settles { rate, .. } => format!("stable, time constant {}", time(1.0 / rate, 6)),
        _ => "as without".to_owned(),
    }
}

/// Returns true for a spin that is stable only without internal friction.
pub(crate) fn needs_no_friction(one: &PermanentRotation) -> bool {
    matches!(one.stability, Stability::Stable { .. }) && one.is_ended_by_friction()
}
