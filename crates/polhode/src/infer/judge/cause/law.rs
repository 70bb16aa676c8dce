//! Euler's equations as a program may implement them: correct, or with mistakes.

use crate::math::frame::{Body, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::task::scenario::Scenario;

/// Vector along body axes, of any quantity.
pub(super) type BodyVector = Direction<Body>;

/// Law of motion I ω̇ = L × Ω + N − ḣ − c I ω with L = I ω + h, and q̇ = ½ q Ω; correct if Ω = ω
/// (apart from energy sinks) and c = 0.
#[derive(Clone, Debug)]
pub(super) struct Law<'a> {
    /// Rotor on which the torques act.
    pub(super) rotor: Rotor,
    /// Acting torques, each with its use in this law.
    pub(super) torques: Vec<(&'a TorqueModel, TorqueUse)>,
    /// Inertia tensor I, kg·m², possible or not.
    pub(super) tensor: Symmetric3,
    /// Inverse I⁻¹ of the tensor.
    pub(super) inverse: Symmetric3,
    /// Principal moments and axes of the tensor.
    pub(super) principal: [(f64, BodyVector); 3],
    /// Form of the gyroscopic term L × ω.
    pub(super) gyroscopic: Gyroscopic,
    /// Angular velocity used for the attitude.
    pub(super) turning: Turning,
    /// Damping c, 1/s.
    pub(super) damping: f64,
    /// Limit of |ω|, rad/s.
    pub(super) speed_limit: f64,
}

/// Form of the gyroscopic term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Gyroscopic {
    /// Correct: L × ω.
    Right,
    /// Omitted: zero.
    LeftOut,
    /// L × Ω with the Ω of the attitude: L is constant in space and is converted to body axes with
    /// that attitude.
    OfAttitude,
}

/// Angular velocity used for the attitude.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turning {
    /// Correct: Ω = ω.
    Right,
    /// Wrong: q̇ = ½ ω q with ω along body axes.
    BodyAsSpace,
    /// Wrong: q̇ = ½ q ω with ω along space axes.
    SpaceAsBody,
}

/// Use of a torque in a law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TorqueUse {
    /// Factor of the torque.
    pub(super) factor: f64,
    /// Axes to which the program assigns the components.
    pub(super) axes: TorqueAxes,
}

/// Axes to which a program assigns the components of a torque.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TorqueAxes {
    /// Correct axes.
    Right,
    /// Components along body axes are used along space axes.
    BodyAsSpace,
    /// Components along space axes are used along body axes.
    SpaceAsBody,
}

/// Threshold below which a moment counts as zero (a rod about its own line), relative to the
/// largest.
const MASSLESS: f64 = 1e-13;

impl<'a> Law<'a> {
    /// Returns the correct law of a scenario.
    pub(super) fn of(scenario: &'a Scenario) -> Self {
        let off = scenario.switched_off();
        let acting = scenario.torques().iter().enumerate().filter(|(k, _)| !off.contains(k));
        let right = TorqueUse { factor: 1.0, axes: TorqueAxes::Right };
        let rotor = scenario.rotor().clone();
        let tensor = *rotor.inertia().symmetric();
        Self {
            torques: acting.map(|(_, torque)| (torque, right)).collect(),
            rotor,
            tensor,
            inverse: tensor,
            principal: [(0.0, BodyVector::ZERO); 3],
            gyroscopic: Gyroscopic::Right,
            turning: Turning::Right,
            damping: 0.0,
            speed_limit: f64::INFINITY,
        }
        .with_tensor(tensor)
    }

    /// Returns the law with another tensor, possible or not.
    pub(super) fn with_tensor(&self, tensor: Symmetric3) -> Self {
        let eigen = tensor.eigen();
        let least = MASSLESS * tensor.max_abs();
        let principal: [(f64, BodyVector); 3] =
            core::array::from_fn(|k| (eigen.values[k], BodyVector::from_array(eigen.vectors[k])));
        let inverse = principal.iter().fold(Symmetric3::default(), |sum, (moment, axis)| {
            let over = if moment.abs() > least { 1.0 / moment } else { 0.0 };
            sum + Symmetric3::outer(axis.to_array()) * over
        });
        let rotor = self.rotor.with_inertia(tensor, self.rotor.lever()).unwrap_or_else(|| self.rotor.clone());
        Self { rotor, tensor, inverse, principal, ..self.clone() }
    }

    /// Returns the law without wheels, for a body with this tensor.
    pub(super) fn without_wheels(&self, tensor: Symmetric3) -> Self {
        let mut law = self.with_tensor(tensor);
        law.rotor = law.rotor.with_wheels(&[]).unwrap_or_else(|_| self.rotor.clone());
        law
    }

    /// Returns the law with another use of one torque, or of all if `which` is `None`.
    pub(super) fn using(&self, which: Option<usize>, usage: TorqueUse) -> Self {
        let mut law = self.clone();
        for (k, (_, used)) in law.torques.iter_mut().enumerate() {
            if which.is_none_or(|which| which == k) {
                *used = usage;
            }
        }
        law
    }

    /// Returns the number of acting torques.
    pub(super) const fn torque_count(&self) -> usize {
        self.torques.len()
    }

