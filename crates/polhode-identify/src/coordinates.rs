//! Unconstrained coordinates of physically consistent inertia tensors.
//!
//! A tensor I is physically consistent if and only if the second moments G = ½ tr(I) 1 − I = ∫ x xᵀ
//! dm are positive semidefinite. With
//!
//! G = U Uᵀ,  U = ((e^a, d, e), (0, e^b, f), (0, 0, e^c))
//!
//! every (a, b, c, d, e, f) gives a consistent tensor. Conversely, every body except a lamina has
//! such coordinates. A lamina is the limit a, b or c → −∞.
//!
//! Source: C. Rucker, P. M. Wensing, IEEE Robot. Autom. Lett. 7 (2022) 2747.

use nalgebra::DMatrix;
use polhode::math::symmetric_eigen;

use crate::six::{PLACES, Six, matrix, moments_of, of_eigen, tensor_of};

/// Map between the shared physical parameters and unconstrained coordinates, part by part.
#[derive(Clone, Debug, Default)]
pub(crate) struct Coordinates {
    parts: Vec<Part>,
}

/// Kind of a group of consecutive shared parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Part {
    /// Unconstrained parameters, and their count.
    Free(usize),
    /// Positive parameter; its coordinate is its logarithm.
    Positive,
    /// Physically consistent tensor Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the centre of mass;
    /// coordinates of the factor U.
    Tensor,
    /// Physically consistent tensor by the symmetric root S of G = S². S is any symmetric matrix,
    /// so plates and rods have finite coordinates, and no axis is special.
    RootedTensor,
    /// Positive semidefinite symmetric matrix xx, yy, zz, xy, xz, yz; coordinates of the factor U.
    Positive3,
}

impl Part {
    /// Returns the number of parameters, which is also the number of coordinates.
    pub(crate) const fn count(self) -> usize {
        match self {
            Self::Free(count) => count,
            Self::Positive => 1,
            Self::Tensor | Self::RootedTensor | Self::Positive3 => 6,
        }
    }
}

impl Coordinates {
    pub(crate) const fn new(parts: Vec<Part>) -> Self {
        Self { parts }
    }

    /// Returns the coordinates of physical parameters. A tensor at or beyond the boundary of
    /// physical consistency is moved to the nearest one inside.
    pub(crate) fn of(&self, physical: &[f64]) -> Vec<f64> {
        let mut all = Vec::with_capacity(physical.len());
        for (part, numbers) in self.each(physical) {
            match part {
                Part::Free(_) => all.extend_from_slice(numbers),
                Part::Positive => all.push(libm::log(numbers[0])),
                Part::Tensor => all.extend(factor(moments_of(six(numbers)))),
                Part::RootedTensor => all.extend(root(moments_of(six(numbers)))),
                Part::Positive3 => all.extend(factor(six(numbers))),
            }
        }
        all
    }

    /// Returns the physical parameters of the coordinates.
    pub(crate) fn physical(&self, coordinates: &[f64]) -> Vec<f64> {
        let mut all = Vec::with_capacity(coordinates.len());
        for (part, x) in self.each(coordinates) {
            match part {
                Part::Free(_) => all.extend_from_slice(x),
                Part::Positive => all.push(libm::exp(x[0])),
                Part::Tensor => all.extend(tensor_of(product(&upper(six(x))))),
                Part::RootedTensor => all.extend(tensor_of(product(&matrix(six(x))))),
                Part::Positive3 => all.extend(product(&upper(six(x)))),
            }
        }
        all
    }

    /// Returns the Jacobian ∂physical/∂coordinates.
    pub(crate) fn jacobian(&self, coordinates: &[f64]) -> DMatrix<f64> {
        let n = coordinates.len();
        let mut matrix = DMatrix::zeros(n, n);
        let mut at = 0;
        for (part, x) in self.each(coordinates) {
            let count = part.count();
            let mut set = |row: usize, column: usize, value: f64| matrix[(at + row, at + column)] = value;
            match part {
                Part::Free(count) => (0..count).for_each(|k| set(k, k, 1.0)),
                Part::Positive => set(0, 0, libm::exp(x[0])),
                Part::Tensor => product_columns(six(x), tensor_of, &mut set),
                Part::RootedTensor => square_columns(six(x), &mut set),
                Part::Positive3 => product_columns(six(x), |g| g, &mut set),
            }
            at += count;
        }
        matrix
    }

    fn each<'a>(&'a self, numbers: &'a [f64]) -> impl Iterator<Item = (Part, &'a [f64])> {
        self.parts.iter().scan(numbers, |rest, &part| {
            let (these, others) = rest.split_at(part.count());
            *rest = others;
            Some((part, these))
        })
    }
}

fn six(numbers: &[f64]) -> Six {
    core::array::from_fn(|k| numbers[k])
}

/// Returns the factor U of the coordinates a, b, c, d, e, f.
fn upper([a, b, c, d, e, f]: Six) -> [[f64; 3]; 3] {
    [[libm::exp(a), d, e], [0.0, libm::exp(b), f], [0.0, 0.0, libm::exp(c)]]
}

/// Returns the product U Uᵀ.
fn product(u: &[[f64; 3]; 3]) -> Six {
    PLACES.map(|(i, j)| (0..3).map(|k| u[i][k] * u[j][k]).sum())
}

