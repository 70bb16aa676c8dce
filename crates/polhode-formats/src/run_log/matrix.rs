//! Matrices of rotations, as programs print them: in single precision, or with six digits.

use polhode::math::{Body, Rotation};

/// The largest element of |RᵀR − 1| at which a matrix still is a rotation: single precision, and six printed digits.
pub(super) const TOLERANCE: f64 = 1e-5;

/// Why a matrix is no rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NoRotation {
    /// The largest element of |RᵀR − 1|.
    Departs(f64),
    Mirrors,
}

type Matrix = [[f64; 3]; 3];

/// The quaternion, scalar first, of the rotation nearest to a matrix of finite numbers, which come row by row.
pub(super) fn quaternion(numbers: [f64; 9]) -> Result<[f64; 4], NoRotation> {
    let [a, b, c, d, e, f, g, h, i] = numbers;
    let mut r = [[a, b, c], [d, e, f], [g, h, i]];
    let departure = departure(&r);
    if !(departure <= TOLERANCE) {
        return Err(NoRotation::Departs(departure));
    }
    if a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g) < 0.0 {
        return Err(NoRotation::Mirrors);
    }
    // Newton's steps to the nearest rotation square the departure: 1e-5, 1e-10, less than rounding.
    for _ in 0..2 {
        r = nearer(&r);
    }
    Rotation::<Body, Body>::from_matrix(r)
        .map(Rotation::quaternion)
        .map_err(|_| NoRotation::Departs(departure))
}

/// RᵀR, of which the rotations have 1.
fn gram(r: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| r[k][i] * r[k][j]).sum()))
}

/// The largest element of |RᵀR − 1|; NaN where it has no size.
fn departure(r: &Matrix) -> f64 {
    let gram = gram(r);
    let elements = (0..9).map(|k| (gram[k / 3][k % 3] - f64::from(u8::from(k / 3 == k % 3))).abs());
    elements.fold(0.0, |most, e| if e > most || e.is_nan() { e } else { most })
}

/// R (3 − RᵀR)/2
fn nearer(r: &Matrix) -> Matrix {
    let gram = gram(r);
    let factor = |k: usize, j: usize| 0.5 * (if k == j { 3.0 } else { 0.0 } - gram[k][j]);
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| r[i][k] * factor(k, j)).sum()))
}
