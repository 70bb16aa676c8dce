//! The results of Lagrange's top, beside its motion: bounds, periods, rates and kind, in text, JSON and on the page.

use polhode::motion::torque::TorqueModel;
use polhode::motion::{HeavyTop, Scenario, State, SteadyPrecession, TopPath};
use polhode_document::layout::labelled;
use polhode_document::number::number;
use polhode_document::unit::{DIGITS, rate};
use serde_json::{Value, json};

/// The top that a scenario's body is, if gravity alone acts on it and it is symmetric about its arm.
pub(crate) fn of(scenario: &Scenario, start: State) -> Option<HeavyTop> {
    let [TorqueModel::Gravity(gravity)] = scenario.torques() else { return None };
    if scenario.prescribed().is_some() || scenario.suspension().is_some() || scenario.history().is_some() {
        return None;
    }
    HeavyTop::of(scenario.rotor(), gravity, start).ok()
}

/// `summary.json`, key `heavy_top`.
pub(crate) fn to_json(top: &HeavyTop) -> Value {
    let [across, along] = top.moments();
    let [highest, lowest] = top.nutation_bounds();
    let steady = steady(top);
    json!({
        "path": top.path().name(),
        "transverse_moment": across,
        "axial_moment": along,
        "weight_torque_n_m": top.weight_torque(),
        "spin_rad_s": top.spin(),
        "nutation_rad": [highest, lowest],
        "nutation_period_s": top.nutation_period(),
        "precession_in_a_nutation_rad": top.precession_in_a_nutation(),
        "mean_precession_rad_s": top.mean_precession(),
        "mean_spin_rad_s": top.mean_spin(),
        "sleeping_threshold_rad_s": Some(top.sleeping_threshold()).filter(|spin| spin.is_finite()),
        "steady_slow_rad_s": steady.map(|rates| rates.slow),
        "steady_fast_rad_s": steady.and_then(|rates| rates.fast),
    })
}

/// The lines of the screen.
pub(crate) fn to_text(top: &HeavyTop) -> String {
    let mut text = String::new();
    for Fact { label, value, unit, note } in facts(top) {
        let unit = if unit.is_empty() || unit == "°" { unit.to_owned() } else { format!(" {unit}") };
        let note = if note.is_empty() { String::new() } else { format!(", {note}") };
        text.push_str(&labelled(label, &format!("{value}{unit}{note}")));
    }
    text
}

/// One number or word, for the screen and the page.
pub(crate) struct Fact {
    pub(crate) label: &'static str,
    pub(crate) value: String,
    pub(crate) unit: &'static str,
    pub(crate) note: String,
}

/// What there is to say, in order.
pub(crate) fn facts(top: &HeavyTop) -> Vec<Fact> {
    let fact = |label, value, unit, note: &str| Fact { label, value, unit, note: note.to_owned() };
    let shown = |x: f64| number(x, DIGITS);
    let mut facts = vec![fact("heavy top", top.path().description().to_owned(), "", "")];
    let [highest, lowest] = top.nutation_bounds().map(|angle| number(angle.to_degrees(), DIGITS));
    if highest == lowest {
        facts.push(fact("leaning", highest, "°", "from the vertical"));
    } else {
        facts.push(fact("leaning", format!("{highest} … {lowest}"), "°", "from the vertical"));
    }
    if let Some(period) = top.nutation_period() {
        let steady = matches!(top.path(), TopPath::SteadySlow | TopPath::SteadyFast | TopPath::Conical);
        let note = if steady { "of small nutations" } else { "of nutation" };
        facts.push(fact("period", shown(period), "s", note));
    }
    if let (Some(precession), Some(spin)) = (top.mean_precession(), top.mean_spin()) {
        facts.push(fact("precession", rate(precession), "", "on average, about the vertical"));
        facts.push(fact("own spin", rate(spin), "", "on average, about the axis"));
    } else if let Some(turned) = top.precession_in_a_nutation() {
        facts.push(fact("precession", shown(turned.to_degrees()), "°", "in a nutation, about the vertical"));
    }
    if let Some(SteadyPrecession { slow, fast }) = steady(top).filter(|_| is_inclined(top)) {
        let middle = number(middle(top).to_degrees(), DIGITS);
        let fast = fast.map_or_else(String::new, |fast| format!(" and {}, the fast one", rate(fast)));
        let note = format!("the slow one{fast}: without nodding at {middle}°, with this ω along the axis");
        facts.push(fact("steady", rate(slow), "", &note));
    }
    let threshold = top.sleeping_threshold();
    if threshold.is_finite() {
        let note = format!("upright, above 2 √(M g l A)/C; here ω along the axis is {}", rate(top.spin()));
        facts.push(fact("would sleep", rate(threshold), "", &note));
    }
    facts
}

/// The steady rates at the middle of the nutation, with its spin.
fn steady(top: &HeavyTop) -> Option<SteadyPrecession> {
    top.steady_precession(middle(top), top.spin())
}

/// The angle in the middle of the nutation, rad.
fn middle(top: &HeavyTop) -> f64 {
    let [highest, lowest] = top.nutation_bounds();
    0.5 * (highest + lowest)
}

/// True unless the axis stays vertical, or in one vertical plane: there is nothing to precess then.
const fn is_inclined(top: &HeavyTop) -> bool {
    !matches!(top.path(), TopPath::Sleeping { .. } | TopPath::Hanging | TopPath::Planar)
}
