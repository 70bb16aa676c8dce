//! Numbers for numerical kernels: one f64, or several SIMD lanes.

use core::ops::{Add, Div, Mul, Neg, Sub};

pub(crate) use core::f64::consts::PI;

/// One f64, [`Lanes`](super::lanes::Lanes) of them, or a SIMD vector type with one number for each
/// of several bodies.
///
/// Invariant: every lane has the same bits as the f64 computation. a·b + c is rounded once where it
/// is written as [`Number::mul_add`] and the processor has the instruction ([`FUSED`]), and twice
/// everywhere else.
///
/// SIMD vector types carry their instruction set, so a value can only be created from another one:
/// [`Number::like`].
pub(crate) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Number of lanes.
    const LANES: usize;

    /// Returns x in every lane.
    fn like(self, x: f64) -> Self;

    /// Returns the number in a lane.
    fn lane(&self, lane: usize) -> f64;

    /// Sets the number in a lane.
    fn put(&mut self, lane: usize, x: f64);

    /// Applies f to every lane.
    fn map(self, f: impl Fn(f64) -> f64) -> Self;

    /// Applies f to every lane of two operands.
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self;

    /// Applies f to every lane of three operands.
    fn zip3(self, b: Self, c: Self, f: impl Fn(f64, f64, f64) -> f64) -> Self;

    /// Returns self · b + c; see [`FUSED`] for the rounding.
    fn mul_add(self, b: Self, c: Self) -> Self;

    /// Returns √self.
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }
}

/// Numbers that can be created from a constant; used by the kernels of closed forms and meshes.
pub(crate) trait Splat: Number {
    /// Returns the same number in every lane.
    fn splat(x: f64) -> Self;

    /// Returns the integer nearest to each number, ties to even; numbers too large to have a
    /// fraction are unchanged.
    fn nearest(self) -> Self;

    /// Returns true if |x| ≤ limit in every lane; false for NaN.
    fn within(self, limit: Self) -> bool;
}

/// True if a·b + c of f64 numbers is rounded once.
///
/// IEEE 754 defines that result exactly, so it is the same on all processors with the instruction.
/// These are 64-bit ARM, and all Intel and AMD processors since 2013 (with the feature `simd`,
/// which detects it at run time). Without the instruction, the platform's library would compute it
/// 140 times as slowly. Therefore a·b + c is then rounded twice. Results are the same on all of
/// these processors and in all code paths, and differ from the others by rounding.
pub(crate) const FUSED: bool = cfg!(any(
    target_arch = "aarch64",
    target_feature = "fma",
    all(feature = "simd", not(all(no_avx512, no_avx2)), any(target_arch = "x86", target_arch = "x86_64")),
));

/// Returns a·b + c, fused if [`FUSED`] is true.
#[inline(always)]
fn mul_add(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

impl Number for f64 {
    const LANES: usize = 1;

    #[inline(always)]
    fn like(self, x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }

    #[inline(always)]
    fn put(&mut self, _: usize, x: f64) {
        *self = x;
    }

    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        f(self)
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        f(self, other)
    }

    #[inline(always)]
    fn zip3(self, b: Self, c: Self, f: impl Fn(f64, f64, f64) -> f64) -> Self {
        f(self, b, c)
    }

    #[inline(always)]
    fn mul_add(self, b: f64, c: f64) -> f64 {
        mul_add(self, b, c)
    }
}

impl Splat for f64 {
    #[inline(always)]
    fn splat(x: f64) -> Self {
        x
    }

    /// Adds and subtracts 2⁵², above which numbers have no fraction. Without AVX or similar, the
    /// rounding instruction would be a function call.
    #[inline(always)]
    fn nearest(self) -> Self {
        let big = 4_503_599_627_370_496.0_f64.copysign(self);
        if self.abs() < 4_503_599_627_370_496.0 { (self + big) - big } else { self }
    }

    #[inline(always)]
    fn within(self, limit: f64) -> bool {
        self.abs() <= limit
    }
}

