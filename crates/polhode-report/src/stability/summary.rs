//! Stability as JSON.

use polhode::observe::{
    DissipativeLimit, OrbitalEquilibrium, OscillationMode, PermanentRotation, SmallOscillations, Stability,
    SteadyTop,
};
use polhode_document::finding;
use polhode_document::json::{numbers, vector};
use serde_json::{Value, json};

use super::search::{Found, Place};
use super::{Judged, StabilityReport};
use crate::{VERSION, block};

pub(super) fn of(report: &StabilityReport) -> Value {
    let mut later = report.judged.iter().map(|judged| at(report, judged));
    let mut object = json!({
        "polhode": VERSION,
        "source": report.source.to_json(),
        "principal": block::principal(report.rotor.principal()),
        "momentum": report.momentum,
        "findings": finding::to_json(&report.findings),
    });
    if let (Some(object), Some(Value::Object(first))) = (object.as_object_mut(), later.next()) {
        object.extend(first);
        object.insert("later".to_owned(), later.collect());
    }
    object
}

/// What lasts while the wheels have the momentum of one time.
fn at(report: &StabilityReport, judged: &Judged) -> Value {
    let rotations = judged.rotations.as_ref().ok();
    let oscillations = judged.oscillations.as_ref().and_then(|found| found.as_ref().ok());
    let prevented = judged.oscillations.as_ref().and_then(|found| found.as_ref().err());
    let rotation = |one: &PermanentRotation| rotation(report, one);
    json!({
        "judged_at_s": judged.time,
        "wheel_momentum_body": vector(report.rotor.wheel_momentum(judged.time)),
        "permanent_rotations": rotations.map(|all| all.iter().map(rotation).collect::<Value>()),
        "small_oscillations": oscillations.map(small),
        "prevented_by": prevented.map_or(&[][..], |prevented| &prevented.by),
        "small_oscillations_of_the_rest": prevented.and_then(|p| p.of_the_rest.as_ref()).map(small),
        "torques_that_do_not_act": judged.idle,
    })
}

fn rotation(report: &StabilityReport, rotation: &PermanentRotation) -> Value {
    let (frequency, growth_rate) = match rotation.stability {
        Stability::Stable { frequency, .. } => (Some(frequency), None),
        Stability::Unstable { growth_rate, .. } => (None, Some(growth_rate)),
        _ => (None, None),
    };
    let settling = report.sink.map(|sink| rotation.with_friction(&sink));
    json!({
        "omega_body": vector(rotation.omega),
        "momentum_body": vector(rotation.momentum),
        "kinetic_energy_j": report.rotor.kinetic_energy(rotation.omega),
        "stability": rotation.stability.name(),
        "frequency": frequency,
        "growth_rate": growth_rate,
        "ended_by_friction": rotation.is_ended_by_friction(),
        "with_sink": settling.map(DissipativeLimit::name),
        "with_sink_rate": settling.and_then(|settling| match settling {
            DissipativeLimit::Leaves { rate, .. } => Some(rate),
            DissipativeLimit::Settles { rate, .. } => Some(-rate),
            _ => None,
        }),
    })
}

fn small(found: &Found) -> Value {
    let equilibrium = &found.oscillations.equilibrium;
    let (top, upright) = match &found.place {
        Place::Top(top, other) => (Some(steady_top(top)), other.as_deref().map(steady_top)),
        _ => (None, None),
    };
    json!({
        "equilibrium": match found.place {
            Place::Start => "start",
            Place::Orbit(_) => "on_orbit",
            Place::Top(..) => "top",
            Place::Nearest => "nearest",
            Place::Vertical => "nearest_about_the_vertical",
            Place::Rest => "nearest_at_rest",
        },
        "turned_from_start": found.turned,
        "omega_from_start": found.omega_off,
        "attitude_wxyz": numbers(&equilibrium.attitude.canonical_quaternion()),
        "omega_body": vector(equilibrium.omega),
        "stable": found.oscillations.is_stable(),
        "neutral": found.oscillations.neutral,
        "modes": modes(&found.oscillations),
        "top": top,
        "other_top": upright,
        "on_orbit": found.on_orbit.iter().map(on_orbit).collect::<Value>(),
    })
}

fn modes(oscillations: &SmallOscillations) -> Value {
    oscillations.modes.iter().map(mode).collect()
}

fn steady_top(top: &SteadyTop) -> Value {
    json!({
        "path": top.path.name(),
        "nutation_rad": top.angle,
        "precession_rad_s": top.precession,
        "spin_rad_s": top.spin,
        "stable": top.oscillations.is_stable(),
        "modes": modes(&top.oscillations),
    })
}

fn on_orbit((equilibrium, oscillations): &(OrbitalEquilibrium, SmallOscillations)) -> Value {
    let axes = equilibrium.axes.map(|(k, is_along)| if is_along { k as i64 + 1 } else { -(k as i64) - 1 });
    json!({
        "principal_axes_up_ahead_normal": axes,
        "tilt": equilibrium.tilt,
        "up_body": vector(equilibrium.up),
        "ahead_body": vector(equilibrium.ahead),
        "normal_body": vector(equilibrium.normal),
        "attitude_wxyz": numbers(&equilibrium.state.attitude.canonical_quaternion()),
        "omega_body": vector(equilibrium.state.omega),
        "stable": oscillations.is_stable(),
        "modes": modes(oscillations),
    })
}

fn mode(mode: &OscillationMode) -> Value {
    json!({
        "frequency": mode.frequency,
        "growth_rate": mode.growth_rate,
        "damping_ratio": mode.damping_ratio(),
        "axis_body": vector(mode.axis),
        "minor_axis_body": vector(mode.minor_axis),
        "multiplicity": mode.multiplicity,
    })
}
