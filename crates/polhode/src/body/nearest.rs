//! Possible tensors nearest to an impossible one.

use core::f64::consts::LN_2;

use super::error::BodyError;
use super::inertia::{InertiaTensor, POSSIBLE_TOLERANCE, symmetric};
use crate::math::frame::Body;
use crate::math::root::root;
use crate::math::symmetric3::{Eigen, Symmetric3, power_of_two_near};

/// Possible tensors nearest to a given one, in two metrics; [`nearest_possible`] returns it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestPossible {
    /// Nearest tensor in the Frobenius norm, whose distance is in kg·m²: all elements count alike.
    pub frobenius: Nearest,
    /// Nearest tensor in the affine-invariant metric, whose distance has no unit: ratios count, and
    /// no choice of axes or units. `None` if a principal moment is not positive (or only within
    /// rounding, 64 ε i3); every possible tensor is then infinitely far away.
    pub affine_invariant: Option<Nearest>,
}

/// Possible tensor at a distance from a given one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Possible tensor, along the axes of the given one, kg·m².
    pub tensor: InertiaTensor<Body>,
    /// Distance from the given tensor, in the unit of the metric.
    pub distance: f64,
}

/// Returns the possible tensors nearest to a symmetric matrix (off-diagonals −∫xy dm), about the
/// centre of mass, kg·m².
///
/// A possible matrix is its own nearest tensor. Otherwise the nearest tensors are on the boundary of
/// the possible ones, i1 + i2 = i3: those of a flat body, in the extreme of a rod or a point. They
/// do not correct an error: a measured or computed tensor is better.
///
/// Mass and centre of mass play no part, because a tensor about the centre of mass is possible or
/// not whatever they are. Move a tensor about another point to the centre of mass first: one that is
/// possible about that point may be impossible about the centre.
///
/// Both metrics are invariant under rotations, and the distance of two matrices is at least that of
/// their sorted eigenvalues (Hoffman & Wielandt; Bhatia, ch. 6). So the nearest tensors have
/// the principal axes of the matrix, and the problem has three variables:
///
/// - Frobenius, d = ‖I − X‖: the projection of the moments onto the cone with the faces
///   i₁ + i₂ = i₃, i₂ + i₃ = i₁, i₃ + i₁ = i₂.
/// - Affine-invariant, d = ‖log(I^(−1/2) X I^(−1/2))‖ = √Σ log²(xₖ/iₖ). Matrices with common axes
///   have the same distance in the log-Euclidean metric, ‖log I − log X‖. If i1 = i2, other axes
///   in their plane are as near.
///
/// ```
/// use polhode::body::nearest_possible;
/// let nearest = nearest_possible([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.3]])?;
/// // A third of the excess 0.3 for each moment.
/// let xx = nearest.frobenius.tensor[(0, 0)];
/// assert!((xx - 1.1).abs() < 1e-15 && (nearest.frobenius.distance - 0.03_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
///
/// Source: A. J. Hoffman, H. W. Wielandt, Duke Math. J. 20 (1953) 37; R. Bhatia, Positive Definite
/// Matrices (2007), chapter 6.
///
/// # Errors
/// [`BodyError::NotSymmetric`], or [`BodyError::Parameter`] if an element is not finite.
pub fn nearest_possible(rows: [[f64; 3]; 3]) -> Result<NearestPossible, BodyError> {
    let given = symmetric(rows)?;
    match InertiaTensor::from_symmetric(given) {
        Ok(tensor) => {
            let own = Nearest { tensor, distance: 0.0 };
            let own_too = is_positive(given.eigen().values).then_some(own);
            return Ok(NearestPossible { frobenius: own, affine_invariant: own_too });
        }
        Err(BodyError::NegativeMoment { .. } | BodyError::TriangleInequality { .. }) => {}
        Err(error) => return Err(error),
    }
    // A power of two brings the moments near 1; no square overflows or vanishes.
    let scale = power_of_two_near(given.max_abs());
    let Eigen { values, vectors } = (given * (1.0 / scale)).eigen();
    let [a, b, c] = vectors;
    let columns = [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]];
    let tensor = |moments: [f64; 3]| {
        InertiaTensor::from_symmetric(Symmetric3::diagonal(moments).rotated(&columns) * scale)
    };
    let moments = projected(values);
    let frobenius = Nearest { tensor: tensor(moments)?, distance: scale * apart(values, moments) };
    let affine_invariant = match most_similar(values) {
        Some((moments, distance)) => Some(Nearest { tensor: tensor(moments)?, distance }),
        None => None,
    };
    Ok(NearestPossible { frobenius, affine_invariant })
}

