//! Vectors whose types state their quantity and frame.

use core::fmt;
use core::marker::PhantomData;
use core::ops::{Add, AddAssign, Div, Index, Mul, Neg, Sub, SubAssign};

/// Vector of a quantity `Q` along the axes of a frame `F`, in SI units.
///
/// Sums require the same quantity and the same frame; a cross product has the quantity that follows
/// from physics (`AngularVelocity × Position = Velocity`). Anything else does not compile:
///
/// ```compile_fail,E0308
/// use polhode::math::{Body, Position, Space};
/// let a = Position::<Space>::new(1.0, 0.0, 0.0);
/// let b = Position::<Body>::new(0.0, 1.0, 0.0);
/// let c = a + b; // two frames
/// ```
///
/// ```compile_fail
/// use polhode::math::{AngularMomentum, Space, Torque};
/// let l = AngularMomentum::<Space>::new(1.0, 0.0, 0.0);
/// let n = Torque::<Space>::new(0.0, 1.0, 0.0);
/// let c = l + n; // two quantities
/// ```
pub struct Vector<Q, F> {
    /// Component along the first axis.
    pub x: f64,
    /// Component along the second axis.
    pub y: f64,
    /// Component along the third axis.
    pub z: f64,
    kind: PhantomData<(Q, F)>,
}

impl<Q, F> Vector<Q, F> {
    /// Zero vector.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);

    /// Returns the vector with the given components.
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z, kind: PhantomData }
    }

    /// Returns the vector with the given components, in the order x, y, z.
    pub const fn from_array([x, y, z]: [f64; 3]) -> Self {
        Self::new(x, y, z)
    }

    /// Returns the components in the order x, y, z.
    pub const fn to_array(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }

    /// Returns the scalar product `a · b`; the two may be different quantities (`ω · L`).
    pub fn dot<P>(self, b: Vector<P, F>) -> f64 {
        self.x * b.x + self.y * b.y + self.z * b.z
    }

    /// Returns the vector product `a × b`, for the pairs of quantities that occur in physics.
    ///
    /// ```
    /// use polhode::math::{AngularVelocity, Body, Position, Velocity};
    /// let omega = AngularVelocity::<Body>::new(0.0, 0.0, 2.0);
    /// let r = Position::<Body>::new(1.5, -0.5, 4.0);
    /// assert_eq!(omega.cross(r), Velocity::new(1.0, 3.0, 0.0));
    /// ```
    pub fn cross<P>(self, b: Vector<P, F>) -> Vector<Q::Output, F>
    where
        Q: CrossProduct<P>,
    {
        Vector::new(self.y * b.z - self.z * b.y, self.z * b.x - self.x * b.z, self.x * b.y - self.y * b.x)
    }

    /// Returns the magnitude, without intermediate overflow or underflow.
    pub fn norm(self) -> f64 {
        let scale = self.max_abs();
        if scale == 0.0 || !scale.is_finite() {
            return scale;
        }
        let [x, y, z] = [self.x / scale, self.y / scale, self.z / scale];
        scale * (x * x + y * y + z * z).sqrt()
    }

    /// Returns the largest absolute component; NaN if any component is NaN.
    pub fn max_abs(self) -> f64 {
        let larger = |a: f64, b: f64| if a >= b || a.is_nan() { a } else { b };
        larger(larger(self.x.abs(), self.y.abs()), self.z.abs())
    }

    /// Returns the unit vector along this one; `None` for the zero vector and for one that is not
    /// finite.
    pub fn direction(self) -> Option<Direction<F>> {
        let scale = self.max_abs();
        if scale == 0.0 || !scale.is_finite() {
            return None;
        }
        let [x, y, z] = [self.x / scale, self.y / scale, self.z / scale];
        let norm = (x * x + y * y + z * z).sqrt();
        Some(Vector::new(x / norm, y / norm, z / norm))
    }

    /// Returns the angle between two vectors, 0 … π rad, accurate for nearly (anti)parallel ones;
    /// zero if either is zero.
    pub fn angle_to<P>(self, b: Vector<P, F>) -> f64 {
        match (self.direction(), b.direction()) {
            // Kahan's formula 2 atan2(|u − v|, |u + v|).
            (Some(u), Some(v)) => 2.0 * libm::atan2((u - v).norm(), (u + v).norm()),
            _ => 0.0,
        }
    }

    /// Returns true if all three components are finite.
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }

    /// Returns the same numbers as another quantity, for relations that the type system does not
    /// express (mass times velocity is momentum).
    pub(crate) const fn as_quantity<P>(self) -> Vector<P, F> {
        Vector::new(self.x, self.y, self.z)
    }

    /// Returns the same numbers along other axes, for shapes whose axes coincide by definition.
    pub(crate) const fn as_frame<G>(self) -> Vector<Q, G> {
        Vector::new(self.x, self.y, self.z)
    }
}

