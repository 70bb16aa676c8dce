//! Motion as an ordinary differential equation, in a chart around the attitude at the start of each
//! step.
//!
//! Within a step the attitude is attitude(t₀) · turn(θ), where θ is the rotation vector (|θ| rad
//! about θ), and
//!
//! θ̇ = ω + ½ θ × ω + c θ × (θ × ω),  c = (1 − (θ/2) cot(θ/2)) / θ²
//!
//! Advantages: three numbers instead of four describe the attitude, and the quaternion made from θ
//! is always a unit quaternion. An error δθ is an angle. A steady rotation is linear in time, so
//! the step size depends only on the deviation from it.
//!
//! The state has θ and ω (principal axes), and as a check the work W and the angular impulse J of
//! the torque: Ẇ = N · ω, J̇ = N in space.
//!
//! Source: Bortz, IEEE Trans. Aerosp. Electron. Syst. 7 (1971) 61; as a Lie-group method, θ̇ =
//! dexp⁻¹ ω (Munthe-Kaas, BIT 38 (1998) 92).

use std::rc::Rc;

use crate::math::frame::{Body, Principal, Space};
use crate::math::number::sin_cos;
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularMomentum, AngularVelocity, Direction, Torque, Vector};
use crate::motion::error::MotionError;
use crate::motion::model::euler::euler;
use crate::motion::model::state::State;

use super::piece::Piece;
use super::rounding::{ROUNDING, THIN};

/// Number of variables: θ (3), ω (3), W, J (3).
pub(super) const N: usize = 10;
pub(super) type Y = [f64; N];

/// Equations of motion around one attitude.
#[derive(Clone, Debug)]
pub(super) struct Chart<'a> {
    /// Acting torques and body.
    pub(super) piece: Rc<Piece<'a>>,
    /// Attitude of the principal axes at θ = 0.
    pub(super) center: Rotation<Space, Principal>,
}

impl Chart<'_> {
    /// Returns dy/dt.
    pub(super) fn derivative(&self, t: f64, y: &Y) -> Y {
        let (omega, piece) = (omega(y), &*self.piece);
        let moments = piece.rotor.principal().moments();
        if piece.is_free() {
            let [a, b, c] = theta_dot(theta(y), omega).to_array();
            let [p, q, r] = euler(moments, omega, Torque::ZERO).to_array();
            return [a, b, c, p, q, r, 0.0, 0.0, 0.0, 0.0];
        }
        let attitude = self.attitude(y);
        let torque = self.torque(t, y, attitude);
        // Internal torques: wheels, h × ω − ḣ, and friction, α L × (L × ω). With friction the body
        // rotates faster by α L × ω.
        let (h, reaction) = (piece.wheel_momentum(t), -piece.motor_torque());
        let l = piece.angular_momentum(t, omega);
        let bending: Torque<Principal> = l.cross(omega);
        let slip: AngularVelocity<Principal> = bending.as_quantity() * piece.sink;
        let inside = h.cross(omega) + l.cross(slip) + reaction;
        let [a, b, c] = theta_dot(theta(y), omega + slip).to_array();
        let [p, q, r] = euler(moments, omega, torque + inside).to_array();
        let [j, k, l] = (attitude * torque).to_array();
        let power = (torque + reaction).dot(omega) - piece.sink * bending.dot(bending);
        [a, b, c, p, q, r, power, j, k, l]
    }

    /// Returns Ω = ω + α L × ω, the rate of rotation of the body.
    pub(super) fn turning(&self, t: f64, omega: AngularVelocity<Principal>) -> AngularVelocity<Principal> {
        if self.piece.sink == 0.0 {
            return omega;
        }
        let bending: Torque<Principal> = self.piece.angular_momentum(t, omega).cross(omega);
        omega + (bending * self.piece.sink).as_quantity()
    }

    /// Returns the attitude of the principal axes.
    pub(super) fn attitude(&self, y: &Y) -> Rotation<Space, Principal> {
        self.center * Rotation::from_rotation_vector(theta(y))
    }

    /// Returns the state in body axes.
    pub(super) fn state(&self, t: f64, y: &Y) -> State {
        self.state_at(t, y, self.attitude(y))
    }

    fn state_at(&self, t: f64, y: &Y, attitude: Rotation<Space, Principal>) -> State {
        let r = self.piece.rotor.principal().rotation();
        State { time: t, attitude: attitude * r.inverse(), omega: r * omega(y) }
    }

    /// Returns an error for a torque about an axis without inertia, which nothing could balance.
    pub(super) fn require_determined(&self, t: f64, y: &Y) -> Result<(), MotionError> {
        // Only a rod has such an axis, and it is principal axis 1.
        if self.piece.torques.is_empty() || self.piece.rotor.principal().moments()[0] != 0.0 {
            return Ok(());
        }
        match self.torque(t, y, self.attitude(y)).x {
            0.0 => Ok(()),
            torque => Err(MotionError::TorqueWithoutInertia { torque, time: t }),
        }
    }

    fn torque(&self, t: f64, y: &Y, attitude: Rotation<Space, Principal>) -> Torque<Principal> {
        let principal = self.piece.rotor.principal();
        let near = self.center * principal.rotation().inverse();
        let torque: Torque<Body> = self.piece.torque(&self.state_at(t, y, attitude), near);
        let torque = principal.rotation().inverse() * torque;
        // About the axis of a needle the torque of gravity is only rounding. Divided by the very
        // small moment, it would make the needle spin.
        let [i1, i2, i3] = principal.moments();
        let clean = |n: f64, i: f64| {
            if i < THIN * i3 && n.abs() < ROUNDING * self.piece.largest_torque { 0.0 } else { n }
        };
        Torque::new(clean(torque.x, i1), clean(torque.y, i2), torque.z)
    }
}

