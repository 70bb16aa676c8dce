//! Free motion as trigonometric theta series, for a nome that is not near 1.

use core::array::from_fn;

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elementary::sin_cos_quarters;
use crate::math::landen::Landen;
use crate::math::number::{PI, Splat};

use super::compact::{ScalarThetaParameters, ThetaParameters};
use super::elements::Elements;
use super::flow::{Point, Series};
use crate::motion::solve::phase::Phase;

/// Coefficients of the theta functions as polynomials: constants of a motion.
///
/// The nome is q, and Y = e^−w̄ with √q ≤ Y ≤ 1. (For a symmetric body Y → tan ½θ, where θ is its
/// nutation angle.) Then f = θ₄(z − iw | q²) is
///
/// f = 1 + Σ (−1)ⁿ q^(2n²−n) (Y²ⁿ e^2inz + (q/Y)²ⁿ e^−2inz),  n = 1, 2, 3
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Trigonometric<T> {
    /// Re f as a polynomial of 2 cos 2z.
    real: [T; 4],
    /// Im f / sin 2z as a polynomial of 2 cos 2z.
    imaginary: [T; 3],
    /// θ₂/cos z and θ₁/sin z without the factor 2q^(1/4), as polynomials of ±2 cos 2z.
    odd: [T; 5],
    /// θ₃ and θ₄ as polynomials of ±2 cos 2z.
    even: [T; 5],
}

/// Constants that determine the series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Nomes<T> {
    /// Nome q.
    pub(super) nome: T,
    /// Y² and (q/Y)².
    squares: [T; 2],
}

impl Nomes<f64> {
    /// Returns the constants of the series and the phase of the start, 2z/π, quarter turns.
    pub(super) fn of(elements: &Elements) -> (Self, f64) {
        let landen = Landen::new(elements.m.value(), elements.m1().value());
        let (q, y) = (landen.nome(), half_nutation(elements, &landen));
        let x = if y == 0.0 { 0.0 } else { q / y };
        let [c, s] = elements.start.map(Double::value);
        (Self { nome: q, squares: [y * y, x * x] }, landen.angle(s, c) * (2.0 / PI))
    }
}

impl ScalarThetaParameters for Nomes<f64> {
    type Of<T: Splat> = Nomes<T>;

    /// Fixes the factors by cn = dn = 1 at u = 0 and sn = 1 at u = K.
    fn scale(&self) -> [f64; 3] {
        let series = self.series();
        let Point { theta: [cn, _, dn], below: at_zero, .. } = series.at([1.0, 0.0]);
        let Point { theta: [_, sn, _], below: at_quarter, .. } = series.at([0.0, 1.0]);
        [at_zero / cn, at_quarter / sn, at_zero / dn]
    }

    fn assembled<T: Splat>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Nomes<T> {
        Nomes { nome: pick(&|n| n.nome), squares: from_fn(|k| pick(&|n| n.squares[k])) }
    }
}

impl<T: Splat> ThetaParameters<T> for Nomes<T> {
    type Series = Trigonometric<T>;

    #[inline(always)]
    fn low_start(&self) -> T {
        T::splat(0.0)
    }

    #[inline(always)]
    fn series(&self) -> Trigonometric<T> {
        let q = self.nome;
        let q2 = q * q;
        let q4 = q2 * q2;
        let (q6, q8) = (q4 * q2, q4 * q4);
        let (q9, q12, q16) = (q8 * q, q6 * q6, q8 * q8);
        let [y2, x2] = self.squares;
        let (real, imaginary) = attitude_polynomials([q, q6, q9 * q6], y2, x2);
        Trigonometric {
            real,
            imaginary,
            odd: odd_polynomial([q2, q6, q12, q16 * q4]),
            even: even_polynomial([q, q4, q9, q16]),
        }
    }
}

/// Returns Y = e^−w̄ with w̄ = π F(arctan(A3/A1) | m₁) / 2K, from e^−χ = A1 / (L + A3) where L2 =
/// 0.
///
/// If w̄ is more than half of the way to K′, the complement F(arctan(1/√−n) | m₁) is used instead:
/// Y = √q e^w, e^χ = (1 + √(1 − n)) / √−n.
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