impl<Q, F> Add for Vector<Q, F> {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self::new(self.x + b.x, self.y + b.y, self.z + b.z)
    }
}

impl<Q, F> Sub for Vector<Q, F> {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Self::new(self.x - b.x, self.y - b.y, self.z - b.z)
    }
}

impl<Q, F> AddAssign for Vector<Q, F> {
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl<Q, F> SubAssign for Vector<Q, F> {
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}

impl<Q, F> Neg for Vector<Q, F> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<Q, F> Mul<f64> for Vector<Q, F> {
    type Output = Self;
    fn mul(self, s: f64) -> Self {
        Self::new(self.x * s, self.y * s, self.z * s)
    }
}

impl<Q, F> Mul<Vector<Q, F>> for f64 {
    type Output = Vector<Q, F>;
    fn mul(self, v: Vector<Q, F>) -> Vector<Q, F> {
        v * self
    }
}

impl<Q, F> Div<f64> for Vector<Q, F> {
    type Output = Self;
    fn div(self, s: f64) -> Self {
        Self::new(self.x / s, self.y / s, self.z / s)
    }
}

// Implemented by hand, because a derive would add bounds on Q and F.
impl<Q, F> Clone for Vector<Q, F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Q, F> Copy for Vector<Q, F> {}

impl<Q, F> PartialEq for Vector<Q, F> {
    fn eq(&self, b: &Self) -> bool {
        self.to_array() == b.to_array()
    }
}

impl<Q, F> From<[f64; 3]> for Vector<Q, F> {
    fn from(components: [f64; 3]) -> Self {
        Self::from_array(components)
    }
}

impl<Q, F> From<Vector<Q, F>> for [f64; 3] {
    fn from(v: Vector<Q, F>) -> Self {
        v.to_array()
    }
}

impl<Q, F> core::iter::Sum for Vector<Q, F> {
    fn sum<I: Iterator<Item = Self>>(vectors: I) -> Self {
        vectors.fold(Self::ZERO, |sum, v| sum + v)
    }
}

/// Components (x, y, z) with the unit; the precision applies to each number.
///
/// ```
/// use polhode::math::{AngularVelocity, Body, Torque};
/// assert_eq!(AngularVelocity::<Body>::new(0.25, -3.0, 1.0).to_string(), "(0.25, -3, 1) rad/s");
/// assert_eq!(format!("{:.2}", Torque::<Body>::new(0.0, 2e-9, 12.3456)), "(0.00, 2.00e-9, 12.35) N·m");
/// ```
impl<Q: quantity::Quantity, F> fmt::Display for Vector<Q, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        super::display::row(f, &self.to_array())?;
        if Q::UNIT.is_empty() { Ok(()) } else { write!(f, " {}", Q::UNIT) }
    }
}

/// Component by its index 0, 1 or 2.
///
/// # Panics
/// Panics like an array if the index exceeds 2.
impl<Q, F> Index<usize> for Vector<Q, F> {
    type Output = f64;

    fn index(&self, component: usize) -> &f64 {
        [&self.x, &self.y, &self.z][component]
    }
}

impl<Q, F> fmt::Debug for Vector<Q, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?}, {:?}, {:?})", self.x, self.y, self.z)
    }
}

/// Quantity of the cross product `Self × P`.
pub trait CrossProduct<P> {
    /// Quantity of the product.
    type Output;
}

/// Quantities of a [`Vector`].
pub mod quantity {
    /// Quantity with the unit of its components.
    pub trait Quantity {
        /// SI unit; empty for pure numbers.
        const UNIT: &'static str;
    }

