//! Taylor coefficients of elementary functions of series.
//!
//! Each function returns coefficient n ≥ 1 of its result. It needs coefficients up to n of its
//! argument and up to n − 1 of the result. Each function is an integral of products or quotients,
//! compared power by power: y' = u' w gives n yₙ = Σ k uₖ wₙ₋ₖ.
//!
//! Source: L. B. Rall, Automatic Differentiation (1981), ch. 3.3.

use super::row::{Row, Series};
use super::scalar::{Scalars, WHOLE, convolution, power};
use crate::math::number::Number;

/// Returns coefficient n of y = ∫ u' w: n yₙ = Σ_{k≥1} k uₖ wₙ₋ₖ. w is needed up to n − 1.
///
/// exp u has w = y, sin u has w = cos u, cos u has w = −sin u, tan u has w = 1 + y².
#[inline(always)]
pub(super) fn integral_by<N: Number>(u: &Scalars<N>, w: &Scalars<N>, n: usize) -> N {
    weighted(u, w, n) / u[0].like(n as f64)
}

/// Returns coefficient n of y = ∫ u'/d: n d₀ yₙ = n uₙ − Σ_{1≤k<n} k yₖ dₙ₋ₖ.
///
/// log u has d = u, asin u has d = √(1 − u²), acos u has d = −√(1 − u²), atan u has d = 1 + u².
#[inline(always)]
pub(super) fn integral_over<N: Number>(u: &Scalars<N>, d: &Scalars<N>, y: &Scalars<N>, n: usize) -> N {
    (u[n] - weighted_before(y, d, n) / u[0].like(n as f64)) / d[0]
}

/// Returns coefficient n of y = atan2(a, b) = ∫ (a' b − b' a)/d, d = a² + b².
#[inline(always)]
pub(super) fn angle<N: Number>(
    a: &Scalars<N>,
    b: &Scalars<N>,
    d: &Scalars<N>,
    y: &Scalars<N>,
    n: usize,
) -> N {
    (weighted(a, b, n) - weighted(b, a, n) - weighted_before(y, d, n)) / (a[0].like(n as f64) * d[0])
}

/// Returns coefficient n of c = √(a² + b²), from c c' = a a' + b b'. If c₀ = 0, it is zero as long
/// as a and b are zero, and NaN otherwise.
#[inline(always)]
pub(super) fn hypotenuse<N: Number>(a: &Scalars<N>, b: &Scalars<N>, c: &Scalars<N>, n: usize) -> N {
    let sum = weighted(a, a, n) + weighted(b, b, n) - weighted_before(c, c, n);
    where_zero(sum / (a[0].like(n as f64) * c[0]), c[0], |lane| is_zero(a, n, lane) && is_zero(b, n, lane))
}

/// Returns coefficient n of c = aᵖ for a constant p. If a₀ = 0, it is zero as long as a is zero and
/// p > 0, and NaN otherwise.
#[inline(always)]
pub(super) fn constant_power<N: Number>(a: &Scalars<N>, p: f64, c: &Scalars<N>, n: usize) -> N {
    where_zero(power(a, p, c, n), a[0], |lane| p > 0.0 && is_zero(a, n, lane))
}

/// Returns the coefficient `value`, except in lanes where `number` is zero. There it is zero if
/// `is_zero` holds for the lane, and NaN otherwise.
#[inline(always)]
fn where_zero<N: Number>(mut value: N, number: N, is_zero: impl Fn(usize) -> bool) -> N {
    for lane in 0..N::LANES {
        if number.lane(lane) == 0.0 {
            value.put(lane, if is_zero(lane) { 0.0 } else { f64::NAN });
        }
    }
    value
}

/// Returns coefficient n of a², component by component.
#[inline(always)]
pub(super) fn rows_square<N: Number>(a: &Series<N>, n: usize) -> Row<N> {
    if n == 0 {
        return a.at(0) * a.at(0);
    }
    // Each product of two different coefficients occurs twice.
    let count = (n - 1) / 2;
    let mut sum = products(&a[1..=count], &a[n - count..n], Row::splat(a.at(0).0[0].like(0.0)));
    if n.is_multiple_of(2) {
        let middle = a.at(n / 2);
        sum = (middle * Row::splat(middle.0[0].like(0.5))).mul_add(middle, sum);
    }
    let half = a.at(0).mul_add(a.at(n), sum);
    half + half
}

/// Returns a/b for the three components.
#[inline(always)]
pub(super) fn ratio<N: Number>(a: Row<N>, b: Row<N>) -> Row<N> {
    let ([x, y, z, _], [p, q, r, _]) = (a.0, b.0);
    Row([x / p, y / q, z / r, x.like(0.0)])
}

/// Returns Σ aₖ bₙ₋ₖ, k = 1 … n, component by component, in the order of [`convolution`].
#[inline(always)]
pub(super) fn rows_convolution<N: Number>(a: &Series<N>, b: &Series<N>, n: usize) -> Row<N> {
    let none = Row::splat(a.at(0).0[0].like(0.0));
    if N::LANES > 1 {
        return products(&a[1..=n], &b[..n], none);
    }
    let mut sums = [none; 4];
    for (a, b) in a.forward().zip(b.backward(n)) {
        for i in 0..4 {
            sums[i] = a[i].mul_add(b[3 - i], sums[i]);
        }
    }
    let [first, second, third, fourth] = sums;
    (first + second) + (third + fourth)
}

/// Returns the sum of the products of rows with those of a slice of the same length, from its end.
/// `none`: zero.
#[inline(always)]
fn products<N: Number>(ahead: &[Row<N>], back: &[Row<N>], none: Row<N>) -> Row<N> {
    let mut sums = [none; 4];
    let ((fours, rest), (first, back)) = (ahead.as_chunks::<4>(), back.as_rchunks::<4>());
    for (a, b) in fours.iter().zip(back.iter().rev()) {
        for i in 0..4 {
            sums[i] = a[i].mul_add(b[3 - i], sums[i]);
        }
    }
    for i in 0..3 {
        if i < rest.len() {
            sums[i] = rest[i].mul_add(first[rest.len() - 1 - i], sums[i]);
        }
    }
    let [first, second, third, fourth] = sums;
    (first + second) + (third + fourth)
}

/// Returns Σ_{1≤k≤n} k uₖ wₙ₋ₖ.
#[inline(always)]
fn weighted<N: Number>(u: &Scalars<N>, w: &Scalars<N>, n: usize) -> N {
    convolution(u, w, n, n, |k, u, w| u.like(WHOLE[k]) * u * w)
}

/// Returns Σ_{1≤k<n} k yₖ dₙ₋ₖ = Σ_{1≤k<n} (n − k) dₖ yₙ₋ₖ.
#[inline(always)]
fn weighted_before<N: Number>(y: &Scalars<N>, d: &Scalars<N>, n: usize) -> N {
    convolution(d, y, n, n - 1, |k, d, y| d.like(n as f64 - WHOLE[k]) * d * y)
}

fn is_zero<N: Number>(a: &Scalars<N>, n: usize, lane: usize) -> bool {
    a[..=n].iter().all(|x| x.lane(lane) == 0.0)
}
