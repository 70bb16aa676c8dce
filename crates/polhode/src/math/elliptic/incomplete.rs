//! Incomplete elliptic integrals F, E and Π for any amplitude, with one formula for the three
//! kinds.
//!
//! Let s = sin φ, c = cos φ and Δ² = 1 − m s² = c² + m₁ s². Then
//!
//! F, E, Π(n) = s R_F(c², Δ², 1) + w s³/3 R_J(c², Δ², 1, 1 − n s²),
//!
//! where (w, n) is absent for F, (−m, 0) for E and (n, n) for Π.
//!
//! All terms are positive except the second term of E for m > 0, which cancels by a factor of about
//! 100 at most (double-double arithmetic has sufficient digits), and that of Π for n < 0. For large
//! |n|, the characteristic is changed to m/n there:
//!
//! Π(n) = s R_C(c² Δ², p²q²) + w s³/3 R_J(c², Δ², 1, q²),
//! w = −m/n, p² = 1 − n s², q² = 1 − (m/n) s².
//!
//! Sources: DLMF 19.25.5, 19.25.9, 19.25.14, 19.21.12; F and E beyond a quarter turn: 19.2.10.

use crate::math::double::Double;

use super::carlson::{rc, rf, rj};
use super::reduced::Reduced;
use super::{EllipticError, EllipticParameter, HUGE, TINY, root};

impl EllipticParameter {
    /// Returns F(φ | m) = ∫₀^φ dt / √(1 − m sin²t), the integral of the first kind, for any real φ
    /// in rad.
    ///
    /// It is infinite beyond ±π/2 at m = 1, infinite for infinite φ, and NaN for NaN.
    ///
    /// ```
    /// let m = polhode::math::elliptic::EllipticParameter::new(0.8)?;
    /// assert!((m.incomplete_f(m.jacobi(17.0).am) - 17.0).abs() < 1e-14);
    /// # Ok::<(), polhode::math::elliptic::EllipticError>(())
    /// ```
    ///
    /// Source: DLMF 19.2.4.
    pub fn incomplete_f(&self, phi: f64) -> f64 {
        self.incomplete(IntegralKind::First, phi)
    }

    /// Returns E(φ | m) = ∫₀^φ √(1 − m sin²t) dt, the integral of the second kind, for any real φ
    /// in rad.
    ///
    /// It is infinite for infinite φ, and NaN for NaN.
    ///
    /// Source: DLMF 19.2.5.
    pub fn incomplete_e(&self, phi: f64) -> f64 {
        self.incomplete(IntegralKind::Second, phi)
    }

    /// Returns Π(n; φ | m) = ∫₀^φ dt / ((1 − n sin²t) √(1 − m sin²t)), the integral of the third
    /// kind, for any real φ in rad.
    ///
    /// It is infinite beyond ±π/2 at m = 1, infinite for infinite φ, and NaN for NaN.
    ///
    /// # Errors
    /// [`EllipticError::Characteristic`] for n ≥ 1, or an n that is not finite.
    ///
    /// Source: DLMF 19.2.7, with α² = n.
    pub fn incomplete_pi(&self, n: f64, phi: f64) -> Result<f64, EllipticError> {
        Ok(self.incomplete(IntegralKind::third(n)?, phi))
    }

    /// Returns u between −2K and 2K from sn u, cn u and dn u, each with full relative precision: sn
    /// R_F(cn², dn², 1) up to a quarter period.
    ///
    /// Source: DLMF 19.25.5, 22.4(iii).
    pub(crate) fn argument_of(&self, [sn, cn, dn]: [f64; 3]) -> f64 {
        let quarter = sn.abs() * rf([cn.abs(), dn.abs(), 1.0].map(Double::from)).value();
        let u = if cn < 0.0 { 2.0 * self.k() - quarter } else { quarter };
        u.copysign(sn)
    }

