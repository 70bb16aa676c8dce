//! Newton–Euler equations about the sensor's origin.
//!
//! Define s = a − g, h = m c, and the tensor I about the origin. Then
//!
//! f = m s + α × h + ω × (ω × h),  τ = h × s + I α + ω × I ω
//!
//! is linear in m, h and I. Source: C. G. Atkeson, C. H. An, J. M. Hollerbach, Int. J. Robot. Res.
//! 5 (1986) 101, eqs. 4–9.

use super::small::{Vector6, cross, dot};
use crate::six::PLACES;

/// Motion at one time: ω, α and a − g.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Motion(pub(super) [f64; 9]);

/// Derivatives of the wrench by the parameters m, m c, Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
pub(super) type Regressor = [[f64; 10]; 6];

const UNITS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Motion {
    fn parts(&self) -> [[f64; 3]; 3] {
        let m = &self.0;
        [[m[0], m[1], m[2]], [m[3], m[4], m[5]], [m[6], m[7], m[8]]]
    }

    /// Returns the regressor: column k is the wrench on the payload for parameter k = 1 and all
    /// others 0.
    pub(super) fn regressor(&self) -> Regressor {
        let [w, a, s] = self.parts();
        let mut all = [[0.0; 10]; 6];
        for i in 0..3 {
            all[i][0] = s[i];
        }
        for (j, h) in UNITS.into_iter().enumerate() {
            let (euler, centrifugal, moment) = (cross(a, h), cross(w, cross(w, h)), cross(h, s));
            for i in 0..3 {
                all[i][1 + j] = euler[i] + centrifugal[i];
                all[3 + i][1 + j] = moment[i];
            }
        }
        for k in 0..6 {
            let gyroscopic = cross(w, element_times(k, w));
            let euler = element_times(k, a);
            for i in 0..3 {
                all[3 + i][4 + k] = euler[i] + gyroscopic[i];
            }
        }
        all
    }

    /// Returns the motion plus a multiple of a direction.
    pub(super) fn moved(&self, direction: &[f64; 9], by: f64) -> Self {
        Self(core::array::from_fn(|k| self.0[k] + by * direction[k]))
    }

    /// Returns the derivative of the wrench on the payload by ω, α and a − g.
    pub(super) fn jacobian(&self, numbers: &[f64]) -> [[f64; 9]; 6] {
        let [w, ..] = self.parts();
        let m = numbers[0];
        let h = [numbers[1], numbers[2], numbers[3]];
        let times = |v: [f64; 3]| {
            let mut sum = [0.0; 3];
            for k in 0..6 {
                let part = element_times(k, v);
                (0..3).for_each(|i| sum[i] += numbers[4 + k] * part[i]);
            }
            sum
        };
        let momentum = times(w);
        let mut all = [[0.0; 9]; 6];
        for (j, e) in UNITS.into_iter().enumerate() {
            // d(ω × (ω × h)) = e × (ω × h) + ω × (e × h), d(ω × I ω) = e × I ω + ω × I e
            let (first, second) = (cross(e, cross(w, h)), cross(w, cross(e, h)));
            let (third, fourth) = (cross(e, momentum), cross(w, times(e)));
            let (euler, turned, moment) = (cross(e, h), times(e), cross(h, e));
            for i in 0..3 {
                all[i][j] = first[i] + second[i];
                all[3 + i][j] = third[i] + fourth[i];
                all[i][3 + j] = euler[i];
                all[3 + i][3 + j] = turned[i];
                all[i][6 + j] = m * e[i];
                all[3 + i][6 + j] = moment[i];
            }
        }
        all
    }
}

/// Returns the wrench of a regressor and parameters.
pub(super) fn wrench_of(regressor: &Regressor, numbers: &[f64]) -> Vector6 {
    regressor.map(|row| dot(&row, numbers))
}

/// Returns E v, where E has ones at one element of the tensor and its transpose.
fn element_times(k: usize, v: [f64; 3]) -> [f64; 3] {
    let (i, j) = PLACES[k];
    let mut product = [0.0; 3];
    product[i] = v[j];
    product[j] = v[i];
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOTION: Motion = Motion([0.7, -1.1, 0.4, 2.1, 0.6, -1.7, 3.2, -8.1, 4.4]);
    const NUMBERS: [f64; 10] = [1.7, 0.31, -0.22, 0.43, 0.31, 0.42, 0.53, 0.04, -0.03, 0.02];

    #[test]
    fn the_wrench_is_the_sum_over_particles() {
        let points = [[0.3, -0.1, 0.2], [-0.2, 0.15, 0.4], [0.1, 0.25, -0.3], [0.05, -0.3, 0.12]];
        let masses = [0.4, 0.7, 0.3, 1.1];
        let [w, a, s] = MOTION.parts();
        let mut numbers = [0.0; 10];
        let mut wrench = [0.0; 6];
        for (m, r) in masses.into_iter().zip(points) {
            let (euler, centrifugal) = (cross(a, r), cross(w, cross(w, r)));
            let f: [f64; 3] = core::array::from_fn(|i| m * (s[i] + euler[i] + centrifugal[i]));
            let t = cross(r, f);
            for i in 0..3 {
                wrench[i] += f[i];
                wrench[3 + i] += t[i];
                numbers[1 + i] += m * r[i];
            }
            numbers[0] += m;
            for (k, (i, j)) in PLACES.into_iter().enumerate() {
                let square = if i == j { dot(&r, &r) } else { 0.0 };
                numbers[4 + k] += m * (square - r[i] * r[j]);
            }
        }
        for (a, b) in wrench_of(&MOTION.regressor(), &numbers).into_iter().zip(wrench) {
            assert!((a - b).abs() < 1e-13, "{a} {b}");
        }
    }

    #[test]
    fn the_jacobian_is_that_of_differences() {
        let jacobian = MOTION.jacobian(&NUMBERS);
        for k in 0..9 {
            let mut direction = [0.0; 9];
            direction[k] = 1.0;
            let there = wrench_of(&MOTION.moved(&direction, 0.5).regressor(), &NUMBERS);
            let back = wrench_of(&MOTION.moved(&direction, -0.5).regressor(), &NUMBERS);
            for i in 0..6 {
                // Exact, because the wrench is quadratic in the motion.
                assert!((there[i] - back[i] - jacobian[i][k]).abs() < 1e-13);
            }
        }
    }
}
