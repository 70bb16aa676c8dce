//! Another unit entered as kg·m²: `inertia.unit`.
//!
//! CAD programs print g·mm² as they print kg·m², and a file does not say. Where the geometry's tensor is found again
//! after the change of unit, in all elements, that is proved. Where only the size is right, and the gyration radius
//! absurd, it is asked ([`super::gyration`]).

use super::explanation::{Candidates, Explanation, edits};
use super::written::{restyled, shifted, short};
use crate::moments::{difference, norm, scaled, trace};

/// A unit that moments of inertia are given in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    pub(super) name: &'static str,
    /// In kg·m².
    pub(super) factor: f64,
    /// The factor as a power of ten, if it is one.
    power: Option<i32>,
}

const UNITS: [Unit; 8] = [
    Unit { name: "g·mm²", factor: 1e-9, power: Some(-9) },
    Unit { name: "g·cm²", factor: 1e-7, power: Some(-7) },
    Unit { name: "kg·mm²", factor: 1e-6, power: Some(-6) },
    Unit { name: "kg·cm²", factor: 1e-4, power: Some(-4) },
    Unit { name: "g·m² or t·mm²", factor: 1e-3, power: Some(-3) },
    Unit { name: "oz·in²", factor: 1.828_997_852_041_5e-5, power: None },
    Unit { name: "lb·in²", factor: 2.926_396_563_266_4e-4, power: None },
    Unit { name: "lb·ft²", factor: 0.042_140_110_093_80, power: None },
];

/// Tensors too small by these: the same slips the other way.
const TOO_SMALL: [i32; 4] = [3, 4, 6, 9];

/// A dummy is round, and so are cubes and spheres: these three agree by chance more often than six numbers do. Below
/// this part of the tensor its differences count as none.
const ROUND: f64 = 0.05;

/// The unit in which numbers too large by `ratio` would be right, to within a factor.
pub(super) fn nearest(ratio: f64, within: f64) -> Option<Unit> {
    let distance = |u: &Unit| (ratio * u.factor).ln().abs();
    let decimal = UNITS.iter().filter(|u| u.power.is_some());
    decimal.min_by(|a, b| distance(a).total_cmp(&distance(b))).filter(|u| distance(u) <= within.ln()).copied()
}

pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    let third = trace(&body.tensor) / 3.0;
    let differences = norm(&difference(&body.tensor, &[third, third, third, 0.0, 0.0, 0.0]));
    if differences <= ROUND * norm(&body.tensor) {
        return;
    }
    let moment = || short(body.moments.values[2], 4);
    let explanation = |mistake, text: &dyn Fn(usize, &str) -> Option<String>| Explanation {
        code: "inertia.unit",
        mistake,
        rule: "moments of inertia are in kg·m²",
        span: body.tensor_place(),
        edits: edits(body, |k, old| if body.written[k] == 0.0 { Some(old.to_owned()) } else { text(k, old) }),
    };
    for unit in UNITS {
        candidates.offer(scaled(&body.tensor, unit.factor), || {
            let mass = short(body.mass, 4);
            let mistake = format!("{} kg·m² on {mass} kg, {} written as kg·m²", moment(), unit.name);
            explanation(mistake, &|k, text| match unit.power {
                Some(power) => shifted(text, power),
                None => Some(restyled(body.written[k] * unit.factor, text)),
            })
        });
    }
    for power in TOO_SMALL {
        candidates.offer(scaled(&body.tensor, 10f64.powi(power)), || {
            let mistake = format!("{} kg·m² is 10^{power} times too small", moment());
            explanation(mistake, &|_, text| shifted(text, power))
        });
    }
}
