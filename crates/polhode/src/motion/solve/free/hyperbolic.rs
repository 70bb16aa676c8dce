//! Free motion as a few travelling pulses, for a nome near 1 up to the separatrix.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elementary::{exp_both, sin_cos_quarters};
use crate::math::landen::{Landen, log_of};
use crate::math::number::{PI, Splat};
use crate::math::symmetric3::power_of_two_near;

use super::compact::{ScalarThetaParameters, ThetaParameters};
use super::elements::Elements;
use super::flow::{Point, Series};
use crate::motion::solve::phase::Phase;

/// Coefficients of the theta functions in the complementary nome: constants of a motion.
///
/// Jacobi's imaginary transformation turns θ(z | q²) into θ(¼π − b + iy | Q), where y = κz, κ =
/// K/2K′, Q = e^−πκ. Let X = e^−2|y| and W = Q/X; both are between Q and 1. Every term is a power
/// of X or of W times a power of Q. On the separatrix Q = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hyperbolic<T> {
    /// πκ: factor from quarter turns of z to 2y.
    stretch: T,
    /// ½ − 2b/π: coefficient of the phase contribution of the pulse.
    bend: T,
    /// Nome Q.
    nome: T,
    /// cos aₙ and sin aₙ times Q^(n²), aₙ = (2n+1)(¼π − b): coefficients of powers of W.
    rising: [[T; 4]; 2],
    /// cos aₙ and sin aₙ times Q^(n(n+1)): coefficients of powers of X.
    falling: [[T; 3]; 2],
    /// Nome q′ = Q² of cn, sn and dn, its square and its fourth power.
    pub(super) squares: [T; 3],
}

/// Constants that determine the series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pulse<T> {
    /// Low word of the phase 2z/π at the start, quarter turns.
    low_start: T,
    /// πκ: factor from quarter turns of z to 2y.
    pub(super) stretch: T,
    /// ½ − 2b/π
    bend: T,
    /// Nome Q.
    nome: T,
}

impl Pulse<f64> {
    /// Returns the constants of the series and the phase of the start: high word of 2z/π, quarter
    /// turns.
    pub(super) fn of(elements: &Elements) -> (Self, f64) {
        // m and 1 − m exchange their roles.
        let landen = Landen::new(elements.m1().value(), elements.m.value());
        // q′ = m₁/16 + … underflows before its square root does.
        let k1 = elements.k1.value();
        let nome = if k1 < TINY { 0.25 * k1 } else { landen.nome().sqrt() };
        // K′ = π / 2 agm(1, √m):  κ = K / 2K′
        let other_quarter = Double::TAU.scaled(0.25) / mean(elements.m.sqrt());
        let kappa = elements.quarter / other_quarter.scaled(2.0);
        // 2b = π F(arctan(A3/A1) | m₁) / 2K′
        let [a1, _, a3] = elements.amplitudes.map(Double::value);
        let l = elements.momentum.value();
        let b = 0.5 * landen.angle(a3 / l, a1 / l);
        let [start, low_start] = start(elements, &landen, kappa);
        let stretch = (Double::TAU * kappa).scaled(0.5).value();
        (Self { low_start, stretch, bend: 0.5 - 2.0 * b / PI, nome }, start)
    }
}

impl ScalarThetaParameters for Pulse<f64> {
    type Of<T: Splat> = Pulse<T>;

    /// Fixes the factors by cn = dn = 1 at u = 0 and sn = 1 at u = K.
    fn scale(&self) -> [f64; 3] {
        let series = self.series();
        let ([cn, _, dn], at_zero) = series.elliptic(1.0, self.nome);
        let ([_, sn, _], at_quarter) = series.elliptic(self.nome, 1.0);
        [at_zero / cn, at_quarter / sn, at_zero / dn]
    }

    fn assembled<T: Splat>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Pulse<T> {
        Pulse {
            low_start: pick(&|p| p.low_start),
            stretch: pick(&|p| p.stretch),
            bend: pick(&|p| p.bend),
            nome: pick(&|p| p.nome),
        }
    }
}

impl<T: Splat> ThetaParameters<T> for Pulse<T> {
    type Series = Hyperbolic<T>;

