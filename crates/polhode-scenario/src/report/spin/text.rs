//! The motion on one screen: what it is, how long it takes, how it would end.

use polhode::body::Symmetry;
use polhode::motion::{FreeMotion, PermanentAxis, Regime};
use polhode::observe::{Cones, FreeRegime, GeometricPhase, LeastEnergySpin, SymmetricTop};
use polhode_document::SourceInfo;
use polhode_document::finding;
use polhode_document::layout::{labelled, plain_spaces};
use polhode_document::number::{number, tidy, vector};
use polhode_document::sparkline::Sparkline;
use polhode_document::unit;
use polhode_document::unit::{CLOSED, DIGITS, duration};

use super::{SpinReport, body, invariable_plane, states};
use crate::report::free_facts::FreeFacts;
use crate::report::{intermediate, omega, periods as conventions};

/// The motion, with a picture of ω of so many columns if there is to be one.
pub(crate) fn write(report: &SpinReport, picture: Option<usize>) -> String {
    let free = FreeFacts::of(report.motion);
    let motion = &free.motion;
    let mut text = heading(report.source.as_ref());
    text.push_str(&labelled("moments", &body::in_words(motion.principal())));
    if motion.regime() != Regime::AtRest {
        text.push_str(&labelled("start", &omega::in_words(motion.start().omega)));
    }
    text.push_str(&kind(motion));
    text.push_str(&instability(&free));
    text.push_str(&periods(&free));
    if let Some(columns) = picture {
        text.push_str(&curve(motion, columns));
    }
    text.push_str(&tumbling(&free));
    text.push_str(&nutation(motion));
    text.push_str(&herpolhode(motion));
    text.push_str(&phase(motion));
    text.push_str(&end(motion));
    text.push_str(&finding::to_text(&report.findings));
    text.push_str(&states::to_text(&report.states));
    plain_spaces(&text)
}

/// The file, if there is one, and its title.
pub(crate) fn heading(source: Option<&SourceInfo>) -> String {
    source.map_or_else(String::new, |source| format!("{}\n", source.heading()))
}

/// The regime, and what stays constant.
fn kind(motion: &FreeMotion) -> String {
    if motion.regime() == Regime::AtRest {
        return labelled("motion", "at rest: ω = 0");
    }
    let kind = labelled("motion", motion.regime().description());
    let constants = format!(
        "|L| = {} kg·m²/s, 2T = {} J",
        number(motion.momentum().norm(), DIGITS),
        number(2.0 * motion.kinetic_energy(), DIGITS)
    );
    kind + &labelled("", &constants)
}

fn instability(FreeFacts { motion, regime, .. }: &FreeFacts) -> String {
    let Some(growth) = regime.growth_rate else { return String::new() };
    let growth = number(growth, 6);
    let line = if motion.regime() == Regime::Permanent(PermanentAxis::Intermediate) {
        format!("an exact, unstable equilibrium: ω stays as it is; growth rate {growth} /s of any departure")
    } else {
        let off = intermediate::degrees_off(motion.principal(), &motion.start());
        format!("starts {off}° from the unstable intermediate axis (2); growth rate {growth} /s")
    };
    labelled("instability", &line)
}

/// The period of ω in the body with all its digits.
fn periods(FreeFacts { motion, regime, .. }: &FreeFacts) -> String {
    let FreeRegime { regime, period, flip_interval, growth_rate } = *regime;
    match (regime, period) {
        (Regime::Permanent(_), _) => {
            let turn = std::f64::consts::TAU / motion.start().omega.norm();
            labelled("one turn", &duration(turn, 16))
        }
        (Regime::Separatrix, _) => {
            labelled("period of ω", "none: it creeps to axis 2 and never comes back, nor ever arrives")
        }
        (_, None) => String::new(),
        (_, Some(period)) => {
            let flips = flip_interval.map_or_else(String::new, |flip| match growth_rate {
                Some(_) => format!("; flips every {}", duration(flip, 16)),
                None => format!("; along axis 2 it reverses every {}", duration(flip, 16)),
            });
            labelled("period of ω", &format!("{} in the body{flips}", duration(period, 16)))
        }
    }
}

