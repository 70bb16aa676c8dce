//! Symmetric 3×3 matrices and their eigenvectors.

use core::ops::{Add, Mul, Sub};

/// A symmetric 3×3 matrix by its six elements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Symmetric3 {
    pub(crate) xx: f64,
    pub(crate) yy: f64,
    pub(crate) zz: f64,
    pub(crate) xy: f64,
    pub(crate) xz: f64,
    pub(crate) yz: f64,
}

/// Eigenvalues in ascending order; `vectors[k]` belongs to `values[k]`; orthonormal, either handedness.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Eigen {
    pub(crate) values: [f64; 3],
    pub(crate) vectors: [[f64; 3]; 3],
}

impl Symmetric3 {
    pub(crate) const fn diagonal([xx, yy, zz]: [f64; 3]) -> Self {
        Self { xx, yy, zz, xy: 0.0, xz: 0.0, yz: 0.0 }
    }

    /// v vᵀ
    pub(crate) fn outer([x, y, z]: [f64; 3]) -> Self {
        Self { xx: x * x, yy: y * y, zz: z * z, xy: x * y, xz: x * z, yz: y * z }
    }

    /// tr(S) 1 − S: the second moments ∫ x xᵀ dm become the inertia tensor, written without cancellation.
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

    /// S v
    pub(crate) fn apply(&self, v: [f64; 3]) -> [f64; 3] {
        self.rows().map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    /// R S Rᵀ, rows of `r` given.
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

    pub(crate) fn elements(&self) -> [f64; 6] {
        [self.xx, self.yy, self.zz, self.xy, self.xz, self.yz]
    }

    pub(crate) fn max_abs(&self) -> f64 {
        self.elements().iter().fold(0.0, |max, e| f64::max(max, e.abs()))
    }

    /// Eigenvalues and eigenvectors by cyclic Jacobi rotations.
    ///
    /// An off-diagonal element is left alone once |a_pq| ≤ ½ε √|a_pp a_qq|, not once it is small beside the largest
    /// element: a graded positive definite matrix (one that a diagonal scaling makes well-conditioned) then keeps its
    /// small eigenvalues to full *relative* accuracy. All others are accurate to a few ε of the largest.
    ///
    /// Source: Demmel & Veselić, SIAM J. Matrix Anal. Appl. 13 (1992) 1204; rotations as in Golub & Van Loan §8.5.
    pub(crate) fn eigen(&self) -> Eigen {
        // A power of two brings the elements near 1: exact, and no square overflows.
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

/// A guard only: the convergence is quadratic, and a few sweeps do.
const MAX_SWEEPS: usize = 32;

/// One Jacobi rotation, which makes a_pq zero; false if it was negligible already.
fn annihilate(a: &mut [[f64; 3]; 3], v: &mut [[f64; 3]; 3], p: usize, q: usize) -> bool {
    let apq = a[p][q];
    let negligible = 0.5 * f64::EPSILON * (a[p][p].abs().sqrt() * a[q][q].abs().sqrt());
    // A subnormal residue beside zero diagonals is rounding, too.
    if apq.abs() <= negligible.max(f64::MIN_POSITIVE) {
        a[p][q] = 0.0;
        a[q][p] = 0.0;
        return false;
    }
    // t = tan of the angle: the smaller root of t² + 2ζt − 1 = 0
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

/// The power of two at or just below |x|; 1 for zero.
pub(crate) fn power_of_two_near(x: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return 1.0;
    }
    let (_, exponent) = libm::frexp(x);
    // Kept away from the ends of the range, so that its inverse is finite too.
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
