//! One kernel for every free motion: two phases, a few terms of a theta series, a quaternion.

use crate::math::complex::Complex;
use crate::math::elementary::{nearest, sin_cos_turns};
use crate::math::real::Real;
use crate::math::sum::two_sum;

use super::hyperbolic::Hyperbolic;
use super::phase::{Elapsed, Phase};
use super::trigonometric::Trigonometric;

/// Cayley–Klein parameters: the quaternion w + iz = α, x + iy = β, of any norm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spinor<T> {
    pub(super) alpha: Complex<T>,
    pub(super) beta: Complex<T>,
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
    pub(super) precession: Phase<T>,
    /// z/2π, turns.
    pub(super) polhode: Phase<T>,
    /// Columns: the axes times the amplitudes of ω along them.
    pub(super) omega: [[T; 3]; 3],
    /// From (Re α, Re β, Im β, Im α) to the attitude's quaternion.
    pub(super) attitude: [[T; 4]; 4],
    pub(super) series: S,
}

/// Theta functions of one kind.
pub(super) trait Series<T> {
    /// (f, g) and (cn, sn, dn) at z/2π turns, |z| ≤ ½π.
    fn at(&self, x: T) -> (Spinor<T>, [T; 3]);

    /// 2b/π.
    fn bend(&self) -> Option<T>;
}

impl<T: Real> Series<T> for Trigonometric<T> {
    #[inline(always)]
    fn at(&self, x: T) -> (Spinor<T>, [T; 3]) {
        Self::at(self, x)
    }

    #[inline(always)]
    fn bend(&self) -> Option<T> {
        None
    }
}

impl<T: Real> Series<T> for Hyperbolic<T> {
    #[inline(always)]
    fn at(&self, x: T) -> (Spinor<T>, [T; 3]) {
        Self::at(self, x)
    }

    #[inline(always)]
    fn bend(&self) -> Option<T> {
        Some(self.bend)
    }
}

impl<T: Real, S: Series<T>> Flow<T, S> {
    /// The attitude's quaternion (w, x, y, z) and ω in the body, in the flow's units.
    #[inline(always)]
    pub(super) fn at(&self, elapsed: Elapsed<T>) -> ([T; 4], [T; 3]) {
        let (high, low) = self.polhode.at(elapsed);
        let half_turns = nearest(T::splat(2.0) * high);
        let x = (high - T::splat(0.5) * half_turns) + low;
        // (−1)ᴺ
        let sign = half_turns.map(|n| {
            let half = 0.5 * n;
            if (half - nearest(half)).abs() == 0.5 { -1.0 } else { 1.0 }
        });
        let (Spinor { alpha, beta }, [cn, sn, dn]) = self.series.at(x);

        let (high, low) = self.precession.at(elapsed);
        let high = high - T::splat(0.25) * half_turns;
        let (high, low) = match self.series.bend() {
            None => (high, low),
            Some(bend) => {
                let (sum, error) = two_sum(high, -(bend * x));
                (sum, error + low)
            }
        };
        let (s, c) = sin_cos_turns(high, low);
        let unit = (alpha.norm2() + beta.norm2()).map(|n| 1.0 / n.sqrt());
        let phase = Complex { re: c * unit, im: s * unit };
        let alpha = alpha.times(phase);
        // −i (−1)ᴺ
        let beta = beta.times(Complex { re: sign * phase.im, im: -(sign * phase.re) });

        let labelled = [alpha.re, beta.re, beta.im, alpha.im];
        let rates = [sign * cn, sign * sn, dn];
        // 1/√n = (3 − n)/2 for n near 1: the norm's last digits
        let q = self.attitude.map(|row| dot(row, labelled));
        let correction = T::splat(1.5) - T::splat(0.5) * dot(q, q);
        (q.map(|c| c * correction), self.omega.map(|row| dot(row, rates)))
    }
}

#[inline(always)]
fn dot<T: Real, const N: usize>(a: [T; N], b: [T; N]) -> T {
    let mut sum = a[0] * b[0];
    for k in 1..N {
        sum = sum + a[k] * b[k];
    }
    sum
}