/// Returns the nearest possible moments to ascending ones that are impossible, in the Euclidean
/// norm.
///
/// The cone of possible moments has three faces, which meet in three edges (rods) and the apex. The
/// nearest of the projections onto these seven that are possible is the projection onto the cone.
fn projected(moments: [f64; 3]) -> [f64; 3] {
    let mut nearest = [0.0; 3];
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        // Face iᵢ + iⱼ = iₖ, of plates perpendicular to axis k.
        let third = (moments[k] - moments[i] - moments[j]) / 3.0;
        let (first, second) = (moments[i] + third, moments[j] + third);
        // Edge iᵢ = iⱼ, iₖ = 0, of rods along axis k.
        let mean = 0.5 * (moments[i] + moments[j]);
        for (least, at_i, at_j, at_k) in
            [(first.min(second), first, second, first + second), (mean, mean, mean, 0.0)]
        {
            let mut candidate = [0.0; 3];
            (candidate[i], candidate[j], candidate[k]) = (at_i, at_j, at_k);
            if least >= 0.0 && apart(moments, candidate) < apart(moments, nearest) {
                nearest = candidate;
            }
        }
    }
    nearest
}

/// Returns true if the least of ascending moments is positive beyond rounding.
fn is_positive([i1, _, i3]: [f64; 3]) -> bool {
    i1 > POSSIBLE_TOLERANCE * i3
}

fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// Returns the possible moments nearest to ascending ones with i1 + i2 < i3, by the logarithms of
/// their ratios, and the distance; `None` if a moment is not positive.
///
/// Minimize Σ δₖ² with i1 e^δ₁ + i2 e^δ₂ = i3 e^δ₃. With the Lagrange multiplier λ and the share p
/// of the first moment in the sum, q = 1 − p:
///
///   δ = λ (p, q, −1),   λ (1 + p) = ln(p i3/i1),   λ (1 + q) = ln(q i3/i2).
///
/// Eliminating λ leaves F(p) = ln(p i3/i1) (1 + q) − ln(q i3/i2) (1 + p) = 0. A minimum has
/// p ≤ ½, as exchanging the moments of one with p > ½ brings each nearer. F is concave on (0, ½],
/// negative where p i3 = i1, and not negative at ½: the first zero is the only minimum. Beyond the
/// maximum of F, if that is before ½, there is none.
fn most_similar(moments: [f64; 3]) -> Option<([f64; 3], f64)> {
    if !is_positive(moments) {
        return None;
    }
    let [i1, i2, i3] = moments;
    let [x, y] = [i1, i2].map(|i| libm::log(i3 / i));
    // In u = ln p, so that small shares are accurate.
    let share = |u: f64| (libm::exp(u), -libm::expm1(u));
    let residual = |u: f64| {
        let (p, q) = share(u);
        (x + u) * (1.0 + q) - (y + libm::log(q)) * (1.0 + p)
    };
    let slope = |u: f64| {
        let (p, q) = share(u);
        (1.0 + q) / p + (1.0 + p) / q - (x + u) - (y + libm::log(q))
    };
    let last = match slope(-LN_2) {
        below if below < 0.0 => root(slope, [-x, -LN_2], [slope(-x), below]),
        _ => -LN_2,
    };
    let [from, to] = [residual(-x), residual(last)];
    // Rounding may make F at equal moments slightly negative; the zero is then that end.
    let u = if from < 0.0 && to > 0.0 { root(residual, [-x, last], [from, to]) } else { last };
    let (p, q) = share(u);
    let lambda = (x + u) / (1.0 + p);
    let [j1, j2] = [i1 * libm::exp(lambda * p), i2 * libm::exp(lambda * q)];
    Some(([j1, j2, j1 + j2], lambda * (1.0 + p * p + q * q).sqrt()))
}
