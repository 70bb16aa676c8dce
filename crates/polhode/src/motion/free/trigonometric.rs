//! The motion as trigonometric series: for a nome that is not near 1.

use core::array::from_fn;

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elementary::sin_cos_quarters;
use crate::math::landen::Landen;
use crate::math::real::{PI, Real};

use super::elements::Elements;
use super::flow::{Family, Point, Series};
use super::phase::Phase;

/// Coefficients of the theta functions at z: constants of a motion.
///
/// With the nome q and Y = e^−w̄, √q ≤ Y ≤ 1 (Y → tan ½θ of a symmetric body's nutation θ), f = θ₄(z − iw | q²) is
///
/// f = 1 + Σ (−1)ⁿ q^(2n²−n) (Y²ⁿ e^2inz + (q/Y)²ⁿ e^−2inz),  n = 1, 2, 3
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Trigonometric<T> {
    /// Re f as a polynomial of 2 cos 2z.
    real: [T; 4],
    /// Im f / sin 2z as a polynomial of 2 cos 2z.
    imaginary: [T; 3],
    /// θ₂/cos z and θ₁/sin z without 2q^(1/4), as polynomials of ±2 cos 2z.
    odd: [T; 5],
    /// θ₃ and θ₄ as polynomials of ±2 cos 2z.
    even: [T; 5],
}

impl Trigonometric<f64> {
    /// The series, and where on them the motion starts: 2z/π, quarter turns.
    pub(super) fn of(elements: &Elements) -> (Self, [f64; 2]) {
        let landen = Landen::new(elements.m.value(), elements.m1().value());
        let q = landen.nome();
        let y = half_nutation(elements, &landen);
        let (real, imaginary) =
            attitude_polynomials(q, y * y, if y == 0.0 { 0.0 } else { (q / y) * (q / y) });
        let series = Self { real, imaginary, odd: odd_polynomial(q), even: even_polynomial(q) };
        let [c, s] = elements.start.map(Double::value);
        (series, [landen.angle(s, c) * (2.0 / PI), 0.0])
    }
}

/// Y = e^−w̄, w̄ = π F(arctan(A3/A1) | m₁) / 2K: from e^−χ = A1 / (L + A3) where L2 = 0.
///
/// Beyond half of the way to K′ by what is left of it, F(arctan(1/√−n) | m₁): Y = √q e^w, e^χ = (1 + √(1 − n)) / √−n.
fn half_nutation(elements: &Elements, landen: &Landen) -> f64 {
    let l = elements.momentum.value();
    let [a1, _, a3] = elements.amplitudes.map(Double::value);
    let sech2 = (a1 / l) * (a1 / l);
    if !(sech2 > 0.0) {
        return 0.0;
    }
    if a3 * elements.m.value().sqrt().sqrt() <= a1 {
        return a1 / (l + a3) * libm::exp(landen.hyperbolic_correction(a3 / l, sech2));
    }
    let minus_n = elements.minus_n.value();
    let root = (1.0 + minus_n).sqrt();
    let correction = landen.hyperbolic_correction(1.0 / root, minus_n / (1.0 + minus_n));
    landen.nome().sqrt() * (1.0 + root) / minus_n.sqrt() * libm::exp(-correction)
}

/// Re f and Im f / sin 2z, to q¹⁵: with f = 1 + Σ (fₙ e^2inz + gₙ e^−2inz),
///
/// Re f = 1 + Σ (fₙ + gₙ) cos 2nz,  Im f = Σ (fₙ − gₙ) sin 2nz,  fₙ = (−1)ⁿ q^(2n²−n) Y²ⁿ,  gₙ = (−1)ⁿ q^(2n²−n) (q/Y)²ⁿ
fn attitude_polynomials(q: f64, y2: f64, x2: f64) -> ([f64; 4], [f64; 3]) {
    let [a, b, c] = [1, 2, 3].map(|n| power(-1.0, n) * power(q, n * (2 * n - 1)));
    let [f1, f2, f3] = [a * y2, b * y2 * y2, c * y2 * y2 * y2];
    let [g1, g2, g3] = [a * x2, b * x2 * x2, c * x2 * x2 * x2];
    // cos 4z = ½C² − 1, cos 6z = ½C³ − 1½C; sin 4z = C sin 2z, sin 6z = (C² − 1) sin 2z
    let [s1, s2, s3] = [f1 + g1, f2 + g2, f3 + g3];
    let [d1, d2, d3] = [f1 - g1, f2 - g2, f3 - g3];
    ([1.0 - s2, 0.5 * (s1 - 3.0 * s3), 0.5 * s2, 0.5 * s3], [d1 - d3, d2, d3])
}

