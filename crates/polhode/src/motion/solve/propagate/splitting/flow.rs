//! Free rotation of a body for a short time, exact to rounding.
//!
//! `FreeMotion` is exact for any time, but takes microseconds to prepare. Here the time is short,
//! and each motion is evaluated once.
//!
//! A symmetric body rotates about L and about its axis, both at a constant rate. For other bodies,
//! e = ℓ/L, the direction of L in the body, and the angle φ about it are power series in time, with
//! as many terms as rounding requires:
//!
//! ė = e × I⁻¹ℓ,  φ̇ = I⁻¹ℓ · (e + e₀)/(1 + e · e₀),  rotation = exp(φ e₀) · (the smallest rotation
//! from e to e₀)
//!
//! This needs four convolutions instead of the fifteen for ω and a quaternion. `FreeMotion` is used
//! if the series is too long.

use core::array::from_fn;

use crate::body::principal::Symmetry;
use crate::math::frame::{Body, Principal};
use crate::math::number::sin_cos;
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularMomentum, AngularVelocity, Direction};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::solve::free::FreeMotion;

/// Largest number of terms of the series.
const TERMS: usize = 28;

/// Squared truncation threshold, relative to the sum. Such terms are below rounding even when
/// summed over 10⁷ steps. The series ends after two consecutive terms below it.
const NEGLIGIBLE: f64 = 1e-40;

/// Rotation minus the identity: (w − 1, x, y, z), each component with full relative precision.
pub(super) type Turn = [f64; 4];

/// Free motion of one body.
#[derive(Clone, Debug)]
pub(super) struct FreeFlow {
    moments: [f64; 3],
    /// 1/i; zero for an axis without inertia.
    inverses: [f64; 3],
    /// 1/i3 − 1/i2 and cyclic permutations: ℓ̇1 = (1/i3 − 1/i2) ℓ2 ℓ3.
    differences: [f64; 3],
    shape: Form,
}

#[derive(Clone, Copy, Debug)]
enum Form {
    Spherical,
    /// Index of the symmetry axis, and 1/i perpendicular to it.
    Symmetric {
        axis: usize,
        across: f64,
    },
    Asymmetric,
}

impl FreeFlow {
    pub(super) fn of(rotor: &Rotor) -> Self {
        let principal = rotor.principal();
        let [i1, i2, i3] = principal.moments();
        let over = |numerator: f64, i: f64| if i == 0.0 { 0.0 } else { numerator / i };
        let shape = match principal.symmetry() {
            Symmetry::Point | Symmetry::Spherical => Form::Spherical,
            Symmetry::Oblate => Form::Symmetric { axis: 2, across: over(1.0, i1) },
            Symmetry::Prolate | Symmetry::Rod => Form::Symmetric { axis: 0, across: over(1.0, i3) },
            Symmetry::Asymmetric => Form::Asymmetric,
        };
        Self {
            moments: [i1, i2, i3],
            inverses: [over(1.0, i1), over(1.0, i2), over(1.0, i3)],
            differences: [
                over(over(i2 - i3, i2), i3),
                over(over(i3 - i1, i3), i1),
                over(over(i1 - i2, i1), i2),
            ],
            shape,
        }
    }

    /// Returns ω = I⁻¹ ℓ. Along an axis without inertia ω is the constant `spin`.
    pub(super) fn omega(
        &self,
        momentum: AngularMomentum<Principal>,
        spin: f64,
    ) -> AngularVelocity<Principal> {
        let [j1, j2, j3] = self.inverses;
        let along = if self.moments[0] == 0.0 { spin } else { j1 * momentum.x };
        AngularVelocity::new(along, j2 * momentum.y, j3 * momentum.z)
    }

    /// Returns the rotation of the body in a time, s, which may be negative. `momentum`: angular
    /// momentum at the start.
    pub(super) fn turn(&self, momentum: AngularMomentum<Principal>, spin: f64, time: f64) -> Turn {
        let size = momentum.dot(momentum).sqrt();
        let [j1, ..] = self.inverses;
        match self.shape {
            Form::Spherical => about(momentum.to_array(), size, j1 * time),
            Form::Symmetric { axis, across } => {
                let omega = self.omega(momentum, spin).to_array();
                let relative = omega[axis] - across * momentum.to_array()[axis];
                let mut unit = [0.0; 3];
                unit[axis] = 1.0;
                let precession = about(momentum.to_array(), size, across * time);
                product(precession, about(unit, 1.0, relative * time))
            }
            Form::Asymmetric if size == 0.0 => [0.0; 4],
            Form::Asymmetric => {
                self.series(momentum, size, time).unwrap_or_else(|| self.elliptic(momentum, time))
            }
        }
    }

