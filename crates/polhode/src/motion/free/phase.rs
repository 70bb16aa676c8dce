//! Angles that grow linearly with time, reduced without losing a digit.

use crate::math::real::Real;
use crate::math::sum::{halves, two_product_of_halves, two_sum};

/// f in turns per unit of time, in two words: after 10⁹ turns the error is below 10⁻²² of one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rate<T> {
    /// The first word and its halves.
    pub(super) first: [T; 3],
    pub(super) second: T,
}

/// f in three words: of a sphere or a permanent rotation the error is still below 10⁻²² of a turn after 10²⁴ of them; of other
/// bodies f itself is known to 10⁻³¹ of their wobble.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FineRate<T> {
    /// The first two words and their halves.
    pub(super) first: [T; 3],
    pub(super) second: [T; 3],
    pub(super) third: T,
}

/// A time in two words, the difference of two times; the first also in halves.
///
/// Where the second word is known to be zero, as from a start at t = 0, `WHOLE` leaves out what would only add zeros: the
/// same bits in less time.
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

/// A phase has long lost its digits here, and no product overflows yet.
const LONGEST: f64 = 1e280;

#[inline(always)]
fn with_halves<T: Real>(a: T) -> [T; 3] {
    let (high, low) = halves(a);
    [a, high, low]
}

impl Rate<f64> {
    pub(super) fn new([first, second]: [f64; 2]) -> Self {
        Self { first: with_halves(first), second }
    }
}

impl FineRate<f64> {
    pub(super) fn new([first, second, third]: [f64; 3]) -> Self {
        Self { first: with_halves(first), second: with_halves(second), third }
    }
}

impl<T: Real> Rate<T> {
    /// start + f t modulo two turns, in two words.
    #[inline(always)]
    pub(super) fn turns<const WHOLE: bool>(&self, t: &Elapsed<T>, start: [T; 2]) -> (T, T) {
        // The first product and its error may both be many turns.
        let (p0, e0) = two_product_of_halves(t.high, self.first);
        let mut rest = t.high[0] * self.second;
        if !WHOLE {
            rest = rest + t.low * self.first[0];
        }
        let (s, r0) = two_sum(p0.modulo_two(), start[0]);
        two_sum(s, (r0 + start[1]) + (e0 + rest).modulo_two())
    }
}

impl<T: Real> FineRate<T> {
    /// f t modulo two turns, in two words.
    #[inline(always)]
    pub(super) fn turns<const WHOLE: bool>(&self, t: &Elapsed<T>) -> (T, T) {
        let (p0, e0) = two_product_of_halves(t.high, self.first);
        let (p1, e1) = two_product_of_halves(t.high, self.second);
        let mut rest = e1 + t.high[0] * self.third;
        let (s, r0) = two_sum(p0.modulo_two(), e0.modulo_two());
        let (mut s, r1) = two_sum(s, p1.modulo_two());
        let mut low = r0 + r1;
        if !WHOLE {
            // of the time's second word, too, the product may be many turns
            let (p2, e2) = two_product_of_halves(with_halves(t.low), self.first);
            let (sum, r2) = two_sum(s, p2.modulo_two());
            (s, low) = (sum, low + r2);
            rest = rest + (e2 + t.low * self.second[0]);
        }
        two_sum(s, low + rest.modulo_two())
    }
}
