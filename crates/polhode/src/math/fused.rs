//! Numbers whose multiplications are fused with additions, one or many side by side.
//!
//! The law of these kernels: a·b + c is rounded once where it is written so ([`Fused::mul_add`]), and nowhere else. IEEE 754 says what
//! that is, to the last bit; so one number, four and eight have the same bits, on every machine. One without the
//! instruction computes it by the platform's library, some thirty times as slowly.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// One f64, or a vector of them.
pub(crate) trait Fused:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// How many numbers.
    const LANES: usize;
    /// What shows that the machine has such vectors.
    type Machine: Copy;

    /// The number of each lane.
    fn from_fn(machine: Self::Machine, f: impl FnMut(usize) -> f64) -> Self;

    /// The number of a lane.
    fn lane(&self, lane: usize) -> f64;

    /// self · b + c, rounded once.
    fn mul_add(self, b: Self, c: Self) -> Self;

    /// √self
    fn sqrt(self) -> Self;

    /// The same number in every lane.
    #[inline(always)]
    fn splat(machine: Self::Machine, number: f64) -> Self {
        Self::from_fn(
            machine,
            #[inline(always)]
            |_| number,
        )
    }
}

impl Fused for f64 {
    const LANES: usize = 1;
    type Machine = ();

    #[inline(always)]
    fn from_fn((): (), mut f: impl FnMut(usize) -> f64) -> f64 {
        f(0)
    }

    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }

    #[inline(always)]
    fn mul_add(self, b: f64, c: f64) -> f64 {
        f64::mul_add(self, b, c)
    }

    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
}

/// Work that wants vectors.
pub(crate) trait Task {
    type Output;

    /// To be `#[inline(always)]`, with all that it calls: it is compiled once for each kind of vector.
    fn run<T: Fused>(self, machine: T::Machine) -> Self::Output;
}

/// Runs work with vectors of eight where this machine multiplies and adds in one instruction, otherwise number by number.
#[inline(always)]
pub(crate) fn in_widest<W: Task>(task: W) -> W::Output {
    #[cfg(all(feature = "simd", any(target_arch = "x86_64", target_arch = "x86")))]
    {
        use fearless_simd::{Level, Simd as _};
        let level = Level::new();
        #[cfg(not(no_avx512))]
        if let Some(avx512) = level.as_avx512() {
            return avx512.vectorize(
                #[inline(always)]
                || task.run::<vectors::Eight<_>>(avx512),
            );
        }
        if let Some(avx2) = level.as_avx2() {
            return avx2.vectorize(
                #[inline(always)]
                || task.run::<vectors::Eight<_>>(avx2),
            );
        }
    }
    task.run::<f64>(())
}

#[cfg(all(feature = "simd", any(target_arch = "x86_64", target_arch = "x86")))]
mod vectors {
    use core::ops::{Add, Div, Mul, Neg, Sub};

    use super::Fused;
    use fearless_simd::{Simd, SimdBase, SimdFloat, f64x8};

    /// Eight numbers: a vector of AVX-512, two of AVX2.
    #[derive(Clone, Copy)]
    pub(super) struct Eight<S: Simd>(f64x8<S>);

    impl<S: Simd> Fused for Eight<S> {
        const LANES: usize = 8;
        type Machine = S;

        #[inline(always)]
        fn from_fn(machine: S, f: impl FnMut(usize) -> f64) -> Self {
            Self(f64x8::from_fn(machine, f))
        }

        #[inline(always)]
        fn lane(&self, lane: usize) -> f64 {
            self.0.as_slice().get(lane).copied().unwrap_or(f64::NAN)
        }

        #[inline(always)]
        fn mul_add(self, b: Self, c: Self) -> Self {
            Self(self.0.mul_add_precise(b.0, c.0))
        }

        #[inline(always)]
        fn sqrt(self) -> Self {
            Self(self.0.sqrt())
        }

        #[inline(always)]
        fn splat(machine: S, number: f64) -> Self {
            Self(f64x8::splat(machine, number))
        }
    }

    impl<S: Simd> Add for Eight<S> {
        type Output = Self;
        #[inline(always)]
        fn add(self, b: Self) -> Self {
            Self(self.0 + b.0)
        }
    }

    impl<S: Simd> Sub for Eight<S> {
        type Output = Self;
        #[inline(always)]
        fn sub(self, b: Self) -> Self {
            Self(self.0 - b.0)
        }
    }

    impl<S: Simd> Mul for Eight<S> {
        type Output = Self;
        #[inline(always)]
        fn mul(self, b: Self) -> Self {
            Self(self.0 * b.0)
        }
    }

    impl<S: Simd> Div for Eight<S> {
        type Output = Self;
        #[inline(always)]
        fn div(self, b: Self) -> Self {
            Self(self.0 / b.0)
        }
    }

    impl<S: Simd> Neg for Eight<S> {
        type Output = Self;
        #[inline(always)]
        fn neg(self) -> Self {
            Self(-self.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// a·b + c, √a, a/b and −a of eight numbers.
    struct All([f64; 8], [f64; 8], [f64; 8]);

    impl Task for All {
        type Output = Vec<[f64; 4]>;

        #[inline(always)]
        fn run<T: Fused>(self, machine: T::Machine) -> Self::Output {
            let Self(a, b, c) = self;
            (0..8)
                .step_by(T::LANES)
                .flat_map(|first| {
                    let [a, b, c] = [a, b, c].map(|x| T::from_fn(machine, |lane| x[first + lane]));
                    let all = [a.mul_add(b, c), a.sqrt(), a / b, -a];
                    (0..T::LANES).map(move |lane| all.map(|x| x.lane(lane)))
                })
                .collect()
        }
    }

    #[test]
    fn every_lane_has_the_bits_of_one_number() {
        let a = [1.1, 2e-5, 3e100, 0.7, 5.3, 1e-310, 9.9, 0.0];
        let b = [-0.3, 7e4, 1e-99, 1.9, -2.7, 3.0, 1e300, 0.4];
        // such that most of a·b is cancelled: fused or not is seen
        let c: [f64; 8] = core::array::from_fn(|k| -(a[k] * b[k]));
        let wide = in_widest(All(a, b, c));
        let one = All(a, b, c).run::<f64>(());
        let bits = |all: &[[f64; 4]]| all.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&wide), bits(&one));
        // 0.33 is not −0.3 · 1.1 to the last bit
        assert_ne!(one[0][0], 0.0);
    }
}
