//! Facts about a free motion: kind, periods, cones, and Poinsot's construction.

use std::f64::consts::TAU;

use polhode::body::Symmetry;
use polhode::math::{AngularMomentum, Space};
use polhode::motion::{FreeMotion, Mechanism, MethodReason, Regime};
use polhode::observe::{
    AxisConvention, Cones, FreeRegime, GeometricPhase, Herpolhode, LeastEnergySpin, SymmetricTop,
    TumblingPeriods,
};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::number::number;
use polhode_document::unit::{CLOSED, duration};

use super::Known;
use crate::report::free_facts::FreeFacts;
use crate::report::periods::Periods;

/// Returns the facts with the keys of `motion`. Keys of free motions are `null` for any other
/// motion.
pub(super) fn facts(known: &Known<'_>) -> Vec<Fact> {
    let free = known.free();
    let is_rotor = known
        .scenario
        .is_none_or(|scenario| scenario.mechanism() == Mechanism::Rotor && scenario.wheels().is_empty());
    let at_start = known.at_start.filter(|_| known.needed.is_none() && is_rotor);
    let energy = match known.trajectory.reason() {
        MethodReason::Contact => ("T of the rotation", "at the start"),
        MethodReason::Gimbals => ("T of the rotor", "at the start"),
        _ => ("T at the start", ""),
    };
    let mut facts = vec![
        Fact::data("motion.regime", None),
        Fact::data("motion.regime_at_start", at_start.map(|free| kind(free.regime.regime))),
    ];
    facts.extend(periods(free));
    let about = format!("about the {}", known.about());
    facts.extend(constants(energy, known.kinetic_energy, ("|L| at the start", &about), known.momentum));
    facts.push(Fact::data("motion.symmetric_top", None));
    facts.extend(free.map_or_else(Vec::new, nutation).into_iter().map(Fact::without_key));
    facts
}

/// Returns the kind and periods of a free motion; for other motions the keys only.
pub(crate) fn periods(free: Option<&FreeFacts>) -> Vec<Fact> {
    let number = |of: fn(&FreeRegime) -> Option<f64>| free.and_then(|free| of(&free.regime));
    let period = |of: fn(&Periods) -> Option<f64>| free.and_then(|free| of(&free.periods));
    let time = |seconds: Option<f64>| seconds.map(Quantity::Duration);
    let axis = free.map_or("", |free| circled_axis(&free.motion));
    let convention = match axis {
        _ if free.is_some_and(|free| free.top.is_some()) => "",
        "axis 1" => " (long-axis convention, P_φ)",
        _ => " (short-axis convention, P_φ)",
    };
    let is_permanent = free.is_some_and(|free| matches!(free.regime.regime, Regime::Permanent(_)));
    let growth = number(|r| r.growth_rate).map(|rate| Quantity::Number(rate, "/s"));
    let off = free.map_or_else(String::new, FreeFacts::degrees_off);
    vec![
        Fact::new("motion.regime", "free motion", free.map(|free| kind(free.regime.regime))),
        Fact::new("motion.period_s", "period of ω", time(number(|r| r.period))).note("in the body"),
        Fact::new("motion.precession_period_s", "precession", time(period(|p| p.precession)))
            .note(format!("{axis} about L, mean period{convention}")),
        Fact::new("motion.rotation_period_s", "rotation", time(period(|p| p.rotation)))
            .note(if is_permanent { "one turn" } else { "once about the axis that L circles" }),
        Fact::new("motion.flip_interval_s", "flips every", time(number(|r| r.flip_interval)))
            .note("ω along axis 2 reverses"),
        Fact::new("motion.growth_rate_per_s", "growth rate", growth)
            .note(format!("of a small deviation from axis 2; ω starts {off}° from it")),
    ]
}

/// Returns T, |L| and L, the first two with their labels and notes.
pub(crate) fn constants(
    energy: (&str, &str),
    joule: f64,
    momentum: (&str, &str),
    l: AngularMomentum<Space>,
) -> [Fact; 3] {
    [
        Fact::new("motion.kinetic_energy_j", energy.0, Quantity::Energy(joule)).note(energy.1),
        Fact::new("motion.momentum_kg_m2_s", momentum.0, Quantity::Number(l.norm(), "kg·m²/s"))
            .note(momentum.1),
        Fact::data("motion.momentum_space_kg_m2_s", Quantity::Vector(l.to_array(), "kg·m²/s")),
    ]
}

/// Returns the angle between L and the axis that it circles, and the precession of the other
/// extreme axis. For a symmetric top, `cones` states the angle.
pub(crate) fn nutation(free: &FreeFacts) -> Vec<Fact> {
    let nutates = !matches!(free.regime.regime, Regime::Permanent(_) | Regime::AtRest) && free.top.is_none();
    let range = Quantity::Angles(free.motion.nutation_range());
    let angle = Fact::new("motion.nutation_range_rad", "nutation", range)
        .note(format!("of {} from L", circled_axis(&free.motion)))
        .shown_if(nutates);
    let other = other_convention(&free.motion).filter(|_| nutates);
    [angle].into_iter().chain(other).collect()
}

fn circled_axis(motion: &FreeMotion) -> &'static str {
    if motion.circles_least() { "axis 1" } else { "axis 3" }
}

fn kind(regime: Regime) -> Quantity {
    Quantity::Word(regime.name(), regime.description().to_owned())
}

