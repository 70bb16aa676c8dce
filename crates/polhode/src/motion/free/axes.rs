//! Principal axes in three words, of a tensor as it is given.

use crate::body::principal::{PrincipalFrame, Symmetry};
use crate::math::frame::Body;
use crate::math::symmetric3::{Symmetric3, power_of_two_near};
use crate::math::triple::Triple;

/// Principal moments in any order, and right-handed axes, to about 46 digits: after 10⁹ turns the 16 digits of a
/// [`PrincipalFrame`] would be 7, and differences of moments have fewer still.
#[derive(Clone, Copy, Debug)]
pub(super) struct FineAxes {
    /// In units of `unit`.
    pub(super) moments: [Triple; 3],
    pub(super) axes: [[Triple; 3]; 3],
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
            let moments = [scaled.xx, scaled.yy, scaled.zz].map(Triple::from);
            let (one, zero) = (Triple::from(1.0), Triple::default());
            return Self {
                moments,
                axes: [[one, zero, zero], [zero, one, zero], [zero, zero, one]],
                unit,
                given: true,
            };
        }
        let ([a, b, c], axes) = diagonalised(&scaled);
        let moments = if principal.symmetry() == Symmetry::Rod {
            // A rod's own moment is zero, and what is found there is rounding, as is the difference of the others.
            let m = (b + c).scaled(0.5);
            [Triple::default(), m, m]
        } else {
            [a, b, c]
        };
        Self { moments, axes, unit, given: false }
    }

    /// The components of a body vector along the axes.
    pub(super) fn along(&self, v: [f64; 3]) -> [Triple; 3] {
        let v = v.map(Triple::from);
        if self.given {
            return v;
        }
        self.axes.map(|axis| dot(axis, v))
    }
}

fn dot(a: [Triple; 3], b: [Triple; 3]) -> Triple {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Moments, ascending but for rounding, and axes: Jacobi rotations from the axes that are right to one word.
///
/// Of the tensor less one of its diagonal elements, which is exact: the differences of nearly equal moments keep their own
/// digits.
fn diagonalised(tensor: &Symmetric3) -> ([Triple; 3], [[Triple; 3]; 3]) {
    let shift = tensor.xx;
    let rest = |element: f64| Triple::from(element) - Triple::from(shift);
    let [xx, yy, zz] = [tensor.xx, tensor.yy, tensor.zz].map(rest);
    let [xy, xz, yz] = [tensor.xy, tensor.xz, tensor.yz].map(Triple::from);
    let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];

    let coarse = Symmetric3 { xx: xx.value(), yy: yy.value(), zz: zz.value(), ..*tensor }.eigen();
    let mut axes = orthonormal(coarse.vectors.map(|axis| axis.map(Triple::from)));
    let images = axes.map(|axis| rows.map(|row| dot(row, axis)));
    let mut a = axes.map(|axis| images.map(|image| dot(axis, image)));
    let negligible = NEGLIGIBLE * coarse.values.iter().fold(0.0, |max: f64, value| max.max(value.abs()));
    for _sweep in 0..MOST_SWEEPS {
        let mut turned = false;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            turned |= annihilate(&mut a, &mut axes, [p, q], negligible);
        }
        if !turned {
            break;
        }
    }
    ([0, 1, 2].map(|k| a[k][k] + Triple::from(shift)), axes)
}

/// Part of the largest element.
const NEGLIGIBLE: f64 = 1e-46;

/// A guard only.
const MOST_SWEEPS: usize = 16;

/// Gram–Schmidt; the third axis completes a right-handed set.
fn orthonormal([first, second, _]: [[Triple; 3]; 3]) -> [[Triple; 3]; 3] {
    let unit = |v: [Triple; 3]| {
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
fn annihilate(
    a: &mut [[Triple; 3]; 3],
    axes: &mut [[Triple; 3]; 3],
    [p, q]: [usize; 2],
    negligible: f64,
) -> bool {
    let apq = a[p][q];
    if apq.value().abs() <= negligible {
        return false;
    }
    let one = Triple::from(1.0);
    // t = tan of the angle: the smaller root of t² + 2ζt − 1 = 0
    let zeta = (a[q][q] - a[p][p]) / apq.scaled(2.0);
    let root = (zeta.square() + one).sqrt();
    let t = if zeta.value() < 0.0 { -(one / (root - zeta)) } else { one / (root + zeta) };
    let c = one / (t.square() + one).sqrt();
    let s = t * c;
    a[p][p] = a[p][p] - t * apq;
    a[q][q] = a[q][q] + t * apq;
    (a[p][q], a[q][p]) = (Triple::default(), Triple::default());
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
