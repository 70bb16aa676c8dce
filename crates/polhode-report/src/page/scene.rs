//! What the 3-D view shows besides the body: how fast it should play, gravity, and a line on each picture.

use polhode::motion::torque::TorqueModel;
use polhode::motion::{HeavyTop, Scenario, Solution};
use polhode_document::json::{finite, numbers};
use serde_json::{Value, json};

use super::caption::Captions;
use super::top::time_round;
use super::{PageInput, PageSubject};
use crate::free_facts::FreeFacts;

/// A precession of more nutations is not what the eye follows.
const MOST_NUTATIONS: f64 = 100.0;

pub(super) fn json(input: &PageInput<'_>, free: Option<&FreeFacts>) -> Value {
    let scenario = match input.subject {
        PageSubject::Scenario(scenario) => Some(scenario),
        PageSubject::Moments(_) => None,
    };
    let top = scenario.and_then(|s| top(s, input));
    json!({
        "period": top.as_ref().map_or_else(|| free.and_then(slow_period), precession_period),
        "gravity": scenario.and_then(gravity).map(|g| numbers(&g.map(finite))),
        "captions": Captions::of(scenario, input.trajectory, top.as_ref(), free).json(),
    })
}

/// The heavy top whose motion is shown.
fn top(scenario: &Scenario, input: &PageInput<'_>) -> Option<HeavyTop> {
    let is_computed = !matches!(input.trajectory.solution(), Solution::Prescribed(_));
    crate::heavy_top::of(scenario, input.trajectory.start().state).filter(|_| is_computed)
}

/// The time of a precession about the vertical, s; of a nutation where there is none.
fn precession_period(top: &HeavyTop) -> Option<f64> {
    let nutation = top.nutation_period()?;
    Some(time_round(top).filter(|period| *period <= MOST_NUTATIONS * nutation).unwrap_or(nutation))
}

/// The longest of a free motion's periods, s.
fn slow_period(free: &FreeFacts) -> Option<f64> {
    let periods = [free.periods.precession, free.periods.rotation, free.regime.period];
    periods.into_iter().flatten().reduce(f64::max).filter(|period| period.is_finite())
}

/// The acceleration of gravity, space axes, m/s², if it turns the body.
fn gravity(scenario: &Scenario) -> Option<[f64; 3]> {
    let model = |torque: &TorqueModel| match torque {
        TorqueModel::Gravity(gravity) => Some(gravity.acceleration.to_array()),
        _ => None,
    };
    scenario.torques().iter().find_map(model).filter(|_| scenario.rotor().is_pivoted())
}
