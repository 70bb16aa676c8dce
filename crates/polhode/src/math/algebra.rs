//! Numbers and vectors as abstract operations.
//!
//! A law written with these operations can be evaluated (f64), recognised as a polynomial, or
//! recorded as a graph from which Taylor coefficients are computed: see `motion/model/law.rs`.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::formula::{Binary, Unary};
use super::number::Number;
use super::vector::{Direction, Vector};

/// Number, or a representation of one: an expression or a polynomial.
pub trait Scalar:
    Copy + Neg<Output = Self> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Returns the product with a constant.
    #[must_use]
    fn scaled(self, by: f64) -> Self;

    /// Returns a function of this number.
    #[must_use]
    fn unary(self, function: Unary) -> Self;

    /// Returns a function of this number and another one; constant exponents are recognised.
    #[must_use]
    fn binary(self, function: Binary, b: Self) -> Self;

    /// Returns selfᵖ for a constant p.
    #[must_use]
    fn power(self, p: f64) -> Self;

    /// Returns selfᵖ − (self + δ)ᵖ for a constant p, with the relative precision of δ.
    #[must_use]
    fn power_difference(self, delta: Self, p: f64) -> Self;

    /// Returns self/d, or zero if d is zero.
    #[must_use]
    fn over_or_zero(self, d: Self) -> Self;

    /// Returns an angle reduced to −π … π, rad.
    #[must_use]
    fn wrapped(self) -> Self;

    /// Returns arccos w/√(1 − w²) for w = self > −1: half an angle divided by its sine, smooth at
    /// w = 1.
    #[must_use]
    fn half_angle_over_sine(self) -> Self;

    /// Returns √self.
    #[must_use]
    fn sqrt(self) -> Self {
        self.unary(Unary::Sqrt)
    }

    /// Returns the angle of the point (x, self) from the first axis, rad.
    #[must_use]
    fn atan2(self, x: Self) -> Self {
        self.binary(Binary::Atan2, x)
    }
}

/// Field with square roots: the operations that vectors and polynomials need.
pub(crate) trait Field:
    Copy + Neg<Output = Self> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Returns the product with a constant.
    fn times(self, constant: f64) -> Self;

    /// Returns √self.
    fn root(self) -> Self;

    /// Returns self + by · x.
    #[inline(always)]
    fn plus_multiple(self, x: Self, by: f64) -> Self {
        self + x.times(by)
    }

    /// Returns Σ aₖ bₖ.
    #[inline(always)]
    fn sum_of_products([ax, ay, az]: [Self; 3], [bx, by, bz]: [Self; 3]) -> Self {
        ax * bx + ay * by + az * bz
    }

    /// Returns a b − c d.
    #[inline(always)]
    fn difference_of_products([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        a * b - c * d
    }
}

impl<S: Scalar> Field for S {
    #[inline(always)]
    fn times(self, constant: f64) -> Self {
        self.scaled(constant)
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

/// SIMD lanes as a [`Field`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Side<N>(pub(crate) N);

impl<N: Number> Neg for Side<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<N: Number> Add for Side<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self(self.0 + b.0)
    }
}

impl<N: Number> Sub for Side<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Self(self.0 - b.0)
    }
}

impl<N: Number> Mul for Side<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Self(self.0 * b.0)
    }
}

impl<N: Number> Div for Side<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, b: Self) -> Self {
        Self(self.0 / b.0)
    }
}

impl<N: Number> Field for Side<N> {
    #[inline(always)]
    fn times(self, constant: f64) -> Self {
        Self(self.0 * self.0.like(constant))
    }

    #[inline(always)]
    fn root(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline(always)]
    fn plus_multiple(self, x: Self, by: f64) -> Self {
        Self(x.0.mul_add(x.0.like(by), self.0))
    }

    #[inline(always)]
    fn sum_of_products([ax, ay, az]: [Self; 3], [bx, by, bz]: [Self; 3]) -> Self {
        Self(az.0.mul_add(bz.0, ay.0.mul_add(by.0, ax.0 * bx.0)))
    }

