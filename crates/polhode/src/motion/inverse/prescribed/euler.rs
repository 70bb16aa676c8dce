//! 3-1-3 Euler angles as functions of time.

use crate::math::frame::{Body, Space};
use crate::math::number::sin_cos;
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::{AngularAcceleration, AngularVelocity, Direction, Vector};

/// Returns R₃(φ) R₁(θ) R₃(ψ).
pub(super) fn turns([phi, theta, psi]: [f64; 3]) -> Attitude {
    let z = Direction::new(0.0, 0.0, 1.0);
    let first = Rotation::<Space, Space>::turn(z, phi);
    let second = Rotation::<Space, Body>::turn(Direction::new(1.0, 0.0, 0.0), theta);
    first * second * Rotation::<Body, Body>::turn(Direction::new(0.0, 0.0, 1.0), psi)
}

/// Returns ω = (φ̇ sθ sψ + θ̇ cψ, φ̇ sθ cψ − θ̇ sψ, φ̇ cθ + ψ̇) and its derivative.
///
/// This is the derivative of R₃(φ) R₁(θ) R₃(ψ). The tests compare it with difference quotients.
pub(super) fn kinematics(
    [_, theta, psi]: [f64; 3],
    [p, n, s]: [f64; 3],
    [pp, nn, ss]: [f64; 3],
) -> (AngularVelocity<Body>, AngularAcceleration<Body>) {
    let ((st, ct), (sp, cp)) = (sin_cos(theta), sin_cos(psi));
    let omega = Vector::new(p * st * sp + n * cp, p * st * cp - n * sp, p * ct + s);
    // Terms of constant rates in turning axes, and terms of the second derivatives.
    let acceleration = Vector::new(
        p * n * ct * sp + p * s * st * cp - n * s * sp + pp * st * sp + nn * cp,
        p * n * ct * cp - p * s * st * sp - n * s * cp + pp * st * cp - nn * sp,
        -p * n * st + pp * ct + ss,
    );
    (omega, acceleration)
}
