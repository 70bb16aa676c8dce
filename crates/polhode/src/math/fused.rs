//! Numbers whose multiplications are fused with additions.

use super::lanes::Lanes;
use super::number::Number;

/// Numbers that multiply and add with one rounding.
///
/// The law of the kernels that ask for it: a·b + c is rounded once where it is written [`Fused::mul_add`], and nowhere else. IEEE 754
/// says what that is to the last bit, so one number and eight side by side have the same bits on every machine. One without the
/// instruction computes it by the platform's library, more than ten times as slowly.
pub(crate) trait Fused: Number {
    /// self · b + c, rounded once.
    fn mul_add(self, b: Self, c: Self) -> Self;

    /// √self
    fn sqrt(self) -> Self;

    /// The number of each lane.
    #[inline(always)]
    fn each(self, number: impl Fn(usize) -> f64) -> Self {
        let mut all = self;
        for lane in 0..Self::LANES {
            all.put(lane, number(lane));
        }
        all
    }
}

impl Fused for f64 {
    #[inline(always)]
    fn mul_add(self, b: f64, c: f64) -> f64 {
        f64::mul_add(self, b, c)
    }

    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
}

impl<const N: usize> Fused for Lanes<N> {
    #[inline(always)]
    fn mul_add(mut self, b: Self, c: Self) -> Self {
        for k in 0..N {
            self.0[k] = self.0[k].mul_add(b.0[k], c.0[k]);
        }
        self
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Number::map(self, f64::sqrt)
    }
}

#[cfg(feature = "simd")]
impl<S: fearless_simd::Simd> Fused for fearless_simd::f64x8<S> {
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        // not `mul_add`, which rounds twice where there is no instruction for it
        self.simd.mul_add_precise_f64x8(self, b, c)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.simd.sqrt_f64x8(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::machine::{Machine, Work, in_vectors};

    /// a·b + c, √a and a/b of eight numbers.
    struct All([[f64; 8]; 3]);

    impl Work for All {
        type Output = [[f64; 8]; 3];

        #[inline(always)]
        fn run<S: Machine>(self, s: S) -> Self::Output {
            let [a, b, c] = self.0.map(|x| s.eight(0.0).each(|lane| x[lane]));
            [a.mul_add(b, c), a.sqrt(), a / b].map(|x| core::array::from_fn(|lane| x.lane(lane)))
        }
    }

    #[test]
    fn every_lane_has_the_bits_of_one_number() {
        let a = [1.1, 2e-5, 3e100, 0.7, 5.3, 1e-310, 9.9, 0.0];
        let b = [-0.3, 7e4, 1e-99, 1.9, -2.7, 3.0, 1e300, 0.4];
        // What is left of a·b is its rounding: fused or not is seen.
        let c: [f64; 8] = core::array::from_fn(|k| -(a[k] * b[k]));
        let wide = in_vectors(All([a, b, c]));
        for k in 0..8 {
            let one = [Fused::mul_add(a[k], b[k], c[k]), Fused::sqrt(a[k]), a[k] / b[k]];
            assert_eq!([0, 1, 2].map(|n| wide[n][k].to_bits()), one.map(f64::to_bits), "{k}");
        }
        assert_ne!(wide[0][0], 0.0);
    }
}
