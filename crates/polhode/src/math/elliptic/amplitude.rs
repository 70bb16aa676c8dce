//! Double-double arguments and results for closed forms, whose long times amplify rounding.

use crate::math::double::Double;
use crate::math::triple::Triple;

use super::carlson::{rf, rj};
use super::incomplete::hypotenuse;
use super::jacobi::{hyperbolic, landen};
use super::reduced::Reduced;
use super::{EllipticParameter, root};

/// Amplitude am u = jπ + φ, |φ| ≤ π/2, given by the sine and cosine of φ.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Amplitude {
    /// Number j of half turns; rounded if it is too large to count exactly.
    pub(crate) half_turns: f64,
    /// True if j is odd.
    pub(crate) odd: bool,
    /// Sine of φ: sn of the remainder.
    pub(crate) sn: Double,
    /// Cosine of φ: cn of the remainder, not negative.
    pub(crate) cn: Double,
    /// Delta amplitude dn.
    pub(crate) dn: Double,
}

impl Amplitude {
    /// Returns the sign (−1)ʲ of sn and cn.
    pub(crate) fn sign(&self) -> f64 {
        if self.odd { -1.0 } else { 1.0 }
    }
}

impl EllipticParameter {
    /// Returns am u. At m = 1, sn, cn and dn have f64 precision only.
    pub(crate) fn amplitude(&self, u: Double) -> Amplitude {
        if self.is_hyperbolic() {
            let at = hyperbolic(u.value());
            let [sn, cn, dn] = [at.sn, at.cn, at.dn].map(Double::from);
            return Amplitude { half_turns: 0.0, odd: false, sn, cn, dn };
        }
        let Reduced { half_turns, odd, sin, cos } = Reduced::of(Triple::from(u) * self.inverse_k);
        let [sn, cn, dn] = landen(root(self.m1), sin, cos);
        Amplitude { half_turns, odd, sn, cn, dn }
    }

    /// Returns m as a double-double number.
    pub(crate) const fn m_in_words(&self) -> Double {
        self.m
    }

    /// Returns m and m₁ as double-double numbers.
    pub(crate) const fn words(&self) -> [Double; 2] {
        [self.m, self.m1]
    }

    /// Returns K; infinite at m = 1.
    pub(crate) fn quarter(&self) -> Double {
        if self.is_hyperbolic() { Double::from(f64::INFINITY) } else { Double::ONE / self.inverse_k.double() }
    }

    /// Returns F(φ | m) from the sine and cosine of φ, in double-double arithmetic; −π ≤ φ ≤ π.
    pub(crate) fn first(&self, sin: Double, cos: Double) -> Double {
        let delta = hypotenuse(cos, root(self.m1) * sin);
        let to_axis = sin * rf([cos.abs(), delta, Double::ONE]);
        if cos.high >= 0.0 {
            return to_axis;
        }
        // F(π − φ) = 2K − F(φ).
        let half_turn = self.quarter().scaled(if sin.high < 0.0 { -2.0 } else { 2.0 });
        half_turn - to_axis
    }

    /// Returns ⅓ sn³ R_J(cn², dn², 1, cn² + n₁ sn²) of the remainder: (Π(n) − F)/n at n = 1 − n₁,
    /// for every n₁ > 0.
    pub(crate) fn third(&self, at: &Amplitude, n1: Double) -> Double {
        let p = hypotenuse(at.cn, n1.sqrt() * at.sn);
        at.sn * at.sn.square() * rj([at.cn, at.dn, Double::ONE], p) / Double::from(3.0)
    }

    /// Returns the same quantity over a quarter turn.
    pub(crate) fn complete_third(&self, n1: Double) -> Double {
        rj([Double::default(), root(self.m1), Double::ONE], n1.sqrt()) / Double::from(3.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reference values by mpmath, as double-double numbers.
    #[test]
    fn generic_points_have_22_digits() {
        let near = |got: Double, want: (f64, f64)| {
            let error = (got - Double::sum(want.0, want.1)).value() / want.0;
            assert!(error.abs() < 1e-22, "{got:?} {want:?} {error:e}");
        };
        let parameter = EllipticParameter::new(0.6875).unwrap();
        let at = parameter.amplitude(Double::from(9.25));
        for (name, high, low) in [
            ("sn", 0.7972777580225817, -3.9182569631728516e-17),
            ("cn", 0.6036126047080906, 9.47073560622296e-18),
            ("dn", 0.750326176663662, 2.90655500637496e-17),
            ("F", 9.25, 0.0),
            ("third", 0.37524391167893745, -1.427633421759406e-17),
            ("large", 0.0794256820563919, -3.9471050448972005e-18),
            ("complete", 2.208845301393758, -1.6970835866426714e-16),
        ] {
            let got = match name {
                "sn" => at.sn.scaled(at.sign()),
                "cn" => at.cn.scaled(at.sign()),
                "dn" => at.dn,
                "F" => parameter.first(at.sn, at.cn) + parameter.quarter().scaled(2.0 * at.half_turns),
                "third" => parameter.third(&at, Double::from(0.3125)),
                "large" => parameter.third(&at, Double::from(7.5)),
                _ => parameter.complete_third(Double::from(0.4375)),
            };
            near(got, (high, low));
        }
    }
}
