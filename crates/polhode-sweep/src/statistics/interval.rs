//! Confidence intervals.

use std::f64::consts::PI;

/// Returns the half width t s/√n of the interval of the mean of n values with standard deviation s,
/// t from Student's distribution. `None` for fewer than two.
pub(super) fn half_of_mean(n: u64, deviation: f64, confidence: f64) -> Option<f64> {
    (n > 1).then(|| student(n - 1, confidence) * deviation / (n as f64).sqrt())
}

/// Returns the interval m ± t s/√k of the mean over k independently drawn sets, from the mean of
/// each set. `None` for fewer than two.
pub(super) fn of_sets(means: &[f64], confidence: f64) -> Option<[f64; 2]> {
    let k = means.len() as f64;
    let mean = means.iter().sum::<f64>() / k;
    let squares = means.iter().map(|m| (m - mean) * (m - mean)).sum::<f64>();
    let half = half_of_mean(means.len() as u64, (squares / (k - 1.0)).sqrt(), confidence)?;
    Some([mean - half, mean + half])
}

/// Standard normal quantile Φ⁻¹(0.975).
const Z: f64 = 1.959_963_984_540_054;

/// Returns Wilson's 95 % interval of a proportion:
///
/// (p + z²/2n ± z √(p (1 − p)/n + z²/4n²)) / (1 + z²/n)
///
/// Source: Wilson, J. Am. Stat. Assoc. 22 (1927) 209.
pub(super) fn of_share(count: u64, n: u64) -> [f64; 2] {
    if n == 0 {
        return [0.0, 1.0];
    }
    let (n, p) = (n as f64, count as f64 / n as f64);
    let (middle, whole) = (p + Z * Z / (2.0 * n), 1.0 + Z * Z / n);
    let half = Z * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).sqrt();
    [((middle - half) / whole).max(0.0), ((middle + half) / whole).min(1.0)]
}

/// Returns the ranks (from 0) on both sides of a quantile of n values, and the fraction between
/// them; the quantile is at (n − 1) p.
pub(super) fn around(n: u64, p: f64) -> (u64, u64, f64) {
    let place = n.saturating_sub(1) as f64 * p;
    let below = place.floor();
    (below as u64, (below as u64 + 1).min(n.saturating_sub(1)), place - below)
}

/// Returns the ranks (from 0) of order statistics that enclose the distribution's quantile with at
/// least this confidence. An end is `None` if n is too small.
///
/// Let B ~ Binomial(n, p) be the number of values below the quantile. The lower rank is the largest
/// k with P(B ≤ k) ≤ α/2, the upper rank the smallest with P(B ≤ k) ≥ 1 − α/2.
pub(super) fn of_quantile(n: u64, p: f64, confidence: f64) -> [Option<u64>; 2] {
    let tail = 0.5 * (1.0 - confidence);
    let (size, q) = (n as f64, 1.0 - p);
    let reach = 12.0 * (size * p * q).sqrt();
    let mut k = (size * p - reach).floor().max(0.0);
    // P(B = k) = n! / k! (n − k)! p^k q^(n − k)
    let ln = |x: f64| libm::lgamma(x + 1.0);
    let mut mass = libm::exp(ln(size) - ln(k) - ln(size - k) + k * libm::log(p) + (size - k) * libm::log(q));
    let (mut below, mut lower) = (0.0, None);
    while k < size {
        below += mass;
        if below <= tail {
            lower = Some(k as u64);
        } else if below >= 1.0 - tail {
            return [lower, Some(k as u64)];
        }
        mass *= (size - k) / (k + 1.0) * (p / q);
        k += 1.0;
    }
    [lower, None]
}