/// Returns sin x and cos x, x in rad, by `libm`, so that no result depends on the platform's
/// library.
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// Implementations for SIMD vector types: number of lanes, and names of the operations without an
/// operator.
#[cfg(feature = "simd")]
macro_rules! vectors {
    ($($vector:ident: $lanes:literal, $splat:ident, $mul_add:ident, $sqrt:ident;)*) => {$(
        impl<S: fearless_simd::Simd> Number for fearless_simd::$vector<S> {
            const LANES: usize = $lanes;

            #[inline(always)]
            fn like(self, x: f64) -> Self {
                self.simd.$splat(x)
            }

            #[inline(always)]
            fn lane(&self, lane: usize) -> f64 {
                self[lane]
            }

            #[inline(always)]
            fn put(&mut self, lane: usize, x: f64) {
                self[lane] = x;
            }

            #[inline(always)]
            fn map(mut self, f: impl Fn(f64) -> f64) -> Self {
                for x in self.iter_mut() {
                    *x = f(*x);
                }
                self
            }

            #[inline(always)]
            fn zip(mut self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
                for lane in 0..$lanes {
                    self[lane] = f(self[lane], other[lane]);
                }
                self
            }

            #[inline(always)]
            fn zip3(mut self, b: Self, c: Self, f: impl Fn(f64, f64, f64) -> f64) -> Self {
                for lane in 0..$lanes {
                    self[lane] = f(self[lane], b[lane], c[lane]);
                }
                self
            }

            /// Rounds twice if the processor has no fused instruction.
            #[inline(always)]
            fn mul_add(self, b: Self, c: Self) -> Self {
                // The fused operation of WebAssembly may be of either kind.
                if cfg!(target_arch = "wasm32") { self * b + c } else { self.simd.$mul_add(self, b, c) }
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                self.simd.$sqrt(self)
            }
        }
    )*};
}

#[cfg(feature = "simd")]
vectors! {
    f64x2: 2, splat_f64x2, mul_add_f64x2, sqrt_f64x2;
    f64x4: 4, splat_f64x4, mul_add_f64x4, sqrt_f64x4;
    f64x8: 8, splat_f64x8, mul_add_f64x8, sqrt_f64x8;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::machine::{Machine, Work, in_narrower_vectors, in_vectors};

    /// Computes a·b + c, √a and a/b for eight numbers.
    struct All([[f64; 8]; 3]);

    impl Work for All {
        type Output = [[f64; 8]; 3];

        #[inline(always)]
        fn run<S: Machine>(self, s: S) -> Self::Output {
            let [a, b, c] = self.0.map(|x| each(s.eight(0.0), |lane| x[lane]));
            let eight = all(a, b, c).map(|x| core::array::from_fn(|lane| x.lane(lane)));
            for first in (0..8).step_by(S::Many::LANES) {
                let [a, b, c] = self.0.map(|x| each(s.many(0.0), |lane| x[first + lane]));
                for (many, eight) in all(a, b, c).iter().zip(&eight) {
                    for lane in 0..S::Many::LANES {
                        assert_eq!(many.lane(lane).to_bits(), eight[first + lane].to_bits());
                    }
                }
            }
            eight
        }
    }

    /// Sets each lane from a function of its index.
    fn each<N: Number>(mut all: N, number: impl Fn(usize) -> f64) -> N {
        (0..N::LANES).for_each(|lane| all.put(lane, number(lane)));
        all
    }

    #[inline(always)]
    fn all<N: Number>(a: N, b: N, c: N) -> [N; 3] {
        [a.mul_add(b, c), a.sqrt(), a / b]
    }

    #[test]
    fn every_lane_has_the_bits_of_one_number() {
        let a = [1.1, 2e-5, 3e100, 0.7, 5.3, 1e-310, 9.9, 0.0];
        let b = [-0.3, 7e4, 1e-99, 1.9, -2.7, 3.0, 1e300, 0.4];
        // The remainder of a·b is its rounding error, which shows whether the operation is fused.
        let c: [f64; 8] = core::array::from_fn(|k| -(a[k] * b[k]));
        for wide in
            [Some(in_vectors(All([a, b, c]))), in_narrower_vectors(All([a, b, c]))].into_iter().flatten()
        {
            for k in 0..8 {
                let one = all(a[k], b[k], c[k]);
                assert_eq!([0, 1, 2].map(|n| wide[n][k].to_bits()), one.map(f64::to_bits), "{k}");
            }
            assert_eq!(wide[0][0] != 0.0, FUSED);
        }
    }
}
