//! ω as three functions of time: formulas, or a spline through a table.

use crate::math::formula::Formula;
use crate::math::spline::Spline;

/// Three components of ω, rad/s, along body or space axes.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Rates {
    Formulas([Formula; 3]),
    Table(Spline<3>),
}

impl Rates {
    /// Returns ω, rad/s.
    pub(super) fn omega(&self, time: f64) -> [f64; 3] {
        match self {
            Self::Formulas(formulas) => formulas.each_ref().map(|formula| formula.evaluate(&[time])),
            Self::Table(spline) => spline.at(time)[0],
        }
    }

    /// Returns ω, rad/s, and dω/dt, rad/s².
    pub(super) fn at(&self, time: f64) -> [[f64; 3]; 2] {
        match self {
            Self::Formulas(formulas) => {
                let jets = formulas.each_ref().map(|formula| formula.derivatives(time));
                [jets.map(|jet| jet[0]), jets.map(|jet| jet[1])]
            }
            Self::Table(spline) => {
                let [omega, rate, _] = spline.at(time);
                [omega, rate]
            }
        }
    }
}