    fn incomplete(&self, kind: IntegralKind, phi: f64) -> f64 {
        // φ + (m + 2n) φ³/6 + ….
        if !phi.is_finite() || phi.abs() * self.largest(kind).sqrt() < 1e-9 {
            return phi;
        }
        let reduced = Reduced::angle(phi);
        let rest = Legs::new(self, kind, reduced.sin, reduced.cos).integral(self, kind);
        // F(jπ + φ) = 2jK + F(φ), and similarly for E and Π.
        reduced.unfolded(|| self.complete(kind).scaled(2.0), rest)
    }

    /// Returns the largest of 1, m₁ and 1 − n.
    fn largest(&self, kind: IntegralKind) -> f64 {
        let n = if let IntegralKind::Third { n } = kind { n } else { 0.0 };
        self.complement().max(1.0 - n).max(1.0)
    }
}

/// Kinds of elliptic integrals.
#[derive(Clone, Copy, Debug)]
pub(super) enum IntegralKind {
    First,
    Second,
    Third { n: f64 },
}

impl IntegralKind {
    pub(super) fn third(n: f64) -> Result<Self, EllipticError> {
        if n.is_finite() && n < 1.0 {
            Ok(Self::Third { n })
        } else {
            Err(EllipticError::Characteristic { n })
        }
    }
}

/// Unit 2⁻²²⁰, for values up to 10¹⁵⁴ and down to 10⁻¹⁶².
const SMALL_UNIT: f64 = 5.934_729_841_099_874e-67;

/// sin φ, cos φ and √(1 − m sin²φ) of an amplitude of at most a quarter turn.
///
/// The integrals are homogeneous of degree zero in (s, c, 1), so all three may be scaled by any
/// `unit`: a small one if squares of the others would overflow.
pub(super) struct Legs {
    s: Double,
    c: Double,
    delta: Double,
    unit: f64,
}

impl Legs {
    pub(super) fn new(parameter: &EllipticParameter, kind: IntegralKind, sin: Double, cos: Double) -> Self {
        let unit = if parameter.largest(kind) > HUGE { SMALL_UNIT } else { 1.0 };
        let (s, c) = (sin.scaled(unit), cos.scaled(unit));
        // Δ² = c² + m₁ s².
        let delta = hypotenuse(c, root(parameter.m1) * s);
        Self { s, c, delta, unit }
    }

    pub(super) fn integral(&self, parameter: &EllipticParameter, kind: IntegralKind) -> Double {
        let m = parameter.m;
        let one = Double::from(self.unit);
        let first = || rf([self.c, self.delta, one]);
        self.s
            * match kind {
                IntegralKind::First => first(),
                IntegralKind::Second => first() + self.weighted_rj(-m, one),
                IntegralKind::Third { n } if n < -1.0 && 0.25 * n < m.high => {
                    // m/n, scaled so that neither is too large.
                    let ratio = m.scaled(TINY) / Double::from(n * TINY);
                    let p = self.one_minus(Double::sum(1.0, -n));
                    let q = self.one_minus(Double::ONE - ratio);
                    let scale = 1.0 / self.unit;
                    rc((self.c * self.delta).scaled(scale), (p * q).scaled(scale))
                        + self.weighted_rj(-ratio, q)
                }
                IntegralKind::Third { n } => {
                    first() + self.weighted_rj(Double::from(n), self.one_minus(Double::sum(1.0, -n)))
                }
            }
    }

    /// Returns w s²/3 R_J(c², Δ², 1, p²).
    fn weighted_rj(&self, weight: Double, p: Double) -> Double {
        let one = Double::from(self.unit);
        weight.scaled(self.unit) * self.s * self.s.scaled(1.0 / self.unit) / Double::from(3.0)
            * rj([self.c, self.delta, one], p)
    }

    /// Returns √(1 − n s²) = √(c² + n₁ s²), given n₁ = 1 − n.
    fn one_minus(&self, n1: Double) -> Double {
        hypotenuse(self.c, root(n1) * self.s)
    }
}

/// Returns √(a² + b²).
pub(super) fn hypotenuse(a: Double, b: Double) -> Double {
    if a.is_zero() { b.abs() } else { (a.square() + b.square()).sqrt() }
}