    #[inline(always)]
    fn low_start(&self) -> T {
        self.low_start
    }

    #[inline(always)]
    fn series(&self) -> Hyperbolic<T> {
        // e^ia, a = ¼π − b, and its odd powers by products
        let (s, c) = sin_cos_quarters(T::splat(0.0), self.bend);
        let first = Complex { re: c, im: s };
        let square = Complex { re: c * c - s * s, im: T::splat(2.0) * (c * s) };
        let third = first.times(square);
        let fifth = third.times(square);
        let seventh = fifth.times(square);
        let q = self.nome;
        let q2 = q * q;
        let q4 = q2 * q2;
        let (q6, q8) = (q4 * q2, q4 * q4);
        let q9 = q8 * q;
        Hyperbolic {
            stretch: self.stretch,
            bend: self.bend,
            nome: q,
            rising: [
                [first.re, q * third.re, q4 * fifth.re, q9 * seventh.re],
                [first.im, q * third.im, q4 * fifth.im, q9 * seventh.im],
            ],
            falling: [[first.re, q2 * third.re, q6 * fifth.re], [first.im, q2 * third.im, q6 * fifth.im]],
            squares: [q2, q4, q8],
        }
    }
}

/// Threshold of k₁. Below it Q = k₁/4 to full f64 precision.
const TINY: f64 = 1e-9;

/// Returns the arithmetic–geometric mean agm(1, g).
fn mean(g: Double) -> Double {
    let (mut a, mut g) = (Double::ONE, g);
    while (a - g).high > 1e-17 {
        (a, g) = ((a + g).scaled(0.5), (a * g).sqrt());
    }
    (a + g).scaled(0.5)
}

/// Returns u0/K in quarter turns, computed from the nearer end of the quarter in which it lies.
fn start(elements: &Elements, landen: &Landen, kappa: Double) -> [f64; 2] {
    let [c, s] = elements.start;
    let root = elements.k1;
    // if tan φ > 1/√k′, u0 is nearer to K
    let near_zero = s.abs() * root.sqrt() <= c.abs();
    let (tangent_sine, tangent_cosine) = if near_zero { (s, c) } else { (c, root * s) };
    let y = argument(tangent_sine, tangent_cosine, landen);
    let quarters = (y / (Double::TAU * kappa)).scaled(4.0);
    let quarters = Double::sum(quarters.high, quarters.low);
    let start = match (near_zero, c.high < 0.0, s.high < 0.0) {
        (true, false, _) => quarters,
        (true, true, _) => Double::from(2.0) + quarters,
        // u = ±K − F(φ′), tan φ′ = cos / (k′ sin)
        (false, _, false) => Double::from(1.0) - quarters,
        (false, _, true) => Double::from(-1.0) - quarters,
    };
    [start.high, start.low]
}

/// Returns π F(φ|m) / 4K′ for tan φ = sin/cos, |φ| < ½π; odd in tan φ. sin² + cos² need not be 1.
///
/// The value is ½ (χ − Σ ηₙ/2ⁿ⁺¹), where tan φ = sinh χ.
fn argument(sin: Double, cos: Double, landen: &Landen) -> Double {
    // use units in which no square leaves the range of f64
    let unit = 1.0 / power_of_two_near(sin.high.abs().max(cos.high.abs()));
    let (s, c) = (sin.abs().scaled(unit), cos.abs().scaled(unit));
    let h2 = s.square() + c.square();
    let h = h2.sqrt();
    let correction = landen.hyperbolic_correction((s / h).value(), (c.square() / h2).value());
    let y = (log_of((s + h) / c) - Double::from(correction)).scaled(0.5);
    if (sin.high < 0.0) == (cos.high < 0.0) { y } else { -y }
}

impl<T: Splat> Series<T> for Hyperbolic<T> {
    #[inline(always)]
    fn place(&self, z: Phase<T>) -> ([T; 2], Option<T>) {
        ([z.quarters, z.rest], Some(self.bend * within_half_period(z)))
    }

    #[inline(always)]
    fn at(&self, place: [T; 2]) -> Point<T> {
        let Ends { sign, turned, falling, rising } = self.ends(place);
        let ([cn, sn, dn], below) = self.elliptic(falling, rising);
        Point {
            f: self.attitude(falling, rising, sign),
            theta: [turned * cn, (turned * sign) * sn, dn],
            below,
        }
    }
}