/// Returns the precession in the convention of the axis that L does not circle; `None` unless the
/// three moments differ.
fn other_convention(motion: &FreeMotion) -> Option<Fact> {
    let (axis, name, convention) = match motion.circles_least() {
        true => (3, "short", AxisConvention::ShortAxis),
        false => (1, "long", AxisConvention::LongAxis),
    };
    let periods = TumblingPeriods::of(motion, convention)?;
    let note = format!("mean period ({name}-axis convention, P_φ); the body rocks about this axis");
    Some(
        Fact::shown(format!("axis {axis} about L"), Quantity::Duration(periods.precession))
            .note(note)
            .detail(),
    )
}

/// Returns the cones of a symmetric top, and the deviation of L, ω and the axis from one plane.
pub(super) fn cones(known: &Known<'_>) -> Vec<Fact> {
    const KEY: &str = "motion.symmetric_top";
    let Some(top) = known.top.as_ref() else { return Vec::new() };
    let coplanarity =
        Fact::new(format!("{KEY}.coplanarity"), "coplanarity", Quantity::Error(top.coplanarity, ""));
    let note = "largest e · (ω × L) / |ω||L|: rounding";
    symmetric_top(KEY, &top.motion, &top.cones).into_iter().chain([coplanarity.note(note).detail()]).collect()
}

/// Returns the axis, moments, rates and cones of a symmetric top, under a key.
pub(crate) fn symmetric_top(key: &str, top: &SymmetricTop, cones: &Cones) -> Vec<Fact> {
    let [axial, transverse] = top.moments();
    let is_open = cones.body_half_angle >= CLOSED;
    let fact = |name: &str, label: &str, value: Quantity| Fact::new(format!("{key}.{name}"), label, value);
    let every = |rate: f64, what: &str| match rate {
        0.0 => what.to_owned(),
        rate => format!("{what}, once in {}", duration(TAU / rate.abs(), 6)),
    };
    let of_cone = |name: &str, label: &str, value: Quantity, note: &str| {
        fact(name, label, value).note(note).shown_if(is_open)
    };
    let [body_rate, space_rate] = [
        every(cones.body_rate, "Ω: ω round the axis"),
        every(cones.space_rate, "φ\u{307}: ω and the axis about L"),
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
            "half-angle: ω about L",
        ),
        of_cone("nutation_rad", "nutation", Quantity::Angle(cones.nutation), "of the symmetry axis from L"),
    ]
}

/// Returns the geometry of the herpolhode on the invariable plane, and the rotation about L in a
/// period.
pub(crate) fn picture(motion: &FreeMotion) -> Vec<Fact> {
    /// Length of the curve in periods, so short that it has few points.
    const PIECE: f64 = 1e-9;
    const COARSE: f64 = 0.1;
    let mut facts = Vec::new();
    let plane = Herpolhode::of(motion, PIECE, COARSE).ok().filter(|herpolhode| herpolhode.height > 0.0);
    if let Some(Herpolhode { annulus, height, normal, .. }) = plane {
        let data = |key: &str, value| Fact::data(format!("motion.herpolhode.{key}"), value);
        facts.extend([
            data("least_radius_rad_s", Quantity::Rate(annulus[0])),
            data("greatest_radius_rad_s", Quantity::Rate(annulus[1])),
            Fact::new("motion.herpolhode.height_rad_s", "ω along L", Quantity::Rate(height))
                .note("height of the invariable plane"),
            Fact::shown("ω across L", Quantity::Range(annulus, "rad/s")).note("radius of the herpolhode"),
            data("normal_space", Quantity::Vector(normal.to_array(), "")),
        ]);
    }
    if let Some(phase) = GeometricPhase::of(motion) {
        let angle = |key: &str, label, rad| {
            Fact::new(format!("motion.geometric_phase.{key}"), label, Quantity::Number(rad, "rad"))
        };
        facts.extend([
            angle("total_rad", "turn in a period", phase.total).note("about L"),
            angle("dynamic_rad", "dynamic part", phase.dynamic).note("2 T P / |L|"),
            angle("geometric_rad", "geometric part", phase.geometric).note("a solid angle"),
        ]);
    }
    facts.into_iter().map(Fact::detail).collect()
}

/// Returns the spin in which friction inside the body would end.
pub(crate) fn dissipation(motion: &FreeMotion) -> Vec<Fact> {
    let Some(end) = LeastEnergySpin::of(motion) else { return Vec::new() };
    let axis = match motion.principal().symmetry() {
        Symmetry::Prolate | Symmetry::Rod => "an axis across the symmetry axis",
        Symmetry::Point | Symmetry::Spherical | Symmetry::Oblate | Symmetry::Asymmetric => "axis 3",
    };
    let lost = number(100.0 * end.energy_lost / motion.kinetic_energy(), 4);
    let loses = end.energy_lost != 0.0;
    let fact = |key: &str, label: &str, value: Quantity| {
        Fact::new(format!("motion.least_energy_spin.{key}"), label, value)
    };
    let ratio = if loses { "least at the same |L|" } else { "no spin with the same |L| has less energy" };
    vec![
        fact("axis", "", Quantity::Vector(end.axis.to_array(), "")),
        fact("rate_rad_s", "final spin", Quantity::Rate(end.rate))
            .note(format!("about {axis}, with the same |L|"))
            .shown_if(loses),
        fact("kinetic_energy_j", "", Quantity::Energy(end.kinetic_energy)),
        fact("energy_lost_j", "T lost", Quantity::Energy(end.energy_lost))
            .note(format!("{lost}\u{a0}% of T"))
            .shown_if(loses),
        fact("energy_ratio", "T / least T", Quantity::Number(end.energy_ratio, "")).note(ratio),
    ]
}
