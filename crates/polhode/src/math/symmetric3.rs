//! Symmetric 3×3 matrices, their eigenvalues and eigenvectors.

use core::ops::{Add, Mul, Sub};

use super::double::Double;

/// Symmetric 3×3 matrix, stored as its six elements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Symmetric3 {
    pub(crate) xx: f64,
    pub(crate) yy: f64,
    pub(crate) zz: f64,
    pub(crate) xy: f64,
    pub(crate) xz: f64,
    pub(crate) yz: f64,
}

/// Eigenvalues in ascending order; `vectors[k]` belongs to `values[k]`; the vectors are orthonormal
/// with either handedness.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Eigen {
    pub(crate) values: [f64; 3],
    pub(crate) vectors: [[f64; 3]; 3],
}

impl Symmetric3 {
    pub(crate) const fn diagonal([xx, yy, zz]: [f64; 3]) -> Self {
        Self { xx, yy, zz, xy: 0.0, xz: 0.0, yz: 0.0 }
    }

    /// Returns v vᵀ.
    pub(crate) fn outer([x, y, z]: [f64; 3]) -> Self {
        Self { xx: x * x, yy: y * y, zz: z * z, xy: x * y, xz: x * z, yz: y * z }
    }

    /// Returns u vᵀ + v uᵀ.
    pub(crate) fn twice_outer([x, y, z]: [f64; 3], [a, b, c]: [f64; 3]) -> Self {
        Self {
            xx: 2.0 * x * a,
            yy: 2.0 * y * b,
            zz: 2.0 * z * c,
            xy: x * b + y * a,
            xz: x * c + z * a,
            yz: y * c + z * b,
        }
    }

    /// Returns tr(S) 1 − S, which converts second moments ∫ x xᵀ dm to the inertia tensor without
    /// cancellation.
    pub(crate) fn inertia_of_second_moments(&self) -> Self {
        Self {
            xx: self.yy + self.zz,
            yy: self.xx + self.zz,
            zz: self.xx + self.yy,
            xy: -self.xy,
            xz: -self.xz,
            yz: -self.yz,
        }
    }

    pub(crate) fn rows(&self) -> [[f64; 3]; 3] {
        [[self.xx, self.xy, self.xz], [self.xy, self.yy, self.yz], [self.xz, self.yz, self.zz]]
    }