    #[inline(always)]
    fn difference_of_products([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        Self(a.0.mul_add(b.0, -(c.0 * d.0)))
    }
}

/// Vector along body axes with such numbers as components.
pub trait VectorAlgebra<S>:
    Copy + Neg<Output = Self> + Add<Output = Self> + Sub<Output = Self> + Mul<S, Output = Self>
{
    /// Returns the product with a constant.
    #[must_use]
    fn scaled(self, by: f64) -> Self;

    /// Returns self · b.
    #[must_use]
    fn dot(self, b: Self) -> S;

    /// Returns self × b.
    #[must_use]
    fn cross(self, b: Self) -> Self;

    /// Returns |self|.
    #[must_use]
    fn norm(self) -> S;
}

impl Scalar for f64 {
    fn scaled(self, by: f64) -> Self {
        self * by
    }

    fn unary(self, function: Unary) -> Self {
        function.of(self)
    }

    fn binary(self, function: Binary, b: Self) -> Self {
        function.of(self, b)
    }

    fn power(self, p: f64) -> Self {
        libm::pow(self, p)
    }

    fn power_difference(self, delta: Self, p: f64) -> Self {
        -self.power(p) * libm::expm1(p * libm::log1p(delta / self))
    }

    fn over_or_zero(self, d: Self) -> Self {
        if d == 0.0 { 0.0 } else { self / d }
    }

    fn wrapped(self) -> Self {
        super::rotation::wrap(self)
    }

    fn half_angle_over_sine(self) -> Self {
        let sine = ((1.0 - self) * (1.0 + self)).max(0.0).sqrt();
        if sine == 0.0 { 1.0 } else { libm::atan2(sine, self) / sine }
    }
}

/// Vector of three numbers of any kind. Its components are written one by one, because closures
/// over arrays are not compiled to SIMD instructions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Components<S>(pub(crate) [S; 3]);

impl<S: Field> Components<S> {
    #[inline(always)]
    fn each(self, b: Self, f: impl Fn(S, S) -> S) -> Self {
        let ([ax, ay, az], [bx, by, bz]) = (self.0, b.0);
        Self([f(ax, bx), f(ay, by), f(az, bz)])
    }

    #[inline(always)]
    pub(crate) fn scaled(self, by: f64) -> Self {
        let [x, y, z] = self.0;
        Self([x.times(by), y.times(by), z.times(by)])
    }

    /// Returns M self for a constant matrix M, given by its rows.
    #[inline(always)]
    pub(crate) fn image(self, rows: &[[f64; 3]; 3]) -> Self {
        let ([x, y, z], [a, b, c]) = (self.0, rows);
        Self([
            x.times(a[0]).plus_multiple(y, a[1]).plus_multiple(z, a[2]),
            x.times(b[0]).plus_multiple(y, b[1]).plus_multiple(z, b[2]),
            x.times(c[0]).plus_multiple(y, c[1]).plus_multiple(z, c[2]),
        ])
    }

    #[inline(always)]
    pub(crate) fn dot(self, b: Self) -> S {
        S::sum_of_products(self.0, b.0)
    }

    #[inline(always)]
    pub(crate) fn cross(self, b: Self) -> Self {
        let ([ax, ay, az], [bx, by, bz]) = (self.0, b.0);
        Self([
            S::difference_of_products([ay, bz], [az, by]),
            S::difference_of_products([az, bx], [ax, bz]),
            S::difference_of_products([ax, by], [ay, bx]),
        ])
    }
}

impl<S: Field> Neg for Components<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let [x, y, z] = self.0;
        Self([-x, -y, -z])
    }
}

impl<S: Field> Add for Components<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        self.each(b, |a, b| a + b)
    }
}

impl<S: Field> Sub for Components<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        self.each(b, |a, b| a - b)
    }
}

impl<S: Field> Mul<S> for Components<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: S) -> Self {
        let [x, y, z] = self.0;
        Self([x * b, y * b, z * b])
    }
}

impl<S: Scalar> VectorAlgebra<S> for Components<S> {
    fn scaled(self, by: f64) -> Self {
        Self::scaled(self, by)
    }

    fn dot(self, b: Self) -> S {
        Self::dot(self, b)
    }

    fn cross(self, b: Self) -> Self {
        Self::cross(self, b)
    }

    fn norm(self) -> S {
        let [x, y, z] = self.0;
        x.binary(Binary::Hypot, y).binary(Binary::Hypot, z)
    }
}

impl<F> VectorAlgebra<f64> for Direction<F> {
    fn scaled(self, by: f64) -> Self {
        self * by
    }

    fn dot(self, b: Self) -> f64 {
        Vector::dot(self, b)
    }

    fn cross(self, b: Self) -> Self {
        Vector::cross(self, b)
    }

    fn norm(self) -> f64 {
        Vector::norm(self)
    }
}
