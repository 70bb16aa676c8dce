//! The shapes of modes: of one by itself, or of several with one frequency, which are a basis of what the body can do at it.

use super::mode::OscillationMode;
use crate::math::complex::Complex;
use crate::math::eigenvalues::{Matrix, eigenvector};
use crate::math::frame::Body;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Direction;

/// What is left of a vector across those before it, below which it is not another one: a defective root has but one.
const ANOTHER: f64 = 1e-3;

/// Squares of what the differences leave of a direction that the shapes do not have.
const FLAT: f64 = 1e-10;

/// A step aside from roots that agree, far beyond their rounding: from there their vectors are all alike.
const ASIDE: f64 = 1e-8;

/// The modes of one root, or of several that agree: their values in the matrix's own unit of time, and σ and ϖ.
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

/// An eigenvector for each root, if there are so many: each of unit length and across the others.
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

/// Axes about which the body swings to and fro, of several shapes that have a real basis: nearest to the body's own.
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

/// With its largest component positive.
fn positive(v: Direction<Body>) -> Direction<Body> {
    let largest = v.to_array().into_iter().fold(0.0, |max: f64, x| if x.abs() > max.abs() { x } else { max });
    v * 1.0_f64.copysign(largest)
}
