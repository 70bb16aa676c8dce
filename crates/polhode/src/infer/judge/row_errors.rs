//! Errors of a motion at every row.

use super::difference::{length, rotation_vector, to_space};
use super::motion::ReadMotion;
use crate::math::frame::{Body, Space};
use crate::math::vector::{AngularMomentum, AngularVelocity};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// Errors of a motion, row by row.
///
/// The errors of ω, T and L are relative to the largest exact value of the run, because a pendulum
/// is at rest at its turning points.
#[derive(Clone, Debug, PartialEq)]
pub struct RowErrors {
    /// Rotation vector θ of R = R_exact exp(θ), body axes, rad.
    pub attitude: Vec<[f64; 3]>,
    /// Errors of ω and derived quantities, if the log has ω.
    pub rates: Option<RateErrors>,
    /// Largest deviation of a quaternion's length from 1.
    pub norm: f64,
}

/// Errors of ω and derived quantities, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct RateErrors {
    /// Relative error |δω|.
    pub omega: Vec<f64>,
    /// Relative error of the kinetic energy T = ½ ω · I ω, with its sign.
    pub kinetic_energy: Vec<f64>,
    /// Relative error of |L|, with L = I ω + h, with its sign.
    pub momentum: Vec<f64>,
    /// Angle between L in space and the exact one, rad.
    pub momentum_direction: Vec<f64>,
}

impl RowErrors {
    /// Computes the errors of a motion from the exact states at its times.
    pub fn of(rotor: &Rotor, motion: &ReadMotion, exact: &[State]) -> Self {
        let rows = || motion.attitude.iter().zip(exact);
        let attitude =
            rows().map(|(&read, exact)| rotation_vector(exact.attitude.quaternion(), read)).collect();
        let off_unit = |q: &[f64; 4]| (q.iter().map(|c| c * c).sum::<f64>().sqrt() - 1.0).abs();
        let norm = motion.attitude.iter().map(off_unit).fold(0.0, f64::max);
        let rates = motion.omega.as_ref().map(|omega| RateErrors::of(rotor, &motion.attitude, omega, exact));
        Self { attitude, rates, norm }
    }

    /// Returns the angle between the attitude of a row and the exact one, rad.
    pub fn angle(&self, row: usize) -> f64 {
        self.attitude.get(row).map_or(f64::NAN, |&theta| length(theta))
    }

    /// Returns the angles of all rows, rad.
    pub fn angles(&self) -> Vec<f64> {
        self.attitude.iter().map(|&theta| length(theta)).collect()
    }
}

impl RateErrors {
    fn of(rotor: &Rotor, attitude: &[[f64; 4]], omega: &[AngularVelocity<Body>], exact: &[State]) -> Self {
        let in_body = |omega, time| rotor.angular_momentum(omega) + rotor.wheel_momentum(time);
        let largest = |size: &dyn Fn(&State) -> f64| exact.iter().map(size).fold(f64::MIN_POSITIVE, f64::max);
        let (rate, energy) =
            (largest(&|state| state.omega.norm()), largest(&|s| rotor.kinetic_energy(s.omega)));
        let momentum_scale = largest(&|state| in_body(state.omega, state.time).norm());
        let mut errors = Self {
            omega: Vec::with_capacity(exact.len()),
            kinetic_energy: Vec::with_capacity(exact.len()),
            momentum: Vec::with_capacity(exact.len()),
            momentum_direction: Vec::with_capacity(exact.len()),
        };
        for ((&omega, &quaternion), state) in omega.iter().zip(attitude).zip(exact) {
            errors.omega.push((omega - state.omega).norm() / rate);
            errors
                .kinetic_energy
                .push((rotor.kinetic_energy(omega) - rotor.kinetic_energy(state.omega)) / energy);
            let (read, right) = (in_body(omega, state.time), in_body(state.omega, state.time));
            errors.momentum.push((read.norm() - right.norm()) / momentum_scale);
            let read = AngularMomentum::<Space>::from_array(to_space(quaternion, read.to_array()));
            let right = to_space(state.attitude.quaternion(), right.to_array());
            errors.momentum_direction.push(read.angle_to(AngularMomentum::<Space>::from_array(right)));
        }
        errors
    }
}
