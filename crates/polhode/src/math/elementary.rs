//! sin, cos and exp for lanes: polynomials without branches, about 1 ulp, the same bits in every lane.

use super::real::{PI, Real};

/// Σ cₖ xᵏ of an even number of terms: Horner's rule in x², which waits half as often as that in x.
#[inline(always)]
pub(crate) fn polynomial<T: Real, const N: usize>(x: T, coefficients: [f64; N]) -> T {
    let pair = |k: usize| T::splat(coefficients[k]) + T::splat(coefficients[k + 1]) * x;
    let x2 = x * x;
    let mut sum = pair(N - 2);
    for k in (0..N / 2 - 1).rev() {
        sum = sum * x2 + pair(2 * k);
    }
    sum
}

/// sin x and cos x for |x| ≤ π/4 rad.
///
/// The polynomials of fdlibm's `k_sin` and `k_cos` (Sun Microsystems, 1993), error below 2⁻⁵⁸.
#[inline(always)]
pub(crate) fn sin_cos_eighth<T: Real>(x: T) -> (T, T) {
    let z = x * x;
    let sine = [
        -1.666_666_666_666_663_2e-1,
        8.333_333_333_322_49e-3,
        -1.984_126_982_985_795e-4,
        2.755_731_370_707_006_8e-6,
        -2.505_076_025_340_686_3e-8,
        1.589_690_995_211_55e-10,
    ];
    let cosine = [
        4.166_666_666_666_66e-2,
        -1.388_888_888_887_411e-3,
        2.480_158_728_947_673e-5,
        -2.755_731_435_139_066_3e-7,
        2.087_572_321_298_175e-9,
        -1.135_964_755_778_819_5e-11,
    ];
    let sin = x + z * x * polynomial(z, sine);
    let half = T::splat(0.5) * z;
    let one = T::splat(1.0);
    let w = one - half;
    let cos = w + (((one - w) - half) + z * z * polynomial(z, cosine));
    (sin, cos)
}

/// sin 2πx and cos 2πx of x = high + low turns, |high| small enough to have a fraction.
#[inline(always)]
pub(crate) fn sin_cos_turns<T: Real>(high: T, low: T) -> (T, T) {
    let quarters = (T::splat(4.0) * high).nearest();
    let rest = (high - T::splat(0.25) * quarters) + low;
    let (s, c) = sin_cos_eighth(T::splat(2.0 * PI) * rest);
    // k quarters, modulo 4, as −2 … 2
    let k = quarters - T::splat(4.0) * (T::splat(0.25) * quarters).nearest();
    let sin = k.zip3(s, c, |k, s, c| {
        let part = if k.abs() == 1.0 { c } else { s };
        if k < 0.0 || k == 2.0 { -part } else { part }
    });
    let cos = k.zip3(s, c, |k, s, c| {
        let part = if k.abs() == 1.0 { s } else { c };
        if k > 0.0 || k == -2.0 { -part } else { part }
    });
    (sin, cos)
}

/// e^−x for x ≥ 0; beyond 700 as at 700, which is nothing.
#[inline(always)]
pub(crate) fn exp_minus<T: Real>(x: T) -> T {
    // x = k ln 2 − r, |r| ≤ ½ ln 2;  e^−x = 2^−k e^r
    let x = x.map(|x| if x < 700.0 { x } else { 700.0 });
    let k = (x * T::splat(core::f64::consts::LOG2_E)).nearest();
    // ln 2 in two words, the first short enough for k of 11 bits
    let r = (k * T::splat(6.931_471_803_691_238e-1) - x) + k * T::splat(1.908_214_929_270_587_7e-10);
    // Σ rⁿ/n!
    let series = [
        0.5,
        1.0 / 6.0,
        1.0 / 24.0,
        1.0 / 120.0,
        1.0 / 720.0,
        1.0 / 5040.0,
        1.0 / 40_320.0,
        1.0 / 362_880.0,
        1.0 / 3_628_800.0,
        1.0 / 39_916_800.0,
        1.0 / 479_001_600.0,
        1.0 / 6_227_020_800.0,
    ];
    let e = T::splat(1.0) + (r + r * r * polynomial(r, series));
    // 2^−k: the low bits of 1.5·2⁵² + (1023 − k) are the exponent's
    let power = k.map(|k| f64::from_bits((6_755_399_441_055_744.0 + (1023.0 - k)).to_bits() << 52));
    e * power
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::lanes::Lanes;

    #[test]
    fn they_agree_with_libm_to_two_ulp() {
        for k in -4000..4000 {
            let x = f64::from(k) * 0.000_537_3;
            let (s, c) = sin_cos_turns(x, 0.0);
            let (s0, c0) = libm::sincos(2.0 * PI * x);
            // libm's own argument 2πx is rounded: that error, times x, is allowed for
            let tolerance = 3e-16 + 4.5e-16 * 2.0 * PI * x.abs();
            assert!((s - s0).abs() < tolerance && (c - c0).abs() < tolerance, "{x}");
            let y = x.abs() * 300.0;
            assert!((exp_minus(y) / libm::exp(-y) - 1.0).abs() < 2.0 * f64::EPSILON, "{y}");
        }
        for (x, s, c) in
            [(0.0, 0.0, 1.0), (0.25, 1.0, 0.0), (-0.5, 0.0, -1.0), (0.75, -1.0, 0.0), (1.5, 0.0, -1.0)]
        {
            assert_eq!(sin_cos_turns(x, 0.0), (s, c));
        }
        assert_eq!(exp_minus(0.0), 1.0);
        assert!(exp_minus(f64::INFINITY) < 1e-300);
    }

    #[test]
    fn integers_and_remainders_are_exact() {
        for x in
            [0.5, 1.5, -2.5, 3.4999, -7.7, 2f64.powi(52) + 1.0, -2f64.powi(53), 1e300, 4503599627370495.5]
        {
            assert_eq!(x.nearest(), x.round_ties_even());
            assert_eq!(Lanes([x]).nearest().0, [x.round_ties_even()]);
        }
        for (x, rest) in [(7.25, -0.75), (2f64.powi(52) + 1.0, 1.0), (2f64.powi(60), 0.0), (-0.3, -0.3)] {
            assert_eq!(x.modulo_two(), rest);
            assert_eq!(Lanes([x]).modulo_two().0, [rest]);
        }
    }

    #[test]
    fn every_lane_has_the_bits_of_the_number() {
        let x = Lanes::<8>::from_fn(|k| (k as f64 - 3.3) * 0.177);
        let (s, c) = sin_cos_turns(x, Lanes::splat(1e-18));
        let e = exp_minus(x.map(f64::abs));
        for k in 0..8 {
            assert_eq!((s.0[k], c.0[k]), sin_cos_turns(x.0[k], 1e-18));
            assert_eq!(e.0[k], exp_minus(x.0[k].abs()));
        }
    }
}
