//! Jacobi's theta functions on a line parallel to the real axis, for motions that are quotients of
//! them. The shorter of two series is used.
//!
//! Let E = e^2iz, the nome q = e^−πt with t = K′/K, s = e^−2w with 0 ≤ w ≤ ½πt, and
//!
//! N(z) = Σ εⁿ q^(n²+n) s⁻ⁿ Eⁿ over all integers n.
//!
//! Up to a constant factor, N is e^−iz iθ₁(z − iw) for ε = −1 and e^−iz θ₂(z − iw) for ε = 1. It is
//! 1 + εs/E + …, so its winding number about 0 is zero.
//!
//! If q is not small, Jacobi's imaginary transformation (DLMF 20.7.30–33) gives a series in Q =
//! e^−π/t:
//!
//! N(z) ∝ e^−z²/πt e^−2iby/π θ(iy − b | Q),  y = z/t,  b = ½π − w/t,
//!
//! with θ = θ₂ for ε = −1 and θ₃ for ε = 1. The Gaussian factor is omitted here, for θ₄(z) too,
//! because it cancels in quotients.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elementary::{exp_both, sin_cos_quarters};
use crate::math::elliptic::EllipticParameter;
use crate::math::number::Splat;

use super::phase::Phase;

/// Theta functions of a parameter m, by the shorter series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lattice {
    /// t = K′/K.
    ratio: Double,
    /// π/2K.
    scale: Double,
    /// Elliptic functions of the complementary parameter m₁, for the shifts w.
    complementary: EllipticParameter,
    series: ThetaSeries,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum ThetaSeries {
    /// Series in q.
    Trigonometric { nome: f64 },
    /// Series in Q. y is `stretch` times z in quarter turns.
    Hyperbolic { nome: f64, stretch: f64 },
}

/// Functions of z in the form that the series take.
#[derive(Clone, Copy, Debug)]
pub(super) enum SeriesArgument<T> {
    /// cos z and sin z; C = 2 cos 2z and sin 2z.
    Trigonometric { cos: T, sin: T, c: T, s: T },
    /// x = e^−2|y| and its root; w = Q/x; the sign of y; `turned`, the sign of cos z with |y|
    /// counted over several periods.
    Hyperbolic { root: T, x: T, w: T, sign: T, turned: T, quarters: T },
}

/// N for one w and ε, or its complex conjugate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shifted {
    coefficients: Coefficients,
    /// Additional phase of N, in quarter turns per quarter turn of z.
    bend: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Coefficients {
    /// Re N and Im N/sin 2z, as polynomials in C.
    Trigonometric { real: [f64; 5], imaginary: [f64; 4] },
    /// Coefficients of Wⁿ and of Xⁿ, for the real and the imaginary part. If `is_even`, √X
    /// multiplies both sums; otherwise X multiplies the second.
    Hyperbolic { rising: [[f64; 4]; 2], falling: [[f64; 4]; 2], is_even: bool },
}

/// Largest nome for which the trigonometric series with five terms has full precision. Q is then
/// below 0.014.
const BALANCE: f64 = 0.1;

/// Lower bound on the parameter m: smaller values are replaced by it. The nome is then negligible,
/// and K′ stays finite.
const LEAST: f64 = 1e-280;

impl Lattice {
    /// Computes the constants for a parameter below 1.
    pub(super) fn of(parameter: &EllipticParameter) -> Self {
        let [m, m1] = parameter.words();
        let m = if m.high > LEAST { m } else { Double::from(LEAST) };
        let complementary = EllipticParameter::of(m1, m);
        let ratio = complementary.quarter() / parameter.quarter();
        let nome = exp_minus(half_turn() * ratio);
        let series = if nome <= BALANCE {
            ThetaSeries::Trigonometric { nome }
        } else {
            let stretch = (quarter_turn() / ratio).value();
            ThetaSeries::Hyperbolic { nome: exp_minus(half_turn() / ratio), stretch }
        };
        Self { ratio, scale: quarter_turn() / parameter.quarter(), complementary, series }
    }

    /// Returns ½πt, the largest shift w.
    pub(super) fn largest_shift(&self) -> Double {
        self.ratio * quarter_turn()
    }

    /// Returns the shift w = π F(φ|m₁)/2K for tan φ = sin/cos, 0 ≤ φ ≤ ½π.
    pub(super) fn shift(&self, sin: Double, cos: Double) -> Double {
        let length = (sin.square() + cos.square()).sqrt();
        self.complementary.first(sin / length, cos / length) * self.scale
    }