    /// Computes the rotation by power series; `None` if they are too long.
    fn series(&self, momentum: AngularMomentum<Principal>, size: f64, time: f64) -> Option<Turn> {
        let (e0, scale) = ((momentum / size).to_array(), size * time);
        let c = self.differences.map(|c| c * scale);
        let p: [f64; 3] = from_fn(|k| self.inverses[k] * e0[k] * scale);
        // Coefficients of (e2, e3, e1, e₀·(e − e₀)) and of (e3, e1, e2, φ̇). Only the sums of their
        // products are needed.
        let (mut left, mut right) = ([[0.0; 4]; TERMS], [[0.0; 4]; TERMS]);
        left[0] = [e0[1], e0[2], e0[0], 0.0];
        right[0] = [e0[2], e0[0], e0[1], 0.0];
        let (mut e, mut change, mut phi) = (e0, [0.0; 3], 0.0);
        let (mut sum, mut was_small) = (0.0, false);
        for n in 0..TERMS - 1 {
            let over = 1.0 / (n + 1) as f64;
            let [x, y, z, known] = convolution(&left, &right, n);
            // φ̇ = (2 p·e₀ + p·(e − e₀)) / (2 + e₀·(e − e₀))
            let rate = if n == 0 { dot(p, e0) } else { 0.5 * (dot(p, e) - known) };
            right[n][3] = rate;
            phi += rate * over;
            // ė1 = c1 e2 e3, …
            e = [c[0] * x * over, c[1] * y * over, c[2] * z * over];
            left[n + 1] = [e[1], e[2], e[0], dot(e0, e)];
            right[n + 1] = [e[2], e[0], e[1], 0.0];
            change = from_fn(|k| change[k] + e[k]);
            let term = rate * rate + dot(e, e);
            sum += term;
            let is_small = term <= NEGLIGIBLE * sum;
            if is_small && was_small {
                return Some(reassembled(e0, change, phi));
            }
            was_small = is_small;
        }
        None
    }

