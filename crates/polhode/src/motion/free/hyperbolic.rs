//! The motion as a few travelling pulses: for a nome near 1, up to the separatrix itself.

use core::array::from_fn;

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elementary::exp_minus;
use crate::math::landen::{Landen, log_of};
use crate::math::real::{PI, Real};
use crate::math::symmetric3::power_of_two_near;

use super::elements::Elements;
use super::flow::{Family, Point, Spinor};

/// Coefficients of the theta functions in the complementary nome: constants of a motion.
///
/// Jacobi's imaginary transformation turns θ(z | q²) into θ(¼π − b + iy | Q), y = κz, κ = K/2K′, Q = e^−πκ. With X = e^−2|y| and
/// W = Q/X, both between Q and 1, every term is a power of one of them times a power of Q. On the separatrix Q = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hyperbolic<T> {
    /// 4πκ: from the phase in turns to 2y.
    stretch: T,
    /// 2b/π: the part of the phase that goes with the pulse.
    pub(super) bend: T,
    /// Q
    nome: T,
    /// cos aₙ and sin aₙ times Q^(n²), aₙ = (2n+1)(¼π − b): with powers of W.
    rising: [[T; 4]; 2],
    /// The same times Q^(n(n+1)): with powers of X.
    falling: [[T; 3]; 2],
    /// q′ = Q² of cn, sn, dn, and its fourth power.
    squares: [T; 3],
}

impl Hyperbolic<f64> {
    /// The series, and where on them the motion starts: z/2π, turns.
    pub(super) fn of(elements: &Elements) -> (Self, [f64; 2]) {
        // The roles of m and 1 − m are exchanged.
        let landen = Landen::new(elements.m1().value(), elements.m.value());
        let squared = landen.nome();
        // q′ = m₁/16 + … leaves the range of f64 before its root does.
        let k1 = elements.k1.value();
        let nome = if k1 < TINY { 0.25 * k1 } else { squared.sqrt() };
        // K′ = π / 2 agm(1, √m):  κ = K / 2K′
        let other_quarter = Double::TAU.scaled(0.25) / mean(elements.m.sqrt());
        let kappa = elements.quarter / other_quarter.scaled(2.0);
        // 2b = π F(arctan(A3/A1) | m₁) / 2K′
        let [a1, _, a3] = elements.amplitudes.map(Double::value);
        let l = elements.momentum.value();
        let b = 0.5 * landen.angle(a3 / l, a1 / l);
        let angle = |n: usize| libm::sincos((2 * n + 1) as f64 * (0.25 * PI - b));
        let power = |n: usize| (0..n).fold(1.0, |p, _| p * nome);
        let mut series = Self {
            stretch: (Double::TAU * kappa).scaled(2.0).value(),
            bend: 2.0 * b / PI,
            nome,
            rising: [from_fn(|n| power(n * n) * angle(n).1), from_fn(|n| power(n * n) * angle(n).0)],
            falling: [from_fn(|n| power(n * n + n) * angle(n).1), from_fn(|n| power(n * n + n) * angle(n).0)],
            squares: [squared, squared * squared, (squared * squared) * (squared * squared)],
        };
        let Point { spinor, over, .. } = series.at(0.0);
        let unit = (over * (spinor.alpha.norm2() + spinor.beta.norm2())).sqrt();
        for coefficient in series.rising.iter_mut().flatten().chain(series.falling.iter_mut().flatten()) {
            *coefficient /= unit;
        }
        (series, start(elements, &landen, kappa))
    }
}

/// Below it Q = k₁/4 to the last digit.
const TINY: f64 = 1e-9;

/// agm(1, g)
fn mean(g: Double) -> Double {
    let (mut a, mut g) = (Double::ONE, g);
    while (a - g).high > 1e-17 {
        (a, g) = ((a + g).scaled(0.5), (a * g).sqrt());
    }
    (a + g).scaled(0.5)
}

/// u0/4K, turns, from the nearer end of the quarter in which it lies.
fn start(elements: &Elements, landen: &Landen, kappa: Double) -> [f64; 2] {
    let [c, s] = elements.start;
    let root = elements.k1;
    // tan φ above 1/√k′ is nearer to K
    let near_zero = s.abs() * root.sqrt() <= c.abs();
    let (tangent_sine, tangent_cosine) = if near_zero { (s, c) } else { (c, root * s) };
    let y = argument(tangent_sine, tangent_cosine, landen);
    let turns = y / (Double::TAU * kappa);
    let turns = Double::sum(turns.high, turns.low);
    let start = match (near_zero, c.high < 0.0, s.high < 0.0) {
        (true, false, _) => turns,
        (true, true, _) => Double::from(0.5) + turns,
        // u = ±K − F(φ′), tan φ′ = cos / (k′ sin)
        (false, _, false) => Double::from(0.25) - turns,
        (false, _, true) => Double::from(-0.25) - turns,
    };
    [start.high, start.low]
}

