//! Laws that are polynomials: detection of linear and quadratic torques, and their coefficients.
//!
//! A law evaluated over these numbers shows if it is a polynomial of degree at most two in ω and in
//! one vector u, along the principal axes. u is fixed in space, or it is the direction to the
//! attracting mass on a circular orbit. Both have series with a few products
//! (`propagate/taylor/recurrence.rs`), so such torques need no graph.

use core::cell::RefCell;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::algebra::{Components, Scalar};
use crate::math::formula::{Binary, Unary};
use crate::math::frame::{Body, Principal, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Direction;
use crate::motion::model::law::{LawInput, OrbitPosition};
use crate::motion::model::orbit::Orbit;
use crate::motion::model::rotor::Rotor;

/// The vector u.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::motion) enum JointVector {
    /// Vector fixed in space.
    Fixed(Direction<Space>),
    /// r/r₀ on a circular orbit.
    Circular(Orbit),
}

/// State as unknowns of polynomials, along principal axes.
#[derive(Debug)]
pub(in crate::motion) struct Unknowns<'a> {
    rotor: &'a Rotor,
    to_principal: Rotation<Principal, Body>,
    /// True if u may be on a circular orbit.
    with_orbit: bool,
    /// u, once a law has used one.
    joint: RefCell<Option<JointVector>>,
}

/// Number of unknowns: ω1 ω2 ω3 u1 u2 u3.
const UNKNOWNS: usize = 6;

/// Polynomial of degree at most two; `None` if the value is not one.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct Polynomial(Option<Terms>);

/// Terms c + Σ lₖ xₖ + q₁ u₂ u₃ + q₂ u₃ u₁ + q₃ u₁ u₂ + other products of two unknowns.
#[derive(Clone, Copy, Debug)]
struct Terms {
    /// Degree of the expression, independent of the coefficients. It is therefore the same for all
    /// bodies with the same laws.
    degree: u8,
    /// True if ω occurs.
    of_omega: bool,
    constant: f64,
    linear: [f64; UNKNOWNS],
    /// Coefficients q of the products.
    products: [f64; 3],
    /// True if other products occur.
    has_others: bool,
}

impl Terms {
    const fn constant(constant: f64) -> Self {
        let (linear, products) = ([0.0; UNKNOWNS], [0.0; 3]);
        Self { degree: 0, of_omega: false, constant, linear, products, has_others: false }
    }

    fn zip(mut self, b: &Self, f: impl Fn(f64, f64) -> f64) -> Self {
        self.degree = self.degree.max(b.degree);
        self.of_omega |= b.of_omega;
        self.has_others |= b.has_others;
        self.constant = f(self.constant, b.constant);
        if self.degree > 0 {
            self.linear.iter_mut().zip(b.linear).for_each(|(a, b)| *a = f(*a, b));
        }
        if self.degree > 1 {
            self.products.iter_mut().zip(b.products).for_each(|(a, b)| *a = f(*a, b));
        }
        self
    }

    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        self.zip(&self, |a, _| f(a))
    }

    fn times(&self, b: &Self) -> Option<Self> {
        if self.degree == 0 {
            return Some(b.map(|x| self.constant * x));
        }
        if b.degree == 0 {
            return Some(self.map(|x| x * b.constant));
        }
        if self.degree + b.degree > 2 {
            return None;
        }
        let mut product = self.map(|x| x * b.constant);
        product.linear.iter_mut().zip(b.linear).for_each(|(a, b)| *a += self.constant * b);
        for (j, &x) in self.linear.iter().enumerate() {
            for (k, &y) in b.linear.iter().enumerate().filter(|(_, y)| x != 0.0 && **y != 0.0) {
                if j >= 3 && k >= 3 && j != k {
                    // The third axis: the indices satisfy 3 + 4 + 5 = 12.
                    product.products[12 - j - k - 3] += x * y;
                } else {
                    product.has_others = true;
                }
            }
        }
        product.degree = 2;
        product.of_omega |= b.of_omega;
        Some(product)
    }
}

impl Polynomial {
    const NONE: Self = Self(None);

    const fn constant(x: f64) -> Self {
        Self(Some(Terms::constant(x)))
    }

    fn unknown(k: usize) -> Self {
        let mut terms = Terms::constant(0.0);
        terms.degree = 1;
        terms.of_omega = k < 3;
        terms.linear[k] = 1.0;
        Self(Some(terms))
    }

    fn both(self, b: Self, f: impl Fn(&Terms, &Terms) -> Option<Terms>) -> Self {
        Self(self.0.zip(b.0).and_then(|(a, b)| f(&a, &b)))
    }

    /// Returns the value if the polynomial is a constant.
    fn value(self) -> Option<f64> {
        self.0.filter(|terms| terms.degree == 0).map(|terms| terms.constant)
    }
}

