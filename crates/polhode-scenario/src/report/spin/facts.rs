//! Facts about a free motion. Facts that `simulate` also states have the same keys, labels and
//! notes.

use polhode::motion::{PermanentAxis, Regime, State};
use polhode::observe::{AxisConvention, TumblingPeriods};
use polhode_document::fact::{Fact, Facts, Quantity};
use polhode_document::finding;
use polhode_shape::report::block;
use serde_json::{Value, json};

use super::{SpinReport, body, states};
use crate::report::VERSION;
use crate::report::facts::{constants, dissipation, nutation, periods, picture_of, symmetric_top};
use crate::report::free_facts::FreeFacts;

/// Keys of the JSON.
pub(super) const KEYS: [&str; 7] =
    ["polhode", "source", "possible", "principal", "start", "motion", "findings"];

/// Keys of `motion`; `null` where a motion has no value.
const MOTION: [&str; 20] = [
    "regime",
    "permanent_axis",
    "period_s",
    "precession_period_s",
    "rotation_period_s",
    "flip_interval_s",
    "growth_rate_per_s",
    "kinetic_energy_j",
    "momentum_kg_m2_s",
    "momentum_space_kg_m2_s",
    "precession_rate_rad_s",
    "nutation_range_rad",
    "parameter_m",
    "complementary_parameter",
    "periods",
    "symmetric_top",
    "geometric_phase",
    "least_energy_spin",
    "herpolhode",
    "states",
];

/// Significant digits of a number in the text.
pub(super) const DIGITS: usize = 6;

/// Returns the facts in sections, in the order of the text.
pub(super) fn of(report: &SpinReport, free: &FreeFacts) -> Vec<Facts> {
    let FreeFacts { motion, top, .. } = free;
    let section = |title: &str, facts: Vec<Fact>| {
        Facts::new(title, facts.into_iter().map(|fact| fact.digits(DIGITS)).collect())
    };
    let cones = |(top, cones)| symmetric_top("motion.symmetric_top", &top, &cones);
    let principal = motion.principal();
    let physical = Quantity::Data(body::is_possible(principal).into(), body::in_words(principal));
    vec![
        section("", MOTION.map(|key| Fact::data(format!("motion.{key}"), None)).to_vec()),
        section("Motion", motion_facts(free)),
        section("Cones", top.map_or_else(Vec::new, cones)),
        section("Poinsot's picture", picture_of(motion)),
        section("Internal friction", dissipation(motion)),
        section("Body", vec![Fact::new("possible", "moments", physical)]),
        section(
            "",
            vec![
                Fact::data("polhode", VERSION.to_owned()),
                Fact::data("source", report.source.as_ref().map(|source| source.to_json().into())),
                Fact::data("principal", block::principal(principal)),
                Fact::data("motion.states", states::to_json(&report.states)),
                Fact::data("findings", finding::to_json(&report.findings)),
            ],
        ),
    ]
}

fn motion_facts(free: &FreeFacts) -> Vec<Fact> {
    let FreeFacts { motion, regime, .. } = free;
    let [m, complement] = motion.parameter();
    let rate = Quantity::Rate(motion.precession_rate());
    let number = |key: &str, label: &str, x: f64| Fact::new(key, label, Quantity::Number(x, "")).detail();
    let axis = permanent_axis(regime.regime).map(|axis| Quantity::Word(axis, String::new()));
    let mut facts = periods(Some(free));
    facts.push(Fact::data("motion.permanent_axis", axis));
    facts.extend(constants(("T", ""), motion.kinetic_energy(), ("|L|", ""), motion.momentum()));
    facts.push(Fact::new("motion.precession_rate_rad_s", "precession rate", rate).note("mean").detail());
    facts.extend(nutation(free));
    facts.extend([
        number("motion.parameter_m", "m", m).note("parameter of the elliptic functions"),
        number("motion.complementary_parameter", "1 − m", complement),
        in_convention("long_axis", TumblingPeriods::of(motion, AxisConvention::LongAxis)),
        in_convention("short_axis", TumblingPeriods::of(motion, AxisConvention::ShortAxis)),
    ]);
    facts.extend(start(&motion.start()));
    facts
}

/// Returns P_φ and P_ψ in a convention; the text states them by the axis that precesses.
fn in_convention(name: &str, periods: Option<TumblingPeriods>) -> Fact {
    Fact::data(format!("motion.periods.{name}"), periods.map(|periods| tumbling(periods).into()))
}

/// Returns `{"precession_period_s": P_φ, "rotation_period_s": P_ψ}`.
pub(super) fn tumbling(periods: TumblingPeriods) -> Value {
    json!({ "precession_period_s": periods.precession, "rotation_period_s": periods.rotation })
}

fn start(state: &State) -> [Fact; 5] {
    [
        Fact::data("start.time_s", Quantity::Duration(state.time)),
        Fact::data("start.attitude_wxyz", Quantity::Attitude(state.attitude.canonical_quaternion())),
        Fact::new("start.omega_body", "ω at the start", Quantity::Vector(state.omega.to_array(), "rad/s"))
            .note("in body axes"),
        Fact::shown("|ω| at the start", Quantity::Rate(state.omega.norm())),
        Fact::data("start.omega_space", Quantity::Vector(state.omega_space().to_array(), "rad/s")),
    ]
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