/// π F(φ|m) / 4K′ of tan φ = sin/cos, sin² + cos² whatever it is; odd in tan φ, |φ| < ½π.
///
/// With tan φ = sinh χ it is ½ (χ − Σ ηₙ/2ⁿ⁺¹).
fn argument(sin: Double, cos: Double, landen: &Landen) -> Double {
    // in units in which no square leaves the range of f64
    let unit = 1.0 / power_of_two_near(sin.high.abs().max(cos.high.abs()));
    let (s, c) = (sin.abs().scaled(unit), cos.abs().scaled(unit));
    let h2 = s.square() + c.square();
    let h = h2.sqrt();
    let correction = landen.hyperbolic_correction((s / h).value(), (c.square() / h2).value());
    let y = (log_of((s + h) / c) - Double::from(correction)).scaled(0.5);
    if (sin.high < 0.0) == (cos.high < 0.0) { y } else { -y }
}

impl Family for Hyperbolic<f64> {
    type Of<T: Real> = Hyperbolic<T>;

    /// cn and dn are 1 at u = 0, sn at u = K.
    fn scale(&self) -> [f64; 3] {
        let ([cn, _, dn], at_zero) = self.elliptic(1.0, self.nome, 1.0);
        let ([_, sn, _], at_quarter) = self.elliptic(self.nome, 1.0, 1.0);
        [1.0 / (cn * at_zero), 1.0 / (sn * at_quarter), 1.0 / (dn * at_zero)]
    }

    fn assembled<T: Real>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Hyperbolic<T> {
        Hyperbolic {
            stretch: pick(&|s| s.stretch),
            bend: pick(&|s| s.bend),
            nome: pick(&|s| s.nome),
            rising: from_fn(|i| from_fn(|k| pick(&|s| s.rising[i][k]))),
            falling: from_fn(|i| from_fn(|k| pick(&|s| s.falling[i][k]))),
            squares: from_fn(|k| pick(&|s| s.squares[k])),
        }
    }
}

impl<T: Real> Hyperbolic<T> {
    /// (α, β) but for the common phase, and cn, sn, dn, of z = 2πx, |x| ≤ ¼ turn.
    #[inline(always)]
    pub(super) fn at(&self, x: T) -> Point<T> {
        let sign = x.map(|x| 1.0_f64.copysign(x));
        let distance = sign * x;
        // The exponential of the nearer end of the pulse; the other follows from X W = Q.
        let nearer = distance.map(|d| if d <= 0.125 { d } else { 0.25 - d });
        let nearer = exp_minus(self.stretch * nearer.map(|d| if d > 0.0 { d } else { 0.0 }));
        let farther = self.nome.zip(nearer, |q, e| q / e);
        let falling = distance.zip3(nearer, farther, |d, near, far| if d <= 0.125 { near } else { far });
        let rising = distance.zip3(nearer, farther, |d, near, far| if d <= 0.125 { far } else { near });
        let (theta, over) = self.elliptic(falling, rising, sign);
        Point { spinor: self.spinor(falling, rising, sign), theta, over }
    }

    /// θ₂ and θ₁ of ¼π − b + iy.
    #[inline(always)]
    fn spinor(&self, x: T, w: T, sign: T) -> Spinor<T> {
        let (w2, x2) = (w * w, x * x);
        // Σ over even n and over odd n: θ₁ alternates.
        let rising = |c: &[T; 4]| (c[0] + c[2] * w2, w * (c[1] + c[3] * w2));
        let falling = |c: &[T; 3]| (x * (c[0] + c[2] * x2), x2 * c[1]);
        let [(rc0, rc1), (rs0, rs1)] = [rising(&self.rising[0]), rising(&self.rising[1])];
        let [(fc0, fc1), (fs0, fs1)] = [falling(&self.falling[0]), falling(&self.falling[1])];
        // cos(a + iy) = cos a cosh y − i sin a sinh y,  sin(a + iy) = sin a cosh y + i cos a sinh y
        let theta2 = Complex { re: (rc0 + rc1) + (fc0 + fc1), im: sign * ((fs0 + fs1) - (rs0 + rs1)) };
        let theta1 = Complex { re: (rs0 - rs1) + (fs0 - fs1), im: sign * ((rc0 - rc1) - (fc0 - fc1)) };
        Spinor { alpha: theta2, beta: theta1 }
    }

    /// θ₄, θ₁/i, θ₃ and 1/θ₂ of 2iy, nome q′ = Q², of which cn, sn, dn are quotients but for constants. The norm of the
    /// spinor is √θ₂, too.
    ///
    /// cn, dn ∝ (1 ∓ 2q′ cosh 4y + …) / (cosh 2y + q′² cosh 6y + …), sn ∝ (sinh 2y − q′² sinh 6y + …) / (…)
    #[inline(always)]
    fn elliptic(&self, x: T, w: T, sign: T) -> ([T; 3], T) {
        let [q1, q2, q4] = self.squares;
        let (v, u) = (w * w, x * x); // e^4|y| q′ and e^−4|y|
        let one = T::splat(1.0);
        let (v2, u2) = (v * v, u * u);
        let below = ((one + u) + q4 * v2) + q1 * (v + q1 * u2);
        let odd = ((one - u) + q4 * v2) - q1 * (v - q1 * u2);
        let (even, uneven) = (one + (q2 * v2 + q4 * u2), v + q1 * u);
        let over = below.map(|b| 1.0 / b);
        ([x * (even - uneven), sign * odd, x * (even + uneven)], over)
    }
}
