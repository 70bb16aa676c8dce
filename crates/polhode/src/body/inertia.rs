//! Inertia tensors: about the centre of mass, and about any other point.

use core::fmt;
use core::marker::PhantomData;
use core::ops::{Index, Mul};

use super::error::BodyError;
use crate::math::display;
use crate::math::frame::Frame;
use crate::math::rotation::Rotation;
use crate::math::symmetric3::{Eigen, Symmetric3};
use crate::math::vector::{
    AngularAcceleration, AngularMomentum, AngularVelocity, Direction, Position, Torque, Vector,
};

/// Inertia tensor of a body about its centre of mass, along the axes of `F`, kg·m².
///
/// I_ij = ∫ (δ_ij r² − x_i x_j) dm: the off-diagonal elements are *minus* the integrals ∫xy dm, so
/// that L = I ω.
///
/// Every tensor of this type is *possible*: finite, symmetric, without negative principal moments,
/// and i1 + i2 ≥ i3. The tolerance is 64 ε i3, the rounding of a sum of many parts. The elements
/// cannot be changed.
///
/// ```
/// use polhode::body::InertiaTensor;
/// use polhode::math::{AngularVelocity, Body};
/// // Thornton & Marion, problem 11-13, in units of m b²
/// let tensor = InertiaTensor::<Body>::with_negative_products([13.0, 16.0, 15.0], [-2.0, 1.0, 4.0])?;
/// let l = tensor * AngularVelocity::new(1.0, 2.0, 3.0);
/// assert_eq!(l.to_array(), [12.0, 42.0, 54.0]);
/// assert!(InertiaTensor::<Body>::diagonal([1.0, 1.0, 3.0]).is_err()); // i1 + i2 < i3
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
///
/// Source: the lecture notes on Thornton & Marion, Classical Dynamics, chapter 11, "The inertia
/// tensor".
pub struct InertiaTensor<F> {
    elements: Symmetric3,
    frame: PhantomData<F>,
}

/// Inertia tensor of a body about a point other than its centre of mass, along the axes of `F`,
/// kg·m².
///
/// [`MassProperties::inertia_about`](crate::body::MassProperties::inertia_about) returns it. It can
/// also be constructed from elements, to be moved to the centre of mass. It is possible in the same
/// sense as [`InertiaTensor`].
pub struct InertiaAbout<F> {
    point: Position<F>,
    elements: Symmetric3,
}

/// Tolerance of the rules for principal moments, relative to the largest: the rounding of a sum of
/// many parts.
pub(super) const POSSIBLE_TOLERANCE: f64 = 64.0 * f64::EPSILON;

/// Tolerance of symmetry, relative to the largest moment: the rounding of a matrix read from a
/// file.
const SYMMETRY_TOLERANCE: f64 = 1e-12;

impl<F: Frame> InertiaTensor<F> {
    /// Returns the tensor with diagonal (xx, yy, zz) and off-diagonals (xy, xz, yz) = −∫xy dm, −∫xz
    /// dm, −∫yz dm.
    ///
    /// # Errors
    /// [`BodyError`] if the tensor is impossible.
    pub fn with_negative_products(moments: [f64; 3], products: [f64; 3]) -> Result<Self, BodyError> {
        Self::from_symmetric(assemble(moments, products))
    }

    /// Returns the tensor from products with the opposite sign, +∫xy dm, +∫xz dm, +∫yz dm: the
    /// convention of most CAD reports.
    ///
    /// # Errors
    /// [`BodyError`] if the tensor is impossible.
    pub fn with_positive_products(moments: [f64; 3], products: [f64; 3]) -> Result<Self, BodyError> {
        Self::from_symmetric(assemble(moments, products.map(|p| 0.0 - p)))
    }

    /// Returns the tensor from a full matrix (off-diagonals −∫xy dm).
    ///
    /// # Errors
    /// [`BodyError::NotSymmetric`] if the matrix differs from its transpose by more than 1e-12 of
    /// its largest moment; any other [`BodyError`] if the tensor is impossible.
    pub fn from_matrix(rows: [[f64; 3]; 3]) -> Result<Self, BodyError> {
        Self::from_symmetric(symmetric(rows)?)
    }

    /// Returns the tensor of a body whose principal axes are the axes of `F`.
    ///
    /// # Errors
    /// [`BodyError`] if the tensor is impossible.
    pub fn diagonal(moments: [f64; 3]) -> Result<Self, BodyError> {
        Self::from_symmetric(Symmetric3::diagonal(moments))
    }

    pub(crate) fn from_symmetric(elements: Symmetric3) -> Result<Self, BodyError> {
        require_possible(&elements)?;
        Ok(Self { elements, frame: PhantomData })
    }

