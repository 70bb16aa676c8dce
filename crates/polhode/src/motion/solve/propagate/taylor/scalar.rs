//! Taylor coefficients of scalar series: products, quotients and powers, one coefficient at a time.
//!
//! Each function returns coefficient n of its result. It needs coefficients up to n of its
//! arguments and up to n − 1 of the result.
//!
//! Source: L. B. Rall, Automatic Differentiation (1981), ch. 3.3; À. Jorba, M. Zou, Exp. Math. 14
//! (2005) 99, prop. 2.1.

use core::ops::{Deref, DerefMut};

use super::row::{MARGIN, Row, Series, TERMS};
use crate::math::number::Number;

/// Taylor coefficients of a number, in ascending order, after [`MARGIN`] zeros that a loop by fours
/// may read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scalars<N = f64>([N; MARGIN + TERMS]);

impl<N: Number> Scalars<N> {
    pub(super) fn all(x: N) -> Self {
        Self([x; MARGIN + TERMS])
    }

    /// Returns a series that is constant.
    pub(super) fn constant(x: N) -> Self {
        let mut series = Self::all(x.like(0.0));
        series[0] = x;
        series
    }
}

impl<N> Deref for Scalars<N> {
    type Target = [N];

    #[inline(always)]
    fn deref(&self) -> &[N] {
        &self.0[MARGIN..]
    }
}

impl<N> DerefMut for Scalars<N> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [N] {
        &mut self.0[MARGIN..]
    }
}

/// Returns Σ f(k, aₖ, bₙ₋ₖ), k = 1 … `last`. f must be proportional to each of aₖ and bₙ₋ₖ. If
/// `last` is n − 1, it must be zero for k = n.
///
/// A single body uses a loop by fours with few, predictable exits; beyond n it reads the zeros
/// before b₀. Several bodies use a loop that ends at `last`, because other lanes may have stored
/// infinities beyond. Both add every fourth term to the same sum, so that no addition waits for the
/// one before it. Adding zeros does not change a sum that begins with +0.
#[inline(always)]
pub(super) fn convolution<N: Number>(
    a: &Scalars<N>,
    b: &Scalars<N>,
    n: usize,
    last: usize,
    term: impl Fn(usize, N, N) -> N,
) -> N {
    let mut sums = [a[0].like(0.0); 4];
    if N::LANES > 1 {
        let ((fours, rest), (first, back)) = (a[1..=last].as_chunks::<4>(), b[n - last..n].as_rchunks::<4>());
        let mut k = 1;
        for (a, b) in fours.iter().zip(back.iter().rev()) {
            for i in 0..4 {
                sums[i] = sums[i] + term(k + i, a[i], b[3 - i]);
            }
            k += 4;
        }
        for i in 0..3 {
            if i < rest.len() {
                sums[i] = sums[i] + term(k + i, rest[i], first[rest.len() - 1 - i]);
            }
        }
    } else {
        let (ahead, back) = (a[1..].as_chunks::<4>().0, b.0[..MARGIN + n].as_rchunks::<4>().1);
        let mut k = 1;
        for (a, b) in ahead.iter().zip(back.iter().rev()) {
            for i in 0..4 {
                sums[i] = sums[i] + term(k + i, a[i], b[3 - i]);
            }
            k += 4;
        }
    }
    let [first, second, third, fourth] = sums;
    (first + second) + (third + fourth)
}

/// Returns coefficient n of a times a vector, with the same loops.
#[inline(always)]
pub(super) fn times_vector<N: Number>(a: &Scalars<N>, v: &Series<N>, n: usize) -> Row<N> {
    let mut sums = [Row::splat(a[0].like(0.0)); 4];
    if N::LANES > 1 {
        let ((fours, rest), (first, back)) = (a[1..=n].as_chunks::<4>(), v[..n].as_rchunks::<4>());
        for (a, v) in fours.iter().zip(back.iter().rev()) {
            for i in 0..4 {
                sums[i] = Row::splat(a[i]).mul_add(v[3 - i], sums[i]);
            }
        }
        for i in 0..3 {
            if i < rest.len() {
                sums[i] = Row::splat(rest[i]).mul_add(first[rest.len() - 1 - i], sums[i]);
            }
        }
    } else {
        for (a, v) in a[1..].as_chunks::<4>().0.iter().zip(v.backward(n)) {
            for i in 0..4 {
                sums[i] = Row::splat(a[i]).mul_add(v[3 - i], sums[i]);
            }
        }
    }
    let [first, second, third, fourth] = sums;
    Row::splat(a[0]).mul_add(v.at(n), (first + second) + (third + fourth))
}

