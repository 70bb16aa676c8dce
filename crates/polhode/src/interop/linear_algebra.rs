//! Conversions to vectors, rotations and tensors of linear-algebra crates.

use crate::body::{BodyError, InertiaTensor};
use crate::math::{Frame, Rotation, RotationError, Vector};

/// Implements the conversions for the three types of a crate, given functions to and from numbers.
macro_rules! conversions {
    (
        $vector:ty: $to_vector:expr, $from_vector:expr;
        $quaternion:ty: $to_quaternion:expr, $from_quaternion:expr;
        $matrix:ty: $to_matrix:expr, $from_matrix:expr;
    ) => {
        impl<Q, F> From<Vector<Q, F>> for $vector {
            fn from(v: Vector<Q, F>) -> Self {
                let make: fn([f64; 3]) -> Self = $to_vector;
                make(v.to_array())
            }
        }

        impl<Q, F> From<$vector> for Vector<Q, F> {
            fn from(v: $vector) -> Self {
                let take: fn($vector) -> [f64; 3] = $from_vector;
                Self::from_array(take(v))
            }
        }

        impl<A, B> From<Rotation<A, B>> for $quaternion {
            fn from(r: Rotation<A, B>) -> Self {
                let make: fn([f64; 4]) -> Self = $to_quaternion;
                make(r.quaternion())
            }
        }

        impl<A, B> TryFrom<$quaternion> for Rotation<A, B> {
            type Error = RotationError;

            fn try_from(q: $quaternion) -> Result<Self, RotationError> {
                let take: fn($quaternion) -> [f64; 4] = $from_quaternion;
                Self::from_quaternion(take(q))
            }
        }

        impl<F: Frame> From<InertiaTensor<F>> for $matrix {
            fn from(tensor: InertiaTensor<F>) -> Self {
                let make: fn([[f64; 3]; 3]) -> Self = $to_matrix;
                make(tensor.matrix())
            }
        }

        impl<F: Frame> TryFrom<$matrix> for InertiaTensor<F> {
            type Error = BodyError;

            fn try_from(matrix: $matrix) -> Result<Self, BodyError> {
                let take: fn($matrix) -> [[f64; 3]; 3] = $from_matrix;
                Self::from_matrix(take(matrix))
            }
        }
    };
}

#[cfg(feature = "mint")]
conversions! {
    mint::Vector3<f64>: Self::from, |v| v.into();
    mint::Quaternion<f64>: |[w, x, y, z]| Self { s: w, v: [x, y, z].into() }, |q| [q.s, q.v.x, q.v.y, q.v.z];
    mint::RowMatrix3<f64>: |[x, y, z]| Self { x: x.into(), y: y.into(), z: z.into() }, |m| [m.x.into(), m.y.into(), m.z.into()];
}

// Columns equal rows, because a tensor is symmetric; the constructor checks this.
#[cfg(feature = "nalgebra")]
conversions! {
    nalgebra::Vector3<f64>: Self::from, |v| v.into();
    nalgebra::UnitQuaternion<f64>:
        |[w, x, y, z]| Self::new_unchecked(nalgebra::Quaternion::new(w, x, y, z)), |q| [q.w, q.i, q.j, q.k];
    nalgebra::Matrix3<f64>: Self::from, |m| m.into();
}

#[cfg(feature = "glam")]
conversions! {
    glam::DVec3: Self::from, |v| v.into();
    glam::DQuat: |[w, x, y, z]| Self::from_xyzw(x, y, z, w), |q| [q.w, q.x, q.y, q.z];
    glam::DMat3: |rows| Self::from_cols_array_2d(&rows), |m| m.to_cols_array_2d();
}