/// Two periods of the component of ω along a principal axis that varies most.
fn curve(motion: &FreeMotion, columns: usize) -> String {
    const PERIODS: f64 = 2.0;
    let Some(period) = motion.period() else { return String::new() };
    let into = motion.principal().rotation().inverse();
    let at = |k: usize| motion.start().time + PERIODS * period * (k as f64 / (columns - 1) as f64);
    let omega: Vec<[f64; 3]> = (0..columns).map(|k| (into * motion.at(at(k)).omega).to_array()).collect();
    let line = Sparkline::of_omega(&omega, columns);
    line.map_or_else(String::new, |spark| {
        labelled(&spark.label(motion.principal()), &format!("{}  2 periods", spark.line))
    })
}

/// P_φ and P_ψ, in both conventions where the body has two extreme axes.
fn tumbling(FreeFacts { motion, top, .. }: &FreeFacts) -> String {
    match top {
        Some((top, cones)) => symmetric(top, cones),
        None => conventions::in_both_conventions(motion, 16),
    }
}

fn symmetric(top: &SymmetricTop, cones: &Cones) -> String {
    let axis = vector(tidy(top.axis().to_array()), 6);
    let axis = labelled("symmetry axis", &format!("e = {axis} in the body"));
    if cones.body_half_angle < CLOSED {
        return axis;
    }
    let turn = |rate: f64| duration(std::f64::consts::TAU / rate.abs(), 16);
    let space = format!("e and ω go round L in {}", turn(cones.space_rate));
    let angles = format!(
        "body cone {}, space cone {}",
        unit::cone(cones.body_half_angle),
        unit::cone(cones.space_half_angle)
    );
    axis + &labelled("in space", &space) + &labelled("cones", &angles)
}

/// The angle between L and the axis that it circles.
fn nutation(motion: &FreeMotion) -> String {
    let axis = if motion.circles_least() { 1 } else { 3 };
    let [least, most] = motion.nutation_range();
    let line = match motion.regime() {
        Regime::AtRest | Regime::Permanent(_) => return String::new(),
        Regime::Symmetric => format!("e stays at {} from L", unit::cone(least)),
        Regime::Separatrix => {
            format!("axis {axis} is at {}° from L at least, and ends at 90°", number(least.to_degrees(), 6))
        }
        _ => {
            let [least, most] = [least, most].map(|angle| number(angle.to_degrees(), 6));
            format!("axis {axis} is {least}° … {most}° from L")
        }
    };
    labelled("nutation", &line)
}

/// Between which circles ω stays on the invariable plane.
fn herpolhode(motion: &FreeMotion) -> String {
    let circles = !matches!(motion.regime(), Regime::AtRest | Regime::Permanent(_));
    let Some(herpolhode) = invariable_plane(motion).filter(|_| circles) else { return String::new() };
    let [least, greatest] = herpolhode.annulus;
    let [shown, most, height] = [least, greatest, herpolhode.height].map(|rate| number(rate, 6));
    let radii = if shown == most { shown } else { format!("{shown} … {most}") };
    labelled("herpolhode", &format!("ω is {radii} rad/s across L, and {height} rad/s along it"))
}

fn phase(motion: &FreeMotion) -> String {
    let Some(phase) = GeometricPhase::of(motion) else { return String::new() };
    let [total, dynamic, geometric] =
        [phase.total, phase.dynamic, phase.geometric.abs()].map(|angle| number(angle, 6));
    let sign = if phase.geometric < 0.0 { "-" } else { "+" };
    let line = format!(
        "in a period of ω the body turns about L by {total} rad = {dynamic} (2TP/|L|) {sign}\u{a0}{geometric} (solid angle)"
    );
    labelled("geometric phase", &line)
}

/// Where dissipation inside the body would end.
fn end(motion: &FreeMotion) -> String {
    let Some(end) = LeastEnergySpin::of(motion) else { return String::new() };
    let axis = match motion.principal().symmetry() {
        Symmetry::Prolate | Symmetry::Rod => "an axis across e",
        _ => "axis 3",
    };
    let line = if end.energy_lost == 0.0 {
        "would change nothing: no spin with this L has less energy".to_owned()
    } else {
        let percent = 100.0 * end.energy_lost / (end.kinetic_energy + end.energy_lost);
        format!(
            "would end in a turn about {axis} at {}, with {} % of T lost; T/T_min = {}",
            unit::rate(end.rate),
            number(percent, 4),
            number(end.energy_ratio, DIGITS)
        )
    };
    labelled("inner friction", &line)
}
