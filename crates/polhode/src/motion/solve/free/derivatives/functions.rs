//! Functions of time that occur in the derivatives.

use core::array::from_fn;

use crate::math::elementary::polynomial;
use crate::motion::solve::free::elements::Elements;
use crate::motion::solve::free::kernel::BALANCE;
use crate::motion::solve::phase::{Angle, Elapsed};

use super::elliptic::Elliptic;
use super::hyperbolic::HyperbolicIntegrals;
use super::trigonometric::TrigonometricIntegrals;

/// Functions of the time t since the start, where u = λt, P = λ² and Q = m λ².
#[derive(Clone, Copy, Debug)]
pub(super) struct TimeFunctions {
    pub(super) time: f64,
    /// σ = sn u / λ
    pub(super) sigma: f64,
    pub(super) cn: f64,
    pub(super) dn: f64,
    /// 1/dn u
    pub(super) over_dn: f64,
    /// S = ∫ σ² dt
    pub(super) square: f64,
    /// V = ∫ σ²/dn² dt
    pub(super) quotient: f64,
    /// W = (σ − t cn dn)/P
    pub(super) lag: f64,
    /// True if |u| is small. W is then formed without division by P, which may be zero.
    pub(super) is_near: bool,
}

/// Constants of the functions of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Functions {
    /// 2z/π, where z = πu/2K, in quarter turns.
    phase: Angle,
    lambda: f64,
    /// 1/λ
    inverse: f64,
    m: f64,
    near: NearSeries,
    far: Far,
}

/// Integrals by the shorter series, the same one as for the motion itself.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Far {
    Trigonometric(TrigonometricIntegrals),
    Hyperbolic(HyperbolicIntegrals),
}

impl Functions {
    /// `factor`: unit of the elements' rates divided by that of the phase's rates.
    pub(super) fn of(elements: &Elements, factor: f64) -> Self {
        let rate = (elements.lambda / elements.quarter).scaled(factor);
        let m = elements.m.value();
        let far = if elements.m1().value() > BALANCE {
            Far::Trigonometric(TrigonometricIntegrals::of(elements))
        } else {
            Far::Hyperbolic(HyperbolicIntegrals::of(elements))
        };
        Self {
            phase: Angle::of(rate, Default::default()),
            lambda: elements.lambda.value(),
            inverse: 1.0 / elements.lambda.value(),
            m,
            near: NearSeries::of(m),
            far,
        }
    }

    /// Evaluates the functions. `elapsed` is in the time unit of the phase, `time` in that of the
    /// elements.
    #[inline(always)]
    pub(super) fn at(&self, elapsed: &Elapsed<f64>, time: f64) -> TimeFunctions {
        let (lambda, u) = (self.lambda, self.lambda * time);
        if u.abs() < NEAR {
            return self.near.at(time, u * u, lambda * lambda, self.m);
        }
        let phase = if elapsed.is_within(self.phase.reach) {
            self.phase.at::<f64, false>(elapsed)
        } else {
            self.phase.at::<f64, true>(elapsed)
        };
        let Elliptic { sn, cn, dn, square, quotient } = match &self.far {
            Far::Trigonometric(integrals) => integrals.at(phase, u),
            Far::Hyperbolic(integrals) => integrals.at(phase, u, self.phase.quarters(elapsed)),
        };
        let cubed = self.inverse * self.inverse * self.inverse;
        TimeFunctions {
            time,
            sigma: sn * self.inverse,
            cn,
            dn,
            over_dn: 1.0 / dn,
            square: square * cubed,
            quotient: quotient * cubed,
            lag: (sn - u * (cn * dn)) * cubed,
            is_near: false,
        }
    }
}

/// Coefficients of σ/t, S/t³, V/t³ and W/t³ as polynomials in u².
#[derive(Clone, Copy, Debug, PartialEq)]
struct NearSeries([[f64; TERMS]; 4]);

/// Threshold of |u| for the power series. Up to it they have full precision, because they converge
/// like that of tan u.
const NEAR: f64 = 0.2;

const TERMS: usize = 8;

impl NearSeries {
    /// Computes the coefficients from sn′ = cn dn, cn′ = −sn dn, dn′ = −m sn cn. If sn = Σ sₖ
    /// u²ᵏ⁺¹, then W = −Σ 2k sₖ u²ᵏ⁺¹.
    fn of(m: f64) -> Self {
        let (mut s, mut c, mut d) = ([0.0; TERMS + 1], [0.0; TERMS + 1], [0.0; TERMS + 1]);
        (c[0], d[0]) = (1.0, 1.0);
        let mut degree = 0.0;
        for k in 0..=TERMS {
            s[k] = product(&c, &d, k) / (degree + 1.0);
            degree += 2.0;
            if k < TERMS {
                c[k + 1] = -product(&s, &d, k) / degree;
                d[k + 1] = -m * product(&s, &c, k) / degree;
            }
        }
        let mut r = [0.0; TERMS + 1]; // sn/dn
        for k in 0..=TERMS {
            r[k] = s[k] - (1..=k).map(|j| d[j] * r[k - j]).sum::<f64>();
        }
        let mut power = 1.0;
        let odd: [f64; TERMS] = from_fn(|_| {
            power += 2.0;
            power
        });
        Self([
            from_fn(|k| s[k]),
            from_fn(|k| product(&s, &s, k) / odd[k]),
            from_fn(|k| product(&r, &r, k) / odd[k]),
            from_fn(|k| (1.0 - odd[k]) * s[k + 1]),
        ])
    }

    fn at(&self, t: f64, u2: f64, p: f64, m: f64) -> TimeFunctions {
        let [sigma, square, quotient, lag] = &self.0;
        let (sigma, square) = (polynomial(u2, *sigma), polynomial(u2, *square));
        let (quotient, lag) = (polynomial(u2, *quotient), polynomial(u2, *lag));
        let (sigma, cubed) = (t * sigma, t * t * t);
        let sn2 = p * sigma * sigma;
        let dn = (1.0 - m * sn2).sqrt();
        TimeFunctions {
            time: t,
            sigma,
            cn: (1.0 - sn2).sqrt(),
            dn,
            over_dn: 1.0 / dn,
            square: cubed * square,
            quotient: cubed * quotient,
            lag: cubed * lag,
            is_near: true,
        }
    }
}

/// Returns coefficient k of the product of two series.
fn product(a: &[f64; TERMS + 1], b: &[f64; TERMS + 1], k: usize) -> f64 {
    (0..=k).map(|j| a[j] * b[k - j]).sum()
}