/// Returns Re f and Im f / sin 2z up to q¹⁵ as polynomials, for f = 1 + Σ (fₙ e^2inz + gₙ e^−2inz):
///
/// Re f = 1 + Σ (fₙ + gₙ) cos 2nz,  Im f = Σ (fₙ − gₙ) sin 2nz,
///
/// fₙ = (−1)ⁿ q^(2n²−n) Y²ⁿ,  gₙ = (−1)ⁿ q^(2n²−n) (q/Y)²ⁿ
#[inline(always)]
fn attitude_polynomials<T: Splat>([q, q6, q15]: [T; 3], y2: T, x2: T) -> ([T; 4], [T; 3]) {
    let (y4, x4) = (y2 * y2, x2 * x2);
    let [f1, f2, f3] = [q * y2, q6 * y4, q15 * (y4 * y2)]; // without their signs
    let [g1, g2, g3] = [q * x2, q6 * x4, q15 * (x4 * x2)];
    // cos 4z = ½C² − 1, cos 6z = ½C³ − 1½C; sin 4z = C sin 2z, sin 6z = (C² − 1) sin 2z
    let [s1, s2, s3] = [f1 + g1, f2 + g2, f3 + g3];
    let [d1, d2, d3] = [f1 - g1, f2 - g2, f3 - g3];
    let (one, half) = (T::splat(1.0), T::splat(0.5));
    ([one - s2, T::splat(1.5) * s3 - half * s1, half * s2, -(half * s3)], [d3 - d1, d2, -d3])
}

/// Returns the polynomial of C = 2 cos 2z that equals Σ q^(n(n+1)) cos (2n+1)z / cos z:
///
/// 1 + q² (C − 1) + q⁶ (C² − C − 1) + q¹² (C³ − C² − 2C + 1) + q²⁰ (C⁴ − C³ − 3C² + 2C + 1)
///
/// The sum of ±q^(n(n+1)) sin (2n+1)z / sin z is the same polynomial of −C.
#[inline(always)]
fn odd_polynomial<T: Splat>([a, b, c, d]: [T; 4]) -> [T; 5] {
    let two = T::splat(2.0);
    [(T::splat(1.0) - a) - (b - (c + d)), (a - b) - two * (c - d), (b - c) - T::splat(3.0) * d, c - d, d]
}

/// Returns the polynomial of C = 2 cos 2z that equals 1 + Σ 2q^(n²) cos 2nz:
///
/// 1 + q C + q⁴ (C² − 2) + q⁹ (C³ − 3C) + q¹⁶ (C⁴ − 4C² + 2)
#[inline(always)]
fn even_polynomial<T: Splat>([q, a, b, c]: [T; 4]) -> [T; 5] {
    let two = T::splat(2.0);
    [T::splat(1.0) - two * (a - c), q - T::splat(3.0) * b, a - T::splat(4.0) * c, b, c]
}

impl<T: Splat> Series<T> for Trigonometric<T> {
    /// Returns (cos z, sin z) and no bend.
    #[inline(always)]
    fn place(&self, z: Phase<T>) -> ([T; 2], Option<T>) {
        let (sin, cos) = sin_cos_quarters(z.quarters, z.rest);
        ([cos, sin], None)
    }

    /// Evaluates the series. cn, sn and dn are quotients of these theta functions times constants:
    ///
    /// θ₂ ∝ cos z + q² cos 3z + q⁶ cos 5z …,  θ₁ ∝ sin z − q² sin 3z …,
    ///
    /// θ₃, θ₄ = 1 ± 2q cos 2z + 2q⁴ cos 4z ± …
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

/// Returns the even and the odd part in c of a polynomial.
#[inline(always)]
fn parts<T: Splat>(p: &[T; 5], c: T, c2: T) -> (T, T) {
    (p[0] + c2 * (p[2] + c2 * p[4]), c * (p[1] + c2 * p[3]))
}
