//! A free motion: its kind, its periods, its cones, Poinsot's picture of it.

use std::f64::consts::TAU;

use polhode::motion::{FreeMotion, Mechanism, MethodReason, Regime};
use polhode::observe::{
    AxisConvention, Cones, FreeRegime, GeometricPhase, Herpolhode, LeastEnergySpin, SymmetricTop,
    TumblingPeriods,
};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::unit::{CLOSED, DIGITS, duration};

use super::Known;
use crate::report::free_facts::FreeFacts;
use crate::report::intermediate;
use crate::report::periods::Periods;

/// The keys of `motion`; for a motion that is not free, `null` where only a free motion has them.
pub(super) fn facts(known: &Known<'_>) -> Vec<Fact> {
    let free = known.free();
    let number = |of: fn(&FreeRegime) -> Option<f64>| free.and_then(|free| of(&free.regime));
    let period = |of: fn(&Periods) -> Option<f64>| free.and_then(|free| of(&free.periods));
    let time = |seconds: Option<f64>| seconds.map(Quantity::Duration);
    let is_rotor = known
        .scenario
        .is_none_or(|scenario| scenario.mechanism() == Mechanism::Rotor && scenario.wheels().is_empty());
    let at_start = known.at_start.filter(|_| known.needed.is_none() && is_rotor);
    let (energy, of) = match known.trajectory.reason() {
        MethodReason::Contact => ("T of the rotation", "at the start"),
        MethodReason::Gimbals => ("T of the rotor", "at the start"),
        _ => ("T at the start", ""),
    };
    let (axis, convention) = match free {
        Some(free) if free.motion.circles_least() => ("axis 1", " (long-axis P_φ)"),
        _ => ("axis 3", " (short-axis P_φ)"),
    };
    let convention = if known.top.is_none() { convention } else { "" };
    let off = intermediate::degrees_off(&known.principal, &known.start);
    let growth = number(|r| r.growth_rate).map(|rate| Quantity::Number(rate, "/s"));
    let mut facts = vec![
        Fact::new("motion.regime", "free motion", free.map(|free| kind(free.regime.regime))),
        Fact::data("motion.regime_at_start", at_start.map(|free| kind(free.regime.regime))),
        Fact::new("motion.period_s", "period of ω", time(number(|r| r.period))).note("in the body"),
        Fact::new("motion.precession_period_s", "precession", time(period(|p| p.precession)))
            .note(format!("{axis} round L, on average{convention}")),
        Fact::new("motion.rotation_period_s", "rotation", time(period(|p| p.rotation)))
            .note("once about the axis that L circles"),
        Fact::new("motion.flip_interval_s", "flips every", time(number(|r| r.flip_interval)))
            .note("ω along axis 2 reverses"),
        Fact::new("motion.growth_rate_per_s", "growth rate", growth)
            .note(format!("of a departure from axis 2; ω starts {off}° from it")),
        Fact::new("motion.kinetic_energy_j", energy, Quantity::Energy(known.kinetic_energy)).note(of),
        Fact::new(
            "motion.momentum_kg_m2_s",
            "|L| at the start",
            Quantity::Number(known.momentum.norm(), "kg·m²/s"),
        )
        .note(format!("about the {}", known.about())),
        Fact::data("motion.momentum_space_kg_m2_s", Quantity::Vector(known.momentum.to_array(), "kg·m²/s")),
        Fact::data("motion.symmetric_top", None),
    ];
    // That of a symmetric top is with its cones.
    let nutates = |free: &&FreeFacts| !matches!(free.regime.regime, Regime::Permanent(_) | Regime::AtRest);
    if let Some(free) = free.filter(nutates).filter(|_| known.top.is_none()) {
        let range = Quantity::Angles(free.motion.nutation_range());
        facts.push(Fact::shown("nutation", range).note(format!("of {axis} from L")));
        facts.extend(other_convention(&free.motion));
    }
    facts
}

fn kind(regime: Regime) -> Quantity {
    Quantity::Word(regime.name(), regime.description().to_owned())
}

