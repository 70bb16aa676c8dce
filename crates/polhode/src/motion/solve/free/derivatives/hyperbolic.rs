//! Integrals as a few travelling pulses, for a nome near 1 up to the separatrix.

use crate::math::means::mean_sine_squared;
use crate::motion::solve::free::compact::{ScalarThetaParameters, ThetaParameters};
use crate::motion::solve::free::elements::Elements;
use crate::motion::solve::free::hyperbolic::{Ends, Hyperbolic, Pulse, within_half_period};
use crate::motion::solve::phase::Phase;

use super::elliptic::Elliptic;

/// Integrals ∫ sn² du and ∫ sn²/dn² du by theta functions of the complementary nome.
///
/// Let Y = πu/2K′ minus N half periods, q′ the nome of m₁, s′ the mean of sn² of parameter m₁, and
/// E′/K′ = 1 − m₁ s′. Then
///
/// m ∫ sn² du = (E′/K′) u − (π/2K′)(2N + d ln θ₂(iY|q′)/dY),
/// m ∫ sn²/dn² du = −(1 − s′) u + (π/2K′)(2N + d ln θ₃(iY|q′)/dY)/m₁,
/// θ₂ ∝ cosh Y + q′² cosh 3Y + q′⁶ cosh 5Y …,  θ₃ = 1 + 2q′ cosh 2Y + 2q′⁴ cosh 4Y …
///
/// q′/m₁ → 1/16 for m₁ → 0, so nothing is divided by m₁ before a half period has passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HyperbolicIntegrals {
    series: Hyperbolic<f64>,
    /// Factors that turn quotients of theta functions into cn, sn and dn.
    scale: [f64; 3],
    /// E′/K′
    share: f64,
    /// 1 − s′
    rest: f64,
    /// π/2K′
    rate: f64,
    inverse_m: f64,
    m1: f64,
    /// q′/m₁
    ratio: f64,
}

/// Threshold of √m₁. Below it the nome of m₁ is m₁/16 to full f64 precision.
const TINY: f64 = 1e-9;

impl HyperbolicIntegrals {
    pub(super) fn of(elements: &Elements) -> Self {
        let (m, m1, k1) = (elements.m.value(), elements.m1().value(), elements.k1.value());
        let pulse = Pulse::of(elements).0;
        let series = pulse.series();
        let mean = mean_sine_squared(m1, elements.m.sqrt().value());
        // πκ = (π/2K′) K
        let rate = pulse.stretch / elements.quarter.value();
        Self {
            scale: pulse.scale(),
            share: 1.0 - m1 * mean,
            rest: 1.0 - mean,
            rate,
            inverse_m: 1.0 / m,
            m1,
            ratio: if k1 < TINY { 1.0 / 16.0 } else { series.squares[0] / m1 },
            series,
        }
    }

    /// Evaluates the functions and integrals. `quarters`: 2z/π before reduction; `z` is the reduced
    /// value.
    #[inline(always)]
    pub(super) fn at(&self, z: Phase<f64>, u: f64, quarters: f64) -> Elliptic {
        let Ends { sign, turned, falling: x, rising: w } = self.series.ends([z.quarters, z.rest]);
        let ([cn, sn, dn], below) = self.series.elliptic(x, w);
        let over = 1.0 / below;
        let half_periods = (0.5 * (quarters - within_half_period(z))).round();
        let [q1, q2, _] = self.series.squares;
        let (v, u2) = (w * w, x * x); // e^2|Y| q′ and e^−2|Y|
        // d ln θ₂/dY, and d ln θ₃/dY divided by m₁
        let of_second = ((1.0 - u2) + 5.0 * (q2 * q2) * (v * v) + 3.0 * q1 * (v - q1 * (u2 * u2))) * over;
        let grown = 1.0 / u2; // e^2|Y|
        let third = 1.0 + (v + q1 * u2) + q2 * (v * v + q2 * (u2 * u2));
        let of_third = self.ratio * (2.0 * (grown - u2) + 4.0 * q2 * (v * grown - q1 * (u2 * u2))) / third;
        let passed = if half_periods == 0.0 { 0.0 } else { 2.0 * half_periods / self.m1 };
        Elliptic {
            sn: turned * sign * sn * over * self.scale[1],
            cn: turned * cn * over * self.scale[0],
            dn: dn * over * self.scale[2],
            square: (self.share * u - self.rate * (2.0 * half_periods + sign * of_second)) * self.inverse_m,
            quotient: (self.rate * (passed + sign * of_third) - self.rest * u) * self.inverse_m,
        }
    }
}
