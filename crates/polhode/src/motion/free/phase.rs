//! Angles that grow linearly with time, reduced without losing a digit.

use crate::math::elementary::modulo_two;
use crate::math::real::Real;
use crate::math::sum::{halves, two_product_of_halves, two_sum};

/// x₀ + f t in turns, the frequency f in W words: with three, after 10²⁴ turns the error is still below 10⁻¹⁶ of one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Phase<T, const W: usize> {
    /// f, turns per unit of time: its words, each with its two halves.
    pub(super) frequency: [[T; 3]; W],
    /// x₀, turns, |x₀| ≤ 1.
    pub(super) start: [T; 2],
}

/// A time in two words, the difference of two times; the first also in halves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Elapsed<T> {
    high: [T; 3],
    low: T,
}

impl<T: Real> Elapsed<T> {
    #[inline(always)]
    pub(super) fn new(high: T, low: T) -> Self {
        Self { high: with_halves(high), low }
    }

    /// time − start, exactly, times `unit`, a power of two. A span too long for any digit of its phase counts as none.
    #[inline(always)]
    pub(super) fn since(start: T, time: T, unit: T) -> Self {
        let (high, low) = two_sum(time, -start);
        let within = |span: f64, word: f64| if span.abs() < LONGEST { word } else { 0.0 };
        let (high, low) = (high * unit, low * unit);
        Self::new(high.zip(high, within), high.zip(low, within))
    }
}

impl<const W: usize> Phase<f64, W> {
    pub(super) fn new(frequency: [f64; W], start: [f64; 2]) -> Self {
        Self { frequency: frequency.map(with_halves), start }
    }
}

/// A phase has long lost its digits here, and no product overflows yet.
const LONGEST: f64 = 1e280;

#[inline(always)]
fn with_halves<T: Real>(a: T) -> [T; 3] {
    let (high, low) = halves(a);
    [a, high, low]
}

impl<T: Real, const W: usize> Phase<T, W> {
    /// The phase modulo two turns, in two words.
    #[inline(always)]
    pub(super) fn at(&self, t: &Elapsed<T>) -> (T, T) {
        // The first word's product and its error may both be many turns; so may the second word's. The last word's is not.
        let (p0, e0) = two_product_of_halves(t.high, self.frequency[0]);
        let (s, r0) = two_sum(modulo_two(p0), self.start[0]);
        let mut tail = t.low * self.frequency[0][0];
        if W == 2 {
            let p1 = t.high[0] * self.frequency[1][0];
            return two_sum(s, (r0 + self.start[1]) + modulo_two(e0 + (p1 + tail)));
        }
        let (s, r1) = two_sum(s, modulo_two(e0));
        let (p1, e1) = two_product_of_halves(t.high, self.frequency[1]);
        let (s, r2) = two_sum(s, modulo_two(p1));
        tail = modulo_two((tail + e1) + t.high[0] * self.frequency[W - 1][0]);
        two_sum(s, ((r0 + r1) + r2) + (tail + self.start[1]))
    }
}