impl Neg for Polynomial {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|a| a.map(|x| -x)))
    }
}

impl Add for Polynomial {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        self.both(b, |a, b| Some(a.zip(b, |x, y| x + y)))
    }
}

impl Sub for Polynomial {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self.both(b, |a, b| Some(a.zip(b, |x, y| x - y)))
    }
}

impl Mul for Polynomial {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        self.both(b, Terms::times)
    }
}

impl Div for Polynomial {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        b.value().map_or(Self::NONE, |by| Self(self.0.map(|a| a.map(|x| x / by))))
    }
}

impl Scalar for Polynomial {
    fn scaled(self, by: f64) -> Self {
        Self(self.0.map(|a| a.map(|x| x * by)))
    }

    fn unary(self, function: Unary) -> Self {
        match (self.value(), function) {
            (Some(x), _) => Self::constant(function.of(x)),
            (None, Unary::Negate) => -self,
            (None, Unary::Power(1)) => self,
            (None, Unary::Power(2)) => self * self,
            _ => Self::NONE,
        }
    }

    fn binary(self, function: Binary, b: Self) -> Self {
        match (self.value(), b.value(), function) {
            (Some(x), Some(y), _) => Self::constant(function.of(x, y)),
            (_, _, Binary::Add) => self + b,
            (_, _, Binary::Subtract) => self - b,
            (_, _, Binary::Multiply) => self * b,
            (_, _, Binary::Divide) => self / b,
            (_, Some(p), Binary::Power) => self.power(p),
            _ => Self::NONE,
        }
    }

    fn power(self, p: f64) -> Self {
        match self.value() {
            Some(x) => Self::constant(x.power(p)),
            None if p == 1.0 => self,
            None if p == 2.0 => self * self,
            None => Self::NONE,
        }
    }

    fn power_difference(self, delta: Self, p: f64) -> Self {
        match (self.value(), delta.value()) {
            (Some(x), Some(delta)) => Self::constant(x.power_difference(delta, p)),
            _ => Self::NONE,
        }
    }

    fn over_or_zero(self, d: Self) -> Self {
        if d.value() == Some(0.0) { Self::constant(0.0) } else { self / d }
    }

    fn wrapped(self) -> Self {
        self.value().map_or(Self::NONE, |x| Self::constant(x.wrapped()))
    }

    fn half_angle_over_sine(self) -> Self {
        self.value().map_or(Self::NONE, |x| Self::constant(x.half_angle_over_sine()))
    }
}

/// Vector of polynomials, along principal axes.
pub(in crate::motion) type PolynomialVector = Components<Polynomial>;

impl PolynomialVector {
    pub(super) const NONE: Self = Self([Polynomial::NONE; 3]);

    fn unknown(first: usize) -> Self {
        Self([0, 1, 2].map(|k| Polynomial::unknown(first + k)))
    }

    fn constant(v: Direction<Principal>) -> Self {
        Self(v.to_array().map(Polynomial::constant))
    }
}

impl<'a> Unknowns<'a> {
    pub(in crate::motion) fn new(rotor: &'a Rotor, with_orbit: bool) -> Self {
        let to_principal = rotor.principal().rotation().inverse();
        Self { rotor, to_principal, with_orbit, joint: RefCell::new(None) }
    }

    /// Returns u, if a law used one.
    pub(in crate::motion) fn into_joint(self) -> Option<JointVector> {
        self.joint.into_inner()
    }

    pub(in crate::motion) fn has_joint(&self) -> bool {
        self.joint.borrow().is_some()
    }

    /// True if u is this vector or not yet set.
    pub(in crate::motion) fn may_be_joint(&self, v: Direction<Space>) -> bool {
        self.joint.borrow().as_ref().is_none_or(|joint| *joint == JointVector::Fixed(v))
    }

    /// True if u is on a circular orbit.
    pub(in crate::motion) fn is_on_orbit(&self) -> bool {
        matches!(*self.joint.borrow(), Some(JointVector::Circular(_)))
    }

    /// Discards the u that a law without this form has set.
    pub(in crate::motion) fn forget_joint(&self) {
        *self.joint.borrow_mut() = None;
    }

    /// Returns u if it is this vector or not yet set.
    fn as_joint(&self, wanted: &JointVector) -> PolynomialVector {
        let mut joint = self.joint.borrow_mut();
        if joint.get_or_insert_with(|| wanted.clone()) == wanted {
            PolynomialVector::unknown(3)
        } else {
            PolynomialVector::NONE
        }
    }
}

