//! A quaternion as a function of time: of any length, since only its direction counts.

use crate::math::frame::Body;
use crate::math::rotation::Attitude;
use crate::math::vector::{AngularAcceleration, AngularVelocity};

/// The attitude of q/|q|, its ω and dω/dt along body axes, from q and its first and second derivative.
///
/// ω = 2 Im(q̄ q̇)/n,  ω̇ = (2 Im(q̄ q̈) − ω ṅ)/n,  n = |q|²
///
/// With q = r u, |u| = 1: q̄ q̇ = r ṙ + r² ū u̇, so the imaginary part is that of the unit quaternion times n; and Im(q̇̄ q̇) = 0.
/// `None` where q is zero or something is not finite.
pub(super) fn kinematics(
    [q, rate, second]: [[f64; 4]; 3],
) -> Option<(Attitude, AngularVelocity<Body>, AngularAcceleration<Body>)> {
    let attitude = Attitude::from_quaternion(q).ok()?;
    // A common factor has no meaning, and keeps the squares in range.
    let size = q.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
    let [q, rate, second] = [q, rate, second].map(|v| v.map(|c| c / size));
    let n = dot(q, q);
    let omega = AngularVelocity::from_array(imaginary(q, rate)) * (2.0 / n);
    let growth = 2.0 * dot(q, rate) / n;
    let acceleration = AngularAcceleration::from_array(imaginary(q, second)) * (2.0 / n);
    Some((attitude, omega, acceleration - (omega * growth).as_quantity()))
}

/// Im(ā b)
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
