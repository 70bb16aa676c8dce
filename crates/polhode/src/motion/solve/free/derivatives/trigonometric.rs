//! Integrals as trigonometric series, for a nome that is not near 1.

use crate::math::elementary::{polynomial, sin_cos_quarters};
use crate::math::means::mean_sine_squared;
use crate::math::number::PI;
use crate::motion::solve::free::compact::{ScalarThetaParameters, ThetaParameters};
use crate::motion::solve::free::elements::Elements;
use crate::motion::solve::free::flow::{Point, Series};
use crate::motion::solve::free::trigonometric::{Nomes, Trigonometric};
use crate::motion::solve::phase::Phase;

use super::elliptic::Elliptic;

/// Integrals ∫ sn² du and ∫ sn²/dn² du, from the mean s̄ of sn² and Jacobi's zeta function Z =
/// (π/2K) θ₄′/θ₄:
///
/// ∫ sn² du = s̄ u − Z/m,  ∫ sn²/dn² du = ((1 − s̄) u + Z/m − sn cn/dn)/m₁
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TrigonometricIntegrals {
    series: Trigonometric<f64>,
    /// Factors that turn quotients of theta functions into cn, sn and dn.
    scale: [f64; 3],
    /// Mean s̄ of sn².
    mean: f64,
    /// 1/m₁
    inverse_m1: f64,
    /// θ₄′ (π/2K)/(m sin 2z) as a polynomial in 2 cos 2z.
    zeta: [f64; 4],
}

/// Threshold of m. Below it the nome of m is m/16 to full f64 precision.
const TINY: f64 = 1e-30;

impl TrigonometricIntegrals {
    pub(super) fn of(elements: &Elements) -> Self {
        let (m, nomes) = (elements.m.value(), Nomes::of(elements).0);
        let q = nomes.nome;
        let factor = 2.0 * PI / elements.quarter.value() * if m < TINY { 1.0 / 16.0 } else { q / m };
        let (q3, q8) = (q * q * q, (q * q) * (q * q) * (q * q) * (q * q));
        let q15 = q8 * (q3 * q3) * q;
        // θ₄′ = 4q sin 2z (1 − 2q³ C + 3q⁸ (C² − 1) − 4q¹⁵ (C³ − 2C) + …), C = 2 cos 2z
        let zeta = [1.0 - 3.0 * q8, 8.0 * q15 - 2.0 * q3, 3.0 * q8, -4.0 * q15].map(|c| factor * c);
        Self {
            series: nomes.series(),
            scale: nomes.scale(),
            mean: mean_sine_squared(m, elements.k1.value()),
            inverse_m1: 1.0 / elements.m1().value(),
            zeta,
        }
    }

    #[inline(always)]
    pub(super) fn at(&self, z: Phase<f64>, u: f64) -> Elliptic {
        let (sin, cos) = sin_cos_quarters(z.quarters, z.rest);
        let Point { theta, below, .. } = self.series.at([cos, sin]);
        let over = 1.0 / below;
        let [cn, sn, dn] = [
            theta[0] * self.scale[0] * over,
            theta[1] * self.scale[1] * over,
            theta[2] * self.scale[2] * over,
        ];
        let (double_sine, double_cosine) = (2.0 * (sin * cos), 2.0 * (cos * cos - sin * sin));
        let zeta = double_sine * polynomial(double_cosine, self.zeta) * over;
        Elliptic {
            sn,
            cn,
            dn,
            square: self.mean * u - zeta,
            quotient: ((1.0 - self.mean) * u + zeta - sn * cn / dn) * self.inverse_m1,
        }
    }
}
