//! Numbers of a distribution from uniform ones: the inverse of its distribution function.
//!
//! All of them rise with the uniform number, so that layers and evenly spread points stay what they are.

use polhode_formats::scenario::Distribution;

use super::normal;

/// F⁻¹(u), 0 < u < 1.
pub(crate) fn quantile(distribution: &Distribution, u: f64) -> f64 {
    match *distribution {
        Distribution::Normal { mean, sd, from, to } => {
            // What rounding puts beyond a bound is at the bound.
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
        // Distributions are added here when they are added to the plan's format.
        _ => 0.0,
    }
}

/// The standard normal z between a < b with P(z) = Φ(a) + u (Φ(b) − Φ(a)).
///
/// Where both bounds are above the mean it is turned over, since 1 − Φ has no digits there.
fn truncated(a: f64, b: f64, u: f64) -> f64 {
    if a == f64::NEG_INFINITY && b == f64::INFINITY {
        return normal::quantile(u);
    }
    if a > 0.0 {
        return -truncated(-b, -a, 1.0 - u);
    }
    let (below, until) = (normal::probability(a), normal::probability(b));
    let p = below + u * (until - below);
    if p > 0.0 && p < 1.0 { normal::quantile(p) } else { a.max(-FARTHEST).min(b) }
}

/// Φ(−38) is the smallest double.
const FARTHEST: f64 = 38.0;
