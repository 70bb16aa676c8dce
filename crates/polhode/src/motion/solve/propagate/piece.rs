//! Acting torques on an interval of time in which none begins or ends.

use std::sync::Arc;

use super::rounding::ROUNDING;
use crate::math::frame::{Body, Principal};
use crate::math::rotation::Attitude;
use crate::math::vector::{AngularMomentum, AngularVelocity, Torque};
use crate::motion::error::MotionError;
use crate::motion::model::mass_history::MassHistory;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::changing::DrivenBody;
use crate::motion::model::torque::{OwnTorque, TorqueModel};

/// Acting torques, from one time until something changes. Within a piece everything is as smooth as
/// the torques themselves.
#[derive(Clone, Debug)]
pub(super) struct Piece<'a> {
    pub(super) rotor: &'a Rotor,
    /// Acting torques, without their schedules. Empty for a body with changing mass properties,
    /// whose law contains them.
    pub(super) torques: Vec<&'a TorqueModel>,
    /// Body with changing mass properties, if it is one, and its law: a torque on the ball that is
    /// integrated in its place.
    pub(super) changing: Option<(Arc<DrivenBody>, TorqueModel)>,
    /// Σ α of the energy sinks.
    pub(super) sink: f64,
    /// Upper bound on the torque, including that of the motors, N·m.
    pub(super) largest_torque: f64,
    /// First time at which something begins or ends, s; infinite if there is none.
    pub(super) until: f64,
    wheels: Wheels,
}

/// Angular momentum of the wheels: h = `momentum` + `rate` (t − `time`), principal axes.
#[derive(Clone, Copy, Debug)]
struct Wheels {
    time: f64,
    momentum: AngularMomentum<Principal>,
    rate: Torque<Principal>,
}

impl<'a> Piece<'a> {
    /// Finds what acts just after the time of a state. `torques` must not contain torques that are
    /// switched off.
    pub(super) fn new(
        rotor: &'a Rotor,
        torques: impl Iterator<Item = &'a TorqueModel> + Clone,
        state: &State,
    ) -> Self {
        let time = state.time;
        let to_principal = rotor.principal().rotation().inverse();
        // A table returns the largest of its rows. The polynomial between two rows returns only its
        // present value, which may be zero.
        let scales = torques.clone().filter(|torque| torque.acting(time).is_some());
        let largest_torque = scales.map(|torque| torque.model().scale(rotor, state)).sum::<f64>();
        let acting: Vec<_> = torques.clone().filter_map(|torque| torque.acting(time)).collect();
        let changes = torques.map(|torque| torque.next_change(time));
        let wheels = rotor.wheels().iter().map(|wheel| wheel.next_change(time));
        Self {
            rotor,
            sink: acting.iter().map(|torque| torque.model().sink()).sum(),
            largest_torque: largest_torque + rotor.motor_torque(time).norm(),
            torques: acting,
            changing: None,
            until: changes.chain(wheels).fold(f64::INFINITY, f64::min),
            wheels: Wheels {
                time,
                momentum: to_principal * rotor.wheel_momentum(time),
                rate: to_principal * rotor.motor_torque(time),
            },
        }
    }

    /// Returns the piece at the start of a motion. Fails for a body that cannot spin, and for
    /// torques that it cannot balance.
    pub(super) fn first(
        rotor: &'a Rotor,
        torques: impl Iterator<Item = &'a TorqueModel> + Clone,
        start: &State,
    ) -> Result<Self, MotionError> {
        if !rotor.is_spinnable() {
            return Err(MotionError::NotSpinnable);
        }
        let piece = Self::new(rotor, torques, start);
        piece.require_balanced_sink(start)?;
        Ok(piece)
    }

    /// Returns the piece for a body with changing mass properties, which has no wheels and no
    /// internal friction.
    pub(super) fn of_changing(
        rotor: &Rotor,
        history: &'a MassHistory,
        torques: impl Iterator<Item = &'a TorqueModel> + Clone,
        state: &State,
    ) -> Self {
        let (time, ball) = (state.time, history.ball());
        let pivot = rotor.is_pivoted().then(|| rotor.point());
        let acting = torques.clone().filter_map(|torque| torque.acting(time)).cloned();
        let body = Arc::new(DrivenBody::new(history.body(time, pivot), acting.collect()));
        let law = TorqueModel::Own(OwnTorque::of_changing(Arc::clone(&body)));
        let changes = torques.map(|torque| torque.next_change(time));
        Self {
            largest_torque: law.scale(ball, state),
            changing: Some((body, law)),
            until: changes.fold(history.next_change(time), f64::min),
            ..Self::new(ball, core::iter::empty(), state)
        }
    }

    /// Returns an error for internal friction in a rod that spins about its own line. The rod has
    /// no inertia about this line, so the spin would stop instantly.
    pub(super) fn require_balanced_sink(&self, state: &State) -> Result<(), MotionError> {
        let principal = self.rotor.principal();
        let omega = principal.rotation().inverse() * state.omega;
        let is_rod = principal.moments()[0] == 0.0;
        if self.sink == 0.0 || !is_rod || omega.x.abs() <= ROUNDING * omega.norm() {
            return Ok(());
        }
        // component 1 of L × Ω for L = (0, I ω₂, I ω₃)
        let momentum = self.angular_momentum(state.time, omega);
        let torque = -self.sink * momentum.dot(momentum) * omega.x;
        Err(MotionError::TorqueWithoutInertia { torque, time: state.time })
    }

    /// Returns true if nothing acts, so that the body moves freely.
    pub(super) fn is_free(&self) -> bool {
        self.acting().next().is_none() && self.rotor.wheels().is_empty()
    }

    /// Returns all torque models on the integrated body.
    pub(super) fn acting(&self) -> impl Iterator<Item = &TorqueModel> + Clone {
        self.torques.iter().copied().chain(self.changing.iter().map(|(_, law)| law))
    }

    /// Returns the total external torque, body axes. Twists are continued from `near`, an attitude
    /// close to that of the state.
    pub(super) fn torque(&self, state: &State, near: Attitude) -> Torque<Body> {
        let torque = |model: &&TorqueModel| model.model().value_near(self.rotor, state, near);
        let changing = self.changing.iter().map(|(body, _)| body.value_near(self.rotor, state, near));
        self.torques.iter().map(torque).chain(changing).fold(Torque::ZERO, |sum, torque| sum + torque)
    }

    /// Returns h, the angular momentum of the wheels, principal axes.
    pub(super) fn wheel_momentum(&self, time: f64) -> AngularMomentum<Principal> {
        self.wheels.momentum + (self.wheels.rate * (time - self.wheels.time)).as_quantity()
    }

    /// Returns ḣ, principal axes.
    pub(super) fn motor_torque(&self) -> Torque<Principal> {
        self.wheels.rate
    }

    /// Returns L = I ω + h, principal axes.
    pub(super) fn angular_momentum(
        &self,
        time: f64,
        omega: AngularVelocity<Principal>,
    ) -> AngularMomentum<Principal> {
        let [i1, i2, i3] = self.rotor.principal().moments();
        let carrier = AngularMomentum::new(i1 * omega.x, i2 * omega.y, i3 * omega.z);
        carrier + self.wheel_momentum(time)
    }
}
