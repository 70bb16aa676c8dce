//! The motion as trigonometric series: for a nome that is not near 1.

use core::array::from_fn;

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elementary::sin_cos_eighth;
use crate::math::landen::Landen;
use crate::math::real::{PI, Real};

use super::elements::Elements;
use super::flow::{Family, Point, Spinor};

/// Coefficients of the theta functions at z, for |z| ≤ ½π: constants of a motion.
///
/// With the nome q and Y = e^−w̄, √q ≤ Y ≤ 1 (Y → tan ½θ of a symmetric body's nutation θ):
///
/// α = Σ ± q^(j(j−1)/2) (q/Y)ʲ e^−i(2j+1)z/2 over even j ± q^(j(j+1)/2) Yʲ⁺¹ e^+i(2j+1)z/2 over odd j, and β the same with even and odd
/// exchanged and z reversed; signs + − − +.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Trigonometric<T> {
    /// ± q^(j(j−1)/2) (q/Y)ʲ
    near: [T; TERMS],
    /// ± q^(j(j+1)/2) Yʲ⁺¹
    far: [T; TERMS],
    /// θ₂/cos z and θ₁/sin z without 2q^(1/4), as polynomials of ±2 cos 2z.
    odd: [T; 5],
    /// θ₃ and θ₄ as polynomials of ±2 cos 2z.
    even: [T; 5],
}

/// Terms down to 10⁻¹⁷ where the nome is 0.2, its largest here.
const TERMS: usize = 8;

impl Trigonometric<f64> {
    /// The series, and where on them the motion starts: z/2π, turns.
    pub(super) fn of(elements: &Elements) -> (Self, [f64; 2]) {
        let landen = Landen::new(elements.m.value(), elements.m1().value());
        let q = landen.nome();
        let y = half_nutation(elements, &landen);
        let ratio = if y == 0.0 { 0.0 } else { q / y };
        let signs = [1.0, -1.0, -1.0, 1.0];
        let triangle = |j: usize| power(q, j * (j + 1) / 2);
        let mut series = Self {
            near: from_fn(|j| signs[j % 4] * power(ratio, j) * if j == 0 { 1.0 } else { triangle(j - 1) }),
            far: from_fn(|j| signs[j % 4] * triangle(j) * power(y, j + 1)),
            odd: odd_polynomial(q),
            even: even_polynomial(q),
        };
        let Point { spinor, over, .. } = series.at(0.0);
        let unit = (over * (spinor.alpha.norm2() + spinor.beta.norm2())).sqrt();
        for coefficient in series.near.iter_mut().chain(&mut series.far) {
            *coefficient /= unit;
        }
        let [c, s] = elements.start.map(Double::value);
        (series, [landen.angle(s, c) / (2.0 * PI), 0.0])
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
        let ([cn, _, dn], at_zero) = self.elliptic([1.0, 0.0]);
        let ([_, sn, _], at_quarter) = self.elliptic([0.0, 1.0]);
        [1.0 / (cn * at_zero), 1.0 / (sn * at_quarter), 1.0 / (dn * at_zero)]
    }

    fn assembled<T: Real>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Trigonometric<T> {
        Trigonometric {
            near: from_fn(|k| pick(&|s| s.near[k])),
            far: from_fn(|k| pick(&|s| s.far[k])),
            odd: from_fn(|k| pick(&|s| s.odd[k])),
            even: from_fn(|k| pick(&|s| s.even[k])),
        }
    }
}

impl<T: Real> Trigonometric<T> {
    /// (α, β) but for the common phase, and cn, sn, dn, of z = 2πx, |x| ≤ ¼ turn.
    #[inline(always)]
    pub(super) fn at(&self, x: T) -> Point<T> {
        let (s, c) = sin_cos_eighth(T::splat(PI) * x);
        let u = Complex { re: c, im: s }; // e^iz/2
        let u2 = u.square();
        let u3 = u2.times(u);
        let step = u2.square(); // e^2iz
        let (near_even, near_odd) = split_series(&self.near, step.conjugate());
        let (far_even, far_odd) = split_series(&self.far, step);
        let spinor = Spinor {
            alpha: u.conjugate().times(near_even).sum(u3.times(far_odd)),
            beta: u.times(far_even).sum(u3.conjugate().times(near_odd)),
        };
        let (theta, over) = self.elliptic([u2.re, u2.im]);
        Point { spinor, theta, over }
    }

    /// θ₂, θ₁, θ₃ and 1/θ₄, of which cn, sn, dn are quotients but for constants, from cos z and sin z. The norm of the spinor
    /// is √θ₄, too.
    ///
    /// θ₂ ∝ cos z + q² cos 3z + q⁶ cos 5z …, θ₁ ∝ sin z − q² sin 3z …, θ₃, θ₄ = 1 ± 2q cos 2z + 2q⁴ cos 4z ± …
    #[inline(always)]
    fn elliptic(&self, [cos, sin]: [T; 2]) -> ([T; 3], T) {
        let c = T::splat(2.0) * (cos * cos - sin * sin); // 2 cos 2z
        let c2 = c * c;
        // the parts even and odd in c
        let parts = |p: &[T; 5]| (p[0] + c2 * (p[2] + c2 * p[4]), c * (p[1] + c2 * p[3]));
        let (plain, alternating) = parts(&self.odd);
        let (even, odd) = parts(&self.even);
        let over = (even - odd).map(|theta4| 1.0 / theta4);
        ([cos * (plain + alternating), sin * (plain - alternating), even + odd], over)
    }
}

/// Σ c₂ₖ xᵏ and Σ c₂ₖ₊₁ xᵏ, k = 0 … 3.
#[inline(always)]
fn split_series<T: Real>(c: &[T; TERMS], x: Complex<T>) -> (Complex<T>, Complex<T>) {
    let x2 = x.square();
    let even = x.scaled(c[6]).plus(c[4]).times(x2).sum(x.scaled(c[2]).plus(c[0]));
    let odd = x.scaled(c[7]).plus(c[5]).times(x2).sum(x.scaled(c[3]).plus(c[1]));
    (even, odd)
}
