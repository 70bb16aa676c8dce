//! Common type of the motions that have a closed form.

use super::free::FreeMotion;
use super::heavy_top::HeavyTop;
use super::reach::require;
use super::swinging_body::SwingingBody;
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::state::StateError;
use crate::motion::model::torque::TorqueModel;

/// Effect of constants that are rounded when they are computed, relative to the effect of input
/// rounding. The latter is estimated from a few samples.
pub(crate) const OF_ROUNDED_CONSTANTS: f64 = 2.8;

/// Motion in closed form: the state at any time in constant time.
///
/// Each is accurate to some 10⁻¹⁵ for 10¹⁵ turns or periods, for exact inputs. The integrators at
/// their tightest tolerance are not more accurate, so `auto` uses a closed form wherever one
/// exists.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ClosedForm {
    /// Motion without torque.
    Free(Box<FreeMotion>),
    /// Symmetric body held at a point of its axis, under gravity.
    HeavyTop(Box<HeavyTop>),
    /// Body that swings about a principal axis under gravity.
    Swinging(Box<SwingingBody>),
}

impl ClosedForm {
    /// Returns the closed form of the motion that starts from a state.
    ///
    /// # Errors
    /// [`MotionError::NoClosedForm`] if none is known, with the reason. Otherwise the errors of
    /// [`FreeMotion::of`] and [`HeavyTop::of`].
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

    /// Returns the state at the start.
    pub fn start(&self) -> State {
        match self {
            Self::Free(motion) => motion.start(),
            Self::HeavyTop(motion) => motion.start(),
            Self::Swinging(motion) => motion.start(),
        }
    }

    /// Returns the state at a time, s, which may be before the start. ω and attitude are NaN beyond
    /// [`ClosedForm::reach`] and for a time that is NaN.
    #[must_use]
    pub fn at(&self, time: f64) -> State {
        match self {
            Self::Free(motion) => motion.at(time),
            Self::HeavyTop(motion) => motion.at(time),
            Self::Swinging(motion) => motion.at(time),
        }
    }

    /// Returns the states at many times (s), in any order: the results of [`ClosedForm::at`],
    /// computed several times faster.
    #[must_use]
    pub fn at_times(&self, times: &[f64]) -> Vec<State> {
        match self {
            Self::Free(motion) => motion.at_times(times),
            Self::HeavyTop(motion) => motion.at_times(times),
            Self::Swinging(motion) => motion.at_times(times),
        }
    }

    /// Returns the error of the formulas at the time `after` from the start. `inputs`: error from
    /// input rounding at that time. Measured; see `book/error.md`.
    ///
    /// The constants of a free motion have three words. Those of the other motions are rounded like
    /// the inputs. As the effect of input rounding is estimated from a few samples, it is
    /// multiplied by [`OF_ROUNDED_CONSTANTS`].
    pub(crate) fn formula_error(&self, after: f64, inputs: StateError) -> StateError {
        match self {
            Self::Free(motion) => motion.formula_error(after),
            Self::HeavyTop(_) | Self::Swinging(_) => {
                StateError { attitude: 1.5e-15, omega: 1e-15 }.plus(inputs, OF_ROUNDED_CONSTANTS)
            }
        }
    }

    /// Returns the time before and after the start for which the motion is accurate to 1e-6 rad,
    /// for exact inputs, s.
    pub fn reach(&self) -> f64 {
        match self {
            Self::Free(motion) => motion.reach(),
            Self::HeavyTop(motion) => motion.reach(),
            Self::Swinging(motion) => motion.reach(),
        }
    }

    /// Checks that the motion is known at each of the times, s.
    ///
    /// # Errors
    /// [`MotionError::BeyondReach`] for the first time that is beyond [`ClosedForm::reach`] or NaN.
    pub fn require(&self, times: &[f64]) -> Result<(), MotionError> {
        require(&self.start(), self.reach(), times)
    }

    /// Returns a description for a summary.
    pub const fn title(&self) -> &'static str {
        match self {
            Self::Free(_) => "free motion by theta functions",
            Self::HeavyTop(_) => "Lagrange's top by elliptic functions",
            Self::Swinging(_) => "a compound pendulum by elliptic functions",
        }
    }
}
