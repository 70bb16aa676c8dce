//! Complete elliptic integrals by arithmetic–geometric means, in double-double precision.

use super::double::Double;

/// Returns K(m), and R = 2 − Σ Qₙ, where Π(1 − p²|m)/K = 1 + ½ (1/p² − 1) Σ Qₙ, from k₁ = √(1 − m)
/// and p² ≥ 1.
///
/// The means are a₀ = 1, g₀ = k₁, p₀ = p, aₙ₊₁ = ½(aₙ + gₙ), gₙ₊₁ = √(aₙgₙ), with Q₀ = 1,
/// Qₙ₊₁ = ½ Qₙ εₙ, εₙ = (pₙ² − aₙgₙ)/(pₙ² + aₙgₙ), pₙ₊₁ = (pₙ² + aₙgₙ)/2pₙ.
///
/// Toward the separatrix, and for large p, Σ Qₙ is nearly 2. Its difference R = Σ Qₙ (1 − εₙ) from
/// 2 has only positive terms, because pₙ ≥ aₙ ≥ gₙ, and therefore keeps full relative precision.
/// For k₁ = 0, where K is infinite, 2¹⁰⁰ is returned for K.
///
/// Source: DLMF 19.8.5, 19.8.7; R is original to this library.
pub(crate) fn quarter_and_share(k1: Double, p_squared: Double) -> (Double, Double) {
    if k1.is_zero() {
        return (Double::from(INFINITE), Double::default());
    }
    let (mut a, mut g, mut p) = (Double::ONE, k1, p_squared.sqrt());
    let (mut weight, mut share) = (Double::ONE, Double::default());
    for _mean in 0..MOST_MEANS {
        let (p2, ag) = (p.square(), a * g);
        let sum = p2 + ag;
        let epsilon = (p2 - ag).over(sum);
        // 1 − ε = 2ag / (p² + ag).
        share = share + (weight * ag.scaled(2.0)).over(sum);
        weight = weight * epsilon.scaled(0.5);
        let converged = (a - g).high <= SQUARE_IS_NOTHING * a.high && epsilon.high <= SQUARE_IS_NOTHING;
        p = sum.over(p.scaled(2.0));
        (a, g) = ((a + g).scaled(0.5), ag.sqrt());
        if converged {
            break;
        }
    }
    // K = π / 2 agm(1, k₁).
    (Double::TAU.scaled(0.25) / a, share + weight)
}

/// Substitute 2¹⁰⁰ for an infinite K; no time with significant digits is this large.
const INFINITE: f64 = 1.267_650_600_228_229_4e30;

/// Iteration limit; p halves until it is near 1.
const MOST_MEANS: usize = 200;

/// Convergence threshold; the next mean differs by its square, far below double-double precision.
const SQUARE_IS_NOTHING: f64 = 1e-17;

/// Returns the mean of sn² over a period, (1 − E/K)/m, between ½ and 1, from m and √(1 − m) > 0.
///
/// It is ½ + Σ 2ⁿ⁻¹ cₙ²/m, where cₙ are the differences of the means: c₁ = m/2(1 + √(1 − m)),
/// cₙ₊₁ = cₙ²/4aₙ₊₁.
///
/// Source: DLMF 19.8.6.
pub(crate) fn mean_sine_squared(m: f64, k1: f64) -> f64 {
    let (mut a, mut g) = (0.5 * (1.0 + k1), k1.sqrt());
    let mut difference = 0.5 / (1.0 + k1); // cₙ/m
    let (mut sum, mut weight) = (0.5, m);
    for _mean in 0..MOST_MEANS {
        let term = weight * difference * difference;
        sum += term;
        if term <= f64::EPSILON * f64::EPSILON {
            break;
        }
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
        difference *= m * difference / (4.0 * a);
        weight *= 2.0;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::PI;

    /// Returns ∫₀^{π/2} f dφ for an even function of period π, by the trapezoidal rule.
    fn quadrature(f: impl Fn(f64) -> f64) -> f64 {
        let n = 4000;
        let term = |k: i32| f((f64::from(k) + 0.5) * 0.5 * PI / f64::from(n));
        (0..n).map(term).sum::<f64>() * 0.5 * PI / f64::from(n)
    }

    #[test]
    fn the_means_are_the_integrals() {
        for m1 in [1.0, 0.9, 0.3, 0.01, 1e-4] {
            for p2 in [1.0, 1.5, 4.0, 300.0] {
                let (quarter, share) = quarter_and_share(Double::from(m1).sqrt(), Double::from(p2));
                let (quarter, share) = (quarter.value(), share.value());
                let root = |s: f64| (1.0 - (1.0 - m1) * s).sqrt();
                let k = quadrature(|x| 1.0 / root(x.sin().powi(2)));
                let pi = quadrature(|x| 1.0 / (root(x.sin().powi(2)) * (1.0 + (p2 - 1.0) * x.sin().powi(2))));
                assert!((quarter / k - 1.0).abs() < 1e-14, "{m1} {p2}");
                let found = quarter * (1.0 + 0.5 * (1.0 / p2 - 1.0) * (2.0 - share));
                assert!((found / pi - 1.0).abs() < 1e-12, "{m1} {p2}: {:e}", found / pi - 1.0);
            }
        }
    }
}
