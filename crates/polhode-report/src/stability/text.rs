//! Stability on one screen.

use std::f64::consts::TAU;

use polhode::{MotionError, OscillationMode, PermanentRotation, Stability};

use super::{Found, Place, StabilityReport};
use crate::finding;
use crate::layout::{columns, labelled, plain_spaces};
use crate::number::{alike, number, tidy_beside, vector};

pub(super) fn write(report: &StabilityReport) -> String {
    let mut text = report.source.heading() + "\n";
    let point = if report.rotor.is_pivoted() { "the pivot" } else { "the centre of mass" };
    let moments = alike(&report.rotor.principal().moments(), 7).join(", ");
    text.push_str(&labelled("moments", &format!("{moments} kg·m², about {point}")));
    let wheels = report.rotor.wheel_momentum(0.0).to_array();
    if wheels != [0.0; 3] {
        text.push_str(&labelled(
            "wheels",
            &format!("h = {} kg·m²/s at t = 0, in body axes", vector(wheels, 6)),
        ));
    }
    text.push_str(&rotations(report));
    match &report.oscillations {
        None => {}
        Some(Err(error)) => text.push_str(&labelled("small swings", &no_equilibrium(error))),
        Some(Ok(found)) => text.push_str(&oscillations(found)),
    }
    text.push_str(&finding::to_text(&report.findings));
    plain_spaces(&text)
}

/// What no torque changes: the steady spins with one angular momentum.
fn rotations(report: &StabilityReport) -> String {
    let of = if report.is_of_start { "as at the start" } else { "the start is at rest" };
    let all = match &report.rotations {
        Err(error) => return labelled("permanent", &format!("no rotation: {error}")),
        Ok(all) => all,
    };
    let size = number(report.momentum, 6);
    let head = format!("rotations without torque that have |L| = {size} kg·m²/s ({of}), in body axes:");
    let rows: Vec<Vec<String>> = all.iter().map(rotation).collect();
    labelled("permanent", &head) + &indented(&rows)
}

fn rotation(rotation: &PermanentRotation) -> Vec<String> {
    let omega = rotation.omega.to_array();
    let shown = vector(tidy_beside(omega, rotation.omega.norm()), 6);
    let what = match rotation.stability {
        Stability::Stable { frequency, .. } => {
            format!("stable: a departure goes round it in {} s", number(TAU / frequency, 6))
        }
        Stability::Unstable { growth_rate, .. } => {
            format!("unstable: a departure grows at {} /s", number(growth_rate, 6))
        }
        _ => "marginal: a departure is neither held nor does it grow exponentially".to_owned(),
    };
    vec![format!("ω = {shown} rad/s"), what]
}

fn no_equilibrium(error: &MotionError) -> String {
    format!("no equilibrium near the start: {error}")
}

fn oscillations(found: &Found) -> String {
    let away = number(found.turned.to_degrees(), 4);
    let place = match found.place {
        Place::Start => "about the start, which is an equilibrium".to_owned(),
        Place::Nearest => format!("about the nearest equilibrium, {away}° from the start"),
        Place::Rest => format!(
            "about the nearest equilibrium at rest, without the start's spin, {away}° from its attitude"
        ),
    };
    let oscillations = &found.oscillations;
    let verdict = if oscillations.is_stable() { "nothing grows" } else { "unstable" };
    let mut text = labelled("small swings", &format!("{place}: {verdict}"));
    let rows: Vec<Vec<String>> = oscillations.modes.iter().map(mode).collect();
    text.push_str(&indented(&rows));
    if oscillations.neutral > 0 {
        let line = format!(
            "{} of 6 rates are zero: the body can be turned, or made to turn on, without a torque",
            oscillations.neutral
        );
        text.push_str(&labelled("neutral", &line));
    }
    text
}

fn mode(mode: &OscillationMode) -> Vec<String> {
    let period = if mode.frequency > 0.0 {
        format!("{} rad/s, period {} s", number(mode.frequency, 7), number(TAU / mode.frequency, 7))
    } else {
        "no swing".to_owned()
    };
    let rate = match mode.growth_rate {
        rate if rate > 0.0 => format!("grows at {} /s", number(rate, 6)),
        rate if rate < 0.0 => format!("dies away at {} /s", number(-rate, 6)),
        _ => "kept".to_owned(),
    };
    let about = |v: [f64; 3]| vector(tidy(v), 4);
    let axis = about(mode.axis.to_array());
    let shape = if mode.minor_axis.norm() < STRAIGHT {
        format!("about {axis}")
    } else {
        format!("on a cone: about {axis}, then {}", about(mode.minor_axis.to_array()))
    };
    vec![period, rate, shape]
}

/// A swing whose ellipse is thinner than this is about one axis.
const STRAIGHT: f64 = 1e-6;

/// Components of a unit vector without what its four digits do not show.
fn tidy(v: [f64; 3]) -> [f64; 3] {
    v.map(|x| if x.abs() < 5e-7 { 0.0 } else { x })
}

fn indented(rows: &[Vec<String>]) -> String {
    columns(rows).iter().map(|line| format!("  {line}\n")).collect()
}
