//! Phases that grow linearly with time, reduced modulo a turn at full precision.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elementary::{sin_cos_quarters, split};
use crate::math::number::Splat;
use crate::math::sum::{two_product_of_halves, two_sum, with_halves};

/// Rate f of a phase in three words, quarter turns per unit time.
///
/// The error for a sphere or a permanent rotation is below 10⁻²² of a turn after 10²⁴ turns. For
/// other bodies f itself is known to 10⁻³¹ of their nutation rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::motion::solve) struct Rate<T> {
    /// First word, and its two halves for exact products.
    first: [T; 3],
    second: T,
    pub(in crate::motion::solve) third: T,
}

/// Elapsed time in two words: the exact difference of two times.
///
/// The const parameter `WHOLE` is true if the second word is known to be zero, as for a start at t
/// = 0. The code then omits the terms with this word: same bits, less time.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion::solve) struct Elapsed<T> {
    high: T,
    low: T,
}

/// Phase: a whole number of quarter turns, and a remainder.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion::solve) struct Phase<T> {
    /// Whole number of quarter turns, modulo 4 in the last two bits.
    pub(in crate::motion::solve) quarters: T,
    /// Remainder in quarter turns, between −½ and ½ up to rounding.
    pub(in crate::motion::solve) rest: T,
}

impl Elapsed<f64> {
    pub(in crate::motion::solve) fn double(&self) -> Double {
        Double::sum(self.high, self.low)
    }
}

impl<T: Splat> Elapsed<T> {
    /// Returns time − start exactly, times `unit`, a power of two.
    #[inline(always)]
    pub(in crate::motion::solve) fn since<const WHOLE: bool>(start: T, time: T, unit: T) -> Self {
        let (high, low) = if WHOLE { (time, T::splat(0.0)) } else { two_sum(time, -start) };
        Self { high: high * unit, low: low * unit }
    }

    #[inline(always)]
    pub(in crate::motion::solve) fn none() -> Self {
        Self { high: T::splat(0.0), low: T::splat(0.0) }
    }

    /// Returns true if the time in no lane is longer than `reach`.
    #[inline(always)]
    pub(in crate::motion::solve) fn is_within(&self, reach: T) -> bool {
        self.high.within(reach)
    }

    /// Replaces times longer than `LONGEST` by zero. Only a body at rest is known so far from its
    /// start.
    fn with_digits(&self) -> Self {
        let within = |span: f64, word: f64| if span.abs() < LONGEST { word } else { 0.0 };
        Self { high: self.high.zip(self.high, within), low: self.high.zip(self.low, within) }
    }
}

/// Largest time, and largest reach, for which no product overflows.
const LONGEST: f64 = 1e280;

impl<T: Splat> Phase<T> {
    /// Reduces a phase in two words, plus the phase of the start, which is within a turn.
    #[inline(always)]
    pub(in crate::motion::solve) fn of((high, low): (T, T), start: Option<[T; 2]>) -> Self {
        let (high, low) = match start {
            None => (high, low),
            Some(start) => {
                let (sum, error) = two_sum(high, start[0]);
                (sum, (error + start[1]) + low)
            }
        };
        let (quarters, whole) = split(high);
        Self { quarters, rest: (high - whole) + low }
    }

    /// Returns cos + i sin of the phase.
    #[inline(always)]
    pub(in crate::motion::solve) fn unit(self) -> Complex<T> {
        let (im, re) = sin_cos_quarters(self.quarters, self.rest);
        Complex { re, im }
    }

    /// Adds an angle of a few quarter turns.
    #[inline(always)]
    pub(in crate::motion::solve) fn plus(self, angle: T) -> Self {
        let sum = self.rest + angle;
        let (_, whole) = split(sum);
        Self { quarters: self.quarters + whole, rest: sum - whole }
    }
}

impl Rate<f64> {
    /// Copies the rate to every lane.
    #[inline(always)]
    pub(in crate::motion::solve) fn splat<T: Splat>(&self) -> Rate<T> {
        let Self { first, second, third } = *self;
        let [a, b, c] = first;
        Rate {
            first: [T::splat(a), T::splat(b), T::splat(c)],
            second: T::splat(second),
            third: T::splat(third),
        }
    }
}

