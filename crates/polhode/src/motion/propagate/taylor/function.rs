//! Coefficients of elementary functions of series: n ≥ 1, from coefficients up to n of what it is of and up to n − 1 of itself.
//!
//! Each function is an integral of products or quotients, compared power by power: from y' = u' w follows n yₙ = Σ k uₖ wₙ₋ₖ.
//!
//! Source: L. B. Rall, Automatic Differentiation (1981), ch. 3.3.

use super::scalar::Scalars;

/// y = ∫ u' w: n yₙ = Σ_{k≥1} k uₖ wₙ₋ₖ, w up to n − 1.
///
/// exp u has w = y, sin u has w = cos u, cos u has w = −sin u, tan u has w = 1 + y².
#[inline(always)]
pub(super) fn integral_by(u: &Scalars, w: &Scalars, n: usize) -> f64 {
    weighted(u, w, n) / n as f64
}

/// y = ∫ u'/d: n d₀ yₙ = n uₙ − Σ_{1≤k<n} k yₖ dₙ₋ₖ.
///
/// log u has d = u, asin u has d = √(1 − u²), acos u has d = −√(1 − u²), atan u has d = 1 + u².
#[inline(always)]
pub(super) fn integral_over(u: &Scalars, d: &Scalars, y: &Scalars, n: usize) -> f64 {
    (u[n] - weighted_before(y, d, n) / n as f64) / d[0]
}

/// y = atan2(a, b) = ∫ (a' b − b' a)/d, d = a² + b².
#[inline(always)]
pub(super) fn angle(a: &Scalars, b: &Scalars, d: &Scalars, y: &Scalars, n: usize) -> f64 {
    (weighted(a, b, n) - weighted(b, a, n) - weighted_before(y, d, n)) / (n as f64 * d[0])
}

/// c = √(a² + b²), from c c' = a a' + b b'; where c₀ = 0, zero while a and b are.
#[inline(always)]
pub(super) fn hypotenuse(a: &Scalars, b: &Scalars, c: &Scalars, n: usize) -> f64 {
    if c[0] == 0.0 {
        return if is_zero(a, n) && is_zero(b, n) { 0.0 } else { f64::NAN };
    }
    (weighted(a, a, n) + weighted(b, b, n) - weighted_before(c, c, n)) / (n as f64 * c[0])
}

/// c = aᵖ for any constant p; where a₀ = 0, zero while a is and p > 0.
#[inline(always)]
pub(super) fn constant_power(a: &Scalars, p: f64, c: &Scalars, n: usize) -> f64 {
    if a[0] == 0.0 {
        return if p > 0.0 && is_zero(a, n) { 0.0 } else { f64::NAN };
    }
    super::scalar::power(a, p, c, n)
}

/// Σ_{1≤k≤n} k uₖ wₙ₋ₖ
#[inline(always)]
fn weighted(u: &Scalars, w: &Scalars, n: usize) -> f64 {
    let pairs = u[1..=n].iter().zip(w[..n].iter().rev());
    pairs.zip(1_u32..).fold(0.0, |sum, ((u, w), k)| sum + f64::from(k) * u * w)
}

/// Σ_{1≤k<n} k yₖ dₙ₋ₖ
#[inline(always)]
fn weighted_before(y: &Scalars, d: &Scalars, n: usize) -> f64 {
    let pairs = y[1..n].iter().zip(d[1..n].iter().rev());
    pairs.zip(1_u32..).fold(0.0, |sum, ((y, d), k)| sum + f64::from(k) * y * d)
}

fn is_zero(a: &Scalars, n: usize) -> bool {
    a[..=n].iter().all(|x| *x == 0.0)
}
