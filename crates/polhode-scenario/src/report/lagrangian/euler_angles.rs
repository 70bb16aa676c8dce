//! Euler angles 3-1-3 of computed motions, with their rates.

use polhode::math::{Attitude, Body, Direction, Frame, Part, Principal, Rotation, Space};
use polhode::motion::{Rotor, Sample};
use polhode_algebra::{RationalFunction, Symbol};

use super::error::LagrangianError;
use super::system::{cosine, sine, velocity};
use super::verify::{Instant, Motion};

/// Least sine of θ at which equations are evaluated; φ and ψ are undefined at zero.
const LEAST_SINE: f64 = 0.01;

/// Axes to which Euler angles refer.
pub(super) struct Axes {
    /// Axes of space, of which the third is the polar axis of θ.
    pub space: Rotation<Space, Part>,
    /// Axes of the body 1, 2, 3.
    pub body: Rotation<Body, Principal>,
}

/// Returns ω₁, ω₂, ω₃ in the Euler angles φ, θ, ψ (Goldstein, *Classical Mechanics*, eq. 4.87).
pub(super) fn omega([phi, theta, psi]: [Symbol; 3]) -> [RationalFunction; 3] {
    let [phi_dot, theta_dot, psi_dot] = [phi, theta, psi].map(velocity);
    let across = phi_dot.times(&sine(theta));
    [
        &across * sine(psi) + &theta_dot * cosine(psi),
        &across * cosine(psi) - &theta_dot * sine(psi),
        psi_dot + phi_dot * cosine(theta),
    ]
}

/// Returns a rotation whose third axis is along `axis`. The first is that of x, or of y, without its
/// component along `axis`.
fn along<A: Frame, B: Frame>(axis: Direction<A>) -> Option<Rotation<A, B>> {
    let z = axis.direction()?;
    let first = if z.x.abs() <= 0.9 { Direction::new(1.0, 0.0, 0.0) } else { Direction::new(0.0, 1.0, 0.0) };
    let x = (first - z * z.dot(first)).direction()?;
    let y: Direction<A> = z.cross(x);
    Rotation::from_matrix([[x.x, y.x, z.x], [x.y, y.y, z.y], [x.z, y.z, z.z]]).ok()
}

impl Axes {
    /// Returns axes with the third ones along directions that are not zero.
    pub(super) fn along(polar: Direction<Space>, axis: Direction<Body>) -> Result<Self, LagrangianError> {
        match (along(polar), along(axis)) {
            (Some(space), Some(body)) => Ok(Self { space, body }),
            _ => Err(LagrangianError::because("the vertical or the axis of the body has no direction")),
        }
    }

    /// Returns φ, θ and ψ of an attitude.
    pub(super) fn angles(&self, attitude: Attitude) -> [f64; 3] {
        (self.space.inverse() * attitude * self.body).euler313()
    }

    /// Returns the motion of a rotor in Euler angles, with accelerations from Euler's equations.
    pub(super) fn motion(&self, rotor: &Rotor, samples: &[Sample]) -> Motion {
        let instants: Vec<Instant> =
            samples.iter().filter_map(|sample| self.instant(rotor, sample)).collect();
        Motion { left_out: samples.len() - instants.len(), instants }
    }

    fn instant(&self, rotor: &Rotor, sample: &Sample) -> Option<Instant> {
        let state = &sample.state;
        let [phi, theta, psi] = self.angles(state.attitude);
        let ((s, c), (sin_psi, cos_psi)) = (theta.sin_cos(), psi.sin_cos());
        if s < LEAST_SINE {
            return None;
        }
        let w = (self.body.inverse() * state.omega).to_array();
        let a = (self.body.inverse() * rotor.acceleration(state.omega, sample.torque)).to_array();
        // Components along the line of nodes, and across it in the plane of axes 1 and 2.
        let split = |v: [f64; 3]| [v[0] * cos_psi - v[1] * sin_psi, v[0] * sin_psi + v[1] * cos_psi];
        let ([theta_dot, across], [along_a, across_a]) = (split(w), split(a));
        let phi_dot = across / s;
        let psi_dot = w[2] - phi_dot * c;
        // The line of nodes turns at −ψ̇ in the body.
        let theta_ddot = along_a - psi_dot * across;
        let phi_ddot = (across_a + psi_dot * theta_dot - phi_dot * theta_dot * c) / s;
        let psi_ddot = a[2] - phi_ddot * c + phi_dot * theta_dot * s;
        let coordinates =
            vec![[phi, phi_dot, phi_ddot], [theta, theta_dot, theta_ddot], [psi, psi_dot, psi_ddot]];
        Some(Instant { time: state.time, coordinates, others: Vec::new() })
    }
}