/// Sets the derivatives of a linear function of G with respect to a … f: dG = dU Uᵀ + U dUᵀ.
fn product_columns(x: Six, linear: impl Fn(Six) -> Six, set: &mut impl FnMut(usize, usize, f64)) {
    let u = upper(x);
    for (column, &(row, k)) in PLACES.iter().enumerate() {
        let size = if row == k { u[row][k] } else { 1.0 };
        // dU has one element, at (row, k): dG_ij = size (δ_i,row u_jk + δ_j,row u_ik)
        let g = PLACES.map(|(i, j)| {
            let one = if i == row { u[j][k] } else { 0.0 };
            let other = if j == row { u[i][k] } else { 0.0 };
            size * (one + other)
        });
        for (element, value) in linear(g).into_iter().enumerate() {
            set(element, column, value);
        }
    }
}

/// Sets the derivatives ∂I/∂S: dG = S dS + dS S.
fn square_columns(x: Six, set: &mut impl FnMut(usize, usize, f64)) {
    let s = matrix(x);
    for column in 0..6 {
        let mut unit = [0.0; 6];
        unit[column] = 1.0;
        let d = matrix(unit);
        let g = PLACES.map(|(i, j)| (0..3).map(|k| s[i][k] * d[k][j] + d[i][k] * s[k][j]).sum::<f64>());
        for (element, value) in tensor_of(g).into_iter().enumerate() {
            set(element, column, value);
        }
    }
}

/// Returns the eigenvalues and eigenvectors of second moments, and the lower bound on the
/// eigenvalues. Smaller eigenvalues are raised to the bound, [`THIN`] times the largest.
fn inside(g: Six) -> ([f64; 3], [[f64; 3]; 3], f64) {
    let (values, vectors) = symmetric_eigen(g);
    let least = THIN * values.iter().fold(f64::MIN_POSITIVE, |most, v| most.max(v.abs()));
    (values.map(|value| value.max(least)), vectors, least)
}

/// Returns the root S of second moments whose small eigenvalues are raised by [`inside`].
fn root(g: Six) -> Six {
    let (values, vectors, _) = inside(g);
    of_eigen(values.map(f64::sqrt), vectors)
}

/// Smallest second moment at the start, relative to the largest: a plate 1 mm thick and 10 m wide.
const THIN: f64 = 1e-8;

/// Returns a … f of second moments whose small eigenvalues are raised by [`inside`].
fn factor(g: Six) -> Six {
    let (values, vectors, least) = inside(g);
    let [xx, yy, zz, xy, xz, yz] = of_eigen(values, vectors);
    let c = zz.sqrt();
    let (e, f) = (xz / c, yz / c);
    let least = least.sqrt();
    let root = |square: f64| square.max(least * least).sqrt();
    let b = root(yy - f * f);
    let d = (xy - e * f) / b;
    let a = root(xx - d * d - e * e);
    [libm::log(a), libm::log(b), libm::log(c), d, e, f]
}

#[cfg(test)]
mod tests {
    use super::*;

    const TENSOR: Six = [3.1, 4.2, 5.3, 0.4, -0.3, 0.2];

    fn close(a: &[f64], b: &[f64], tolerance: f64) {
        for (a, b) in a.iter().zip(b) {
            assert!((a - b).abs() <= tolerance * (1.0 + b.abs()), "{a} {b}");
        }
    }

    #[test]
    fn there_and_back() {
        let all = Coordinates::new(vec![Part::Free(2), Part::Positive, Part::Tensor, Part::RootedTensor]);
        let mut numbers = vec![-1.5, 7.0];
        numbers.push(0.25);
        numbers.extend(TENSOR);
        numbers.extend(TENSOR);
        close(&all.physical(&all.of(&numbers)), &numbers, 1e-14);
    }

    #[test]
    fn the_jacobian_is_that_of_differences() {
        let all = Coordinates::new(vec![Part::Positive, Part::Tensor, Part::Positive3, Part::RootedTensor]);
        let mut numbers = vec![0.25];
        numbers.extend(TENSOR);
        numbers.extend(TENSOR);
        numbers.extend(TENSOR);
        let x = all.of(&numbers);
        let jacobian = all.jacobian(&x);
        for column in 0..x.len() {
            let moved = |h: f64| {
                let mut there = x.clone();
                there[column] += h;
                all.physical(&there)
            };
            let h = 1e-5;
            let slope: Vec<f64> = moved(h).iter().zip(moved(-h)).map(|(a, b)| (a - b) / (2.0 * h)).collect();
            close(jacobian.column(column).as_slice(), &slope, 1e-9);
        }
    }

    #[test]
    fn whatever_the_coordinates_the_body_is_possible() {
        let tensor = Coordinates::new(vec![Part::Tensor]);
        let mut state = 0.37_f64;
        for _ in 0..1000 {
            let x: Vec<f64> = (0..6)
                .map(|_| {
                    state = (state * 997.13 + 0.171).fract();
                    8.0 * (state - 0.5)
                })
                .collect();
            let (moments, _) = symmetric_eigen(six(&tensor.physical(&x)));
            assert!(moments[0] + moments[1] >= moments[2] * (1.0 - 1e-12), "{moments:?}");
        }
    }

    #[test]
    fn what_is_not_possible_begins_at_the_edge() {
        let tensor = Coordinates::new(vec![Part::Tensor]);
        let found = tensor.physical(&tensor.of(&[1.0, 2.0, 4.0, 0.1, 0.0, 0.0]));
        let (moments, _) = symmetric_eigen(six(&found));
        assert!(moments[0] + moments[1] >= moments[2] * (1.0 - 1e-9), "{moments:?}");
    }
}
