//! Changes of the errors of a row.

use polhode_document::number::number;

use crate::{LiquidErrors, Measured, PartUncertainty, Row, Spread, Uncertainty};

/// Standard deviation of a number of a row, before and after, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Deviation {
    /// Name of the number's column in the list.
    pub name: &'static str,
    pub sd: [f64; 2],
    unit: &'static str,
    /// Factor from the SI unit to the shown unit.
    scale: f64,
}

const COUNT: usize = 18;

/// Columns of numbers that have errors, including those of liquids. Each has its shown unit and the
/// factor from SI.
const NUMBERS: [(&str, &str, f64); COUNT] = [
    ("mass", "kg", 1.0),
    ("x", "mm", 1e3),
    ("y", "mm", 1e3),
    ("z", "mm", 1e3),
    ("ixx", "kg·m²", 1.0),
    ("iyy", "kg·m²", 1.0),
    ("izz", "kg·m²", 1.0),
    ("ixy", "kg·m²", 1.0),
    ("ixz", "kg·m²", 1.0),
    ("iyz", "kg·m²", 1.0),
    ("at x", "mm", 1e3),
    ("at y", "mm", 1e3),
    ("at z", "mm", 1e3),
    ("rotate x", "deg", 180.0 / core::f64::consts::PI),
    ("rotate y", "deg", 180.0 / core::f64::consts::PI),
    ("rotate z", "deg", 180.0 / core::f64::consts::PI),
    ("fill", "%", 100.0),
    ("density", "%", 100.0),
];

/// Relative rounding error of a change of units.
const ROUNDING: f64 = 1e-12;

/// Returns the standard deviations that differ. There are none if only correlations differ, or only
/// the reference point or the sign of the tensor. Returns `None` if nothing differs.
pub(crate) fn changed(rows: [&Row; 2]) -> Option<Vec<Deviation>> {
    let sd = rows.map(|row| deviations(&row.uncertainty));
    let mut all = Vec::new();
    for (k, (name, unit, scale)) in NUMBERS.into_iter().enumerate() {
        let sd = [sd[0][k], sd[1][k]];
        if (sd[0] - sd[1]).abs() > ROUNDING * sd[0].max(sd[1]) {
            all.push(Deviation { name, sd, unit, scale });
        }
    }
    let [before, after] = rows;
    let has_joint = rows.iter().any(|row| is_joint(&row.uncertainty));
    let is_correlated_otherwise = has_joint && before.uncertainty != after.uncertainty;
    // Errors of a tensor depend on its reference point and its sign convention.
    let has_tensor = (4..10).any(|k| sd[0][k] > 0.0 && sd[1][k] > 0.0);
    let of_tensor = |row: &Row| row.part.as_ref().map(|part| (part.tensor.about.clone(), part.tensor.sign));
    let is_about_other = has_tensor && of_tensor(before) != of_tensor(after);
    (!all.is_empty() || is_correlated_otherwise || is_about_other).then_some(all)
}

fn deviations(of: &Uncertainty) -> [f64; COUNT] {
    let mut all = [0.0; COUNT];
    let mut put = |from: usize, sd: &[f64]| {
        all.iter_mut().skip(from).zip(sd).for_each(|(slot, sd)| *slot = *sd);
    };
    match &of.part {
        PartUncertainty::Separate { mass, center, tensor, .. } => {
            put(0, &[*mass]);
            put(1, &sd(center));
            put(4, &sd(tensor));
        }
        PartUncertainty::Joint(covariance) => put(0, &diagonal(covariance)),
        PartUncertainty::Liquid(liquid) => {
            let LiquidErrors { measured, amount, density } = liquid.errors;
            match measured {
                Measured::Mass => put(0, &[amount]),
                Measured::Fill => put(16, &[amount / liquid.liquid.capacity()]),
            }
            put(17, &[density]);
        }
    }
    put(10, &sd(&of.position));
    put(13, &sd(&of.rotation));
    all
}

fn sd<const N: usize>(spread: &Spread<N>) -> [f64; N] {
    match spread {
        Spread::Exact => [0.0; N],
        Spread::Deviations(all) => *all,
        Spread::Covariance(covariance) => diagonal(covariance),
    }
}

fn diagonal<const N: usize>(covariance: &[[f64; N]; N]) -> [f64; N] {
    core::array::from_fn(|k| covariance[k][k].sqrt())
}

/// Returns true if errors are given by a matrix.
const fn is_joint(of: &Uncertainty) -> bool {
    let of_part = match &of.part {
        PartUncertainty::Separate { center, tensor, .. } => {
            matches!(center, Spread::Covariance(_)) || matches!(tensor, Spread::Covariance(_))
        }
        PartUncertainty::Joint(_) => true,
        PartUncertainty::Liquid(_) => false,
    };
    of_part || matches!(of.position, Spread::Covariance(_)) || matches!(of.rotation, Spread::Covariance(_))
}

impl Deviation {
    /// Returns words such as `mass 0.06 to 0.002 kg`.
    pub(crate) fn words(&self) -> String {
        let [before, after] = self.sd.map(|sd| number(self.scale * sd, 4));
        format!("{} {before} to {after} {}", self.name, self.unit)
    }
}
