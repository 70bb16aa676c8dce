//! Elliptic integrals. For now the complete one of the first kind; the rest of the family moves in
//! here when the asymmetric top does.

use super::real::PI;

/// Complete elliptic integral of the first kind, from the *complementary* parameter m₁ = 1 − m = k′².
///
/// K(m) = ∫₀^{π/2} dφ / √(1 − m sin²φ) = π / (2 agm(1, √m₁))
///
/// m₁ is the argument because near m = 1 only it has digits. m₁ > 0; K is infinite at m₁ = 0 and NaN below.
/// Accurate to 2 ulp for every positive m₁ (m₁ > 1 is m < 0 and is fine).
///
/// Source: DLMF 19.8.5.
pub(crate) fn complete_k(m1: f64) -> f64 {
    if m1 == 0.0 {
        return f64::INFINITY;
    }
    let (mut a, mut g) = (1.0, m1.sqrt());
    // Quadratic convergence: once |a − g| < √ε a, one more mean is exact to rounding.
    while (a - g).abs() > 1e-8 * a {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    PI / (a + g)
}