    /// Computes the rotation in closed form.
    fn elliptic(&self, momentum: AngularMomentum<Principal>, time: f64) -> Turn {
        let omega = self.omega(momentum, 0.0).as_frame::<Body>();
        let start = State { time: 0.0, attitude: Rotation::identity(), omega };
        let turned = FreeMotion::of_moments(self.moments, start).map(|motion| motion.at(time).attitude);
        // NaN indicates that the closed form failed.
        turned.map_or([f64::NAN; 4], |turn| {
            let [w, x, y, z] = turn.quaternion();
            [w - 1.0, x, y, z]
        })
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns the sum Σ aₖ ∘ bₙ₋ₖ of componentwise products.
#[inline(always)]
fn convolution(a: &[[f64; 4]; TERMS], b: &[[f64; 4]; TERMS], n: usize) -> [f64; 4] {
    a[..=n].iter().zip(b[..=n].iter().rev()).fold([0.0; 4], |sum, (a, b)| {
        [sum[0] + a[0] * b[0], sum[1] + a[1] * b[1], sum[2] + a[2] * b[2], sum[3] + a[3] * b[3]]
    })
}

/// Returns exp(φ e₀) · m. m is the smallest rotation from e = e₀ + `change` to e₀: m = (1 + e·e₀, e
/// × e₀)/√(2(1 + e·e₀)).
fn reassembled(e0: [f64; 3], change: [f64; 3], phi: f64) -> Turn {
    let (e0, change) = (Direction::<Principal>::from_array(e0), Direction::<Principal>::from_array(change));
    // |e| = |e₀| = 1: e₀·(e − e₀) = −½|e − e₀|²
    let twice = 2.0 - 0.5 * change.dot(change);
    let v = change.cross(e0) / (2.0 * twice).sqrt();
    let w = (0.5 * twice).sqrt();
    let least = [-v.dot(v) / (1.0 + w), v.x, v.y, v.z];
    product(about(e0.to_array(), 1.0, phi), least)
}

/// Returns the rotation by `size · angle` about a vector of length `size`.
fn about([x, y, z]: [f64; 3], size: f64, angle: f64) -> Turn {
    if size == 0.0 {
        return [0.0; 4];
    }
    // sin ½α = 2 sin ¼α cos ¼α, cos ½α − 1 = −2 sin² ¼α
    let (s, c) = sin_cos(0.25 * size * angle);
    let sine = 2.0 * s * c / size;
    [-2.0 * s * s, sine * x, sine * y, sine * z]
}

/// Returns (1 + a)(1 + b) − 1 for quaternions.
fn product([aw, ax, ay, az]: Turn, [bw, bx, by, bz]: Turn) -> Turn {
    [
        aw + bw + (aw * bw - ax * bx - ay * by - az * bz),
        ax + bx + (aw * bx + ax * bw + ay * bz - az * by),
        ay + by + (aw * by - ax * bz + ay * bw + az * bx),
        az + bz + (aw * bz + ax * by - ay * bx + az * bw),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::Position;
    use crate::motion::Rotor;

    fn rotor(moments: [f64; 3]) -> Rotor {
        let inertia = InertiaTensor::diagonal(moments).unwrap();
        Rotor::free(&MassProperties::new(1.3, Position::new(0.2, -0.1, 0.4), inertia).unwrap())
    }

    /// Returns the difference from the closed form, relative to the rotation if that is small.
    fn error(moments: [f64; 3], omega: [f64; 3], time: f64) -> f64 {
        let (flow, omega) = (FreeFlow::of(&rotor(moments)), AngularVelocity::<Body>::from_array(omega));
        let start = State { time: 0.0, attitude: Rotation::identity(), omega };
        let exact = FreeMotion::of_moments(moments, start).unwrap().at(time).attitude;
        let momentum = from_fn(|k| moments[k] * omega.to_array()[k]);
        let [w, x, y, z] = flow.turn(AngularMomentum::from_array(momentum), omega.x, time);
        assert!(((1.0 + w).powi(2) + x * x + y * y + z * z - 1.0).abs() < 1e-15);
        let turned = Rotation::from_unit([1.0 + w, x, y, z]);
        exact.angle_to(turned.continuous_with(exact)) / exact.angle().min(1.0)
    }

    #[test]
    fn the_flow_is_the_free_motion() {
        let bodies = [
            [1.1, 2.3, 2.9], // asymmetric
            [0.4, 1.7, 1.9], // nearly prolate
            [1.0, 1.0 + 1e-9, 1.4],
            [1.2, 1.2, 1.7], // oblate
            [0.6, 1.9, 1.9], // prolate
            [1.5, 1.5, 1.5],
            [0.0, 1.7, 1.7], // a rod that spins
        ];
        for moments in bodies {
            for omega in [[0.7, -1.1, 0.4], [-0.3, 0.2, 1.7], [1e-7, 1.3, -2e-7], [1.9, 0.1, -0.2]] {
                for time in [1e-3, 0.03, -0.1, 0.4, 1.0, 30.0_f64] {
                    // The closed form is accurate to 4e-15 rad, not relative to the rotation.
                    let bound = 4e-15 / time.abs().min(1.0) + 2e-15 * time.abs();
                    let error = error(moments, omega, time);
                    assert!(error < bound, "{moments:?} {omega:?} {time}: {error:e}");
                }
            }
        }
    }

    #[test]
    fn a_short_flow_has_its_own_digits() {
        // Twice the flow of τ/2 equals the flow of τ, relative to the rotation itself. The closed
        // form is not accurate enough for this test.
        let flow = FreeFlow::of(&rotor([1.1, 2.3, 2.9]));
        let momentum = AngularMomentum::new(0.8, -2.1, 1.3);
        for time in [1e-9, 1e-5, 0.01] {
            let half = flow.turn(momentum, 0.0, 0.5 * time);
            let [w, x, y, z] = half;
            let turned = Rotation::<Principal, Principal>::from_unit([1.0 + w, x, y, z]).inverse() * momentum;
            let twice = product(half, flow.turn(turned, 0.0, 0.5 * time));
            let whole = flow.turn(momentum, 0.0, time);
            for (a, b) in twice.iter().zip(whole) {
                assert!((a - b).abs() < 4e-16 * time, "{time}: {a:e} {b:e}");
            }
        }
    }

    #[test]
    fn at_rest_nothing_turns() {
        for moments in [[1.1, 2.3, 2.9], [1.2, 1.2, 1.7], [1.5, 1.5, 1.5]] {
            assert_eq!(FreeFlow::of(&rotor(moments)).turn(AngularMomentum::ZERO, 0.0, 0.3), [0.0; 4]);
        }
    }
}