    /// Returns N for a shift w, with ε = 1 if `is_even` and ε = −1 otherwise. `is_conjugate`
    /// selects the complex conjugate.
    pub(super) fn shifted(&self, w: Double, is_even: bool, is_conjugate: bool) -> Shifted {
        let sign = if is_conjugate { -1.0 } else { 1.0 };
        match self.series {
            ThetaSeries::Trigonometric { nome } => {
                let [s, r] = [w, self.largest_shift() - w].map(|w| exp_minus(w.scaled(2.0)));
                Shifted {
                    coefficients: trigonometric(nome, [s, r], if is_even { 1.0 } else { -1.0 }, sign),
                    bend: 0.0,
                }
            }
            ThetaSeries::Hyperbolic { nome, .. } => {
                let b = ((self.largest_shift() - w) / self.ratio / quarter_turn()).value();
                Shifted { coefficients: hyperbolic(nome, b, is_even, sign), bend: -sign * b }
            }
        }
    }

    /// Returns the functions of z that the series need.
    #[inline(always)]
    pub(super) fn place<T: Splat>(&self, z: Phase<T>) -> SeriesArgument<T> {
        match self.series {
            ThetaSeries::Trigonometric { .. } => {
                let (sin, cos) = sin_cos_quarters(z.quarters, z.rest);
                let product = cos * sin;
                SeriesArgument::Trigonometric {
                    cos,
                    sin,
                    c: T::splat(2.0) * (cos * cos - sin * sin),
                    s: product + product,
                }
            }
            ThetaSeries::Hyperbolic { nome, stretch } => {
                // z = ½π (x + 2N), |x| ≤ 1
                let is_odd = |quarters: f64| quarters.to_bits() & 1 == 1;
                let quarters = z.rest.zip(z.quarters, |rest, quarters| {
                    if is_odd(quarters) { rest - 1.0_f64.copysign(rest) } else { rest }
                });
                let turned = z.rest.zip(z.quarters, |rest, quarters| {
                    let is_turned =
                        (quarters.to_bits() & 2 == 2) ^ (is_odd(quarters) & rest.is_sign_positive());
                    if is_turned { -1.0 } else { 1.0 }
                });
                // Exponential from the nearer end of the period; the other one follows from X W =
                // Q.
                let (near, rise) = exp_both(T::splat(stretch) * z.rest.map(f64::abs));
                let far = T::splat(nome.sqrt()) * rise;
                let choose = |quarters: f64, a: f64, b: f64| if is_odd(quarters) { b } else { a };
                let (root, other) = (z.quarters.zip3(near, far, choose), z.quarters.zip3(far, near, choose));
                SeriesArgument::Hyperbolic {
                    root,
                    x: root * root,
                    w: other * other,
                    sign: quarters.map(|x| 1.0_f64.copysign(x)),
                    turned,
                    quarters,
                }
            }
        }
    }

    /// Returns e^2ikz.
    #[inline(always)]
    pub(super) fn power<T: Splat>(&self, place: &SeriesArgument<T>, k: i8) -> Complex<T> {
        let first = match *place {
            SeriesArgument::Trigonometric { c, s, .. } => Complex { re: T::splat(0.5) * c, im: s },
            SeriesArgument::Hyperbolic { quarters, .. } => unit_of_quarters(T::splat(2.0) * quarters),
        };
        let first = if k < 0 { first.conjugate() } else { first };
        if k.abs() > 1 { first.times(first) } else { first }
    }

