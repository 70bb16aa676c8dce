//! Attitude that accumulates many small rotations.

use crate::math::frame::{Principal, Space};
use crate::math::number::sin_cos;
use crate::math::rotation::Rotation;
use crate::math::sum::two_sum;
use crate::math::vector::Direction;

/// Unit quaternion with compensated summation. The error after n rotations of d rad each is about ε
/// d √n instead of ε √n.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orientation {
    q: [f64; 4],
    carry: [f64; 4],
}

impl Orientation {
    pub(super) fn new(rotation: Rotation<Space, Principal>) -> Self {
        Self { q: rotation.quaternion(), carry: [0.0; 4] }
    }

    #[inline(always)]
    pub(super) fn rotation(&self) -> Rotation<Space, Principal> {
        Rotation::from_unit(self.quaternion())
    }

    /// Multiplies by a rotation: q ← q ⊗ exp(θ/2) = q + q ⊗ d, d = (−2 sin²(|θ|/4), sin(|θ|/2)
    /// θ/|θ|).
    pub(super) fn turn(&mut self, theta: Direction<Principal>) {
        let angle = theta.norm();
        if angle == 0.0 {
            return;
        }
        let (s, _) = sin_cos(0.25 * angle);
        let dw = -2.0 * s * s;
        let [dx, dy, dz] = (theta * (sin_cos(0.5 * angle).0 / angle)).to_array();
        self.add([dw, dx, dy, dz]);
    }

    /// Returns q/|q|, where |q| is 1 up to rounding, as in [`Rotation::near_unit`].
    fn quaternion(&self) -> [f64; 4] {
        let [w, x, y, z] = self.q;
        let s = 1.5 - 0.5 * (w * w + x * x + y * y + z * z);
        [s * w, s * x, s * y, s * z]
    }

    /// Adds a small rotation: q ← q ⊗ (1 + d) = q + q ⊗ d.
    pub(super) fn add(&mut self, [dw, dx, dy, dz]: [f64; 4]) {
        let [w, x, y, z] = self.q;
        let increment = [
            w * dw - x * dx - y * dy - z * dz,
            w * dx + x * dw + y * dz - z * dy,
            w * dy - x * dz + y * dw + z * dx,
            w * dz + x * dy - y * dx + z * dw,
        ];
        for ((q, carry), increment) in self.q.iter_mut().zip(&mut self.carry).zip(increment) {
            (*q, *carry) = two_sum(*q, increment + *carry);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_turns_come_round() {
        // 1 000 003 equal rotations about a generic axis, 50 000 full turns in total
        let n = 1_000_003;
        let axis = Direction::new(0.48, -0.6, 0.64);
        let step = axis * (50_000.0 * 2.0 * crate::math::number::PI / f64::from(n));
        let start = Rotation::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
        let mut orientation = Orientation::new(start);
        for _ in 0..n {
            orientation.turn(step);
        }
        // The step itself is rounded, so an error of ε times 314 159 rad is allowed.
        let error = orientation.rotation().angle_to(start);
        assert!(error < 6e-11, "{error:e}");
        // Rounding of the step does not affect the direction perpendicular to the axis.
        let tilt = (orientation.rotation() * axis).angle_to(start * axis);
        assert!(tilt < 2e-14, "{tilt:e}");
    }
}
