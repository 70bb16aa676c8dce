//! The motions that have a closed form, under one name.

use super::free::FreeMotion;
use super::heavy_top::HeavyTop;
use super::reach::require;
use super::swinging_body::SwingingBody;
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::state::StateError;
use crate::motion::model::torque::TorqueModel;

/// The effect of constants that are rounded when they are formed, in units of the effect of the
/// last bit of the inputs, which is known from few samples.
pub(crate) const OF_ROUNDED_CONSTANTS: f64 = 2.8;

/// A motion in closed form: the state at any time at once.
///
/// Each of them is right to some 10⁻¹⁵ for as long as anything turns 10¹⁵ times, for the numbers given: no worse than the integrators at their tightest
/// tolerance, so that `auto` takes a closed form wherever there is one.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ClosedForm {
    /// No torque.
    Free(Box<FreeMotion>),
    /// A symmetric body held at a point of its axis, under gravity.
    HeavyTop(Box<HeavyTop>),
    /// A body that swings under gravity about a principal axis.
    Swinging(Box<SwingingBody>),
}

impl ClosedForm {
    /// The closed form of the motion that starts from a state.
    ///
    /// # Errors
    /// [`MotionError::NoClosedForm`] where none is known, with the reason; otherwise as [`FreeMotion::of`] and [`HeavyTop::of`].
    pub fn of(rotor: &Rotor, torques: &[TorqueModel], start: State) -> Result<Self, MotionError> {
        if !rotor.wheels().is_empty() {
            return Err(MotionError::NoClosedForm { why: "wheels spin in the body" });
        }
        match torques {
            [] => FreeMotion::of(rotor, start).map(|motion| Self::Free(Box::new(motion))),
            [TorqueModel::Gravity(gravity)] => {
                if let Ok(motion) = SwingingBody::of(rotor, gravity, start) {
                    return Ok(Self::Swinging(Box::new(motion)));
                }
                HeavyTop::of(rotor, gravity, start).map(|motion| Self::HeavyTop(Box::new(motion)))
            }
            _ => {
                Err(MotionError::NoClosedForm { why: "a torque other than uniform gravity acts on the body" })
            }
        }
    }

    /// The state that it starts from.
    pub fn start(&self) -> State {
        match self {
            Self::Free(motion) => motion.start(),
            Self::HeavyTop(motion) => motion.start(),
            Self::Swinging(motion) => motion.start(),
        }
    }

    /// The state at a time, s, before the start too; not a number beyond [`ClosedForm::reach`], and at a time that is none.
    #[must_use]
    pub fn at(&self, time: f64) -> State {
        match self {
            Self::Free(motion) => motion.at(time),
            Self::HeavyTop(motion) => motion.at(time),
            Self::Swinging(motion) => motion.at(time),
        }
    }

    /// The states at some times, in any order, as [`ClosedForm::at`], several times as fast.
    #[must_use]
    pub fn at_times(&self, times: &[f64]) -> Vec<State> {
        match self {
            Self::Free(motion) => motion.at_times(times),
            Self::HeavyTop(motion) => motion.at_times(times),
            Self::Swinging(motion) => motion.at_times(times),
        }
    }

    /// The error of the formulas so long after the start, where the last bit of the inputs is worth so much: measured, see
    /// `book/error.md`.
    ///
    /// Those of a free motion have constants of three words; those of the others are rounded as the inputs are, whose worth is known from few
    /// samples: [`OF_ROUNDED_CONSTANTS`] times as much.
    pub(crate) fn formula_error(&self, after: f64, inputs: StateError) -> StateError {
        match self {
            Self::Free(motion) => motion.formula_error(after),
            Self::HeavyTop(_) | Self::Swinging(_) => {
                StateError { attitude: 1.5e-15, omega: 1e-15 }.plus(inputs, OF_ROUNDED_CONSTANTS)
            }
        }
    }

    /// For how long before and after its start the motion is known, s, to 1e-6 rad for inputs that are exact.
    pub fn reach(&self) -> f64 {
        match self {
            Self::Free(motion) => motion.reach(),
            Self::HeavyTop(motion) => motion.reach(),
            Self::Swinging(motion) => motion.reach(),
        }
    }

    /// That the motion is known at each of the times, s.
    ///
    /// # Errors
    /// [`MotionError::BeyondReach`] for the first that is beyond [`ClosedForm::reach`], or no number.
    pub fn require(&self, times: &[f64]) -> Result<(), MotionError> {
        require(&self.start(), self.reach(), times)
    }

    /// In words, for a summary.
    pub const fn title(&self) -> &'static str {
        match self {
            Self::Free(_) => "free motion by theta functions",
            Self::HeavyTop(_) => "Lagrange's top by elliptic functions",
            Self::Swinging(_) => "a compound pendulum by elliptic functions",
        }
    }
}