    /// Returns the tensor from a difference of tensors of magnitude `whole` (the largest moment).
    /// If rounding made the tensor of a rod or a plate slightly impossible, the nearest possible
    /// tensor is returned.
    pub(crate) fn from_difference(elements: Symmetric3, whole: f64) -> Result<Self, BodyError> {
        let Eigen { values: [i1, i2, i3], vectors } = elements.eigen();
        let rounding = POSSIBLE_TOLERANCE * whole;
        let [j1, j2, j3] = [i1, i2, i3].map(|i| i.max(0.0));
        let (negative, excess) = (j1 - i1, f64::max(j3 - j2 - j1, 0.0));
        if (negative == 0.0 && excess == 0.0) || negative > rounding || excess > rounding {
            return Self::from_symmetric(elements);
        }
        let [a, b, c] = vectors;
        let columns = [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]];
        let third = excess / 3.0; // smallest change: a third for each moment
        let on_edge = Symmetric3::diagonal([j1 + third, j2 + third, j3 - third]);
        Self::from_symmetric(on_edge.rotated(&columns))
    }

    /// Returns the tensor along the axes of `A`: R I Rᵀ.
    pub fn in_frame<A: Frame>(&self, r: Rotation<A, F>) -> InertiaTensor<A> {
        InertiaTensor { elements: self.elements.rotated(&r.matrix()), frame: PhantomData }
    }

    /// Returns the same elements along the axes of `A`, whose directions coincide with those of
    /// this frame.
    pub(crate) const fn as_frame<A: Frame>(&self) -> InertiaTensor<A> {
        InertiaTensor { elements: self.elements, frame: PhantomData }
    }
}

impl<F: Frame> InertiaAbout<F> {
    /// Returns the tensor about `point` from a full matrix (off-diagonals −∫xy dm, r measured from
    /// `point`).
    ///
    /// # Errors
    /// The errors of [`InertiaTensor::from_matrix`]: the same inequalities hold about any point.
    pub fn from_matrix(point: Position<F>, rows: [[f64; 3]; 3]) -> Result<Self, BodyError> {
        Self::from_symmetric(point, symmetric(rows)?)
    }

    pub(crate) fn from_symmetric(point: Position<F>, elements: Symmetric3) -> Result<Self, BodyError> {
        super::error::finite("the point of the inertia tensor", point.to_array())?;
        require_possible(&elements)?;
        Ok(Self { point, elements })
    }

    /// Returns a tensor obtained from a possible one by the parallel-axis theorem, which keeps it
    /// possible.
    pub(crate) const fn moved(point: Position<F>, elements: Symmetric3) -> Self {
        Self { point, elements }
    }

    /// Returns the reference point of the tensor, m.
    pub const fn point(&self) -> Position<F> {
        self.point
    }
}

macro_rules! tensor {
    ($name:ident) => {
        impl<F: Frame> $name<F> {
            /// Returns the full matrix; off-diagonals are −∫xy dm.
            pub fn matrix(&self) -> [[f64; 3]; 3] {
                self.elements.rows()
            }

            /// Returns the moment of inertia about the axis `n` through the tensor's reference
            /// point: nᵀ I n, kg·m².
            pub fn about_axis(&self, n: Direction<F>) -> f64 {
                n.direction()
                    .map_or(0.0, |n| n.dot(Direction::<F>::from_array(self.elements.apply(n.to_array()))))
            }

            pub(crate) const fn symmetric(&self) -> &Symmetric3 {
                &self.elements
            }

            fn times<P, Q>(&self, v: Vector<P, F>) -> Vector<Q, F> {
                Vector::from_array(self.elements.apply(v.to_array()))
            }
        }

        impl<F: Frame> Mul<AngularVelocity<F>> for $name<F> {
            type Output = AngularMomentum<F>;
            /// Returns L = I ω.
            fn mul(self, omega: AngularVelocity<F>) -> AngularMomentum<F> {
                self.times(omega)
            }
        }

        impl<F: Frame> Mul<AngularAcceleration<F>> for $name<F> {
            type Output = Torque<F>;
            /// Returns I ω̇: the torque that changes ω, without the term ω × L of rotating axes.
            fn mul(self, alpha: AngularAcceleration<F>) -> Torque<F> {
                self.times(alpha)
            }
        }

        impl<F: Frame> Clone for $name<F> {
            fn clone(&self) -> Self {
                *self
            }
        }

        impl<F: Frame> Copy for $name<F> {}

        impl<F: Frame> fmt::Debug for $name<F> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!(stringify!($name), "<{}>{:?}"), F::NAME, self.matrix())
            }
        }

        /// Element at a row and a column, each 0, 1 or 2.
        ///
        /// # Panics
        /// Panics like an array if an index exceeds 2.
        impl<F> Index<(usize, usize)> for $name<F> {
            type Output = f64;

            fn index(&self, (row, column): (usize, usize)) -> &f64 {
                let Symmetric3 { xx, yy, zz, xy, xz, yz } = &self.elements;
                [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]][row][column]
            }
        }
    };
}

