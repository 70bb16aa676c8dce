//! Rotation matrices as programs print them: in single precision, or with six digits.

use std::error::Error;
use std::fmt;

use polhode::math::{Body, Rotation};

/// Largest element of |RᵀR − 1| at which a matrix counts as a rotation. It allows single precision,
/// and six printed digits.
pub(crate) const TOLERANCE: f64 = 1e-5;

/// Reason why a matrix is not a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MatrixError {
    /// RᵀR differs from 1; the number is the largest element of |RᵀR − 1|.
    NotRotation(f64),
    /// det R is −1: the matrix is a reflection.
    Mirrored,
}

impl MatrixError {
    /// Returns advice on how to correct the matrix.
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::NotRotation(_) => {
                "give the nine numbers of one matrix, row by row, with six digits or more"
            }
            Self::Mirrored => {
                "one of its two frames is left-handed: reverse an axis of that one before it is written"
            }
        }
    }
}

/// Message such as `|RᵀR − 1| = 1.00e0 must be 0.00001 or less: the matrix has to be a rotation`.
impl fmt::Display for MatrixError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotRotation(departure) => {
                write!(
                    f,
                    "|RᵀR − 1| = {departure:.2e} must be {TOLERANCE} or less: the matrix has to be a rotation"
                )
            }
            Self::Mirrored => f.write_str("det R = −1 must be +1: the matrix mirrors"),
        }
    }
}

impl Error for MatrixError {}

type Matrix = [[f64; 3]; 3];

/// Returns the quaternion, scalar first, of the rotation nearest to a matrix of finite numbers,
/// given row by row.
///
/// # Errors
/// [`MatrixError`] if the matrix differs from a rotation by more than six digits allow, or is a
/// reflection.
pub fn matrix_quaternion(numbers: [f64; 9]) -> Result<[f64; 4], MatrixError> {
    let [a, b, c, d, e, f, g, h, i] = numbers;
    let mut r = [[a, b, c], [d, e, f], [g, h, i]];
    let departure = departure(&r);
    if !(departure <= TOLERANCE) {
        return Err(MatrixError::NotRotation(departure));
    }
    if a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g) < 0.0 {
        return Err(MatrixError::Mirrored);
    }
    // Newton's steps to the nearest rotation square the departure: 1e-5, 1e-10, less than rounding.
    for _ in 0..2 {
        r = nearer(&r);
    }
    Rotation::<Body, Body>::from_matrix(r)
        .map(Rotation::quaternion)
        .map_err(|_| MatrixError::NotRotation(departure))
}

/// Returns RᵀR, which is 1 for a rotation.
fn gram(r: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| r[k][i] * r[k][j]).sum()))
}

/// Returns the largest element of |RᵀR − 1|; NaN if an element is NaN.
fn departure(r: &Matrix) -> f64 {
    let gram = gram(r);
    let elements = (0..9).map(|k| (gram[k / 3][k % 3] - f64::from(u8::from(k / 3 == k % 3))).abs());
    elements.fold(0.0, |most, e| if e > most || e.is_nan() { e } else { most })
}

/// Returns R (3 − RᵀR)/2.
fn nearer(r: &Matrix) -> Matrix {
    let gram = gram(r);
    let factor = |k: usize, j: usize| 0.5 * (if k == j { 3.0 } else { 0.0 } - gram[k][j]);
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| r[i][k] * factor(k, j)).sum()))
}