    macro_rules! quantities {
        ($($(#[$doc:meta])* $name:ident: $unit:literal;)*) => {$(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
            pub enum $name {}

            impl Quantity for $name {
                const UNIT: &'static str = $unit;
            }
        )*};
    }

    quantities! {
        /// Pure direction or ratio, unit 1.
        Number: "";
        /// Displacement, m.
        Length: "m";
        /// Velocity dr/dt, m/s.
        Velocity: "m/s";
        /// Acceleration d²r/dt², m/s².
        Acceleration: "m/s²";
        /// Linear momentum m v, kg·m/s.
        Momentum: "kg·m/s";
        /// Force m a, N.
        Force: "N";
        /// Angular velocity ω, rad/s.
        AngularVelocity: "rad/s";
        /// Angular acceleration dω/dt, rad/s².
        AngularAcceleration: "rad/s²";
        /// Angular momentum L = I ω, kg·m²/s.
        AngularMomentum: "kg·m²/s";
        /// Torque N = dL/dt, N·m.
        Torque: "N·m";
    }
}

macro_rules! cross_products {
    ($($a:ident * $b:ident = $c:ident;)*) => {$(
        impl CrossProduct<quantity::$b> for quantity::$a {
            type Output = quantity::$c;
        }
    )*};
}

cross_products! {
    Number * Number = Number;
    Number * Length = Length;
    Length * Number = Length;
    AngularVelocity * Number = AngularVelocity;
    AngularVelocity * Length = Velocity;
    AngularVelocity * Velocity = Acceleration;
    AngularAcceleration * Length = Acceleration;
    AngularVelocity * AngularVelocity = AngularAcceleration;
    AngularVelocity * AngularMomentum = Torque;
    AngularMomentum * AngularVelocity = Torque;
    Length * Momentum = AngularMomentum;
    Length * Force = Torque;
}

/// Unit vector or vector of ratios.
pub type Direction<F> = Vector<quantity::Number, F>;
/// Displacement from the frame's origin, m.
pub type Position<F> = Vector<quantity::Length, F>;
/// Velocity dr/dt, m/s.
pub type Velocity<F> = Vector<quantity::Velocity, F>;
/// Acceleration d²r/dt², m/s².
pub type Acceleration<F> = Vector<quantity::Acceleration, F>;
/// Linear momentum m v, kg·m/s.
pub type Momentum<F> = Vector<quantity::Momentum, F>;
/// Force m a, N.
pub type Force<F> = Vector<quantity::Force, F>;
/// Angular velocity ω of the body relative to space, rad/s.
pub type AngularVelocity<F> = Vector<quantity::AngularVelocity, F>;
/// Angular acceleration dω/dt, rad/s².
pub type AngularAcceleration<F> = Vector<quantity::AngularAcceleration, F>;
/// Angular momentum L = I ω, kg·m²/s.
pub type AngularMomentum<F> = Vector<quantity::AngularMomentum, F>;
/// Torque N = dL/dt, N·m.
pub type Torque<F> = Vector<quantity::Torque, F>;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::frame::Body;

    #[test]
    fn norm_and_direction_survive_extreme_scales() {
        for scale in [1e-300, 1e-160, 1.0, 1e160, 1e300] {
            let v = Position::<Body>::new(2.0 * scale, -3.0 * scale, 6.0 * scale);
            assert!((v.norm() / (7.0 * scale) - 1.0).abs() < 4e-16);
            let u = v.direction().unwrap();
            assert!((u - Direction::new(2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0)).norm() < 4e-16);
        }
        assert_eq!(Position::<Body>::ZERO.direction(), None);
        assert_eq!(Position::<Body>::new(f64::NAN, 1.0, 0.0).direction(), None);
        assert_eq!(Position::<Body>::new(1.0, f64::INFINITY, 0.0).direction(), None);
    }

    #[test]
    fn angle_keeps_its_digits_near_zero_and_pi() {
        let a = Direction::<Body>::new(1.0, 0.0, 0.0);
        for tiny in [1e-3, 1e-9, 1e-15] {
            let b = Direction::<Body>::new(libm::cos(tiny), libm::sin(tiny), 0.0);
            assert!((a.angle_to(b) / tiny - 1.0).abs() < 1e-12);
            assert!((a.angle_to(-b) - (core::f64::consts::PI - tiny)).abs() < 1e-15);
        }
    }

    #[test]
    fn the_triple_product_expands_as_the_notes_say() {
        // A × (B × A) = A² B − (A·B) A, at a generic point.
        let a = Direction::<Body>::new(0.7, -1.3, 2.1);
        let b = Direction::<Body>::new(-1.9, 0.4, 0.8);
        let left = a.cross(b.cross(a));
        let right = b * a.dot(a) - a * a.dot(b);
        assert!((left - right).norm() < 1e-14);
    }
}
