//! Complete elliptic integrals K, E and Π, over a quarter turn.

use crate::math::double::Double;
use crate::math::number::PI;

use super::incomplete::{IntegralKind, Legs};
use super::{EllipticError, EllipticParameter};

impl EllipticParameter {
    /// Returns K(m) = ∫₀^{π/2} dt / √(1 − m sin²t), the complete integral of the first kind;
    /// infinite at m = 1.
    ///
    /// Source: DLMF 19.2.8, 19.8.5.
    pub fn k(&self) -> f64 {
        self.complete(IntegralKind::First).value()
    }

    /// Returns E(m) = ∫₀^{π/2} √(1 − m sin²t) dt, the complete integral of the second kind.
    ///
    /// ```
    /// // The perimeter of an ellipse of semi-axes 5 and 3, by the square of its eccentricity.
    /// let m = polhode::math::elliptic::EllipticParameter::from_complement(9.0 / 25.0)?;
    /// assert!((4.0 * 5.0 * m.e() - 25.526998863398124).abs() < 1e-14);
    /// # Ok::<(), polhode::math::elliptic::EllipticError>(())
    /// ```
    ///
    /// Source: DLMF 19.2.8, 19.25.1.
    pub fn e(&self) -> f64 {
        self.complete(IntegralKind::Second).value()
    }

    /// Returns Π(n | m) = ∫₀^{π/2} dt / ((1 − n sin²t) √(1 − m sin²t)), the complete integral of
    /// the third kind; infinite at m = 1.
    ///
    /// # Errors
    /// [`EllipticError::Characteristic`] for n ≥ 1, where it is infinite or only a principal value,
    /// or an n that is not finite.
    ///
    /// Source: DLMF 19.2.8, 19.25.2, with α² = n.
    pub fn pi(&self, n: f64) -> Result<f64, EllipticError> {
        Ok(self.complete(IntegralKind::third(n)?).value())
    }

    /// Returns the complete integral as a double-double number.
    pub(super) fn complete(&self, kind: IntegralKind) -> Double {
        match kind {
            IntegralKind::Second if self.is_hyperbolic() => Double::ONE,
            _ if self.is_hyperbolic() => Double::from(f64::INFINITY),
            IntegralKind::First => Double::ONE / self.inverse_k.double(),
            _ => Legs::new(self, kind, Double::ONE, Double::default()).integral(self, kind),
        }
    }
}

/// Returns the complete elliptic integral of the first kind in f64, from the *complementary*
/// parameter m₁ = 1 − m = k′².
///
/// K(m) = ∫₀^{π/2} dφ / √(1 − m sin²φ) = π / (2 agm(1, √m₁))
///
/// The argument is m₁, because near m = 1 only m₁ has full relative precision. K is infinite at
/// m₁ = 0 and NaN for negative m₁. The error is at most 2 ulp for every positive m₁ (m₁ > 1 means
/// m < 0 and is allowed).
///
/// Source: DLMF 19.8.5.
pub(crate) fn complete_k(m1: f64) -> f64 {
    if m1 == 0.0 {
        return f64::INFINITY;
    }
    let (mut a, mut g) = (1.0, m1.sqrt());
    // Quadratic convergence: if |a − g| < √ε a, one more mean is exact to rounding.
    while (a - g).abs() > 1e-8 * a {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    PI / (a + g)
}

#[cfg(test)]
mod tests {
    use super::complete_k;

    #[test]
    fn k_is_right_from_one_to_the_smallest_complement() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/elliptic_k.toml");
        let table: toml::Table = std::fs::read_to_string(path).unwrap().parse().unwrap();
        let rows = table["complementary"].as_array().unwrap();
        assert!(rows.len() > 20);
        for row in rows {
            let [m1, k] = ["m1", "k"].map(|key| row[key].as_str().unwrap().parse::<f64>().unwrap());
            assert!(
                (complete_k(m1) / k - 1.0).abs() <= 2.0 * f64::EPSILON,
                "{m1:e}: {:e}",
                complete_k(m1) / k - 1.0
            );
        }
        for row in table["parameter"].as_array().unwrap() {
            let [m, k] = ["m", "k"].map(|key| row[key].as_str().unwrap().parse::<f64>().unwrap());
            let m1 = 1.0 - m;
            if 1.0 - m1 == m {
                assert!((complete_k(m1) / k - 1.0).abs() <= 2.0 * f64::EPSILON, "{m:e}");
            }
        }
        assert!(complete_k(0.0).is_infinite() && complete_k(-0.1).is_nan() && complete_k(f64::NAN).is_nan());
    }
}
