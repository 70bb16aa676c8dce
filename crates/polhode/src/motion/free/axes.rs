//! Principal axes in two words, of a tensor as it is given.

use crate::body::principal::{PrincipalFrame, Symmetry};
use crate::math::double::Double;
use crate::math::frame::Body;
use crate::math::symmetric3::{Symmetric3, power_of_two_near};

/// Principal moments in any order, and right-handed axes, to about 30 digits: after 10⁹ turns the 16 digits of a
/// [`PrincipalFrame`] would be 7.
#[derive(Clone, Copy, Debug)]
pub(super) struct FineAxes {
    /// In units of `unit`.
    pub(super) moments: [Double; 3],
    pub(super) axes: [[Double; 3]; 3],
    /// A power of two, kg·m².
    pub(super) unit: f64,
    /// True if these are the tensor's numbers as given, with no rounding of ours.
    pub(super) given: bool,
}

impl FineAxes {
    /// Of a tensor; along the frame's own axes it is exact.
    pub(super) fn of(tensor: &Symmetric3, principal: &PrincipalFrame<Body>) -> Self {
        let unit = power_of_two_near(principal.moments()[2]);
        let scaled = *tensor * (1.0 / unit);
        if [scaled.xy, scaled.xz, scaled.yz] == [0.0; 3] {
            let moments = [scaled.xx, scaled.yy, scaled.zz].map(Double::from);
            return Self { moments, axes: identity(), unit, given: true };
        }
        let coarse = Self {
            moments: principal.moments().map(|i| Double::from(i / unit)),
            axes: principal.axes().map(|axis| axis.to_array().map(Double::from)),
            unit,
            given: false,
        };
        // A rod's own moment is zero, and what is found there is rounding.
        if principal.symmetry() == Symmetry::Rod {
            return coarse;
        }
        let fine = diagonalised(&scaled, principal, unit);
        if fine.moments.iter().all(|i| i.high > 0.0) { fine } else { coarse }
    }

    /// The components of a body vector along the axes.
    pub(super) fn along(&self, v: [f64; 3]) -> [Double; 3] {
        let v = v.map(Double::from);
        self.axes.map(|axis| dot(axis, v))
    }
}

fn identity() -> [[Double; 3]; 3] {
    let (one, zero) = (Double::ONE, Double::default());
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
}

fn dot(a: [Double; 3], b: [Double; 3]) -> Double {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Jacobi rotations from the axes that are right to one word: one sweep more makes them right to two.
fn diagonalised(tensor: &Symmetric3, principal: &PrincipalFrame<Body>, unit: f64) -> FineAxes {
    let mut axes = orthonormal(principal.axes().map(|axis| axis.to_array().map(Double::from)));
    let rows = tensor.rows().map(|row| row.map(Double::from));
    let images = axes.map(|axis| rows.map(|row| dot(row, axis)));
    let mut a = axes.map(|axis| images.map(|image| dot(axis, image)));
    for _sweep in 0..MOST_SWEEPS {
        let mut turned = false;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            turned |= annihilate(&mut a, &mut axes, p, q);
        }
        if !turned {
            break;
        }
    }
    FineAxes { moments: [a[0][0], a[1][1], a[2][2]], axes, unit, given: false }
}

/// A guard only.
const MOST_SWEEPS: usize = 16;

/// Gram–Schmidt; the third axis completes a right-handed set.
fn orthonormal([first, second, _]: [[Double; 3]; 3]) -> [[Double; 3]; 3] {
    let unit = |v: [Double; 3]| {
        let norm = dot(v, v).sqrt();
        v.map(|c| c / norm)
    };
    let e1 = unit(first);
    let along = dot(e1, second);
    let e2 = unit([0, 1, 2].map(|k| second[k] - along * e1[k]));
    let cross = |i: usize, j: usize| e1[i] * e2[j] - e1[j] * e2[i];
    [e1, e2, [cross(1, 2), cross(2, 0), cross(0, 1)]]
}

/// One Jacobi rotation, which makes a_pq zero; false if it was negligible already (Golub & Van Loan, §8.5).
fn annihilate(a: &mut [[Double; 3]; 3], axes: &mut [[Double; 3]; 3], p: usize, q: usize) -> bool {
    let apq = a[p][q];
    if apq.abs().high <= 1e-32 * (a[p][p].high.abs() * a[q][q].high.abs()).sqrt() {
        return false;
    }
    // t = tan of the angle: the smaller root of t² + 2ζt − 1 = 0
    let zeta = (a[q][q] - a[p][p]) / apq.scaled(2.0);
    let root = (zeta.square() + Double::ONE).sqrt();
    let t = if zeta.high < 0.0 { -(Double::ONE / (root - zeta)) } else { Double::ONE / (root + zeta) };
    let c = Double::ONE / (t.square() + Double::ONE).sqrt();
    let s = t * c;
    a[p][p] = a[p][p] - t * apq;
    a[q][q] = a[q][q] + t * apq;
    (a[p][q], a[q][p]) = (Double::default(), Double::default());
    let r = 3 - p - q;
    let (arp, arq) = (a[r][p], a[r][q]);
    a[r][p] = c * arp - s * arq;
    a[r][q] = s * arp + c * arq;
    (a[p][r], a[q][r]) = (a[r][p], a[r][q]);
    let (ep, eq) = (axes[p], axes[q]);
    axes[p] = [0, 1, 2].map(|k| c * ep[k] - s * eq[k]);
    axes[q] = [0, 1, 2].map(|k| s * ep[k] + c * eq[k]);
    true
}
