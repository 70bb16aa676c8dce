//! Stability as JSON.

use polhode::{OscillationMode, PermanentRotation, Stability};
use serde_json::{Value, json};

use super::{Found, Place, StabilityReport};
use crate::json::{numbers, vector};
use crate::{VERSION, block, finding};

pub(super) fn of(report: &StabilityReport) -> Value {
    let rotations = report.rotations.as_ref().ok();
    let oscillations = report.oscillations.as_ref().and_then(|found| found.as_ref().ok());
    json!({
        "polhode": VERSION,
        "source": report.source.to_json(),
        "principal": block::principal(report.rotor.principal()),
        "wheel_momentum_body": vector(report.rotor.wheel_momentum(0.0)),
        "momentum": report.momentum,
        "permanent_rotations": rotations.map(|all| all.iter().map(rotation).collect::<Value>()),
        "small_oscillations": oscillations.map(small),
        "findings": finding::to_json(&report.findings),
    })
}

fn rotation(rotation: &PermanentRotation) -> Value {
    let (frequency, growth_rate) = match rotation.stability {
        Stability::Stable { frequency, .. } => (Some(frequency), None),
        Stability::Unstable { growth_rate, .. } => (None, Some(growth_rate)),
        _ => (None, None),
    };
    json!({
        "omega_body": vector(rotation.omega),
        "momentum_body": vector(rotation.momentum),
        "stability": rotation.stability.name(),
        "frequency": frequency,
        "growth_rate": growth_rate,
    })
}

fn small(found: &Found) -> Value {
    let equilibrium = &found.oscillations.equilibrium;
    json!({
        "equilibrium": match found.place {
            Place::Start => "start",
            Place::Nearest => "nearest",
            Place::Rest => "nearest_at_rest",
        },
        "turned_from_start": found.turned,
        "attitude_wxyz": numbers(&equilibrium.attitude.canonical_quaternion()),
        "omega_body": vector(equilibrium.omega),
        "stable": found.oscillations.is_stable(),
        "neutral": found.oscillations.neutral,
        "modes": found.oscillations.modes.iter().map(mode).collect::<Value>(),
    })
}

fn mode(mode: &OscillationMode) -> Value {
    json!({
        "frequency": mode.frequency,
        "growth_rate": mode.growth_rate,
        "damping_ratio": mode.damping_ratio(),
        "axis_body": vector(mode.axis),
        "minor_axis_body": vector(mode.minor_axis),
    })
}