/// The precession in the convention for the axis that L does not circle, of a body with three different moments.
fn other_convention(motion: &FreeMotion) -> Option<Fact> {
    let (axis, name, convention) = match motion.circles_least() {
        true => (3, "short", AxisConvention::ShortAxis),
        false => (1, "long", AxisConvention::LongAxis),
    };
    let periods = TumblingPeriods::of(motion, convention)?;
    let note = format!("on average ({name}-axis P_φ); about it the body rocks");
    Some(Fact::shown(format!("axis {axis} round L"), Quantity::Duration(periods.precession)).note(note))
}

/// The cones of a symmetric top, and how well L, ω and the axis keep to one plane.
pub(super) fn cones(known: &Known<'_>) -> Vec<Fact> {
    const KEY: &str = "motion.symmetric_top";
    let Some(top) = known.top.as_ref() else { return Vec::new() };
    let coplanarity =
        Fact::new(format!("{KEY}.coplanarity"), "coplanarity", Quantity::Error(top.coplanarity, ""));
    let note = "largest e · (ω × L) / |ω||L|: rounding";
    symmetric_top(KEY, &top.motion, &top.cones).into_iter().chain([coplanarity.note(note).detail()]).collect()
}

/// Axis, moments, rates and cones of a symmetric top, under a key.
pub(crate) fn symmetric_top(key: &str, top: &SymmetricTop, cones: &Cones) -> Vec<Fact> {
    let [axial, transverse] = top.moments();
    let is_open = cones.body_half_angle >= CLOSED;
    let fact = |name: &str, label: &str, value: Quantity| Fact::new(format!("{key}.{name}"), label, value);
    let every = |rate: f64, what: &str| match rate {
        0.0 => what.to_owned(),
        rate => format!("{what}, once in {}", duration(TAU / rate.abs(), DIGITS)),
    };
    let of_cone = |name: &str, label: &str, value: Quantity, note: &str| {
        fact(name, label, value).note(note).shown_if(is_open)
    };
    let [body_rate, space_rate] = [
        every(cones.body_rate, "Ω: ω round the axis"),
        every(cones.space_rate, "φ\u{307}: ω and the axis round L"),
    ];
    vec![
        fact("axis", "symmetry axis", Quantity::Vector(top.axis().to_array(), "")).note("in the body"),
        fact("axial_moment", "axial moment", Quantity::Number(axial, "kg·m²")),
        fact("transverse_moment", "transverse moment", Quantity::Number(transverse, "kg·m²")),
        fact("spin_rad_s", "spin", Quantity::Rate(top.spin())).note("ω along the axis").detail(),
        of_cone("body_rate_rad_s", "rate in the body", Quantity::Rate(cones.body_rate), &body_rate),
        of_cone("space_rate_rad_s", "rate in space", Quantity::Rate(cones.space_rate), &space_rate),
        of_cone(
            "body_cone_half_angle_rad",
            "body cone",
            Quantity::Angle(cones.body_half_angle),
            "half-angle: ω round the symmetry axis",
        ),
        of_cone(
            "space_cone_half_angle_rad",
            "space cone",
            Quantity::Angle(cones.space_half_angle),
            "half-angle: ω round L",
        ),
        of_cone("nutation_rad", "nutation", Quantity::Angle(cones.nutation), "of the symmetry axis from L"),
    ]
}

/// Poinsot's ellipsoid on its plane, the turn in a period, and the end that friction inside would bring.
pub(super) fn picture(motion: &FreeMotion) -> Vec<Fact> {
    /// A piece too short to have many points.
    const PIECE: f64 = 1e-9;
    let mut facts = Vec::new();
    let mut put = |label, value, note: &str| facts.push(Fact::shown(label, value).note(note).detail());
    if let Ok(herpolhode) = Herpolhode::of(motion, PIECE, 0.1) {
        put("ω along L", Quantity::Rate(herpolhode.height), "height of the invariable plane");
        put("ω across L", Quantity::Range(herpolhode.annulus, "rad/s"), "radius of the herpolhode");
    }
    if let Some(phase) = GeometricPhase::of(motion) {
        put("turn in a period", Quantity::Number(phase.total, "rad"), "about L");
        put("dynamic part", Quantity::Number(phase.dynamic, "rad"), "2 T P / |L|");
        put("geometric part", Quantity::Number(phase.geometric, "rad"), "a solid angle");
    }
    if let Some(end) = LeastEnergySpin::of(motion) {
        let note = "least at the same |L|, where friction inside would end";
        put("T / least T", Quantity::Number(end.energy_ratio, ""), note);
    }
    facts
}
