//! The motion as JSON: what `motion` in `summary.json` says too has the same name here.

use polhode::motion::{FreeMotion, PermanentAxis, Regime, State};
use polhode::observe::{
    AxisConvention, FreeRegime, GeometricPhase, Herpolhode, LeastEnergySpin, TumblingPeriods,
};
use polhode_document::SourceInfo;
use polhode_document::fact::{Facts, object};
use polhode_document::finding;
use polhode_document::json::{numbers, vector};
use polhode_shape::report::block;
use serde_json::{Map, Value, json};

use super::{SpinReport, body, invariable_plane, states};
use crate::report::VERSION;
use crate::report::facts::symmetric_top;
use crate::report::free_facts::FreeFacts;
use crate::report::periods::Periods;

pub(crate) fn of(report: &SpinReport) -> Value {
    let principal = report.motion.principal();
    json!({
        "polhode": VERSION,
        "source": report.source.as_ref().map(SourceInfo::to_json),
        "possible": body::is_possible(principal),
        "principal": block::principal(principal),
        "start": start(&report.motion.start()),
        "motion": motion(report),
        "findings": finding::to_json(&report.findings),
    })
}

fn start(state: &State) -> Value {
    json!({
        "time_s": state.time,
        "attitude_wxyz": numbers(&state.attitude.canonical_quaternion()),
        "omega_body": vector(state.omega),
        "omega_space": vector(state.omega_space()),
    })
}

fn motion(report: &SpinReport) -> Value {
    let FreeFacts { motion, regime, periods: Periods { precession, rotation }, top } =
        FreeFacts::of(report.motion);
    let FreeRegime { regime, period, flip_interval, growth_rate } = regime;
    let motion = &motion;
    let [parameter, complementary] = motion.parameter();
    let momentum = motion.momentum();
    let cones =
        |(top, cones)| object(&[], &[Facts::new("", symmetric_top("top", &top, &cones))]).remove("top");
    let entries: [(&str, Value); 20] = [
        ("regime", regime.name().into()),
        ("permanent_axis", permanent_axis(regime).into()),
        ("period_s", period.into()),
        ("precession_period_s", precession.into()),
        ("rotation_period_s", rotation.into()),
        ("flip_interval_s", flip_interval.into()),
        ("growth_rate_per_s", growth_rate.into()),
        ("kinetic_energy_j", motion.kinetic_energy().into()),
        ("momentum_kg_m2_s", momentum.norm().into()),
        ("momentum_space_kg_m2_s", vector(momentum)),
        ("precession_rate_rad_s", motion.precession_rate().into()),
        ("nutation_range_rad", numbers(&motion.nutation_range())),
        ("parameter_m", parameter.into()),
        ("complementary_parameter", complementary.into()),
        ("periods", periods(motion)),
        ("symmetric_top", top.and_then(cones).unwrap_or_default()),
        ("geometric_phase", GeometricPhase::of(motion).map_or(Value::Null, phase)),
        ("least_energy_spin", LeastEnergySpin::of(motion).map_or(Value::Null, least_energy)),
        ("herpolhode", invariable_plane(motion).as_ref().map_or(Value::Null, herpolhode)),
        ("states", states::to_json(&report.states)),
    ];
    Value::Object(entries.into_iter().map(|(key, value)| (key.to_owned(), value)).collect::<Map<_, _>>())
}

fn permanent_axis(regime: Regime) -> Option<&'static str> {
    let Regime::Permanent(axis) = regime else { return None };
    Some(match axis {
        PermanentAxis::Least => "least",
        PermanentAxis::Intermediate => "intermediate",
        PermanentAxis::Greatest => "greatest",
        PermanentAxis::Symmetry => "symmetry",
        PermanentAxis::AcrossSymmetry => "across_symmetry",
        PermanentAxis::Any => "any",
    })
}

/// P_φ and P_ψ in both conventions of those who observe tumblers.
fn periods(motion: &FreeMotion) -> Value {
    let of = |convention| TumblingPeriods::of(motion, convention).map_or(Value::Null, tumbling);
    json!({ "long_axis": of(AxisConvention::LongAxis), "short_axis": of(AxisConvention::ShortAxis) })
}

/// `{"precession_period_s": P_φ, "rotation_period_s": P_ψ}`
pub(crate) fn tumbling(periods: TumblingPeriods) -> Value {
    json!({ "precession_period_s": periods.precession, "rotation_period_s": periods.rotation })
}

fn phase(phase: GeometricPhase) -> Value {
    json!({ "total_rad": phase.total, "dynamic_rad": phase.dynamic, "geometric_rad": phase.geometric })
}

fn least_energy(end: LeastEnergySpin) -> Value {
    json!({
        "axis": vector(end.axis),
        "rate_rad_s": end.rate,
        "kinetic_energy_j": end.kinetic_energy,
        "energy_lost_j": end.energy_lost,
        "energy_ratio": end.energy_ratio,
    })
}

/// How near ω comes to L's line, how far it goes, and where the invariable plane lies.
fn herpolhode(herpolhode: &Herpolhode) -> Value {
    let [least, greatest] = herpolhode.annulus;
    json!({
        "least_radius_rad_s": least,
        "greatest_radius_rad_s": greatest,
        "height_rad_s": herpolhode.height,
        "normal_space": vector(herpolhode.normal),
    })
}
