//! Several numbers side by side, in one vector register where the machine has it.

use core::ops::{Add, Mul, Neg, Sub};

use super::real::Real;

/// N numbers: plain loops over an array, which the compiler turns into vector instructions.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(crate) struct Lanes<const N: usize>(pub(crate) [f64; N]);

impl<const N: usize> Lanes<N> {
    /// The number of each lane.
    pub(crate) fn from_fn(f: impl FnMut(usize) -> f64) -> Self {
        Self(core::array::from_fn(f))
    }
}

impl<const N: usize> Real for Lanes<N> {
    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self([x; N])
    }

    #[inline(always)]
    fn map(mut self, f: impl Fn(f64) -> f64) -> Self {
        for a in &mut self.0 {
            *a = f(*a);
        }
        self
    }

    #[inline(always)]
    fn zip(mut self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        for k in 0..N {
            self.0[k] = f(self.0[k], other.0[k]);
        }
        self
    }

    #[inline(always)]
    fn zip3(mut self, b: Self, c: Self, f: impl Fn(f64, f64, f64) -> f64) -> Self {
        for k in 0..N {
            self.0[k] = f(self.0[k], b.0[k], c.0[k]);
        }
        self
    }

    #[inline(always)]
    fn nearest(self) -> Self {
        self.map(f64::round_ties_even)
    }

    #[inline(always)]
    fn within(self, limit: Self) -> bool {
        self.0.iter().zip(limit.0).fold(true, |all, (x, limit)| all & (x.abs() <= limit))
    }
}

impl<const N: usize> Add for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        self.zip(b, |x, y| x + y)
    }
}

impl<const N: usize> Sub for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        self.zip(b, |x, y| x - y)
    }
}

impl<const N: usize> Mul for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        self.zip(b, |x, y| x * y)
    }
}

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

/// Vectors of four numbers by type: where the compiler's own choice would take them apart.
pub(crate) trait Fours: Copy {
    /// Four numbers in a register.
    type Four: Copy + Add<Output = Self::Four> + Sub<Output = Self::Four> + Mul<Output = Self::Four>;

    fn load(self, numbers: &[f64; 4]) -> Self::Four;
    fn splat(self, number: f64) -> Self::Four;
    fn numbers(self, four: Self::Four) -> [f64; 4];
}

/// Work that wants vectors.
pub(crate) trait Work {
    type Output;

    fn run<S: Fours>(self, s: S) -> Self::Output;
}

#[cfg(feature = "simd")]
impl<S: fearless_simd::Simd> Fours for S {
    type Four = fearless_simd::f64x4<S>;

    #[inline(always)]
    fn load(self, numbers: &[f64; 4]) -> Self::Four {
        fearless_simd::SimdFrom::simd_from(self, *numbers)
    }

    #[inline(always)]
    fn splat(self, number: f64) -> Self::Four {
        self.splat_f64x4(number)
    }

    #[inline(always)]
    fn numbers(self, four: Self::Four) -> [f64; 4] {
        four.into()
    }
}

/// Without vectors.
#[derive(Clone, Copy)]
pub(crate) struct Plain;

impl Fours for Plain {
    type Four = Lanes<4>;

    fn load(self, numbers: &[f64; 4]) -> Lanes<4> {
        Lanes(*numbers)
    }

    fn splat(self, number: f64) -> Lanes<4> {
        Lanes([number; 4])
    }

    fn numbers(self, four: Lanes<4>) -> [f64; 4] {
        four.0
    }
}

/// Runs work with vectors of four, as this machine has them.
#[inline(always)]
pub(crate) fn in_fours<W: Work>(work: W) -> W::Output {
    #[cfg(all(feature = "simd", any(target_arch = "x86_64", target_arch = "x86")))]
    {
        use fearless_simd::{Level, Simd as _};
        let level = Level::new();
        #[cfg(not(no_avx512))]
        if let Some(avx512) = level.as_avx512() {
            return avx512.vectorize(
                #[inline(always)]
                || work.run(avx512),
            );
        }
        if let Some(avx2) = level.as_avx2() {
            return avx2.vectorize(
                #[inline(always)]
                || work.run(avx2),
            );
        }
    }
    work.run(Plain)
}

/// Runs a loop compiled for the widest vectors of this machine: AVX-512 or AVX2, otherwise what every machine of its kind has.
#[cfg(all(feature = "simd", any(target_arch = "x86_64", target_arch = "x86")))]
#[inline(always)]
pub(crate) fn in_widest_vectors(work: impl FnOnce()) {
    use fearless_simd::{Level, Simd as _};
    let level = Level::new();
    #[cfg(not(no_avx512))]
    if let Some(avx512) = level.as_avx512() {
        return avx512.vectorize(work);
    }
    if let Some(avx2) = level.as_avx2() {
        avx2.vectorize(work);
    } else {
        work();
    }
}

#[cfg(not(all(feature = "simd", any(target_arch = "x86_64", target_arch = "x86"))))]
#[inline(always)]
pub(crate) fn in_widest_vectors(work: impl FnOnce()) {
    work();
}
