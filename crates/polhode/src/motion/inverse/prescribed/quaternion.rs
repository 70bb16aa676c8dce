//! A quaternion of arbitrary norm as a function of time; only its direction matters.

use crate::math::frame::Body;
use crate::math::rotation::Attitude;
use crate::math::vector::{AngularAcceleration, AngularVelocity};

/// Returns the attitude of q/|q|, and ω and dω/dt along body axes, from q and its first and second
/// derivatives.
///
/// ω = 2 Im(q̄ q̇)/n,  ω̇ = (2 Im(q̄ q̈) − ω ṅ)/n,  n = |q|²
///
/// Proof: let q = r u with |u| = 1. Then q̄ q̇ = r ṙ + r² ū u̇, so its imaginary part is n times
/// that of the unit quaternion. Further Im(q̇̄ q̇) = 0. Returns `None` if q is zero or something is
/// not finite.
pub(super) fn kinematics(
    [q, rate, second]: [[f64; 4]; 3],
) -> Option<(Attitude, AngularVelocity<Body>, AngularAcceleration<Body>)> {
    let attitude = Attitude::from_quaternion(q).ok()?;
    // A common factor has no effect; dividing by it keeps the squares in range.
    let size = q.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
    let [q, rate, second] = [q, rate, second].map(|v| v.map(|c| c / size));
    let n = dot(q, q);
    let omega = AngularVelocity::from_array(imaginary(q, rate)) * (2.0 / n);
    let growth = 2.0 * dot(q, rate) / n;
    let acceleration = AngularAcceleration::from_array(imaginary(q, second)) * (2.0 / n);
    Some((attitude, omega, acceleration - (omega * growth).as_quantity()))
}

/// Returns Im(ā b).
fn imaginary([aw, ax, ay, az]: [f64; 4], [bw, bx, by, bz]: [f64; 4]) -> [f64; 3] {
    [
        aw * bx - ax * bw - ay * bz + az * by,
        aw * by + ax * bz - ay * bw - az * bx,
        aw * bz - ax * by + ay * bx - az * bw,
    ]
}

fn dot(a: [f64; 4], b: [f64; 4]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
