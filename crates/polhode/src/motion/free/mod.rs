//! Free motion in closed form: constants once, then any time at once.
//!
//! One file per regime. The asymmetric body (Jacobi's elliptic functions) has its place here and is not yet in it;
//! until then its motion is integrated.

pub(crate) mod permanent;
pub(crate) mod symmetric;

use super::error::MotionError;
use super::rotor::Rotor;
use super::state::State;
use crate::body::principal::Symmetry;

pub use permanent::{PermanentAxis, PermanentRotation};
pub use symmetric::{SymmetricTop, SymmetricTopKind};

/// The torque-free motion of a body, classified once; each variant holds only its constants.
///
/// ```
/// use polhode::{AngularVelocity, Attitude, FreeMotion, InertiaTensor, MassProperties, Position, Rotor, State};
/// let inertia = InertiaTensor::diagonal([125.0, 125.0, 100.0])?; // Curtis, example 10.2
/// let tube = Rotor::free(&MassProperties::new(100.0, Position::ZERO, inertia)?);
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, 0.4, 1.0) };
/// let motion = FreeMotion::of(&tube, start)?;
/// let later = motion.at(1e6);
/// assert!((later.omega.z - 1.0).abs() < 1e-15);
/// assert!((later.omega.norm() - start.omega.norm()).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FreeMotion {
    /// ω lies along a principal axis (or is zero) and stays there.
    Permanent(PermanentRotation),
    /// Two equal moments: ω and the symmetry axis circle L.
    Symmetric(SymmetricTop),
}

impl FreeMotion {
    /// The motion that starts from a state with no torque.
    ///
    /// # Errors
    /// [`MotionError::NotSpinnable`] for a body without inertia; [`MotionError::NoClosedForm`] for three different
    /// moments unless ω lies exactly along a principal axis.
    pub fn of(rotor: &Rotor, start: State) -> Result<Self, MotionError> {
        if !rotor.is_spinnable() {
            return Err(MotionError::NotSpinnable);
        }
        if let Some(motion) = PermanentRotation::of(rotor, start) {
            return Ok(Self::Permanent(motion));
        }
        match rotor.principal().symmetry() {
            Symmetry::Asymmetric => {
                Err(MotionError::NoClosedForm { why: "the three principal moments differ" })
            }
            _ => SymmetricTop::of(rotor, start)
                .map(Self::Symmetric)
                .ok_or(MotionError::NoClosedForm { why: "the body has no symmetry axis" }),
        }
    }

    /// The state at a time, s; any time, before the start too.
    pub fn at(&self, time: f64) -> State {
        match self {
            Self::Permanent(motion) => motion.at(time),
            Self::Symmetric(motion) => motion.at(time),
        }
    }
}
