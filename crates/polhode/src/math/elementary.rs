//! sin, cos and exp for SIMD lanes: polynomials without branches, error about 1 ulp, identical bits
//! in every lane.

use super::number::Splat;

/// Returns Σ cₖ xᵏ for an even number of terms, by Horner's rule in x², which has half the latency
/// of that in x.
#[inline(always)]
pub(crate) fn polynomial<T: Splat, const N: usize>(x: T, coefficients: [f64; N]) -> T {
    let pair = |k: usize| T::splat(coefficients[k]) + T::splat(coefficients[k + 1]) * x;
    let x2 = x * x;
    let mut sum = pair(N - 2);
    for k in (0..N / 2 - 1).rev() {
        sum = sum * x2 + pair(2 * k);
    }
    sum
}

/// Returns sin ½πx and cos ½πx for |x| ≤ ½.
///
/// The polynomials are those of fdlibm's `k_sin` and `k_cos` (Sun Microsystems, 1993), rescaled to
/// quarter turns; their error is below 2⁻⁵⁸.
#[inline(always)]
fn sin_cos_eighth<T: Splat>(x: T) -> (T, T) {
    let z = x * x;
    let sine = [
        -0.645964097506245,
        0.07969262624606334,
        -0.0046817541326259334,
        0.00016044115266738095,
        -3.598649570441808e-06,
        5.634704113884751e-08,
    ];
    let cosine = [
        0.25366950790104764,
        -0.02086348076333076,
        0.0009192602743905533,
        -2.520203791691774e-05,
        4.710641505803502e-07,
        -6.32474667886607e-09,
    ];
    let sin = T::splat(core::f64::consts::FRAC_PI_2) * x + z * x * polynomial(z, sine);
    let half = T::splat(1.233_700_550_136_169_8) * z;
    let one = T::splat(1.0);
    let w = one - half;
    let cos = w + (((one - w) - half) + z * z * polynomial(z, cosine));
    (sin, cos)
}

/// Returns the integer nearest to x, |x| < 2⁵¹: as the last bits of a number, and as a number.
#[inline(always)]
pub(crate) fn split<T: Splat>(x: T) -> (T, T) {
    let shifted = x + T::splat(SHIFT);
    (shifted, shifted - T::splat(SHIFT))
}

/// Constant 1.5 · 2⁵², whose last bit has the value 1.
const SHIFT: f64 = 6_755_399_441_055_744.0;

/// Returns sin and cos of an angle of `quarters` quarter turns (in the last two bits) plus
/// |`rest`| ≤ ½ quarter turn.
#[inline(always)]
pub(crate) fn sin_cos_quarters<T: Splat>(quarters: T, rest: T) -> (T, T) {
    let (s, c) = sin_cos_eighth(rest);
    let odd = |q: f64| q.to_bits() & 1 == 1;
    let signed = |x: f64, bits: u64| f64::from_bits(x.to_bits() ^ ((bits & 2) << 62));
    let sin = quarters.zip3(s, c, |q, s, c| signed(if odd(q) { c } else { s }, q.to_bits()));
    let cos = quarters.zip3(s, c, |q, s, c| signed(if odd(q) { s } else { c }, q.to_bits() + 1));
    (sin, cos)
}

/// Returns e^−x and e^x for 0 ≤ x; above 700 the values at 700.
#[inline(always)]
pub(crate) fn exp_both<T: Splat>(x: T) -> (T, T) {
    // x = k ln 2 + r, |r| ≤ ½ ln 2.
    let x = x.map(|x| if x < 700.0 { x } else { 700.0 });
    let (bits, k) = split(x * T::splat(core::f64::consts::LOG2_E));
    // ln 2 as a sum of two numbers, the first short enough for a k of 11 bits.
    let r = (x - k * T::splat(6.931_471_803_691_238e-1)) - k * T::splat(1.908_214_929_270_587_7e-10);
    let z = r * r;
    // cosh r − 1 and sinh r: Σ rⁿ/n! over even n and over odd n.
    let even = [1.0 / 2.0, 1.0 / 24.0, 1.0 / 720.0, 1.0 / 40_320.0, 1.0 / 3_628_800.0, 1.0 / 479_001_600.0];
    let odd =
        [1.0 / 6.0, 1.0 / 120.0, 1.0 / 5040.0, 1.0 / 362_880.0, 1.0 / 39_916_800.0, 1.0 / 6_227_020_800.0];
    let cosh = z * polynomial(z, even);
    let sinh = r + r * z * polynomial(z, odd);
    // 2^±k: the low bits of `bits` are k, and 1023 ± k is the biased exponent.
    let fall = bits.map(|bits| f64::from_bits(1023_u64.wrapping_sub(bits.to_bits()) << 52));
    let rise = bits.map(|bits| f64::from_bits(1023_u64.wrapping_add(bits.to_bits()) << 52));
    let one = T::splat(1.0);
    ((one + (cosh - sinh)) * fall, (one + (cosh + sinh)) * rise)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::lanes::Lanes;
    use crate::math::number::Number;
    use crate::math::number::PI;

    #[test]
    fn they_agree_with_libm_to_two_ulp() {
        for k in -4000..4000 {
            let x = f64::from(k) * 0.000_537_3;
            let (quarters, whole) = split(4.0 * x);
            let (s, c) = sin_cos_quarters(quarters, 4.0 * x - whole);
            let (s0, c0) = libm::sincos(2.0 * PI * x);
            // The argument 2πx of libm is rounded: the tolerance includes that error times x.
            let tolerance = 3e-16 + 4.5e-16 * 2.0 * PI * x.abs();
            assert!((s - s0).abs() < tolerance && (c - c0).abs() < tolerance, "{x}");
            let y = x.abs() * 300.0;
            let (fall, rise) = exp_both(y.min(699.0));
            assert!((fall / libm::exp(-y.min(699.0)) - 1.0).abs() < 2.0 * f64::EPSILON, "{y}");
            assert!((rise / libm::exp(y.min(699.0)) - 1.0).abs() < 2.0 * f64::EPSILON, "{y}");
        }
        for (x, s, c) in
            [(0.0, 0.0, 1.0), (0.25, 1.0, 0.0), (-0.5, 0.0, -1.0), (0.75, -1.0, 0.0), (1.5, 0.0, -1.0)]
        {
            let (quarters, whole) = split(4.0 * x);
            assert_eq!(sin_cos_quarters(quarters, 4.0 * x - whole), (s, c));
        }
        assert_eq!(exp_both(0.0), (1.0, 1.0));
        assert!(exp_both(f64::INFINITY).0 < 1e-300);
    }

    #[test]
    fn integers_are_exact() {
        for x in
            [0.5, 1.5, -2.5, 3.4999, -7.7, 2f64.powi(52) + 1.0, -2f64.powi(53), 1e300, 4503599627370495.5]
        {
            assert_eq!(x.nearest(), x.round_ties_even());
            assert_eq!(Lanes([x]).nearest().0, [x.round_ties_even()]);
        }
    }

    #[test]
    fn every_lane_has_the_bits_of_the_number() {
        let x = Lanes::<8>::from_fn(|k| (k as f64 - 3.3) * 0.177);
        let (quarters, whole) = split(x);
        let (s, c) = sin_cos_quarters(quarters, x - whole);
        let (fall, rise) = exp_both(x.map(f64::abs));
        for k in 0..8 {
            assert_eq!((s.0[k], c.0[k]), sin_cos_quarters(quarters.0[k], x.0[k] - whole.0[k]));
            assert_eq!((fall.0[k], rise.0[k]), exp_both(x.0[k].abs()));
        }
    }
}
