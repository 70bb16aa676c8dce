//! Results of Lagrange's top: bounds, periods, rates and kind.

use std::f64::consts::TAU;

use polhode::motion::torque::TorqueModel;
use polhode::motion::{HeavyTop, Scenario, State, TopPath};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::number::{DIGITS, number};

/// Returns the top of a scenario; `None` unless gravity alone acts and the body is symmetric about
/// its arm.
pub(crate) fn of(scenario: &Scenario, start: State) -> Option<HeavyTop> {
    let [TorqueModel::Gravity(gravity)] = scenario.torques() else { return None };
    if scenario.prescribed().is_some() || scenario.suspension().is_some() || scenario.history().is_some() {
        return None;
    }
    HeavyTop::of(scenario.rotor(), gravity, start).ok()
}

pub(super) fn facts(top: &HeavyTop) -> Vec<Fact> {
    let [across, along] = top.moments();
    let steady = top.steady_precession(middle(top), top.spin());
    let is_steady = matches!(top.path(), TopPath::SteadySlow | TopPath::SteadyFast | TopPath::Conical);
    let goes_round = top.mean_precession().is_some() && top.mean_spin().is_some();
    let is_inclined = !matches!(top.path(), TopPath::Sleeping { .. } | TopPath::Hanging | TopPath::Planar);
    let middle = number(middle(top).to_degrees(), DIGITS);
    let fact = |key: &str, label: &str, value: Quantity| Fact::new(format!("heavy_top.{key}"), label, value);
    let some = |x: Option<f64>, kind: fn(f64) -> Quantity| Quantity::from(x.map(kind));
    let threshold = Some(top.sleeping_threshold()).filter(|spin| spin.is_finite());
    vec![
        fact("path", "kind", Quantity::Word(top.path().name(), top.path().description().to_owned())),
        fact("transverse_moment", "", Quantity::Number(across, "kg·m²")),
        fact("axial_moment", "", Quantity::Number(along, "kg·m²")),
        fact("weight_torque_n_m", "", Quantity::Number(top.weight_torque(), "N·m")),
        fact("spin_rad_s", "spin about the axis", Quantity::Rate(top.spin()))
            .note("ω along the axis, constant"),
        fact("nutation_rad", "inclination", Quantity::Angles(top.nutation_bounds()))
            .note("from the vertical"),
        fact("nutation_period_s", "nutation", some(top.nutation_period(), Quantity::Duration))
            .note(if is_steady { "period of small nutations" } else { "period" }),
        fact(
            "precession_in_a_nutation_rad",
            "precession",
            some(top.precession_in_a_nutation(), Quantity::Angle),
        )
        .note("in a nutation, about the vertical")
        .shown_if(!goes_round),
        fact("mean_precession_rad_s", "precession", some(top.mean_precession(), Quantity::Rate))
            .note("on average, about the vertical")
            .shown_if(goes_round),
        fact("mean_spin_rad_s", "rotation", some(top.mean_spin(), Quantity::Rate))
            .note("ψ\u{307} on average, about the axis")
            .shown_if(goes_round),
        fact("sleeping_threshold_rad_s", "sleeping from", some(threshold, Quantity::Rate))
            .note("upright, spin about the axis above 2 √(M g l A)/C"),
        fact("steady_slow_rad_s", "steady precession", some(steady.map(|rates| rates.slow), Quantity::Rate))
            .note(format!("the slow one, without nutation at {middle}° with this spin"))
            .shown_if(is_inclined),
        fact(
            "steady_fast_rad_s",
            "and the fast one",
            some(steady.and_then(|rates| rates.fast), Quantity::Rate),
        )
        .shown_if(is_inclined),
    ]
}

/// Returns the mean time for one revolution of the axis about the vertical, s. `None` if the axis
/// passes through the vertical: there its azimuth jumps by half a turn, which the mean precession
/// does not count.
pub(crate) fn time_round(top: &HeavyTop) -> Option<f64> {
    let goes_round = !matches!(top.path(), TopPath::Planar | TopPath::ThroughVertical);
    top.mean_precession().filter(|rate| goes_round && *rate != 0.0).map(|rate| TAU / rate.abs())
}

/// Returns the angle in the middle of the nutation, rad.
fn middle(top: &HeavyTop) -> f64 {
    let [highest, lowest] = top.nutation_bounds();
    0.5 * (highest + lowest)
}
