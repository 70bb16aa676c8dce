//! Content of the 3-D view other than the body: playback speed, gravity, orbit, and captions.

use polhode::motion::torque::TorqueModel;
use polhode::motion::{HeavyTop, Scenario};
use polhode_document::json::{finite, numbers};
use serde_json::{Value, json};

use super::caption::Captions;
use super::orbit;
use crate::report::facts::{Known, time_round};
use crate::report::free_facts::FreeFacts;

/// Largest number of nutations per precession for which the playback follows the precession.
const MOST_NUTATIONS: f64 = 100.0;

pub(crate) fn json(known: &Known<'_>, free: Option<&FreeFacts>) -> Value {
    json!({
        "period": known.heavy_top.as_ref().map_or_else(|| free.and_then(slow_period), precession_period),
        "gravity": known.scenario.and_then(gravity).map(|g| numbers(&g.map(finite))),
        "orbit": known.scenario.and_then(Scenario::orbit).map(orbit::json),
        "captions": Captions::of(known, free).json(),
    })
}

/// Returns the period of precession about the vertical, s, or that of nutation if precession is
/// absent or too slow.
fn precession_period(top: &HeavyTop) -> Option<f64> {
    let nutation = top.nutation_period()?;
    Some(time_round(top).filter(|period| *period <= MOST_NUTATIONS * nutation).unwrap_or(nutation))
}

/// Returns the longest period of a free motion, s.
fn slow_period(free: &FreeFacts) -> Option<f64> {
    let periods = [free.periods.precession, free.periods.rotation, free.regime.period];
    periods.into_iter().flatten().reduce(f64::max).filter(|period| period.is_finite())
}

/// Returns the acceleration of gravity, m/s², space axes, if it exerts a torque.
fn gravity(scenario: &Scenario) -> Option<[f64; 3]> {
    let model = |torque: &TorqueModel| match torque {
        TorqueModel::Gravity(gravity) => Some(gravity.acceleration.to_array()),
        _ => None,
    };
    scenario.torques().iter().find_map(model).filter(|_| scenario.rotor().is_pivoted())
}