/// Returns (a b)ₙ = Σ aₖ bₙ₋ₖ.
#[inline(always)]
pub(super) fn product<N: Number>(a: &Scalars<N>, b: &Scalars<N>, n: usize) -> N {
    convolution(a, b, n, n, |_, a, b| a * b) + a[0] * b[n]
}

/// Returns coefficient n of c = a / b: cₙ = (aₙ − Σ_{k≥1} bₖ cₙ₋ₖ) / b₀.
#[inline(always)]
pub(super) fn quotient<N: Number>(a: &Scalars<N>, b: &Scalars<N>, c: &Scalars<N>, n: usize) -> N {
    (a[n] - convolution(b, c, n, n, |_, b, c| b * c)) / b[0]
}

/// Returns coefficient n ≥ 1 of c = a^p: cₙ = Σ_{k≥1} (p k − (n − k)) aₖ cₙ₋ₖ / (n a₀). The caller
/// computes c₀.
#[inline(always)]
pub(super) fn power<N: Number>(a: &Scalars<N>, p: f64, c: &Scalars<N>, n: usize) -> N {
    let whole = a[0].like(n as f64);
    let weight = |k: usize| whole.like((p + 1.0) * WHOLE[k] - n as f64);
    convolution(a, c, n, n, |k, a, c| weight(k) * a * c) / (whole * a[0])
}

/// Returns coefficient n ≥ 1 of f = aᵖ − (a + δ)ᵖ from b = aᵖ and s = a + δ; δ may be small. The
/// caller computes f₀.
///
/// s f' = δ b' − p (δ' b − s' f) gives n s₀ fₙ = n δ₀ bₙ + Σ_{k≥1} ((n − k) − p k) (δₖ bₙ₋ₖ − sₖ
/// fₙ₋ₖ).
#[inline(always)]
pub(super) fn power_difference<N: Number>(
    [delta, s, b]: [&Scalars<N>; 3],
    p: f64,
    f: &Scalars<N>,
    n: usize,
) -> N {
    let whole = delta[0].like(n as f64);
    let weight = |k: usize| whole.like(n as f64 - (p + 1.0) * WHOLE[k]);
    let ahead = convolution(delta, b, n, n, |k, delta, b| weight(k) * delta * b);
    let known = convolution(s, f, n, n, |k, s, f| weight(k) * s * f);
    (whole * delta[0] * b[n] + (ahead - known)) / (whole * s[0])
}

/// Whole numbers 0, 1, 2, … as f64.
pub(super) const WHOLE: [f64; TERMS + MARGIN] = {
    let mut numbers = [0.0; TERMS + MARGIN];
    let mut k = 0;
    while k < numbers.len() {
        numbers[k] = k as f64;
        k += 1;
    }
    numbers
};

/// Series of f(w(t)) or of f′(w(t)) from that of w, where f(w) = arccos w/√(1 − w²).
///
/// If w is the cosine of half an angle, f is half the angle divided by its sine. f(w) = Σ Fₖ (w −
/// w₀)ᵏ, where each power of w − w₀ has its own series. Nothing is divided by 1 − w², which may be
/// zero.
#[derive(Clone, Debug)]
pub(super) struct Composition<N = f64> {
    outer: Scalars<N>,
    /// Series of (w − w₀)ᵏ.
    powers: Box<[Scalars<N>; TERMS]>,
    result: Scalars<N>,
}

impl<N: Number> Composition<N> {
    /// Creates an empty composition.
    pub(super) fn all(zero: N) -> Self {
        let none = Scalars::all(zero);
        Self { outer: none, powers: Box::new([none; TERMS]), result: none }
    }