    /// Returns S v.
    pub(crate) fn apply(&self, v: [f64; 3]) -> [f64; 3] {
        self.rows().map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    /// Returns R S Rᵀ, given the rows of R.
    pub(crate) fn rotated(&self, r: &[[f64; 3]; 3]) -> Self {
        let columns = r.map(|row| self.apply(row)); // S Rᵀ, column by column
        let element =
            |i: usize, j: usize| r[i][0] * columns[j][0] + r[i][1] * columns[j][1] + r[i][2] * columns[j][2];
        Self {
            xx: element(0, 0),
            yy: element(1, 1),
            zz: element(2, 2),
            xy: 0.5 * (element(0, 1) + element(1, 0)),
            xz: 0.5 * (element(0, 2) + element(2, 0)),
            yz: 0.5 * (element(1, 2) + element(2, 1)),
        }
    }

    /// Returns the matrix with the elements xx, yy, zz, xy, xz, yz.
    pub(crate) const fn from_elements([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Self {
        Self { xx, yy, zz, xy, xz, yz }
    }

    pub(crate) fn elements(&self) -> [f64; 6] {
        [self.xx, self.yy, self.zz, self.xy, self.xz, self.yz]
    }

    pub(crate) fn max_abs(&self) -> f64 {
        self.elements().iter().fold(0.0, |max, e| f64::max(max, e.abs()))
    }

    /// Computes eigenvalues and eigenvectors by cyclic Jacobi rotations.
    ///
    /// An off-diagonal element counts as zero if |a_pq| ≤ ½ε √|a_pp a_qq|, not if it is small
    /// compared with the largest element. A graded positive definite matrix (one that a diagonal
    /// scaling makes well-conditioned) then keeps full *relative* accuracy of its small
    /// eigenvalues. All others are accurate to a few ε of the largest.
    ///
    /// Source: Demmel & Veselić, SIAM J. Matrix Anal. Appl. 13 (1992) 1204; rotations as in Golub &
    /// Van Loan §8.5.
    pub(crate) fn eigen(&self) -> Eigen {
        // Scaling by a power of two brings the elements near 1: this is exact, and no square
        // overflows.
        let scale = power_of_two_near(self.max_abs());
        let mut a = (*self * (1.0 / scale)).rows();
        let mut v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for _sweep in 0..MAX_SWEEPS {
            let mut turned = false;
            for (p, q) in [(0, 1), (0, 2), (1, 2)] {
                turned |= annihilate(&mut a, &mut v, p, q);
            }
            if !turned {
                break;
            }
        }
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
        Eigen { values: order.map(|k| a[k][k] * scale), vectors: order.map(|k| [v[0][k], v[1][k], v[2][k]]) }
    }
}

/// Returns the eigenvalues, ascending, and unit eigenvectors of a symmetric matrix with the
/// elements xx, yy, zz, xy, xz, yz of any sign. If an element is not finite, all values are NaN.
///
/// It is meant for matrices that are not inertia tensors: [`crate::body::InertiaTensor`] has its
/// own principal axes, refined and right-handed. The values are accurate to a few ε of the largest;
/// the handedness of the vectors is not defined.
///
/// ```
/// let (values, vectors) = polhode::math::symmetric_eigen([2.0, -1.0, 5.0, 2.0, 0.0, 0.0]);
/// assert_eq!(values, [-2.0, 3.0, 5.0]);
/// // M v = −2 v
/// let [x, y, _] = vectors[0];
/// assert!((2.0 * x + 2.0 * y + 2.0 * x).abs() < 1e-15 && (2.0 * x - y + 2.0 * y).abs() < 1e-15);
/// ```
pub fn symmetric_eigen([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> ([f64; 3], [[f64; 3]; 3]) {
    let matrix = Symmetric3 { xx, yy, zz, xy, xz, yz };
    let Eigen { values, vectors } = matrix.eigen();
    if matrix.elements().iter().all(|x| x.is_finite()) { (values, vectors) } else { ([f64::NAN; 3], vectors) }
}

impl Eigen {
    /// Returns values and vectors that are the f64 numbers nearest to the exact ones of `matrix`,
    /// or their neighbours.
    ///
    /// The vectors V are orthonormalised, and D = Vᵀ S V is computed to 32 digits. A few more
    /// rotations remove the remaining off-diagonal elements. For distinct values, the error is then
    /// rounding only; the vectors of values that are equal to about 1e-16 are any orthonormal ones
    /// in their plane.
    pub(crate) fn polished(&self, matrix: &Symmetric3) -> Self {
        let scale = power_of_two_near(matrix.max_abs());
        let s = (*matrix * (1.0 / scale)).rows().map(|row| row.map(Double::from));
        let mut v = orthonormal(&self.vectors.map(|column| column.map(Double::from)));
        // D = Vᵀ S V, with the columns of V in the rows of `v`.
        let dot = |a: &[Double; 3], b: &[Double; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let images = v.map(|column| s.map(|row| dot(&row, &column)));
        let mut d: [[Double; 3]; 3] =
            core::array::from_fn(|i| core::array::from_fn(|j| dot(&v[i], &images[j])));
        for _sweep in 0..POLISHING_SWEEPS {
            let mut turned = false;
            for (p, q) in [(0, 1), (0, 2), (1, 2)] {
                turned |= annihilate_more(&mut d, &mut v, p, q);
            }
            if !turned {
                break;
            }
        }
        // A value that is more accurate than double-double arithmetic, as for graded matrices, is
        // kept.
        let value = |k: usize| {
            let before = self.values[k] / scale;
            let agrees = (d[k][k] - Double::from(before)).value().abs() <= TWO_WORDS;
            if agrees { self.values[k] } else { d[k][k].value() * scale }
        };
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| value(i).total_cmp(&value(j)));
        Self { values: order.map(value), vectors: order.map(|k| v[k].map(Double::value)) }
    }
}

/// Iteration limit only.
const POLISHING_SWEEPS: usize = 4;

/// Off-diagonal elements below 2⁻⁷⁰ of the largest element do not change any f64 result.
const NEGLIGIBLE: f64 = 1.0 / (1_u128 << 70) as f64;

/// Accuracy of sums of double-double products.
const TWO_WORDS: f64 = 1.0 / (1_u128 << 100) as f64;

/// Returns V (3 − VᵀV) / 2, which makes vectors that are orthonormal except for rounding
/// orthonormal to 31 digits (Newton–Schulz).
fn orthonormal(v: &[[Double; 3]; 3]) -> [[Double; 3]; 3] {
    let dot = |a: &[Double; 3], b: &[Double; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let weight = |i: usize, j: usize| {
        let three = Double::from(if i == j { 3.0 } else { 0.0 });
        (three - dot(&v[i], &v[j])).scaled(0.5)
    };
    core::array::from_fn(|j| {
        let [a, b, c] = [weight(0, j), weight(1, j), weight(2, j)];
        core::array::from_fn(|k| v[0][k] * a + v[1][k] * b + v[2][k] * c)
    })
}

/// Returns the f64 vectors nearest to orthonormal ones, from vectors that are orthonormal except
/// for some rounding.
pub(crate) fn nearest_orthonormal(v: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    orthonormal(&v.map(|vector| vector.map(Double::from))).map(|vector| vector.map(Double::value))
}

/// Works like [`annihilate`] in double-double arithmetic; the rows of `v` are the vectors.
fn annihilate_more(a: &mut [[Double; 3]; 3], v: &mut [[Double; 3]; 3], p: usize, q: usize) -> bool {
    let apq = a[p][q];
    if apq.value().abs() <= NEGLIGIBLE {
        return false;
    }
    // The rotation need not be optimal, but must be orthogonal: t is rounded, c and s are not.
    let zeta = (a[q][q] - a[p][p]).value() / (2.0 * apq.value());
    let t = 1.0_f64.copysign(zeta) / (zeta.abs() + libm::hypot(1.0, zeta));
    let tangent = Double::from(t);
    let c = Double::ONE / (Double::ONE + tangent.square()).sqrt();
    let s = tangent * c;
    let turned = |x: Double, y: Double| (c * x - s * y, s * x + c * y);
    for row in a.iter_mut() {
        (row[p], row[q]) = turned(row[p], row[q]);
    }
    for k in 0..3 {
        (a[p][k], a[q][k]) = turned(a[p][k], a[q][k]);
        (v[p][k], v[q][k]) = turned(v[p][k], v[q][k]);
    }
    true
}

/// Iteration limit only: the convergence is quadratic, and a few sweeps are sufficient.
const MAX_SWEEPS: usize = 32;

/// Performs one Jacobi rotation that makes `a_pq` zero; returns false if it was already negligible.
fn annihilate(a: &mut [[f64; 3]; 3], v: &mut [[f64; 3]; 3], p: usize, q: usize) -> bool {
    let apq = a[p][q];
    let negligible = 0.5 * f64::EPSILON * (a[p][p].abs().sqrt() * a[q][q].abs().sqrt());
    // A subnormal residue next to zero diagonal elements is rounding, too.
    if apq.abs() <= negligible.max(f64::MIN_POSITIVE) {
        a[p][q] = 0.0;
        a[q][p] = 0.0;
        return false;
    }
    // t = tan of the angle: the smaller root of t² + 2ζt − 1 = 0.
    let zeta = (a[q][q] - a[p][p]) / (2.0 * apq);
    let t =
        if zeta.is_infinite() { 0.0 } else { 1.0_f64.copysign(zeta) / (zeta.abs() + libm::hypot(1.0, zeta)) };
    let c = 1.0 / (1.0 + t * t).sqrt();
    let s = t * c;
    a[p][p] -= t * apq;
    a[q][q] += t * apq;
    a[p][q] = 0.0;
    a[q][p] = 0.0;
    let r = 3 - p - q;
    let (arp, arq) = (a[r][p], a[r][q]);
    a[r][p] = c * arp - s * arq;
    a[p][r] = a[r][p];
    a[r][q] = s * arp + c * arq;
    a[q][r] = a[r][q];
    for row in v.iter_mut() {
        let (vp, vq) = (row[p], row[q]);
        row[p] = c * vp - s * vq;
        row[q] = s * vp + c * vq;
    }
    true
}

/// Returns the largest power of two that does not exceed |x|; 1 for zero, NaN and infinity.
pub(crate) fn power_of_two_near(x: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return 1.0;
    }
    let (_, exponent) = libm::frexp(x);
    // Limited to the inner part of the range, so that the inverse is finite too.
    libm::ldexp(1.0, (exponent - 1).clamp(-1000, 1000))
}

impl Add for Symmetric3 {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self {
            xx: self.xx + b.xx,
            yy: self.yy + b.yy,
            zz: self.zz + b.zz,
            xy: self.xy + b.xy,
            xz: self.xz + b.xz,
            yz: self.yz + b.yz,
        }
    }
}

impl Sub for Symmetric3 {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + b * -1.0
    }
}

impl Mul<f64> for Symmetric3 {
    type Output = Self;
    fn mul(self, s: f64) -> Self {
        Self {
            xx: self.xx * s,
            yy: self.yy * s,
            zz: self.zz * s,
            xy: self.xy * s,
            xz: self.xz * s,
            yz: self.yz * s,
        }
    }
}
