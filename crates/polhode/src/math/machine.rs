//! SIMD register types by instruction set, used where LLVM fails to vectorise `[f64; N]`.

use core::marker::PhantomData;

use super::lanes::Lanes;
use super::number::{Number, Splat};

/// Vector types of a processor.
pub(crate) trait Machine: Copy {
    /// Vector of four numbers.
    type Four: Number;
    /// Vector of eight numbers, in as few registers as possible.
    type Eight: Number;
    /// Vector of as many numbers as one register holds.
    type Many: Number;

    fn load(self, numbers: &[f64; 4]) -> Self::Four;
    fn splat(self, number: f64) -> Self::Four;
    fn numbers(self, four: Self::Four) -> [f64; 4];
    fn eight(self, number: f64) -> Self::Eight;
    fn load_eight(self, numbers: &[f64; 8]) -> Self::Eight;
    fn eight_numbers(self, eight: Self::Eight) -> [f64; 8];
    fn many(self, number: f64) -> Self::Many;

    /// Runs work as a separate function, compiled for this processor.
    fn apart<R>(self, work: impl FnOnce() -> R) -> R;
}

/// Work that uses vector instructions.
pub(crate) trait Work {
    type Output;

    fn run<S: Machine>(self, s: S) -> Self::Output;

    /// Runs the work on processors whose registers hold one or two numbers.
    #[cfg_attr(
        not(feature = "simd"),
        allow(dead_code, reason = "without the feature these registers are unavailable")
    )]
    #[inline(always)]
    fn run_narrow<S: Machine>(self, s: S) -> Self::Output
    where
        Self: Sized,
    {
        self.run(s)
    }
}

#[cfg(feature = "simd")]
impl<S: fearless_simd::Simd<f64s: Number>> Machine for S {
    type Four = fearless_simd::f64x4<S>;
    type Eight = fearless_simd::f64x8<S>;
    type Many = S::f64s;

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

    #[inline(always)]
    fn eight(self, number: f64) -> Self::Eight {
        self.splat_f64x8(number)
    }

    #[inline(always)]
    fn load_eight(self, numbers: &[f64; 8]) -> Self::Eight {
        fearless_simd::SimdFrom::simd_from(self, *numbers)
    }

    #[inline(always)]
    fn eight_numbers(self, eight: Self::Eight) -> [f64; 8] {
        eight.into()
    }

    #[inline(always)]
    fn many(self, number: f64) -> Self::Many {
        fearless_simd::SimdBase::splat(self, number)
    }

    #[inline(always)]
    fn apart<R>(self, work: impl FnOnce() -> R) -> R {
        self.vectorize(work)
    }
}

/// Implementation without vector registers, with as many lanes as M.
#[derive(Clone, Copy)]
pub(crate) struct Plain<M>(PhantomData<M>);

/// The code for four lanes is long, so debug builds use one.
#[cfg(debug_assertions)]
type Several = f64;
#[cfg(not(debug_assertions))]
type Several = Lanes<4>;

impl<M> Plain<M> {
    pub(crate) const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<M: Splat> Machine for Plain<M> {
    type Four = Lanes<4>;
    type Eight = Lanes<8>;
    type Many = M;

    fn load(self, numbers: &[f64; 4]) -> Lanes<4> {
        Lanes(*numbers)
    }

    fn splat(self, number: f64) -> Lanes<4> {
        Lanes([number; 4])
    }

    fn numbers(self, four: Lanes<4>) -> [f64; 4] {
        four.0
    }

    fn eight(self, number: f64) -> Lanes<8> {
        Lanes([number; 8])
    }

    fn load_eight(self, numbers: &[f64; 8]) -> Lanes<8> {
        Lanes(*numbers)
    }

    fn eight_numbers(self, eight: Lanes<8>) -> [f64; 8] {
        eight.0
    }

    fn many(self, number: f64) -> M {
        M::splat(number)
    }

    #[inline(never)]
    fn apart<R>(self, work: impl FnOnce() -> R) -> R {
        work()
    }
}

/// Runs work with the vectors of this processor: eight numbers (AVX-512), four (AVX2) or two (SSE2,
/// NEON, WebAssembly SIMD).
#[inline(always)]
pub(crate) fn in_vectors<W: Work>(work: W) -> W::Output {
    #[cfg(feature = "simd")]
    {
        use fearless_simd::{Level, Simd};
        let level = Level::new();
        #[inline(always)]
        fn wide<S: Simd<f64s: Number>, W: Work>(s: S, work: W) -> W::Output {
            s.vectorize(
                #[inline(always)]
                || work.run(s),
            )
        }
        #[inline(always)]
        fn narrow<S: Simd<f64s: Number>, W: Work>(s: S, work: W) -> W::Output {
            s.vectorize(
                #[inline(always)]
                || work.run_narrow(s),
            )
        }
        #[cfg(any(target_arch = "x86_64", target_arch = "x86"))]
        {
            #[cfg(not(no_avx512))]
            if let Some(avx512) = level.as_avx512() {
                return wide(avx512, work);
            }
            // Unit tests of AVX2 request it explicitly; for the others this code would be compiled
            // once more.
            #[cfg(not(any(no_avx2, test)))]
            if let Some(avx2) = level.as_avx2() {
                return wide(avx2, work);
            }
            // Nearly every current processor has wider registers. Debug builds do not use SSE2,
            // because the code for two lanes is the longest.
            if !cfg!(debug_assertions)
                && let Some(sse2) = level.as_sse2()
            {
                return narrow(sse2, work);
            }
        }
        #[cfg(target_arch = "aarch64")]
        if let Some(neon) = level.as_neon() {
            return narrow(neon, work);
        }
        #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
        if let Some(simd128) = level.as_wasm_simd128() {
            return narrow(simd128, work);
        }
    }
    work.run(Plain::<Several>::new())
}

/// Runs a loop over plain arrays, compiled for the widest vectors of this processor.
#[inline(always)]
pub(crate) fn in_widest_vectors(work: impl FnOnce()) {
    struct Loop<F>(F);
    impl<F: FnOnce()> Work for Loop<F> {
        type Output = ();

        #[inline(always)]
        fn run<S: Machine>(self, _: S) {
            self.0();
        }
    }
    in_vectors(Loop(work));
}

/// Runs work with AVX2 on a processor that has it, even if it has wider vectors, to test the
/// narrower code.
#[cfg(test)]
pub(crate) fn in_narrower_vectors<W: Work>(work: W) -> Option<W::Output> {
    #[cfg(all(feature = "simd", any(target_arch = "x86_64", target_arch = "x86")))]
    if let Some(avx2) = fearless_simd::Level::new().as_avx2() {
        return Some(fearless_simd::Simd::vectorize(
            avx2,
            #[inline(always)]
            || work.run(avx2),
        ));
    }
    drop(work);
    None
}