    /// Starts a lane at w₀ ≥ 0, from f(w₀), w₀ and √(1 − w₀²).
    ///
    /// (1 − w²) f' = w f − 1 gives (1 − w₀²)(k + 1) Fₖ₊₁ = (2k + 1) w₀ Fₖ + k Fₖ₋₁, k ≥ 1. The
    /// solutions of this recurrence behave like (−1 − w₀)⁻ᵏ and (1 − w₀)⁻ᵏ; the one needed is the
    /// smaller. It is computed from large k downward (Miller's algorithm, DLMF 3.6(iii)), and
    /// upward only if both hardly differ.
    pub(super) fn start(&mut self, lane: usize, [f, w, sine]: [f64; 3], is_slope: bool) {
        let square = sine * sine;
        let mut outer = [0.0; TERMS + 1];
        outer[0] = f;
        if w < LEAST_COSINE {
            outer[1] = (w * f - 1.0) / square;
            for k in 1..TERMS {
                let step = (2 * k + 1) as f64 * w * outer[k] + k as f64 * outer[k - 1];
                outer[k + 1] = step / (square * (k + 1) as f64);
            }
        } else {
            let (mut above, mut here) = (0.0, 1.0);
            for k in (1..=FAR).rev() {
                if k <= TERMS {
                    outer[k] = here;
                }
                let below = (square * (k + 1) as f64 * above - (2 * k + 1) as f64 * w * here) / k as f64;
                (above, here) = (here, below);
            }
            for coefficient in &mut outer[1..] {
                *coefficient *= f / here;
            }
        }
        for (k, place) in self.outer.iter_mut().enumerate() {
            place.put(lane, if is_slope { (k + 1) as f64 * outer[k + 1] } else { outer[k] });
        }
    }

    /// Computes coefficient n from those of w up to n.
    #[inline(always)]
    pub(super) fn extend(&mut self, w: &Scalars<N>, n: usize) {
        if n == 0 {
            self.result[0] = self.outer[0];
            return;
        }
        let zero = w[0].like(0.0);
        self.powers[1][n] = w[n];
        let mut sum = self.outer[1] * w[n];
        for k in 2..=n {
            // (δᵏ)ₙ = Σ δⱼ (δᵏ⁻¹)ₙ₋ⱼ, and (δᵏ⁻¹)ₘ is zero for m < k − 1
            let below = &self.powers[k - 1][k - 1..n];
            let terms = w[1..=n + 1 - k].iter().zip(below.iter().rev());
            let power = terms.fold(zero, |sum, (&a, &b)| sum + a * b);
            self.powers[k][n] = power;
            sum = sum + self.outer[k] * power;
        }
        self.result[n] = sum;
    }

    /// Returns the coefficients known so far.
    #[inline(always)]
    pub(super) fn series(&self) -> &Scalars<N> {
        &self.result
    }
}

/// Threshold of w₀ for upward recurrence. Below it, rounding grows by at most 1.5 with each k, and
/// F₂₄ is still accurate to twelve digits.
const LEAST_COSINE: f64 = 0.2;

/// First index of the downward recurrence. From here to F₂₄ the other solution decreases by 1.5¹⁰⁰.
const FAR: usize = 130;

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns f(w) = acos(w)/√(1 − w²) by its series in 1 − w: f = Σ aₖ (1 − w)ᵏ, aₖ₊₁ = aₖ (k +
    /// 1)/(2k + 3). It has many terms, so that it also holds far from w₀ = 1.
    fn f(w: f64) -> f64 {
        let (mut term, mut sum) = (1.0, 0.0);
        for k in 0..400 {
            sum += term;
            term *= (1.0 - w) * (k + 1) as f64 / (2 * k + 3) as f64;
        }
        sum
    }

    #[test]
    fn a_composition_has_the_values_of_its_function() {
        for w0 in [1.0_f64, 1.0 - 1e-16, 0.999_999_9, 0.8, 0.31, 0.2, 0.199, 0.05, 0.0] {
            let sine = ((1.0 - w0) * (1.0 + w0)).sqrt();
            let half = libm::atan2(sine, w0);
            let value = if sine == 0.0 { 1.0 } else { half / sine };
            assert!((value - f(w0)).abs() < 1e-14, "{w0}");
            let mut composition = Composition::all(0.0);
            composition.start(0, [value, w0, sine], false);
            // w = w₀ + 0.3 t − 0.7 t² + 0.2 t³
            let mut w = Scalars::all(0.0);
            w[..4].copy_from_slice(&[w0, 0.3, -0.7, 0.2]);
            for n in 0..TERMS {
                composition.extend(&w, n);
            }
            for t in [-0.1_f64, 0.05, 0.12] {
                let at = |series: &Scalars| series.iter().rev().fold(0.0, |sum, c| sum * t + c);
                let (got, want) = (at(composition.series()), f(at(&w)));
                assert!((got - want).abs() < 2e-14, "w₀ = {w0}, t = {t}: {got} {want}");
            }
        }
    }
}
