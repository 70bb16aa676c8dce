//! Mode shapes of one eigenvalue, or of several equal eigenvalues, whose shapes form a basis.

use super::mode::OscillationMode;
use crate::math::complex::Complex;
use crate::math::eigenvalues::{Matrix, eigenvector};
use crate::math::frame::Body;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Direction;

/// Threshold for the component of a vector perpendicular to earlier ones, below which it is not
/// independent; a defective eigenvalue has only one vector.
const ANOTHER: f64 = 1e-3;

/// Threshold of the squared extent in a direction, below which it is an error of the differences.
const FLAT: f64 = 1e-10;

/// Displacement from equal eigenvalues, far larger than their rounding, so that their vectors have
/// the same error.
const ASIDE: f64 = 1e-8;

/// Returns the modes of one eigenvalue or of several equal ones, given in the matrix's own unit of
/// time, with σ and ϖ.
pub(super) fn modes(
    matrix: &Matrix<6>,
    roots: &[Complex<f64>],
    [growth_rate, frequency]: [f64; 2],
) -> Vec<OscillationMode> {
    let vectors = eigenvectors(matrix, roots);
    let shapes: Vec<[Complex<f64>; 3]> = vectors.iter().map(|&[x, y, z, ..]| [x, y, z]).collect();
    let modes: Vec<OscillationMode> = match axes(&shapes) {
        Some(axes) => {
            axes.into_iter().map(|axis| OscillationMode::along(frequency, growth_rate, axis)).collect()
        }
        None => shapes.into_iter().map(|s| OscillationMode::new(frequency, growth_rate, s)).collect(),
    };
    let multiplicity = modes.len();
    modes.into_iter().map(|mode| OscillationMode { multiplicity, ..mode }).collect()
}

/// Returns up to one eigenvector for each eigenvalue; they are orthonormal.
fn eigenvectors(matrix: &Matrix<6>, roots: &[Complex<f64>]) -> Vec<[Complex<f64>; 6]> {
    let mut found: Vec<[Complex<f64>; 6]> = Vec::new();
    let aside = if roots.len() > 1 { ASIDE } else { 0.0 };
    for (seed, root) in (0..6).zip(roots.iter().cycle()) {
        let mut v = eigenvector(matrix, Complex { re: root.re + aside, im: root.im }, seed);
        for u in &found {
            let zero = Complex { re: 0.0, im: 0.0 };
            let along = u.iter().zip(&v).fold(zero, |sum, (u, v)| sum.plus(u.conjugate().times(*v)));
            v = core::array::from_fn(|k| v[k].minus(along.times(u[k])));
        }
        let length = v.iter().map(|c| c.norm_squared()).sum::<f64>().sqrt();
        if length > ANOTHER {
            found.push(v.map(|c| c.scaled(1.0 / length)));
        }
        if found.len() == roots.len() {
            break;
        }
    }
    found
}

/// Returns the oscillation axes nearest to the body's own, if several shapes have a real basis.
fn axes(shapes: &[[Complex<f64>; 3]]) -> Option<Vec<Direction<Body>>> {
    let parts = shapes.iter().flat_map(|s| [s.map(|c| c.re), s.map(|c| c.im)]);
    let spread = parts.fold(Symmetric3::default(), |sum, v| sum + Symmetric3::outer(v)).eigen();
    let rank = spread.values.iter().filter(|value| **value > FLAT * spread.values[2]).count();
    match (shapes.len(), rank) {
        (2, 2) => {
            let normal = Direction::from_array(spread.vectors[0]);
            let nearest = if normal.x.abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
            let nearest = Direction::from_array(nearest);
            let first = (nearest - normal * normal.dot(nearest)).direction()?;
            Some(vec![first, positive(normal.cross(first))])
        }
        (3, 3) => Some(
            [0, 1, 2].map(|k| Direction::from_array(core::array::from_fn(|i| f64::from(i == k)))).to_vec(),
        ),
        _ => None,
    }
}

/// Returns ±v, with its largest component positive.
fn positive(v: Direction<Body>) -> Direction<Body> {
    let largest = v.to_array().into_iter().fold(0.0, |max: f64, x| if x.abs() > max.abs() { x } else { max });
    v * 1.0_f64.copysign(largest)
}