impl<T: Splat> Rate<T> {
    #[inline(always)]
    pub(in crate::motion::solve) fn of([first, second]: [T; 2], third: T) -> Self {
        Self { first: with_halves(first), second, third }
    }

    /// Returns the longest time that counts as short: two words suffice for its phase.
    #[inline(always)]
    pub(in crate::motion::solve) fn reach(&self) -> T {
        self.first[0].map(|first| (MANY / first.abs()).min(LONGEST))
    }

    /// Returns f t in two words. Times must be within [`Rate::reach`] unless `LONG` is set.
    #[inline(always)]
    pub(in crate::motion::solve) fn quarters<const WHOLE: bool, const LONG: bool>(
        &self,
        t: &Elapsed<T>,
        reach: T,
    ) -> (T, T) {
        // The third word and the error of the second product are below rounding.
        let (high, error) = two_product_of_halves(with_halves(t.high), self.first);
        let mut low = error + t.high * self.second;
        if !WHOLE {
            low = low + t.low * self.first[0];
        }
        if !LONG {
            return (high, low);
        }
        let (long_high, long_low) = self.of_long_times(t);
        let short = t.high.zip(reach, |t, reach| if t.abs() <= reach { 1.0 } else { 0.0 });
        let choose = |is_short: f64, short: f64, long: f64| if is_short == 1.0 { short } else { long };
        (short.zip3(high, long_high, choose), short.zip3(low, long_low, choose))
    }

    /// Returns f t minus whole turns, in two words of which the second is small. Each product, and
    /// its rounding error, may be many turns.
    #[cold]
    #[inline(never)] // compiled once, not for every vector width
    fn of_long_times(&self, t: &Elapsed<T>) -> (T, T) {
        let t = t.with_digits();
        let (p0, e0) = two_product_of_halves(with_halves(t.high), self.first);
        let (p1, e1) = two_product_of_halves(with_halves(t.high), with_halves(self.second));
        let (p2, e2) = two_product_of_halves(with_halves(t.low), self.first);
        let rest = (e1 + e2) + (t.high * self.third + t.low * self.second);
        let (s, r0) = two_sum(modulo_turn(p0), modulo_turn(e0));
        let (s, r1) = two_sum(s, modulo_turn(p1));
        let (s, r2) = two_sum(s, modulo_turn(p2));
        two_sum(s, (r0 + r1 + r2) + modulo_turn(rest))
    }
}

/// Largest phase of a short time, quarter turns: about 10⁹ turns. The rounding error of the second
/// word is then still far below one quarter turn.
const MANY: f64 = 8_589_934_592.0;

/// Returns x modulo 4, between −2 and 2, exactly.
#[inline(always)]
fn modulo_turn<T: Splat>(x: T) -> T {
    x - T::splat(4.0) * (T::splat(0.25) * x).nearest()
}

/// Phase that is linear in time, in quarter turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::motion::solve) struct Angle {
    rate: Rate<f64>,
    start: [f64; 2],
    /// Longest time for which two words suffice.
    pub(in crate::motion::solve) reach: f64,
}

impl Angle {
    /// Creates the phase from its rate and its value at the start, quarter turns.
    pub(in crate::motion::solve) fn of(rate: Double, start: Double) -> Self {
        let rate = Rate::of([rate.high, rate.low], 0.0);
        Self { rate, start: [start.high, start.low], reach: rate.reach() }
    }

    /// Returns the phase in one word, not reduced, quarter turns.
    #[inline(always)]
    pub(in crate::motion::solve) fn quarters(&self, elapsed: &Elapsed<f64>) -> f64 {
        self.rate.first[0] * elapsed.high + self.start[0]
    }

    /// Returns the phase in one word, not reduced, rad.
    pub(in crate::motion::solve) fn about(&self, time: f64) -> f64 {
        core::f64::consts::FRAC_PI_2 * (self.rate.first[0] * time + self.start[0])
    }

    #[inline(always)]
    pub(in crate::motion::solve) fn at<T: Splat, const LONG: bool>(&self, elapsed: &Elapsed<T>) -> Phase<T> {
        let quarters = self.rate.splat().quarters::<false, LONG>(elapsed, T::splat(self.reach));
        Phase::of(quarters, Some([T::splat(self.start[0]), T::splat(self.start[1])]))
    }
}
