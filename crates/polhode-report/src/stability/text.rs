//! Stability on one screen.

mod equilibrium;

use std::f64::consts::TAU;

use polhode::motion::MotionError;
use polhode::observe::{DissipativeLimit, PermanentRotation, Stability};
use polhode_document::finding;
use polhode_document::layout::{columns, labelled, plain_spaces};
use polhode_document::number::{number, tidy_beside, vector};

use super::search::Prevented;
use super::{Judged, StabilityReport};

pub(super) fn write(report: &StabilityReport) -> String {
    let mut text = report.source.heading() + "\n";
    let point = if report.rotor.is_pivoted() { "the pivot" } else { "the centre of mass" };
    let moments = report.rotor.principal().moments().map(|moment| number(moment, 7)).join(", ");
    text.push_str(&labelled("moments", &format!("{moments} kg·m², about {point}")));
    for (k, judged) in report.judged.iter().enumerate() {
        text.push_str(&wheels(report, judged, k));
        text.push_str(&rotations(report, judged));
        match &judged.oscillations {
            None => {}
            Some(Err(prevented)) => text.push_str(&no_equilibrium(prevented)),
            Some(Ok(found)) => text.push_str(&equilibrium::write(found)),
        }
        if !judged.idle.is_empty() {
            let time = number(judged.time, 6);
            let line = format!("left out, as it does not act at t = {time} s: {}", listed(&judged.idle));
            text.push_str(&labelled("idle", &line));
        }
    }
    text.push_str(&finding::to_text(&report.findings));
    plain_spaces(&text)
}

/// The wheels' momentum, and for which times what follows holds.
fn wheels(report: &StabilityReport, judged: &Judged, k: usize) -> String {
    if report.rotor.wheels().is_empty() {
        return String::new();
    }
    let time = number(judged.time, 6);
    let (is_only, is_first) = (report.judged.len() == 1, k == 0);
    let when = match () {
        () if report.is_always_driven => format!("at t = {time} s, and a motor changes it all the time"),
        () if judged.time > 0.0 => format!("from t = {time} s on, when the last motor has stopped"),
        () if is_first && !is_only => "at t = 0, before a motor changes it".to_owned(),
        () if report.rotor.wheels().iter().any(polhode::motion::Wheel::is_driven) => {
            "at t = 0, before a motor changes it; the motors never stop for good".to_owned()
        }
        () => "at all times".to_owned(),
    };
    let h = report.rotor.wheel_momentum(judged.time).to_array();
    labelled("wheels", &format!("h = {} kg·m²/s in body axes {when}", vector(h, 6)))
}

/// What no torque changes: the steady spins with one angular momentum.
fn rotations(report: &StabilityReport, judged: &Judged) -> String {
    let of = if report.is_of_start { "as at the start" } else { "the start is at rest" };
    let all = match &judged.rotations {
        Err(_) if report.is_always_driven => {
            let why = "no rotation: the momentum of the wheels is never constant, so that no spin stays";
            return labelled("permanent", why);
        }
        Err(error) => return labelled("permanent", &format!("no rotation: {error}")),
        Ok(all) => all,
    };
    let size = number(report.momentum, 6);
    let head = format!("rotations without torque that have |L| = {size} kg·m²/s ({of}), in body axes:");
    let rows: Vec<Vec<String>> = all.iter().map(|one| rotation(report, one)).collect();
    labelled("permanent", &head) + &indented(&rows) + &friction(report, judged, all)
}

