//! Random numbers of a distribution from uniform numbers, by the inverse of the distribution
//! function.
//!
//! All quantile functions increase, so values from stratified or low-discrepancy points are just as
//! evenly spread.

use polhode_scenario::read::Distribution;

use super::normal;

/// Returns the quantile F⁻¹(u), 0 < u < 1.
pub(crate) fn quantile(distribution: &Distribution, u: f64) -> f64 {
    match *distribution {
        Distribution::Normal { mean, sd, from, to } => {
            // Rounding must not move a value beyond a bound.
            (mean + sd * truncated((from - mean) / sd, (to - mean) / sd, u)).clamp(from, to)
        }
        Distribution::Uniform { from, to } => (from + (to - from) * u).clamp(from, to),
        Distribution::LogNormal { median, sigma } => median * libm::exp(sigma * normal::quantile(u)),
        Distribution::LogUniform { from, to } => {
            (from * libm::exp((libm::log(to) - libm::log(from)) * u)).clamp(from, to)
        }
        Distribution::Triangular { from, mode, to } => {
            let (whole, below) = (to - from, mode - from);
            let value = if u * whole < below {
                from + (u * whole * below).sqrt()
            } else {
                to - ((1.0 - u) * whole * (to - mode)).sqrt()
            };
            value.clamp(from, to)
        }
        Distribution::List(ref values) => {
            let k = ((u * values.len() as f64) as usize).min(values.len().saturating_sub(1));
            values.get(k).copied().unwrap_or_default()
        }
        // Distributions added to the plan's format must be added here.
        _ => 0.0,
    }
}

/// Returns the standard normal z between a and b with Φ(z) = Φ(a) + u (Φ(b) − Φ(a)).
///
/// Above the mean it uses the mirrored problem: Φ is close to 1 there, and 1 − Φ has lost its
/// digits.
fn truncated(a: f64, b: f64, u: f64) -> f64 {
    if a == f64::NEG_INFINITY && b == f64::INFINITY {
        return normal::quantile(u);
    }
    let lower = |a: f64, b: f64, u: f64| {
        let (below, until) = (normal::probability(a), normal::probability(b));
        below + u * (until - below)
    };
    let p = lower(a, b, u);
    if p <= 0.5 {
        return if p > 0.0 { normal::quantile(p) } else { b.min(-FARTHEST) };
    }
    let q = lower(-b, -a, 1.0 - u);
    if q > 0.0 { -normal::quantile(q.min(0.5)) } else { a.max(FARTHEST) }
}

/// Standard deviations at which Φ(−z) is the smallest double.
const FARTHEST: f64 = 38.0;

#[cfg(test)]
mod tests {
    use super::*;

    const UNIFORM: [f64; 6] = [1e-9, 0.013, 0.27, 0.5, 0.81, 0.9993];

    /// Compared with mpmath, 30 digits.
    #[test]
    fn quantiles_agree_with_many_digits() {
        let infinity = f64::INFINITY;
        let normal = |mean, sd, from, to| Distribution::Normal { mean, sd, from, to };
        for (distribution, expected) in [
            (
                normal(-0.4, 0.3, -infinity, infinity),
                [
                    -2.199342104502306,
                    -1.0678635307951525,
                    -0.5838438973049882,
                    -0.4,
                    -0.1366311114846314,
                    0.5583953161289817,
                ],
            ),
            (
                normal(0.2, 0.5, 0.1, infinity),
                [
                    0.10000000074066044,
                    0.10961068248432178,
                    0.2972916513067502,
                    0.4772331890883591,
                    0.8131062885067322,
                    1.874512702537796,
                ],
            ),
            (
                normal(0.2, 0.5, 2.0, 2.5),
                [
                    2.0000000001282854,
                    2.0016778064167204,
                    2.0398878077101483,
                    2.086558183203505,
                    2.198993533273257,
                    2.494712090879014,
                ],
            ),
            (
                Distribution::LogNormal { median: 0.03, sigma: 0.7 },
                [
                    0.00045055842151504617,
                    0.006314503580550123,
                    0.01953540163285709,
                    0.03,
                    0.05546348011383984,
                    0.2807467786025503,
                ],
            ),
            (
                Distribution::LogUniform { from: 0.1, to: 7.0 },
                [
                    0.10000000042484952,
                    0.10567841099908189,
                    0.31490276270364387,
                    0.8366600265340756,
                    3.1226938821949557,
                    6.979213297906107,
                ],
            ),
            (
                Distribution::Triangular { from: -1.0, mode: 0.0, to: 3.0 },
                [
                    -0.9999367544467966,
                    -0.7719649149801724,
                    0.040270282610251625,
                    0.5505102572168219,
                    1.4900331129458502,
                    2.908348486100881,
                ],
            ),
        ] {
            for (u, expected) in UNIFORM.into_iter().zip(expected) {
                let value = quantile(&distribution, u);
                assert!(
                    (value - expected).abs() < 3e-15 * expected.abs().max(0.1),
                    "{distribution:?}, {u}: {value}"
                );
            }
        }
    }

    #[test]
    fn bounds_hold_and_ends_are_finite() {
        let ends = [0.5_f64.powi(53), 1.0 - 0.5_f64.powi(53)];
        for distribution in [
            Distribution::Normal { mean: 1.0, sd: 0.1, from: 3.9, to: 4.0 },
            Distribution::Normal { mean: 1.0, sd: 0.1, from: -3.0, to: -1.9 },
            Distribution::Normal { mean: 1.0, sd: 0.1, from: 0.9, to: f64::INFINITY },
            Distribution::Uniform { from: -1e308, to: 0.3 },
            Distribution::LogUniform { from: 1e-300, to: 1e300 },
            Distribution::Triangular { from: 0.1, mode: 0.1, to: 0.3 },
            Distribution::Triangular { from: 0.1, mode: 0.3, to: 0.3 },
            Distribution::List(vec![0.3, -0.7, 11.0]),
        ] {
            let (least, greatest) = match distribution {
                Distribution::Normal { from, to, .. }
                | Distribution::Uniform { from, to }
                | Distribution::LogUniform { from, to }
                | Distribution::Triangular { from, to, .. } => (from, to),
                _ => (-0.7, 11.0),
            };
            for u in ends.into_iter().chain((1..100).map(|k| f64::from(k) / 100.0)) {
                let value = quantile(&distribution, u);
                assert!(
                    value.is_finite() && (least..=greatest).contains(&value),
                    "{distribution:?}, {u}: {value}"
                );
            }
        }
    }
}