    /// Returns θ₁, θ₂ and θ₃ of z up to constants. Divided by θ₄ they are proportional to sn, cn
    /// and dn.
    #[inline(always)]
    pub(super) fn numerators<T: Splat>(&self, place: &SeriesArgument<T>) -> [T; 3] {
        match (self.series, *place) {
            (ThetaSeries::Trigonometric { nome }, SeriesArgument::Trigonometric { cos, sin, c, .. }) => {
                let q2 = nome * nome;
                let (q6, q12) = (q2 * q2 * q2, q2 * q2 * q2 * q2 * q2 * q2);
                // Σ q^(n²+n) cos (2n+1)z / cos z; the same polynomial of −C is the sum of ±sin
                // (2n+1)z / sin z
                let odd = [1.0 - q2 - q6 + q12, q2 - q6 - 2.0 * q12, q6 - q12, q12];
                [sin * cubic(&odd, -c), cos * cubic(&odd, c), even_sum(nome, c)]
            }
            (
                ThetaSeries::Hyperbolic { nome, .. },
                SeriesArgument::Hyperbolic { root, x, w, sign, turned, .. },
            ) => {
                let q2 = nome * nome;
                let q6 = q2 * q2 * q2;
                // θ₄ and θ₃ of iy: 1 + Σ (∓1)ⁿ (Q^(n²−n) Wⁿ + Q^(n²) Xⁿ)
                let even = T::splat(1.0) + (T::splat(q2) * w * w + T::splat(q2 * q2) * x * x);
                let odd = cubic(&[0.0, 1.0, 0.0, q6], w) + T::splat(nome) * x;
                let turned_sign = turned * sign;
                [turned_sign * odd_sum(nome, x, w, -1.0), turned * root * (even - odd), root * (even + odd)]
            }
            _ => [T::splat(f64::NAN); 3],
        }
    }

    /// Returns the factors that turn their quotients by θ₄ into sn, cn and dn, from cn = dn = 1 at
    /// z = 0 and sn = 1 at ½π.
    pub(super) fn quotients(&self) -> [f64; 3] {
        let [zero, quarter] = [0.0, 1.0].map(|quarters| self.place(Phase::of((quarters, 0.0), None)));
        let [sn, ..] = self.numerators(&quarter);
        let [_, cn, dn] = self.numerators(&zero);
        let (at_zero, at_quarter) = (self.denominator(&zero), self.denominator(&quarter));
        [at_quarter / sn, at_zero / cn, at_zero / dn]
    }

    /// Returns θ₄(z), with the same constant and scale as N.
    #[inline(always)]
    pub(super) fn denominator<T: Splat>(&self, place: &SeriesArgument<T>) -> T {
        match (self.series, *place) {
            (ThetaSeries::Trigonometric { nome }, SeriesArgument::Trigonometric { c, .. }) => {
                even_sum(nome, -c)
            }
            (ThetaSeries::Hyperbolic { nome, .. }, SeriesArgument::Hyperbolic { x, w, .. }) => {
                odd_sum(nome, x, w, 1.0)
            }
            _ => T::splat(f64::NAN),
        }
    }
}

/// Returns cos ½πx + i sin ½πx for |x| < 2⁵¹.
#[inline(always)]
pub(super) fn unit_of_quarters<T: Splat>(x: T) -> Complex<T> {
    Phase::of((x, T::splat(0.0)), None).unit()
}

/// Returns the polynomials of N = 1 + Σ (fₙ Eⁿ + gₙ E⁻ⁿ), where fₙ = εⁿ q^(n²) rⁿ, gₙ = εⁿ q^(n²−n)
/// sⁿ and r = q/s.
fn trigonometric(q: f64, [s, r]: [f64; 2], epsilon: f64, sign: f64) -> Coefficients {
    let (mut sums, mut differences) = ([0.0; 4], [0.0; 4]);
    // εⁿ q^(n²−n), qⁿ, sⁿ, rⁿ
    let (mut power, mut qn, mut sn, mut rn) = (1.0, 1.0, 1.0, 1.0);
    for n in 0..4 {
        power *= epsilon * qn * qn;
        (qn, sn, rn) = (qn * q, sn * s, rn * r);
        let (f, g) = (power * qn * rn, power * sn);
        (sums[n], differences[n]) = (f + g, sign * (f - g));
    }
    let ([s1, s2, s3, s4], [d1, d2, d3, d4]) = (sums, differences);
    // cos 2z = ½C, cos 4z = ½C² − 1, cos 6z = ½C³ − 1½C, cos 8z = ½C⁴ − 2C² + 1; divided by sin 2z:
    // sin 4z → C, sin 6z → C² − 1, sin 8z → C³ − 2C
    Coefficients::Trigonometric {
        real: [1.0 - s2 + s4, 0.5 * s1 - 1.5 * s3, 0.5 * s2 - 2.0 * s4, 0.5 * s3, 0.5 * s4],
        imaginary: [d1 - d3, d2 - 2.0 * d4, d3, d4],
    }
}