/// Returns y at the centre of a chart, θ = 0.
pub(super) fn at_center(omega: AngularVelocity<Principal>, work: f64, impulse: AngularMomentum<Space>) -> Y {
    let ([a, b, c], [j, k, l]) = (omega.to_array(), impulse.to_array());
    [0.0, 0.0, 0.0, a, b, c, work, j, k, l]
}

/// Returns ω in principal axes.
pub(super) fn omega(y: &Y) -> AngularVelocity<Principal> {
    Vector::new(y[3], y[4], y[5])
}

/// Returns the work done by the torque, J.
pub(super) fn work(y: &Y) -> f64 {
    y[6]
}

/// Returns the angular impulse of the torque, N·m·s, space axes.
pub(super) fn impulse(y: &Y) -> AngularMomentum<Space> {
    Vector::new(y[7], y[8], y[9])
}

/// Returns the angle that corresponds to an error of y, rad: |δθ|, an upper bound on the angle of
/// rotation.
pub(super) fn angle(error: &Y) -> f64 {
    theta(error).norm()
}

/// Largest rotation of the body in a step, rad; the chart ends at 2π.
pub(super) const LARGEST_TURN: f64 = 2.0;

/// Returns the rotation vector since the centre of the chart, rad.
pub(super) fn theta(y: &Y) -> Direction<Principal> {
    Vector::new(y[0], y[1], y[2])
}

fn theta_dot(theta: Direction<Principal>, omega: AngularVelocity<Principal>) -> Direction<Principal> {
    let w: Direction<Principal> = omega.as_quantity();
    let twist = theta.cross(w);
    w + twist * 0.5 + theta.cross(twist) * c(theta.dot(theta))
}

/// Returns c = (1 − (θ/2) cot(θ/2)) / θ² = 1/12 + θ²/720 + θ⁴/30240 + …
fn c(theta2: f64) -> f64 {
    if theta2 < 1.0 {
        return SERIES.iter().rev().fold(0.0, |sum, term| sum * theta2 + term);
    }
    let half = 0.5 * theta2.sqrt();
    let (sin, cos) = sin_cos(half);
    (1.0 - half * cos / sin) / theta2
}

/// Coefficients |B₂ₙ| / (2n)!, n = 1 to 9. The next term is below 1e-16 of the first for θ < 1.
/// (DLMF 4.19.6)
const SERIES: [f64; 9] = [
    1.0 / 12.0,
    1.0 / 720.0,
    1.0 / 30_240.0,
    1.0 / 1_209_600.0,
    1.0 / 47_900_160.0,
    691.0 / 1_307_674_368_000.0,
    1.0 / 74_724_249_600.0,
    3617.0 / 10_670_622_842_880_000.0,
    43_867.0 / 5_109_094_217_170_944_000.0,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_chart_turns_as_omega_says() {
        // Differentiate the rotation itself: R(θ(t)) must rotate at ω, at generic points on both
        // sides of the series threshold.
        let w = AngularVelocity::<Principal>::new(0.7, -1.1, 0.4);
        for scale in [1.0, 0.5, 0.1, 1e-3] {
            let theta = Direction::new(0.9, -0.6, 1.3) * scale;
            let rate = theta_dot(theta, w);
            let h = 1e-5;
            let at = |h: f64| Rotation::<Principal, Principal>::from_rotation_vector(theta + rate * h);
            let [_, x, y, z] = (at(-h).inverse() * at(h)).canonical_quaternion();
            let turned = AngularVelocity::<Principal>::new(x, y, z) / h; // half angle / h
            assert!((turned - w).norm() < 1e-9, "{turned:?}");
        }
        // and the two forms of c agree where they meet
        assert!((c(1.0) / c(1.0 - f64::EPSILON) - 1.0).abs() < 4e-15);
    }

    #[test]
    fn an_error_of_theta_is_at_least_its_angle() {
        let theta = Direction::<Principal>::new(0.9, -0.6, 1.3);
        for e in [[1e-7, 2e-7, -2e-7], [0.9e-7, -0.6e-7, 1.3e-7]].map(Direction::from_array) {
            let at = |v| Rotation::<Principal, Principal>::from_rotation_vector(v);
            let angle = at(theta).angle_to(at(theta + e));
            assert!(angle <= e.norm() * (1.0 + 1e-6) && angle > 0.5 * e.norm());
        }
    }
}
