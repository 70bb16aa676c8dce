//! Coefficients of scalar series: products, quotients and powers, one coefficient at a time.
//!
//! Each function gives coefficient n of its result, from coefficients up to n of what it is of and up to n − 1 of itself.
//!
//! Source: L. B. Rall, Automatic Differentiation (1981), ch. 3.3; À. Jorba, M. Zou, Exp. Math. 14 (2005) 99, prop. 2.1.

use super::row::TERMS;
use crate::math::number::Number;

/// Taylor coefficients of a number, from the constant on.
pub(super) type Scalars<N = f64> = [N; TERMS];

/// (a b)ₙ = Σ aₖ bₙ₋ₖ
#[inline(always)]
pub(super) fn product<N: Number>(a: &Scalars<N>, b: &Scalars<N>, n: usize) -> N {
    let zero = a[0].like(0.0);
    a[..=n].iter().zip(b[..=n].iter().rev()).fold(zero, |sum, (&a, &b)| sum + a * b)
}

/// c = a / b: cₙ = (aₙ − Σ_{k≥1} bₖ cₙ₋ₖ) / b₀
#[inline(always)]
pub(super) fn quotient<N: Number>(a: &Scalars<N>, b: &Scalars<N>, c: &Scalars<N>, n: usize) -> N {
    let zero = a[0].like(0.0);
    let known = b[1..=n].iter().zip(c[..n].iter().rev()).fold(zero, |sum, (&b, &c)| sum + b * c);
    (a[n] - known) / b[0]
}

/// c = a^p, n ≥ 1: cₙ = Σ_{k<n} (p (n − k) − k) aₙ₋ₖ cₖ / (n a₀); c₀ is the caller's.
#[inline(always)]
pub(super) fn power<N: Number>(a: &Scalars<N>, p: f64, c: &Scalars<N>, n: usize) -> N {
    let zero = a[0].like(0.0);
    let terms = c[..n].iter().zip(a[1..=n].iter().rev()).enumerate();
    let weight = |k: usize| zero.like(p * (n - k) as f64 - k as f64);
    let sum = terms.fold(zero, |sum, (k, (&c, &a))| sum + weight(k) * a * c);
    sum / (zero.like(n as f64) * a[0])
}

/// Coefficients of f(w(t)), f(w) = arccos w/√(1 − w²), from those of w: half an angle over its sine, by the cosine.
///
/// f(w) = Σ Fₖ (w − w₀)ᵏ, and each power of w − w₀ is a series of its own. Nothing is divided by 1 − w², which may be zero.
#[derive(Clone, Debug)]
pub(super) struct Composition<N = f64> {
    outer: Scalars<N>,
    /// (w − w₀)ᵏ
    powers: Box<[Scalars<N>; TERMS]>,
    result: Scalars<N>,
}

impl<N: Number> Composition<N> {
    /// Of nothing yet.
    pub(super) fn all(zero: N) -> Self {
        let none = [zero; TERMS];
        Self { outer: none, powers: Box::new([none; TERMS]), result: none }
    }

    /// Starts a lane at w₀ ≥ 0 with f(w₀), and √(1 − w₀²).
    ///
    /// (1 − w²) f' = w f − 1, so that (1 − w₀²)(k + 1) Fₖ₊₁ = (2k + 1) w₀ Fₖ + k Fₖ₋₁, k ≥ 1. Of its solutions, which go as (−1 − w₀)⁻ᵏ
    /// and (1 − w₀)⁻ᵏ, ours is the smaller: it is found from large k downward (Miller's algorithm, DLMF 3.6(iii)), and upward only
    /// where the two hardly differ.
    pub(super) fn start(&mut self, lane: usize, f: f64, w: f64, sine: f64) {
        let square = sine * sine;
        let mut outer = [0.0; TERMS];
        outer[0] = f;
        if w < LEAST_COSINE {
            outer[1] = (w * f - 1.0) / square;
            for k in 1..TERMS - 1 {
                let step = (2 * k + 1) as f64 * w * outer[k] + k as f64 * outer[k - 1];
                outer[k + 1] = step / (square * (k + 1) as f64);
            }
        } else {
            let (mut above, mut here) = (0.0, 1.0);
            for k in (1..=FAR).rev() {
                if k < TERMS {
                    outer[k] = here;
                }
                let below = (square * (k + 1) as f64 * above - (2 * k + 1) as f64 * w * here) / k as f64;
                (above, here) = (here, below);
            }
            for coefficient in &mut outer[1..] {
                *coefficient *= f / here;
            }
        }
        for (place, coefficient) in self.outer.iter_mut().zip(outer) {
            place.put(lane, coefficient);
        }
    }

    /// Finds coefficient n from those of w up to n.
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

    /// The coefficients known so far.
    #[inline(always)]
    pub(super) fn series(&self) -> &Scalars<N> {
        &self.result
    }
}

/// Below this w₀, upward: rounding grows by 1.5 with each k, and F₂₄ is still good to twelve digits.
const LEAST_COSINE: f64 = 0.2;

/// Where to begin downward: from here to F₂₄ the other solution fades by 1.5¹⁰⁰.
const FAR: usize = 130;

#[cfg(test)]
mod tests {
    use super::*;

    /// f(w) = acos(w)/√(1 − w²) by its series in 1 − w, f = Σ aₖ (1 − w)ᵏ with aₖ₊₁ = aₖ (k + 1)/(2k + 3): far from w₀ = 1 too, with many
    /// terms.
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
            composition.start(0, value, w0, sine);
            // w = w₀ + 0.3 t − 0.7 t² + 0.2 t³
            let mut w = [0.0; TERMS];
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
