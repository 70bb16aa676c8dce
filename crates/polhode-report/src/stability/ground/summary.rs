//! The stability of a body on the ground as JSON.

use polhode::observe::{EndState, RattleMode, SteadyPath, TippeTop};
use polhode_document::finding;
use polhode_document::json::{numbers, vector};
use serde_json::{Value, json};

use super::GroundStabilityReport;
use polhode_document::VERSION;

pub(super) fn of(report: &GroundStabilityReport) -> Value {
    let steady = &report.steady;
    let spins = steady.stable_spins.as_ref();
    let threshold = spins.and_then(|spins| spins.nearest(steady.spin));
    let (wheel, vertex) = match steady.path {
        SteadyPath::RollingUpright(wheel) | SteadyPath::SpinningUpright(wheel) => (Some(wheel), None),
        SteadyPath::OnVertex(vertex) => (None, Some(vertex)),
        _ => (None, None),
    };
    json!({
        "polhode": VERSION,
        "source": report.source.to_json(),
        "on_ground": {
            "path": steady.path.name(),
            "footing": steady.footing.name(),
            "holds_while_friction_does": report.is_dry,
            "spin": steady.spin,
            "normal_body": vector(steady.normal),
            "omega_body": vector(steady.omega),
            "axis_body": steady.axis.map(vector),
            "turned_from_start": steady.turned_from_start,
            "omega_from_start": steady.omega_from_start,
            "slip_at_start": steady.slip_at_start,
            "stable": steady.is_stable(),
            "modes": steady.modes.iter()
                .map(|mode| json!({ "frequency": mode.frequency, "growth_rate": mode.growth_rate }))
                .collect::<Value>(),
            "neutral": steady.neutral,
            "neutral_ways": steady.neutral_ways(),
            "law": spins.map(|spins| spins.law),
            // An end without a bound is null.
            "stable_spins": spins.map(|spins| spins.intervals.iter().map(|ends| numbers(ends)).collect::<Value>()),
            "threshold": threshold,
            "margin": threshold.map(|threshold| steady.spin / threshold - 1.0),
            "height": wheel.map(|wheel| wheel.height).or(vertex.map(|vertex| vertex.height)),
            "profile_radius": wheel.map(|wheel| wheel.profile),
            "radii": vertex.map(|vertex| vertex.radii.iter().map(|row| numbers(row)).collect::<Value>()),
            "rattleback": vertex.and_then(|vertex| vertex.rattleback()).map(|rattle| json!({
                "stable_sense": rattle.stable_sense,
                "threshold": rattle.threshold,
                "until": rattle.until,
                "modes": rattle.modes.iter().map(swing).collect::<Value>(),
            })),
            "tippe_top": steady.tippe_top.as_ref().zip(steady.jellett).map(|(top, jellett)| tippe_top(top, jellett)),
        },
        "findings": finding::to_json(&report.findings),
    })
}

fn swing(mode: &RattleMode) -> Value {
    json!({ "frequency": mode.frequency, "growth_per_spin": mode.growth_per_spin })
}

fn tippe_top(top: &TippeTop, jellett: f64) -> Value {
    let end = |state: &EndState| {
        json!({
            "place": state.place.name(),
            "cosine": state.cosine,
            "energy_j": state.energy,
            "minimum": state.is_minimum,
        })
    };
    json!({
        "group": top.group(),
        "eccentricity": top.eccentricity,
        "moment_ratio": top.across / top.along,
        "jellett": jellett,
        "bottom_up_to": top.bottom_up_to(),
        "inverted_from": top.inverted_from(),
        "end_states": top.all(jellett).iter().map(end).collect::<Value>(),
    })
}
