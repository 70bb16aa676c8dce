//! One kernel for every free motion: two phases, a few terms of a theta series, a quaternion.

use core::array::from_fn;

use crate::math::complex::Complex;
use crate::math::elementary::sin_cos_turns;
use crate::math::real::Real;
use crate::math::sum::two_sum;

use super::hyperbolic::Hyperbolic;
use super::phase::{Elapsed, FineRate, Rate};
use super::trigonometric::Trigonometric;

/// Cayley–Klein parameters: the quaternion w + iz = α, x + iy = β, of any norm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spinor<T> {
    pub(super) alpha: Complex<T>,
    pub(super) beta: Complex<T>,
}

/// A place on the polhode, as the theta functions give it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<T> {
    /// (f, g), |f|² + |g|² = 1/over
    pub(super) spinor: Spinor<T>,
    /// cn, sn and dn times constants, over `over`.
    pub(super) theta: [T; 3],
    /// 1 over the theta function that they share.
    pub(super) over: T,
}

/// The constants of a motion, in the form that is evaluated.
///
/// With z = π(u0 + λt)/2K reduced by N half turns to |z| ≤ ½π, the attitude of the labelled axes in axes along L is
///
/// α = e^iφ f(z),  β = −i (−1)ᴺ e^iφ g(z),  φ = ½Ωt − ½πN − (2b/π) z
///
/// where f and g are the series (b = 0 for the trigonometric one), and ω = (A1/i1 cn, A2/i2 sn, A3/i3 dn).
///
/// Source: Klein & Sommerfeld, Über die Theorie des Kreisels, ch. VI; derived in `book/free-motion.md`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Flow<T, S> {
    /// ½Ωt, turns.
    pub(super) precession: FineRate<T>,
    /// λ/4K: z/2π, turns.
    pub(super) polhode: Rate<T>,
    /// z/2π at the start, turns.
    pub(super) start: [T; 2],
    /// Columns: the axes times the amplitudes of ω along them, and the constants that make theta functions cn, sn and dn.
    pub(super) omega: [[T; 3]; 3],
    /// From (Re α, Re β, Im β, Im α) to the attitude's quaternion.
    pub(super) attitude: [[T; 4]; 4],
    pub(super) series: S,
}

/// What the time is, as angles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turned<T> {
    /// z/2π, turns, |z| ≤ ½π.
    x: T,
    /// (−1)ᴺ
    sign: T,
    /// Of φ.
    sin: T,
    cos: T,
}

/// Theta functions of one kind.
pub(super) trait Series<T> {
    /// At z/2π turns, |z| ≤ ½π.
    fn at(&self, x: T) -> Point<T>;

    /// 2b/π.
    fn bend(&self) -> Option<T>;
}

/// A series that also comes in other numbers.
pub(super) trait Family: Series<f64> {
    /// What makes the three quotients cn, sn and dn.
    fn scale(&self) -> [f64; 3];

    /// The same series in numbers T.
    type Of<T: Real>: Series<T>;

    /// The series in which each constant is what `pick` makes of the way to it.
    fn assembled<T: Real>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Self::Of<T>;
}

impl<T: Real> Series<T> for Trigonometric<T> {
    #[inline(always)]
    fn at(&self, x: T) -> Point<T> {
        Self::at(self, x)
    }

    #[inline(always)]
    fn bend(&self) -> Option<T> {
        None
    }
}

impl<T: Real> Series<T> for Hyperbolic<T> {
    #[inline(always)]
    fn at(&self, x: T) -> Point<T> {
        Self::at(self, x)
    }

    #[inline(always)]
    fn bend(&self) -> Option<T> {
        Some(self.bend)
    }
}

impl<T: Real> Turned<T> {
    #[inline(always)]
    pub(super) fn still() -> Self {
        let (zero, one) = (T::splat(0.0), T::splat(1.0));
        Self { x: zero, sign: one, sin: zero, cos: one }
    }
}

impl<T: Real, S: Series<T>> Flow<T, S> {
    /// Both phases, reduced; `WHOLE` if the time has one word.
    #[inline(always)]
    pub(super) fn turned<const WHOLE: bool>(&self, elapsed: &Elapsed<T>) -> Turned<T> {
        let (high, low) = self.polhode.turns::<WHOLE>(elapsed, self.start);
        let half_turns = (T::splat(2.0) * high).nearest();
        let x = (high - T::splat(0.5) * half_turns) + low;
        let odd = half_turns.modulo_two();
        let sign = T::splat(1.0) - T::splat(2.0) * (odd * odd);

        let (high, low) = self.precession.turns::<WHOLE>(elapsed);
        let high = high - T::splat(0.25) * half_turns;
        let (high, low) = match self.series.bend() {
            None => (high, low),
            Some(bend) => {
                let (sum, error) = two_sum(high, -(bend * x));
                (sum, error + low)
            }
        };
        let (sin, cos) = sin_cos_turns(high, low);
        Turned { x, sign, sin, cos }
    }

    /// Quaternion and ω of the phases.
    #[inline(always)]
    pub(super) fn state(&self, turned: &Turned<T>) -> ([T; 4], [T; 3]) {
        let Turned { x, sign, sin, cos } = *turned;
        let Point { spinor: Spinor { alpha, beta }, theta: [cn, sn, dn], over } = self.series.at(x);
        let phase = Complex { re: cos, im: sin };
        let alpha = alpha.times(phase);
        // −i (−1)ᴺ
        let beta = beta.times(Complex { re: sign * phase.im, im: -(sign * phase.re) });

        let labelled = [alpha.re, beta.re, beta.im, alpha.im];
        let signed = sign * over;
        let rates = [signed * cn, signed * sn, over * dn];
        let (a, w) = (&self.attitude, &self.omega);
        let [qw, qx, qy, qz] =
            [dot4(&a[0], &labelled), dot4(&a[1], &labelled), dot4(&a[2], &labelled), dot4(&a[3], &labelled)];
        // The norm is 1/√over; its last digits by 1/√n = (3 − n)/2 for n near 1.
        let norm2 = over * ((qw * qw + qx * qx) + (qy * qy + qz * qz));
        let k = over.map(f64::sqrt) * (T::splat(1.5) - T::splat(0.5) * norm2);
        ([qw * k, qx * k, qy * k, qz * k], [dot3(&w[0], &rates), dot3(&w[1], &rates), dot3(&w[2], &rates)])
    }
}

impl<S: Family> Flow<f64, S> {
    /// The flow in other numbers: one body in every lane, or a body in each.
    pub(super) fn assembled<T: Real>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Flow<T, S::Of<T>> {
        Flow {
            precession: FineRate {
                first: from_fn(|k| pick(&|f| f.precession.first[k])),
                second: from_fn(|k| pick(&|f| f.precession.second[k])),
                third: pick(&|f| f.precession.third),
            },
            polhode: Rate {
                first: from_fn(|k| pick(&|f| f.polhode.first[k])),
                second: pick(&|f| f.polhode.second),
            },
            start: from_fn(|k| pick(&|f| f.start[k])),
            omega: from_fn(|i| from_fn(|k| pick(&|f| f.omega[i][k]))),
            attitude: from_fn(|i| from_fn(|k| pick(&|f| f.attitude[i][k]))),
            series: S::assembled(&|get: &dyn Fn(&S) -> f64| pick(&|f: &Self| get(&f.series))),
        }
    }
}

#[inline(always)]
fn dot3<T: Real>(a: &[T; 3], b: &[T; 3]) -> T {
    (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]
}

#[inline(always)]
fn dot4<T: Real>(a: &[T; 4], b: &[T; 4]) -> T {
    (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])
}