    /// Returns the name of a torque.
    pub(super) fn torque_name(&self, which: usize) -> &'static str {
        self.torques.get(which).map_or("torque", |(torque, _)| torque.name())
    }

    /// Returns true if the body has wheels.
    pub(super) fn has_wheels(&self) -> bool {
        !self.rotor.wheels().is_empty()
    }

    /// Returns the tensor, kg·m².
    pub(super) const fn tensor(&self) -> &Symmetric3 {
        &self.tensor
    }

    /// Returns Σ h a of the wheels, kg·m²/s.
    pub(super) fn wheel_momentum(&self, time: f64) -> BodyVector {
        if self.has_wheels() { self.rotor.wheel_momentum(time).as_quantity() } else { BodyVector::ZERO }
    }

    /// Returns L = I ω + h, kg·m²/s.
    pub(super) fn momentum(&self, state: &State) -> BodyVector {
        BodyVector::from_array(self.tensor.apply(state.omega.to_array())) + self.wheel_momentum(state.time)
    }

    /// Returns ω = I⁻¹ (L − h), rad/s.
    pub(super) fn omega(&self, momentum: BodyVector, time: f64) -> AngularVelocity<Body> {
        self.over_inertia(momentum - self.wheel_momentum(time)).as_quantity()
    }

    fn over_inertia(&self, v: BodyVector) -> BodyVector {
        BodyVector::from_array(self.inverse.apply(v.to_array()))
    }

    /// Returns N − ḣ for the torques that act just after the time `since`, N·m.
    pub(super) fn torque(&self, state: &State, since: f64) -> BodyVector {
        let mut sum = BodyVector::ZERO;
        for (torque, TorqueUse { factor, axes }) in &self.torques {
            let Some(acting) = torque.acting(since) else { continue };
            let torque: BodyVector = acting.torque(&self.rotor, state).as_quantity();
            let taken = match axes {
                TorqueAxes::Right => torque,
                TorqueAxes::BodyAsSpace => state.attitude.inverse() * torque.as_frame::<Space>(),
                TorqueAxes::SpaceAsBody => (state.attitude * torque).as_frame(),
            };
            sum += taken * *factor;
        }
        if self.has_wheels() { sum - self.rotor.motor_torque(since).as_quantity() } else { sum }
    }

    /// Returns N without the motor torques, N·m.
    pub(super) fn outer_torque(&self, state: &State) -> BodyVector {
        let motors: BodyVector = self.rotor.motor_torque(state.time).as_quantity();
        self.torque(state, state.time) + motors
    }

    /// Returns Ω, the angular velocity used for the attitude, rad/s.
    pub(super) fn turning(&self, state: &State) -> BodyVector {
        let omega: BodyVector = state.omega.as_quantity();
        match self.turning {
            Turning::Right => omega,
            Turning::BodyAsSpace => state.attitude.inverse() * omega.as_frame::<Space>(),
            Turning::SpaceAsBody => (state.attitude * omega).as_frame(),
        }
    }

    /// Returns ω̇, rad/s².
    pub(super) fn acceleration(&self, state: &State, since: f64) -> BodyVector {
        let omega: BodyVector = state.omega.as_quantity();
        let momentum = self.momentum(state);
        let gyroscopic = match self.gyroscopic {
            Gyroscopic::Right => momentum.cross(omega),
            Gyroscopic::LeftOut => BodyVector::ZERO,
            Gyroscopic::OfAttitude => momentum.cross(self.turning(state)),
        };
        let sink: f64 = self.torques.iter().map(|(torque, usage)| torque.sink() * usage.factor).sum();
        let sunk =
            if sink == 0.0 { gyroscopic } else { gyroscopic + momentum.cross(momentum.cross(omega)) * sink };
        self.over_inertia(sunk + self.torque(state, since)) - omega * self.damping
    }

    /// Returns the next time after `time` at which a torque starts or ends, s.
    pub(super) fn next_change(&self, time: f64) -> f64 {
        let torques = self.torques.iter().map(|(torque, _)| torque.next_change(time));
        let wheels = self.rotor.wheels().iter().map(|wheel| wheel.next_change(time));
        torques.chain(wheels).fold(f64::INFINITY, f64::min)
    }

    /// Returns a characteristic rate of change of a state, 1/s; step sizes are a fraction of its
    /// inverse.
    pub(super) fn rate(&self, state: &State) -> f64 {
        let (omega, turning) = (state.omega.norm(), self.turning(state).norm());
        let wheels = self.over_inertia(self.wheel_momentum(state.time)).norm();
        let torque = self.over_inertia(self.torque(state, state.time)).norm();
        omega.max(turning) + wheels + torque.sqrt() + self.damping.abs()
    }
}

/// Attitude quaternion and ω as seven numbers.
pub(super) type Numbers = [f64; 7];

pub(super) fn numbers(state: &State) -> Numbers {
    let ([w, x, y, z], omega) = (state.attitude.quaternion(), state.omega);
    [w, x, y, z, omega.x, omega.y, omega.z]
}

pub(super) fn state(time: f64, [w, x, y, z, a, b, c]: Numbers) -> State {
    let attitude: Attitude = Rotation::from_quaternion([w, x, y, z]).unwrap_or_else(|_| Rotation::identity());
    State { time, attitude, omega: AngularVelocity::new(a, b, c) }
}

/// Returns q̇ = ½ q Ω, for a quaternion of any length, and ω̇.
pub(super) fn derivative(law: &Law<'_>, time: f64, numbers: &Numbers, since: f64) -> Numbers {
    let [w, x, y, z, ..] = *numbers;
    let state = state(time, *numbers);
    let (turning, acceleration) = (law.turning(&state), law.acceleration(&state, since));
    let (a, b, c) = (0.5 * turning.x, 0.5 * turning.y, 0.5 * turning.z);
    [
        -x * a - y * b - z * c,
        w * a + y * c - z * b,
        w * b + z * a - x * c,
        w * c + x * b - y * a,
        acceleration.x,
        acceleration.y,
        acceleration.z,
    ]
}

/// Returns y + s d.
pub(super) fn advanced(y: &Numbers, s: f64, d: &Numbers) -> Numbers {
    core::array::from_fn(|k| y[k] + s * d[k])
}
