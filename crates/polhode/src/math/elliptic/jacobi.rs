//! Jacobi elliptic functions by Landen's descending transformation.
//!
//! The transformation maps the modulus k to a smaller one and K to K q, with q = ½(1 + k′), where q
//! and √k′ are the next means of 1 and k′. So u/K is invariant, and at k = 0 the functions are the
//! sine and cosine of u/K quarter turns. The inverse transformation is
//!
//! sn = s/D,   cn = q c d/D,   dn = (q c² + k′ s²)/D,   D = q c² + s²,
//!
//! where s, c, d belong to the smaller modulus. These are sums and products of nonnegative numbers,
//! so that each of the three keeps full *relative* precision, also near its zeros. (The usual form
//! of DLMF 22.7.2–4 has 1 − k₁ s² as the numerator of dn.)

use crate::math::double::Double;

use super::reduced::{Reduced, arc};
use super::{EllipticParameter, root};

/// Jacobi elliptic functions of one argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JacobiFunctions {
    /// Sine amplitude sn(u | m) = sin am.
    pub sn: f64,
    /// Cosine amplitude cn(u | m) = cos am.
    pub cn: f64,
    /// Delta amplitude dn(u | m) = √(1 − m sn²).
    pub dn: f64,
    /// Amplitude am(u | m), the inverse of F: continuous in u, not reduced, rad.
    pub am: f64,
}

impl EllipticParameter {
    /// Returns sn, cn, dn and am for any real u.
    ///
    /// u is reduced by K in triple-double precision: the phase of the exact u is correct to 2⁻¹⁵⁰
    /// of the number of periods. This is full relative precision even for the f64 number nearest to
    /// a zero after 10¹⁰ periods. Beyond 2¹⁵⁰ quarter periods the phase is set to 0. The result is
    /// NaN for a u that is not finite.
    ///
    /// ```
    /// let m = polhode::math::elliptic::EllipticParameter::new(0.36)?;
    /// let at = m.jacobi(m.k() / 2.0);
    /// // sn² K/2 = 1/(1 + k′), dn² K/2 = k′ (DLMF 22.5, table)
    /// assert!((at.sn.powi(2) - 1.0 / 1.8).abs() < 1e-15);
    /// assert!((at.dn.powi(2) - 0.8).abs() < 1e-15);
    /// assert!((m.jacobi(20.0 * m.k()).am - 10.0 * std::f64::consts::PI).abs() < 1e-13);
    /// # Ok::<(), polhode::math::elliptic::EllipticError>(())
    /// ```
    ///
    /// Source: DLMF 22.7(i), 22.16(i).
    pub fn jacobi(&self, u: f64) -> JacobiFunctions {
        if !u.is_finite() {
            return JacobiFunctions { sn: f64::NAN, cn: f64::NAN, dn: f64::NAN, am: f64::NAN };
        }
        let modulus1 = root(self.m1);
        // sn = u − (1 + m) u³/6 + ….
        if u.abs() * modulus1.high.max(1.0) < 1e-9 {
            return JacobiFunctions { sn: u, cn: 1.0, dn: 1.0, am: u };
        }
        if self.is_hyperbolic() {
            return hyperbolic(u);
        }
        let reduced = Reduced::new(u, self.inverse_k);
        let [sn, cn, dn] = landen(modulus1, reduced.sin, reduced.cos);
        // am(2jK + u) = jπ + am(u).
        let am = reduced.unfolded(|| Double::TAU.scaled(0.5), arc(sn, cn));
        let sign = if reduced.odd { -1.0 } else { 1.0 };
        JacobiFunctions { sn: sign * sn.value(), cn: sign * cn.value(), dn: dn.value(), am }
    }
}

/// Returns sn, cn, dn of u, given k′ and the sine and cosine of u/K quarter turns.
pub(super) fn landen(modulus1: Double, sin: Double, cos: Double) -> [Double; 3] {
    // k is so small that its square is below the rounding.
    if (modulus1 - Double::ONE).high.abs() < 1e-22 {
        return [sin, cos, Double::ONE];
    }
    let q = (Double::ONE + modulus1).scaled(0.5);
    let [s, c, d] = landen(modulus1.sqrt() / q, sin, cos);
    let (s2, qc2) = (s.square(), q * c.square());
    let by_d = Double::ONE / (qc2 + s2);
    [s * by_d, q * c * d * by_d, (qc2 + modulus1 * s2) * by_d]
}

/// Returns the functions at m = 1: sn = tanh u, cn = dn = sech u.
pub(super) fn hyperbolic(u: f64) -> JacobiFunctions {
    let decay = libm::exp(-u.abs());
    let sech = 2.0 * decay / (1.0 + decay * decay);
    let tanh = libm::tanh(u);
    JacobiFunctions { sn: tanh, cn: sech, dn: sech, am: libm::atan2(tanh, sech) }
}