fn rotation(report: &StabilityReport, rotation: &PermanentRotation) -> Vec<String> {
    let omega = rotation.omega.to_array();
    let shown = vector(tidy_beside(omega, rotation.omega.norm()), 6);
    let mut row = vec![format!("ω = {shown} rad/s")];
    let Some(sink) = report.sink else {
        row.push(match rotation.stability {
            Stability::Stable { frequency, .. } => {
                let period = number(TAU / frequency, 6);
                match (needs_no_friction(rotation), report.rotor.wheels().is_empty()) {
                    (false, _) => format!("stable: a departure goes round it in {period} s"),
                    (true, true) => {
                        format!("minor-axis spin: stable only without dissipation; once round in {period} s")
                    }
                    (true, false) => format!("stable only without dissipation; once round in {period} s"),
                }
            }
            Stability::Unstable { growth_rate, .. } => {
                format!("unstable: a departure grows at {} /s", number(growth_rate, 6))
            }
            _ => "marginal: a departure is neither held nor does it grow exponentially".to_owned(),
        });
        return row;
    };
    row.push(match rotation.stability {
        Stability::Stable { frequency, .. } => {
            format!("stable without friction: once round in {} s", number(TAU / frequency, 6))
        }
        Stability::Unstable { growth_rate, .. } => {
            format!("unstable without friction: grows at {} /s", number(growth_rate, 6))
        }
        _ => "marginal without friction".to_owned(),
    });
    row.push(match rotation.with_friction(&sink) {
        DissipativeLimit::Leaves { rate, .. } => {
            format!("with the sink drifts away: e-fold in {} s", number(1.0 / rate, 6))
        }
        DissipativeLimit::Settles { rate, .. } => {
            format!("with the sink settles: 1/e in {} s", number(1.0 / rate, 6))
        }
        _ => "with the sink as without".to_owned(),
    });
    row
}

/// Where friction inside leads, or would lead.
fn friction(report: &StabilityReport, judged: &Judged, all: &[PermanentRotation]) -> String {
    let Some(least) = all.first() else { return String::new() };
    let omega = vector(tidy_beside(least.omega.to_array(), least.omega.norm()), 6);
    let energy = number(report.rotor.kinetic_energy(least.omega), 6);
    let such = if least.stability == Stability::Marginal { "such as" } else { "as" };
    match report.sink {
        Some(_) => labelled(
            "friction",
            &format!(
                "inside takes energy and leaves |L|: what drifts away ends in a spin that settles, {such} ω = {omega} rad/s, of least \
                 energy, T = {energy} J"
            ),
        ),
        // Of a body on which torques act, |L| does not stay.
        None if judged.oscillations.is_none() && all.iter().any(needs_no_friction) => {
            let what = match report.rotor.wheels().is_empty() {
                true => {
                    format!("minor-axis spin ends in a flat spin at {} rad/s", number(least.omega.norm(), 6))
                }
                false => "spin of most energy ends in that of least energy".to_owned(),
            };
            labelled(
                "dissipation",
                &format!("with any inside the body, the {what}, {such} ω = {omega} rad/s"),
            )
        }
        None => String::new(),
    }
}

/// Stable, but not with any friction inside.
fn needs_no_friction(one: &PermanentRotation) -> bool {
    matches!(one.stability, Stability::Stable { .. }) && one.is_ended_by_friction()
}

/// Why there is no equilibrium, and what there is without what prevents it.
fn no_equilibrium(prevented: &Prevented) -> String {
    let left = match &prevented.error {
        MotionError::NotSteady { torque, scale } => {
            let (torque, scale) = (number(*torque, 4), number(*scale, 4));
            format!("of torques of {scale} N·m in all, {torque} N·m is left over")
        }
        error => error.to_string(),
    };
    let why = match prevented.by.as_slice() {
        [] => "no equilibrium near the start".to_owned(),
        by => format!("no equilibrium near the start: {} prevents it", listed(by)),
    };
    let why = format!("{why}; {left}");
    let rest = prevented
        .of_the_rest
        .as_ref()
        .map(|rest| labelled("without", &format!("{}:", listed(&prevented.by))) + &equilibrium::write(rest));
    labelled("small swings", &why) + &rest.unwrap_or_default()
}

/// `the torque "wind" and the torque "drag"`
fn listed(names: &[String]) -> String {
    names.iter().map(|name| format!("the torque \"{name}\"")).collect::<Vec<_>>().join(" and ")
}

fn indented(rows: &[Vec<String>]) -> String {
    columns(rows).iter().map(|line| format!("  {line}\n")).collect()
}
