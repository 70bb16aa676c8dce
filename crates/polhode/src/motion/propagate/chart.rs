//! The motion as an ordinary differential equation, in a chart around the attitude at the start of each step.
//!
//! Within a step the attitude is attitude(t₀) · turn(p), p = 4 n tan(θ/4) (four times the modified Rodrigues
//! parameters: nearly the rotation vector n θ). Then
//!
//! ṗ = (1 − p²/16) ω + ½ p × ω + ⅛ (p · ω) p
//!
//! is polynomial, three numbers instead of a quaternion's four hold the attitude, the quaternion is unit because it
//! is made from p, and an error δp *is* an angle: |δp| / (1 + p²/16) rad. Beside p and ω (principal axes) the state
//! carries the work W and the angular impulse J of the torque, as evidence: Ẇ = N · ω, J̇ = N in space.
//!
//! Source: Schaub & Junkins, Analytical Mechanics of Space Systems, eq. (3.159), with p = 4σ.

use crate::math::frame::{Body, Principal, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularMomentum, AngularVelocity, Direction, Torque, Vector};
use crate::motion::error::MotionError;
use crate::motion::euler::euler;
use crate::motion::rotor::Rotor;
use crate::motion::state::State;
use crate::motion::torque::{TorqueModel, total_torque};

/// p (3), ω (3), W, J (3).
pub(super) const N: usize = 10;
pub(super) type Y = [f64; N];

/// The equations of motion around one attitude.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chart<'a> {
    pub(super) rotor: &'a Rotor,
    pub(super) torques: &'a [TorqueModel],
    /// The attitude of the principal axes at p = 0.
    pub(super) center: Rotation<Space, Principal>,
}

impl Chart<'_> {
    /// dy/dt.
    pub(super) fn derivative(&self, t: f64, y: &Y) -> Y {
        let (p, omega) = (p(y), omega(y));
        let (torque, attitude) = self.torque(t, y);
        let p_dot = p_dot(p, omega);
        let omega_dot = euler(self.rotor.principal().moments(), omega, torque);
        let impulse = if self.torques.is_empty() { Torque::ZERO } else { attitude * torque };
        let work = torque.dot(omega);
        let mut dy = [0.0; N];
        dy[0..3].copy_from_slice(&p_dot.to_array());
        dy[3..6].copy_from_slice(&omega_dot.to_array());
        dy[6] = work;
        dy[7..10].copy_from_slice(&impulse.to_array());
        dy
    }

    /// The attitude of the principal axes.
    pub(super) fn attitude(&self, y: &Y) -> Rotation<Space, Principal> {
        self.center * from_chart(p(y))
    }

    /// The state in body axes.
    pub(super) fn state(&self, t: f64, y: &Y) -> State {
        let r = self.rotor.principal().rotation();
        State { time: t, attitude: self.attitude(y) * r.inverse(), omega: r * omega(y) }
    }

    /// Refuses a torque about an axis that has no inertia: nothing would balance it.
    pub(super) fn require_determined(&self, t: f64, y: &Y) -> Result<(), MotionError> {
        let (torque, _) = self.torque(t, y);
        let allowed = 1e-9 * torque.max_abs();
        for (n, i) in torque.to_array().into_iter().zip(self.rotor.principal().moments()) {
            if i == 0.0 && n.abs() > allowed {
                return Err(MotionError::TorqueWithoutInertia { torque: n, time: t });
            }
        }
        Ok(())
    }

    fn torque(&self, t: f64, y: &Y) -> (Torque<Principal>, Rotation<Space, Principal>) {
        if self.torques.is_empty() {
            return (Torque::ZERO, self.center);
        }
        let state = self.state(t, y);
        let torque: Torque<Body> = total_torque(self.torques, self.rotor, &state);
        (self.rotor.principal().rotation().inverse() * torque, self.attitude(y))
    }
}

/// y at the centre of a chart.
pub(super) fn at_center(omega: AngularVelocity<Principal>, work: f64, impulse: AngularMomentum<Space>) -> Y {
    let ([a, b, c], [j, k, l]) = (omega.to_array(), impulse.to_array());
    [0.0, 0.0, 0.0, a, b, c, work, j, k, l]
}

/// ω in principal axes.
pub(super) fn omega(y: &Y) -> AngularVelocity<Principal> {
    Vector::new(y[3], y[4], y[5])
}

/// The work done by the torque.
pub(super) fn work(y: &Y) -> f64 {
    y[6]
}

/// The angular impulse of the torque.
pub(super) fn impulse(y: &Y) -> AngularMomentum<Space> {
    Vector::new(y[7], y[8], y[9])
}

/// The angle, in rad, that an error of p at p is.
pub(super) fn angle_of_error(error: Direction<Principal>, y: &Y) -> f64 {
    let p = p(y);
    error.norm() / (1.0 + p.dot(p) / 16.0)
}

/// |p| of a turn by 2 rad: a step should stay on this side of it.
pub(super) const LARGEST_TURN: f64 = 2.0;

fn p(y: &Y) -> Direction<Principal> {
    Vector::new(y[0], y[1], y[2])
}

fn p_dot(p: Direction<Principal>, omega: AngularVelocity<Principal>) -> Direction<Principal> {
    let w: Direction<Principal> = omega.as_quantity();
    w * (1.0 - p.dot(p) / 16.0) + p.cross(w) * 0.5 + p * (p.dot(w) / 8.0)
}

/// q = ((1 − σ²), 2σ) / (1 + σ²), σ = p/4
fn from_chart(p: Direction<Principal>) -> Rotation<Principal, Principal> {
    let s = p * 0.25;
    let s2 = s.dot(s);
    Rotation::from_parts([1.0 - s2, 2.0 * s.x, 2.0 * s.y, 2.0 * s.z])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_chart_turns_as_omega_says() {
        // Differentiate the rotation itself: R(p(t)) must turn at ω, at a generic p.
        let p0 = Direction::new(0.9, -0.6, 1.3);
        let w = AngularVelocity::<Principal>::new(0.7, -1.1, 0.4);
        let h = 1e-5;
        let rate = p_dot(p0, w);
        let step = from_chart(p0 - rate * h).inverse() * from_chart(p0 + rate * h);
        let [_, x, y, z] = step.canonical_quaternion();
        let turned = Vector::<crate::quantity::AngularVelocity, Principal>::new(x, y, z) / h; // half the angle over h
        assert!((turned - w).norm() < 1e-9, "{turned:?}");
    }

    #[test]
    fn an_error_of_p_is_an_angle() {
        let p0 = Direction::new(0.9, -0.6, 1.3);
        let e = Direction::new(1e-7, 2e-7, -2e-7);
        let mut y = [0.0; N];
        y[0..3].copy_from_slice(&p0.to_array());
        let angle = from_chart(p0).angle_to(from_chart(p0 + e));
        assert!((angle / angle_of_error(e, &y) - 1.0).abs() < 1e-6);
    }
}