impl LawInput for Unknowns<'_> {
    type Scalar = Polynomial;
    type Vector = PolynomialVector;

    fn rotor(&self) -> &Rotor {
        self.rotor
    }

    fn number(&self, x: f64) -> Polynomial {
        Polynomial::constant(x)
    }

    fn in_body(&self, v: Direction<Body>) -> PolynomialVector {
        PolynomialVector::constant(self.to_principal * v)
    }

    fn in_space(&self, v: Direction<Space>) -> PolynomialVector {
        self.as_joint(&JointVector::Fixed(v))
    }

    fn time(&self) -> Polynomial {
        Polynomial::NONE
    }

    fn omega(&self) -> PolynomialVector {
        PolynomialVector::unknown(0)
    }

    fn attitude(&self) -> (Polynomial, PolynomialVector) {
        (Polynomial::NONE, PolynomialVector::NONE)
    }

    fn turn_from(&self, _: Attitude) -> (Polynomial, PolynomialVector) {
        self.attitude()
    }

    fn wheel_momentum(&self) -> PolynomialVector {
        match self.rotor.wheels() {
            [] => PolynomialVector::constant(Direction::ZERO),
            _ => PolynomialVector::NONE,
        }
    }

    fn orbit(&self, orbit: &Orbit) -> OrbitPosition<Polynomial, PolynomialVector> {
        if !(self.with_orbit && orbit.is_circular()) {
            let (none, direction) = (Polynomial::NONE, PolynomialVector::NONE);
            let (square, inverse_cube, distance, strength) = (none, none, none, none);
            return OrbitPosition { direction, square, inverse_cube, distance, strength };
        }
        OrbitPosition {
            direction: self.as_joint(&JointVector::Circular(orbit.clone())),
            square: Polynomial::constant(1.0),
            inverse_cube: Polynomial::constant(1.0),
            distance: Polynomial::constant(orbit.periapsis()),
            strength: Polynomial::constant(orbit.strength(orbit.periapsis())),
        }
    }

    fn inertia(&self, v: PolynomialVector) -> PolynomialVector {
        let ([x, y, z], [i1, i2, i3]) = (v.0, self.rotor.principal().moments());
        Components([x.scaled(i1), y.scaled(i2), z.scaled(i3)])
    }

    fn symmetric(&self, elements: [f64; 6], v: PolynomialVector) -> PolynomialVector {
        v.image(&Symmetric3::from_elements(elements).rotated(&self.to_principal.matrix()).rows())
    }

    fn components(&self, v: PolynomialVector) -> [Polynomial; 3] {
        v.image(&self.to_principal.inverse().matrix()).0
    }

    fn vector(&self, components: [Polynomial; 3]) -> PolynomialVector {
        Components(components).image(&self.to_principal.matrix())
    }
}

/// Torque N = c + A u + B ω + (g₁ u₂ u₃, g₂ u₃ u₁, g₃ u₁ u₂), principal axes.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::motion) struct QuadraticTorque {
    pub(in crate::motion) constant: [f64; 3],
    /// Columns of A.
    pub(in crate::motion) of_joint: [[f64; 3]; 3],
    /// Columns of B, and true if ω occurs.
    pub(in crate::motion) of_omega: [[f64; 3]; 3],
    pub(in crate::motion) has_omega: bool,
    /// Coefficients g of the products.
    pub(in crate::motion) products: [f64; 3],
}

impl QuadraticTorque {
    /// Returns the sum of two torques.
    pub(in crate::motion) fn plus(mut self, b: &Self) -> Self {
        let add = |a: &mut [f64; 3], b: &[f64; 3]| a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
        add(&mut self.constant, &b.constant);
        add(&mut self.products, &b.products);
        self.of_joint.iter_mut().zip(&b.of_joint).for_each(|(a, b)| add(a, b));
        self.of_omega.iter_mut().zip(&b.of_omega).for_each(|(a, b)| add(a, b));
        self.has_omega |= b.has_omega;
        self
    }

    /// Returns the coefficients of a polynomial torque, if it has this form.
    pub(in crate::motion) fn of(torque: &PolynomialVector) -> Option<Self> {
        let mut quadratic = Self::default();
        for (row, component) in torque.0.iter().enumerate() {
            let terms = component.0?;
            quadratic.constant[row] = terms.constant;
            quadratic.has_omega |= terms.of_omega;
            for column in 0..3 {
                quadratic.of_omega[column][row] = terms.linear[column];
                quadratic.of_joint[column][row] = terms.linear[3 + column];
            }
            quadratic.products[row] = terms.products[row];
            let is_other = |axis: usize| axis != row && terms.products[axis] != 0.0;
            if terms.has_others || (0..3).any(is_other) {
                return None;
            }
        }
        let is_finite = |rows: &[[f64; 3]]| rows.as_flattened().iter().all(|x| x.is_finite());
        let Self { constant, of_joint, of_omega, products, .. } = &quadratic;
        (is_finite(&[*constant, *products]) && is_finite(of_joint) && is_finite(of_omega))
            .then_some(quadratic)
    }
}