/// Returns t with P(|T| ≤ t) = confidence for Student's distribution.
///
/// Up to 200 degrees of freedom it uses the finite sums of Abramowitz & Stegun 26.7.3 and 26.7.4,
/// above that the expansion 26.7.5 at 95 %.
fn student(freedom: u64, confidence: f64) -> f64 {
    let v = freedom as f64;
    if freedom > 200 {
        let z = Z;
        let g = [(z.powi(3) + z) / 4.0, (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / 96.0];
        return z + g[0] / v + g[1] / (v * v);
    }
    // P increases with θ = atan(t/√v).
    let (mut low, mut high) = (0.0, 0.5 * PI);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if within(freedom, middle) < confidence { low = middle } else { high = middle }
    }
    libm::tan(0.5 * (low + high)) * v.sqrt()
}

/// Returns P(|T| ≤ √v tan θ).
fn within(freedom: u64, theta: f64) -> f64 {
    let (sin, cos) = (libm::sin(theta), libm::cos(theta));
    let odd = freedom % 2 == 1;
    let (mut term, mut sum) = if odd { (cos, 0.0) } else { (1.0, 0.0) };
    // Terms: 1, 1/2 cos², 1·3/2·4 cos⁴ … or cos, 2/3 cos³, 2·4/3·5 cos⁵ …
    for k in 0..freedom / 2 {
        sum += term;
        let j = 2 * k + if odd { 2 } else { 1 };
        term *= cos * cos * j as f64 / (j + 1) as f64;
    }
    if odd { 2.0 / PI * (theta + sin * sum) } else { sin * sum }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may")]

    use super::*;

    #[test]
    fn students_t_is_that_of_the_tables() {
        for (freedom, t) in [
            (1, 12.706_204_736_174_7),
            (2, 4.302_652_729_696_14),
            (3, 3.182_446_305_283_71),
            (9, 2.262_157_162_798_2),
            (10, 2.228_138_851_964_9),
            (100, 1.983_971_518_523_6),
            (1000, 1.962_339_080_862_9),
        ] {
            assert!((student(freedom, 0.95) / t - 1.0).abs() < 1e-8, "{freedom}: {}", student(freedom, 0.95));
        }
        assert!((student(200, 0.95) - student(201, 0.95) - 6e-5).abs() < 2e-5);
    }

    #[test]
    fn wilsons_interval_is_the_published_one() {
        // 81 of 263: Newcombe, Stat. Med. 17 (1998) 857, table I
        let [low, high] = of_share(81, 263);
        assert!((low - 0.2553).abs() < 5e-5 && (high - 0.3662).abs() < 5e-5, "{low} {high}");
        assert_eq!(of_share(0, 20)[0], 0.0);
        assert!((of_share(0, 20)[1] - 0.1611).abs() < 5e-5);
    }

    #[test]
    fn order_statistics_hold_the_quantile() {
        // Compared with a direct sum of the binomial distribution.
        let cumulated = |n: u64, p: f64, k: u64| {
            (0..=k)
                .map(|j| {
                    (1..=j).fold((1.0 - p).powi(n as i32), |m, i| {
                        m * (n - i + 1) as f64 / i as f64 * p / (1.0 - p)
                    })
                })
                .sum::<f64>()
        };
        for (n, p) in [(10, 0.5), (100, 0.5), (37, 0.25), (400, 0.05), (90, 0.95)] {
            let [lower, upper] = of_quantile(n, p, 0.95);
            if let Some(lower) = lower {
                assert!(cumulated(n, p, lower) <= 0.025 && cumulated(n, p, lower + 1) > 0.025, "{n} {p}");
            }
            if let Some(upper) = upper {
                assert!(cumulated(n, p, upper) >= 0.975 && cumulated(n, p, upper - 1) < 0.975, "{n} {p}");
            }
        }
        assert_eq!(of_quantile(10, 0.5, 0.95), [Some(1), Some(8)]);
        assert_eq!(of_quantile(20, 0.01, 0.95)[0], None);
        assert_eq!(of_quantile(20, 0.99, 0.95)[1], None);
        let [Some(low), Some(high)] = of_quantile(1_000_000_000, 0.5, 0.95) else { unreachable!() };
        // Expected ranks: n p ± z √(n p q).
        assert!((500_000_000 - low).abs_diff(30_990) < 20 && (high - 500_000_000).abs_diff(30_990) < 20);
    }
}
