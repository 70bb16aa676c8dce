//! Angles that grow linearly with time, reduced without losing a digit.

use crate::math::elementary::modulo_two;
use crate::math::real::Real;
use crate::math::sum::{two_product, two_sum};

/// x₀ + f t in turns, the frequency f in three words: after 10²⁴ turns the error is still below 10⁻¹⁶ of one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Phase<T> {
    /// f, turns per unit of time.
    pub(super) frequency: [T; 3],
    /// x₀, turns, |x₀| ≤ 1.
    pub(super) start: [T; 2],
}

/// A time in two words: the difference of two times.
#[derive(Clone, Copy, Debug)]
pub(super) struct Elapsed<T> {
    pub(super) high: T,
    pub(super) low: T,
}

impl<T: Real> Phase<T> {
    /// The phase modulo two turns, in two words.
    #[inline(always)]
    pub(super) fn at(&self, t: Elapsed<T>) -> (T, T) {
        let [f0, f1, f2] = self.frequency;
        let (p0, e0) = two_product(t.high, f0);
        let (p1, e1) = two_product(t.high, f1);
        let tail = modulo_two(e1) + modulo_two(t.high * f2) + modulo_two(t.low * f0);
        let (s, r0) = two_sum(modulo_two(p0), self.start[0]);
        let (s, r1) = two_sum(s, modulo_two(e0));
        let (s, r2) = two_sum(s, modulo_two(p1));
        two_sum(s, ((r0 + r1) + r2) + (tail + self.start[1]))
    }
}
