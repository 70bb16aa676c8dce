//! Samples: the motion at one time, and quantities computed from it.

use crate::math::frame::{Body, Space};
use crate::math::vector::{AngularMomentum, Torque};
use crate::motion::error::MotionError;
use crate::motion::inverse::prescribed::Prescribed;
use crate::motion::inverse::required::Required;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::{TorqueModel, total_torque};
use crate::motion::solve::free::FreeMotion;
use crate::motion::solve::propagate::balanced::Balanced;

/// Motion at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Time, attitude and ω.
    pub state: State,
    /// L about the reference point of the rotor, space axes, kg·m²/s.
    pub momentum: AngularMomentum<Space>,
    /// Torque about the same point, body axes, N·m.
    pub torque: Torque<Body>,
    /// T_rot about the same point, J.
    pub kinetic_energy: f64,
    /// Potential energy of all torques, J; `None` if some torque has none.
    pub potential_energy: Option<f64>,
    /// Work of the torque since the start, ∫ N · ω dt, J.
    pub work: f64,
    /// Angular impulse of the torque since the start, ∫ N dt, space axes, N·m·s.
    pub impulse: AngularMomentum<Space>,
}

impl Sample {
    /// Computes the sample of a rotor under torques.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] if energy or momentum leave the range of f64.
    pub(crate) fn of<'a>(
        rotor: &Rotor,
        torques: impl Iterator<Item = &'a TorqueModel>,
        potential_energy: Option<f64>,
        balanced: Balanced,
    ) -> Result<Self, MotionError> {
        let Balanced { state, work, impulse } = balanced;
        let torque = total_torque(torques, rotor, &state);
        let (momentum, kinetic_energy) =
            (rotor.angular_momentum_space(&state), rotor.kinetic_energy(state.omega));
        Self { state, momentum, torque, kinetic_energy, potential_energy, work, impulse }.finite()
    }

    /// Computes the sample of a free motion.
    ///
    /// # Errors
    /// Those of [`Sample::of`].
    pub(crate) fn of_free(motion: &FreeMotion, state: State) -> Result<Self, MotionError> {
        let in_body = motion.angular_momentum(&state);
        let momentum = state.attitude * in_body;
        let (torque, kinetic_energy) = (Torque::ZERO, 0.5 * state.omega.dot(in_body));
        let (work, impulse) = (0.0, AngularMomentum::ZERO);
        Self { state, momentum, torque, kinetic_energy, potential_energy: None, work, impulse }.finite()
    }

    /// Computes the sample of a prescribed motion, with the torque that it requires.
    ///
    /// # Errors
    /// Those of [`Sample::of`], and of [`Required::of_motion`].
    pub(crate) fn of_prescribed(rotor: &Rotor, motion: &Prescribed, time: f64) -> Result<Self, MotionError> {
        let needed = Required::of_motion(rotor, motion, time)?;
        let balanced = Balanced { state: needed.state, work: 0.0, impulse: AngularMomentum::ZERO };
        let sample = Self::of(rotor, core::iter::empty(), None, balanced)?;
        Self { torque: needed.torque, ..sample }.finite()
    }

    /// Computes the sample of a body on the ground or in gimbals, with the given torque. Work and
    /// impulse are the changes of kinetic energy and momentum since `first`.
    ///
    /// # Errors
    /// Those of [`Sample::of`].
    pub(crate) fn held(
        rotor: &Rotor,
        state: State,
        torque: Torque<Body>,
        first: Option<&Self>,
    ) -> Result<Self, MotionError> {
        let balanced = Balanced { state, work: 0.0, impulse: AngularMomentum::ZERO };
        let sample = Self::of(rotor, core::iter::empty(), None, balanced)?;
        let first = first.copied().unwrap_or(sample);
        let work = sample.kinetic_energy - first.kinetic_energy;
        let impulse = sample.momentum - first.momentum;
        Self { torque, work, impulse, ..sample }.finite()
    }

    fn finite(self) -> Result<Self, MotionError> {
        let attitude: f64 = self.state.attitude.quaternion().iter().sum();
        let finite = attitude.is_finite()
            && self.momentum.is_finite()
            && self.torque.is_finite()
            && self.kinetic_energy.is_finite();
        if finite { Ok(self) } else { Err(MotionError::NotFinite { time: self.state.time }) }
    }
}

/// Makes the quaternions continuous. q and −q are the same attitude; each sample gets the sign
/// nearest to the previous one.
pub(crate) fn continuous(mut samples: Vec<Sample>) -> Vec<Sample> {
    for k in 1..samples.len() {
        samples[k].state.attitude = samples[k].state.attitude.continuous_with(samples[k - 1].state.attitude);
    }
    samples
}
