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
