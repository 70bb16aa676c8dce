//! Angles that grow linearly with time, reduced without losing a digit.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elementary::{sin_cos_quarters, split};
use crate::math::number::Splat;
use crate::math::sum::{two_product_of_halves, two_sum, with_halves};

/// f in quarter turns per unit of time, in three words: of a sphere or a permanent rotation the error is still below 10⁻²² of a
/// turn after 10²⁴ of them; of other bodies f itself is known to 10⁻³¹ of their wobble.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::motion::solve) struct Rate<T> {
    /// The first word and its halves.
    first: [T; 3],
    second: T,
    pub(in crate::motion::solve) third: T,
}

/// A time in two words, the difference of two times.
///
/// Where the second word is known to be zero, as from a start at t = 0, `WHOLE` leaves out what would only add zeros: the
/// same bits in less time.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion::solve) struct Elapsed<T> {
    high: T,
    low: T,
}

/// An angle: a whole number of quarter turns, and the rest.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion::solve) struct Phase<T> {
    /// The whole number, modulo 4, in the last two bits.
    pub(in crate::motion::solve) quarters: T,
    /// Quarter turns, within ½ but for the last digits.
    pub(in crate::motion::solve) rest: T,
}

impl Elapsed<f64> {
    pub(in crate::motion::solve) fn double(&self) -> Double {
        Double::sum(self.high, self.low)
    }
}

impl<T: Splat> Elapsed<T> {
    /// time − start, exactly, times `unit`, a power of two.
    #[inline(always)]
    pub(in crate::motion::solve) fn since<const WHOLE: bool>(start: T, time: T, unit: T) -> Self {
        let (high, low) = if WHOLE { (time, T::splat(0.0)) } else { two_sum(time, -start) };
        Self { high: high * unit, low: low * unit }
    }

    #[inline(always)]
    pub(in crate::motion::solve) fn none() -> Self {
        Self { high: T::splat(0.0), low: T::splat(0.0) }
    }

    /// True if no lane's is longer.
    #[inline(always)]
    pub(in crate::motion::solve) fn is_within(&self, reach: T) -> bool {
        self.high.within(reach)
    }

    /// A span so long that only what is at rest is known there counts as none.
    fn with_digits(&self) -> Self {
        let within = |span: f64, word: f64| if span.abs() < LONGEST { word } else { 0.0 };
        Self { high: self.high.zip(self.high, within), low: self.high.zip(self.low, within) }
    }
}

/// No product overflows yet.
const LONGEST: f64 = 1e280;

impl<T: Splat> Phase<T> {
    /// An angle in two words, and a start within a turn.
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

    /// cos + i sin
    #[inline(always)]
    pub(in crate::motion::solve) fn unit(self) -> Complex<T> {
        let (im, re) = sin_cos_quarters(self.quarters, self.rest);
        Complex { re, im }
    }

    /// + an angle of some quarter turns.
    #[inline(always)]
    pub(in crate::motion::solve) fn plus(self, angle: T) -> Self {
        let sum = self.rest + angle;
        let (_, whole) = split(sum);
        Self { quarters: self.quarters + whole, rest: sum - whole }
    }
}

impl Rate<f64> {
    /// The same in every lane.
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

    /// The longest time that counts as short: what it turns needs no more than two words.
    #[inline(always)]
    pub(in crate::motion::solve) fn reach(&self) -> T {
        self.first[0].map(|first| (MANY / first.abs()).min(LONGEST))
    }

    /// f t in two words: of times within [`Rate::reach`]; `LONG` for others too.
    #[inline(always)]
    pub(in crate::motion::solve) fn quarters<const WHOLE: bool, const LONG: bool>(
        &self,
        t: &Elapsed<T>,
        reach: T,
    ) -> (T, T) {
        // Of the third word and of the second product's error nothing would be seen.
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

    /// f t but for whole turns, in two words of which the second is small, when each product and its error may be many turns of
    /// their own.
    #[cold]
    #[inline(never)] // once, and not in every width of vectors
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

/// In quarter turns, some 10⁹ turns: what is left in a second word is still small beside one.
const MANY: f64 = 8_589_934_592.0;

/// x modulo 4, nearest to zero: exact.
#[inline(always)]
fn modulo_turn<T: Splat>(x: T) -> T {
    x - T::splat(4.0) * (T::splat(0.25) * x).nearest()
}

/// An angle that is linear in time, in quarter turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::motion::solve) struct Angle {
    rate: Rate<f64>,
    start: [f64; 2],
    /// The longest time that needs no more than two words.
    pub(in crate::motion::solve) reach: f64,
}

impl Angle {
    /// Of a rate and a start in quarter turns.
    pub(in crate::motion::solve) fn of(rate: Double, start: Double) -> Self {
        let rate = Rate::of([rate.high, rate.low], 0.0);
        Self { rate, start: [start.high, start.low], reach: rate.reach() }
    }

    /// To rounding, not reduced, quarter turns.
    #[inline(always)]
    pub(in crate::motion::solve) fn quarters(&self, elapsed: &Elapsed<f64>) -> f64 {
        self.rate.first[0] * elapsed.high + self.start[0]
    }

    /// To rounding, not reduced, rad.
    pub(in crate::motion::solve) fn about(&self, time: f64) -> f64 {
        core::f64::consts::FRAC_PI_2 * (self.rate.first[0] * time + self.start[0])
    }

    #[inline(always)]
    pub(in crate::motion::solve) fn at<T: Splat, const LONG: bool>(&self, elapsed: &Elapsed<T>) -> Phase<T> {
        let quarters = self.rate.splat().quarters::<false, LONG>(elapsed, T::splat(self.reach));
        Phase::of(quarters, Some([T::splat(self.start[0]), T::splat(self.start[1])]))
    }
}