/// 1 + q² (C − 1) + q⁶ (C² − C − 1) + q¹² (C³ − C² − 2C + 1) + q²⁰ (C⁴ − C³ − 3C² + 2C + 1), C = 2 cos 2z: the sum of
/// q^(n(n+1)) cos (2n+1)z / cos z. That of ±q^(n(n+1)) sin (2n+1)z / sin z has −C.
fn odd_polynomial(q: f64) -> [f64; 5] {
    let [a, b, c, d] = [2, 6, 12, 20].map(|n| power(q, n));
    [1.0 - a - b + c + d, a - b - 2.0 * c + 2.0 * d, b - c - 3.0 * d, c - d, d]
}

/// 1 + q C + q⁴ (C² − 2) + q⁹ (C³ − 3C) + q¹⁶ (C⁴ − 4C² + 2), C = 2 cos 2z: 1 + Σ 2q^(n²) cos 2nz.
fn even_polynomial(q: f64) -> [f64; 5] {
    let [a, b, c] = [4, 9, 16].map(|n| power(q, n));
    [1.0 - 2.0 * a + 2.0 * c, q - 3.0 * b, a - 4.0 * c, b, c]
}

fn power(x: f64, n: usize) -> f64 {
    (0..n).fold(1.0, |product, _| product * x)
}

impl Family for Trigonometric<f64> {
    type Of<T: Real> = Trigonometric<T>;

    /// cn and dn are 1 at u = 0, sn at u = K.
    fn scale(&self) -> [f64; 3] {
        let Point { theta: [cn, _, dn], below: at_zero, .. } = self.at([1.0, 0.0]);
        let Point { theta: [_, sn, _], below: at_quarter, .. } = self.at([0.0, 1.0]);
        [at_zero / cn, at_quarter / sn, at_zero / dn]
    }

    fn assembled<T: Real>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Trigonometric<T> {
        Trigonometric {
            real: from_fn(|k| pick(&|s| s.real[k])),
            imaginary: from_fn(|k| pick(&|s| s.imaginary[k])),
            odd: from_fn(|k| pick(&|s| s.odd[k])),
            even: from_fn(|k| pick(&|s| s.even[k])),
        }
    }
}

impl<T: Real> Series<T> for Trigonometric<T> {
    /// (cos z, sin z)
    #[inline(always)]
    fn place(&self, z: Phase<T>) -> ([T; 2], Option<T>) {
        let (sin, cos) = sin_cos_quarters(z.quarters, z.rest);
        ([cos, sin], None)
    }

    /// θ₂ ∝ cos z + q² cos 3z + q⁶ cos 5z …, θ₁ ∝ sin z − q² sin 3z …, θ₃, θ₄ = 1 ± 2q cos 2z + 2q⁴ cos 4z ± …: of which cn,
    /// sn, dn are quotients but for constants.
    #[inline(always)]
    fn at(&self, [cos, sin]: [T; 2]) -> Point<T> {
        let product = cos * sin;
        let (c, s) = (T::splat(2.0) * (cos * cos - sin * sin), product + product); // 2 cos 2z, sin 2z
        let c2 = c * c;
        let (re, im) = (&self.real, &self.imaginary);
        let f = Complex {
            re: (re[0] + c * re[1]) + c2 * (re[2] + c * re[3]),
            im: s * ((im[0] + c * im[1]) + c2 * im[2]),
        };
        let (plain, alternating) = parts(&self.odd, c, c2);
        let (even, odd) = parts(&self.even, c, c2);
        Point {
            f,
            theta: [cos * (plain + alternating), sin * (plain - alternating), even + odd],
            below: even - odd,
        }
    }
}

/// Those even and odd in c of a polynomial.
#[inline(always)]
fn parts<T: Real>(p: &[T; 5], c: T, c2: T) -> (T, T) {
    (p[0] + c2 * (p[2] + c2 * p[4]), c * (p[1] + c2 * p[3]))
}
