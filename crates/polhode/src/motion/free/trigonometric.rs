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
    /// Of θ₁, θ₂ without q^(1/4): q^(n(n+1)), n = 1 … 4.
    odd: [T; 4],
    /// Of θ₃, θ₄: 2 q^(n²), n = 1 … 4.
    even: [T; 4],
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
            odd: from_fn(|n| power(q, (n + 1) * (n + 2))),
            even: from_fn(|n| 2.0 * power(q, (n + 1) * (n + 1))),
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
        let (one, two) = (T::splat(1.0), T::splat(2.0));
        let twice = two * (cos * cos - sin * sin); // 2 cos 2z
        // cos(2n+1)z / cos z: 1, 2C − 1, …;  sin(2n+1)z / sin z: 1, 2C + 1, …;  next = 2C this − last
        let (mut c0, mut c1) = (one, twice - one);
        let (mut s0, mut s1) = (one, twice + one);
        let (mut theta2, mut theta1) = (one, one);
        for (n, &term) in self.odd.iter().enumerate() {
            theta2 = theta2 + term * c1;
            theta1 = if n % 2 == 0 { theta1 - term * s1 } else { theta1 + term * s1 };
            (c0, c1) = (c1, twice * c1 - c0);
            (s0, s1) = (s1, twice * s1 - s0);
        }
        let t1 = T::splat(0.5) * twice;
        let t2 = twice * t1 - one;
        let t3 = twice * t2 - t1;
        let t4 = twice * t3 - t2;
        let even = one + self.even[1] * t2 + self.even[3] * t4;
        let odd = self.even[0] * t1 + self.even[2] * t3;
        let over = (even - odd).map(|theta4| 1.0 / theta4);
        ([cos * theta2, sin * theta1, even + odd], over)
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