/// Rows of the matrix, with the unit.
impl<F> fmt::Display for InertiaTensor<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("[")?;
        for (k, row) in self.elements.rows().iter().enumerate() {
            f.write_str(if k == 0 { "" } else { ", " })?;
            display::row(f, row)?;
        }
        f.write_str("] kg·m²")
    }
}

impl<F> fmt::Display for InertiaAbout<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let tensor = InertiaTensor::<F> { elements: self.elements, frame: PhantomData };
        tensor.fmt(f)?;
        f.write_str(" about ")?;
        self.point.fmt(f)
    }
}

tensor!(InertiaTensor);
tensor!(InertiaAbout);

impl<F: Frame> PartialEq for InertiaTensor<F> {
    fn eq(&self, other: &Self) -> bool {
        self.elements == other.elements
    }
}

impl<F: Frame> PartialEq for InertiaAbout<F> {
    fn eq(&self, other: &Self) -> bool {
        self.point == other.point && self.elements == other.elements
    }
}

fn assemble([xx, yy, zz]: [f64; 3], [xy, xz, yz]: [f64; 3]) -> Symmetric3 {
    Symmetric3 { xx, yy, zz, xy, xz, yz }
}

pub(super) fn symmetric(rows: [[f64; 3]; 3]) -> Result<Symmetric3, BodyError> {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = rows;
    let scale = xx.abs().max(yy.abs()).max(zz.abs());
    for (i, j, value, mirrored) in [(1, 2, xy, yx), (1, 3, xz, zx), (2, 3, yz, zy)] {
        // Elements that are not finite are reported by `require_possible`, which names the element.
        if value.is_finite() && mirrored.is_finite() && (value - mirrored).abs() > SYMMETRY_TOLERANCE * scale
        {
            return Err(BodyError::NotSymmetric { element: [i, j], value, mirrored });
        }
    }
    let mean = |a: f64, b: f64| 0.5 * a + 0.5 * b;
    Ok(Symmetric3 { xx, yy, zz, xy: mean(xy, yx), xz: mean(xz, zx), yz: mean(yz, zy) })
}

fn require_possible(elements: &Symmetric3) -> Result<(), BodyError> {
    const NAMES: [&str; 6] = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"];
    for (what, value) in NAMES.into_iter().zip(elements.elements()) {
        if !value.is_finite() {
            return Err(BodyError::Parameter { what, value, rule: "finite" });
        }
    }
    let moments = elements.eigen().values;
    let [i1, i2, i3] = moments;
    let tolerance = POSSIBLE_TOLERANCE * i3;
    if i3 < 0.0 || i1 < -tolerance {
        return Err(BodyError::NegativeMoment { moments });
    }
    if i3 - i2 - i1 > tolerance {
        return Err(BodyError::TriangleInequality { moments });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::frame::Body;

    type Tensor = InertiaTensor<Body>;

    #[test]
    fn the_two_sign_conventions_are_two_constructors() {
        let moments = [3.1, 4.2, 5.3];
        let a = Tensor::with_negative_products(moments, [0.4, -0.3, 0.2]).unwrap();
        let b = Tensor::with_positive_products(moments, [-0.4, 0.3, -0.2]).unwrap();
        assert_eq!(a, b);
        assert_eq!(a.matrix()[0][1], 0.4);
    }

    #[test]
    fn impossible_tensors_do_not_exist() {
        use BodyError::{NegativeMoment, NotSymmetric, Parameter, TriangleInequality};
        assert!(matches!(Tensor::diagonal([1.0, 1.0, 3.0]), Err(TriangleInequality { .. })));
        assert!(matches!(Tensor::diagonal([-1.0, 1.0, 1.0]), Err(NegativeMoment { .. })));
        assert!(matches!(Tensor::diagonal([-1.0, -1.0, -1.0]), Err(NegativeMoment { .. })));
        assert!(matches!(Tensor::diagonal([f64::NAN, 1.0, 1.0]), Err(Parameter { what: "Ixx", .. })));
        assert!(matches!(
            Tensor::with_negative_products([1.0; 3], [0.0, f64::INFINITY, 0.0]),
            Err(Parameter { what: "Ixz", .. })
        ));
        let skew = [[3.0, 0.1, 0.2], [0.1, 4.0, 0.3], [-0.2, 0.3, 5.0]];
        assert!(matches!(Tensor::from_matrix(skew), Err(NotSymmetric { element: [1, 3], .. })));
        // A flat plate and a rod are on the limit of the triangle inequality, at any scale.
        for scale in [1e-300, 1e-30, 1.0, 1e300] {
            assert!(Tensor::diagonal([0.1 * scale, 0.2 * scale, 0.3 * scale]).is_ok());
            assert!(Tensor::diagonal([0.0, 0.7 * scale, 0.7 * scale]).is_ok());
            assert!(Tensor::diagonal([0.1 * scale, 0.2 * scale, 0.300001 * scale]).is_err());
        }
    }
}
