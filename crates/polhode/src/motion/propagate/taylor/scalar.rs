//! Coefficients of scalar series: products, quotients and powers, one coefficient at a time.
//!
//! Each function gives coefficient n of its result, from coefficients up to n of what it is of and up to n − 1 of itself.
//!
//! Source: L. B. Rall, Automatic Differentiation (1981), ch. 3.3; À. Jorba, M. Zou, Exp. Math. 14 (2005) 99, prop. 2.1.

use super::row::TERMS;

/// Taylor coefficients of a number, from the constant on.
pub(super) type Scalars = [f64; TERMS];

/// (a b)ₙ = Σ aₖ bₙ₋ₖ
#[inline(always)]
pub(super) fn product(a: &Scalars, b: &Scalars, n: usize) -> f64 {
    a[..=n].iter().zip(b[..=n].iter().rev()).fold(0.0, |sum, (a, b)| sum + a * b)
}

/// c = a / b: cₙ = (aₙ − Σ_{k≥1} bₖ cₙ₋ₖ) / b₀
#[inline(always)]
pub(super) fn quotient(a: &Scalars, b: &Scalars, c: &Scalars, n: usize) -> f64 {
    let known = b[1..=n].iter().zip(c[..n].iter().rev()).fold(0.0, |sum, (b, c)| sum + b * c);
    (a[n] - known) / b[0]
}

/// c = a^p, n ≥ 1: cₙ = Σ_{k<n} (p (n − k) − k) aₙ₋ₖ cₖ / (n a₀); c₀ is the caller's.
#[inline(always)]
pub(super) fn power(a: &Scalars, p: f64, c: &Scalars, n: usize) -> f64 {
    let terms = c[..n].iter().zip(a[1..=n].iter().rev()).enumerate();
    let sum = terms.fold(0.0, |sum, (k, (c, a))| sum + (p * (n - k) as f64 - k as f64) * a * c);
    sum / (n as f64 * a[0])
}
