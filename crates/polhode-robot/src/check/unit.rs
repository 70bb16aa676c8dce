//! All elements wrong by one factor: a unit other than kg·m² (`inertia.unit`), or a power of ten,
//! the mass, or lengths (`inertia.geometry`).
//!
//! CAD programs print g·mm² like kg·m², and a file does not state the unit. If the change of unit
//! gives the geometry's tensor in all elements, it is a fix. If only the magnitude agrees and the
//! radius of gyration is unrealistic, it is a question to the user ([`super::gyration`]).

use super::explanation::{Candidates, Change, Slip, TIGHT, times_too};
use super::factor::{self, RULE};
use super::placeholder::is_round;
use super::written::short;
use crate::moments::trace;

/// Unit of moments of inertia.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unit {
    pub(crate) name: &'static str,
    /// Value of the unit, kg·m².
    pub(crate) factor: f64,
    /// Exponent of the factor, if it is a power of ten.
    power: Option<i32>,
}

pub(crate) const UNITS: [Unit; 8] = [
    Unit { name: "g·mm²", factor: 1e-9, power: Some(-9) },
    Unit { name: "g·cm²", factor: 1e-7, power: Some(-7) },
    Unit { name: "kg·mm²", factor: 1e-6, power: Some(-6) },
    Unit { name: "kg·cm²", factor: 1e-4, power: Some(-4) },
    Unit { name: "g·m² or t·mm²", factor: 1e-3, power: Some(-3) },
    Unit { name: "oz·in²", factor: 1.828_997_852_041_5e-5, power: None },
    Unit { name: "lb·in²", factor: 2.926_396_563_266_4e-4, power: None },
    Unit { name: "lb·ft²", factor: 0.042_140_110_093_80, power: None },
];

/// Powers of ten for tensors that are too small: the same errors in the opposite direction.
const TOO_SMALL: [i32; 4] = [3, 4, 6, 9];

/// Returns the unit that explains numbers too large by `ratio`, within a factor.
pub(super) fn nearest(ratio: f64, within: f64) -> Option<Unit> {
    let distance = |u: &Unit| (ratio * u.factor).ln().abs();
    let decimal = UNITS.iter().filter(|u| u.power.is_some());
    decimal.min_by(|a, b| distance(a).total_cmp(&distance(b))).filter(|u| distance(u) <= within.ln()).copied()
}

pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    if is_round(body) {
        return; // a placeholder
    }
    let loose = candidates.loose();
    let slip = |code, mistake, rule| Slip { code, mistake, rule, span: body.tensor_place(), is_sure: true };
    let size = || format!("{} kg·m² for {} kg", short(body.moments.values[2], 4), short(body.mass, 4));
    let right = trace(&candidates.target) / trace(&body.written);
    let power = right.log10().round();
    if power != 0.0 && power.abs() <= 12.0 {
        let power = power as i32;
        candidates.offer([Change::Shift(power); 6], loose, || {
            let unit = UNITS.iter().find(|unit| unit.power == Some(power));
            let unit_rule = "moments of inertia are in kg·m²";
            match unit {
                Some(unit) => {
                    slip("inertia.unit", format!("{}; {} written as kg·m²", size(), unit.name), unit_rule)
                }
                None if TOO_SMALL.contains(&power) => {
                    let mistake = format!("{}; {}", size(), times_too(power));
                    slip("inertia.unit", mistake, unit_rule)
                }
                None => slip("inertia.geometry", format!("all elements are {}", times_too(power)), RULE),
            }
        });
    }
    for unit in UNITS.iter().filter(|unit| unit.power.is_none()) {
        candidates.offer([Change::Scale(unit.factor); 6], loose, || {
            let mistake = format!("{}; {} written as kg·m²", size(), unit.name);
            slip("inertia.unit", mistake, "moments of inertia are in kg·m²")
        });
    }
    for (factor, why) in factor::named(candidates) {
        candidates.offer([Change::Scale(factor); 6], TIGHT, || {
            slip("inertia.geometry", format!("all elements: {why}"), RULE)
        });
    }
}