/// Returns the coefficients of the series for y > 0, b in quarter turns. The series are those of θ
/// times e^−|y|:
///
/// θ₃ → √X (1 + Σ Q^(n²−n) Wⁿ e^2nib + Q^(n²) Xⁿ e^−2nib),
///
/// θ₂ → Σ Q^(n²) Wⁿ e^(2n+1)ib + Q^(n²+n) Xⁿ⁺¹ e^−(2n+1)ib
fn hyperbolic(q: f64, b: f64, is_even: bool, sign: f64) -> Coefficients {
    let first = if is_even { 0 } else { 1 };
    let (mut rising, mut falling) = ([[0.0; 4]; 2], [[0.0; 4]; 2]);
    for n in 0..4 {
        let angle = Phase::of((f64::from(2 * n + first) * b, 0.0), None);
        let (sin, cos) = sin_cos_quarters(angle.quarters, angle.rest);
        let [up, down] = match (is_even, n) {
            (true, 0) => [1.0, 0.0],
            (true, n) => [q.powi(n * n - n), q.powi(n * n)],
            (false, n) => [q.powi(n * n), q.powi(n * n + n)],
        };
        let k = n as usize;
        (rising[0][k], rising[1][k]) = (up * cos, sign * up * sin);
        (falling[0][k], falling[1][k]) = (down * cos, sign * down * sin);
    }
    Coefficients::Hyperbolic { rising, falling, is_even }
}

impl Shifted {
    /// Returns N(z) without its additional phase.
    #[inline(always)]
    pub(super) fn at<T: Splat>(&self, place: &SeriesArgument<T>) -> Complex<T> {
        match (&self.coefficients, *place) {
            (Coefficients::Trigonometric { real, imaginary }, SeriesArgument::Trigonometric { c, s, .. }) => {
                let c2 = c * c;
                Complex { re: cubic(real, c) + (c2 * c2) * T::splat(real[4]), im: s * cubic(imaginary, c) }
            }
            (
                Coefficients::Hyperbolic { rising, falling, is_even },
                SeriesArgument::Hyperbolic { root, x, w, sign, .. },
            ) => {
                let one = T::splat(1.0);
                let (all, second) = if *is_even { (root, one) } else { (one, x) };
                Complex {
                    re: all * (cubic(&rising[0], w) + second * cubic(&falling[0], x)),
                    im: (all * sign) * (cubic(&rising[1], w) - second * cubic(&falling[1], x)),
                }
            }
            _ => Complex { re: T::splat(f64::NAN), im: T::splat(f64::NAN) },
        }
    }

    /// Returns the additional phase of N at z, quarter turns.
    #[inline(always)]
    pub(super) fn bend_at<T: Splat>(&self, place: &SeriesArgument<T>) -> T {
        match *place {
            SeriesArgument::Trigonometric { .. } => T::splat(0.0),
            SeriesArgument::Hyperbolic { quarters, .. } => T::splat(self.bend) * quarters,
        }
    }
}

/// Returns the sum of the first four terms of a polynomial.
#[inline(always)]
fn cubic<T: Splat, const N: usize>(c: &[f64; N], x: T) -> T {
    (T::splat(c[0]) + T::splat(c[1]) * x) + (x * x) * (T::splat(c[2]) + T::splat(c[3]) * x)
}

/// Returns 1 + 2 Σ q^(n²) cos 2nz: θ₃ for C = 2 cos 2z, θ₄ for −C.
#[inline(always)]
fn even_sum<T: Splat>(q: f64, c: T) -> T {
    let q4 = (q * q) * (q * q);
    let [a, b, d] = [q4, q4 * q4 * q, (q4 * q4) * (q4 * q4)];
    let coefficients = [1.0 - 2.0 * (a - d), q - 3.0 * b, a - 4.0 * d, b];
    let c2 = c * c;
    cubic(&coefficients, c) + (c2 * c2) * T::splat(d)
}

/// Returns Σ (±1)ⁿ (Q^(n²) Wⁿ ± Q^(n²+n) Xⁿ⁺¹): θ₂ or θ₁ of iy, times e^−|y|.
#[inline(always)]
fn odd_sum<T: Splat>(q: f64, x: T, w: T, sign: f64) -> T {
    let q4 = (q * q) * (q * q);
    let rising = [1.0, sign * q, q4, 0.0];
    let falling = [sign, q * q, sign * q4 * q * q, 0.0];
    cubic(&rising, w) + x * cubic(&falling, x)
}

/// Returns e^−x for x ≥ 0.
fn exp_minus(x: Double) -> f64 {
    libm::exp(-x.high) * (1.0 - x.low)
}

fn quarter_turn() -> Double {
    Double::TAU.scaled(0.25)
}

fn half_turn() -> Double {
    Double::TAU.scaled(0.5)
}