/// Position within its half period: z = ½π (x + 2N), |x| ≤ 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ends<T> {
    /// Sign of x.
    pub(super) sign: T,
    /// (−1)ᴺ
    pub(super) turned: T,
    /// X = e^−2|y|.
    pub(super) falling: T,
    /// W = Q/X.
    pub(super) rising: T,
}

/// Returns x for z = ½π (x + 2N), |x| ≤ 1. If the number of quarter turns is even, x is the rest.
/// If it is odd, x is the rest minus its sign.
#[inline(always)]
pub(super) fn within_half_period<T: Splat>(z: Phase<T>) -> T {
    z.rest
        .zip(z.quarters, |rest, quarters| if is_odd(quarters) { rest - 1.0_f64.copysign(rest) } else { rest })
}

#[inline(always)]
fn is_odd(quarters: f64) -> bool {
    quarters.to_bits() & 1 == 1
}

impl<T: Splat> Hyperbolic<T> {
    #[inline(always)]
    pub(super) fn ends(&self, [quarters, rest]: [T; 2]) -> Ends<T> {
        let sign = quarters
            .zip(rest, |q, rest| if is_odd(q) { -1.0_f64.copysign(rest) } else { 1.0_f64.copysign(rest) });
        let turned = quarters.zip(rest, |q, rest| {
            if (q.to_bits() & 2 == 2) ^ (is_odd(q) & rest.is_sign_positive()) { -1.0 } else { 1.0 }
        });
        // Exponential of the nearer end of the pulse. The other one follows from X W = Q.
        let (near, rise) = exp_both(self.stretch * rest.map(f64::abs));
        let far = self.nome * rise;
        let falling = quarters.zip3(near, far, |q, near, far| if is_odd(q) { far } else { near });
        let rising = quarters.zip3(near, far, |q, near, far| if is_odd(q) { near } else { far });
        Ends { sign, turned, falling, rising }
    }

    /// Returns θ₂ of ¼π − b + iy.
    #[inline(always)]
    fn attitude(&self, x: T, w: T, sign: T) -> Complex<T> {
        let (w2, x2) = (w * w, x * x);
        let [rising_cos, rising_sin] = &self.rising;
        let [falling_cos, falling_sin] = &self.falling;
        // cos(a + iy) = cos a cosh y − i sin a sinh y
        Complex {
            re: rising(rising_cos, w, w2) + falling(falling_cos, x, x2),
            im: sign * (falling(falling_sin, x, x2) - rising(rising_sin, w, w2)),
        }
    }

    /// Returns θ₄, |θ₁| and θ₃, and θ₂, of 2iy with nome q′ = Q². Up to constants, cn, sn and dn
    /// are the quotients of the first three by θ₂:
    ///
    /// cn, dn ∝ (1 ∓ 2q′ cosh 4y + …) / (cosh 2y + q′² cosh 6y + …),
    ///
    /// sn ∝ (sinh 2y − q′² sinh 6y + …) / (…)
    #[inline(always)]
    pub(super) fn elliptic(&self, x: T, w: T) -> ([T; 3], T) {
        let [q1, q2, q4] = self.squares;
        let (v, u) = (w * w, x * x); // e^4|y| q′ and e^−4|y|
        let one = T::splat(1.0);
        let (v2, u2) = (v * v, u * u);
        let below = ((one + u) + q4 * v2) + q1 * (v + q1 * u2);
        let odd = ((one - u) + q4 * v2) - q1 * (v - q1 * u2);
        let (even, uneven) = (one + (q2 * v2 + q4 * u2), v + q1 * u);
        ([x * (even - uneven), odd, x * (even + uneven)], below)
    }
}

#[inline(always)]
fn rising<T: Splat>(c: &[T; 4], w: T, w2: T) -> T {
    (c[0] + c[2] * w2) + w * (c[1] + c[3] * w2)
}

#[inline(always)]
fn falling<T: Splat>(c: &[T; 3], x: T, x2: T) -> T {
    x * (c[0] + c[2] * x2) + x2 * c[1]
}
