//! Numbers of torques that motions are differentiated by.

use super::TorqueModel;
use crate::motion::error::MotionError;

/// A number of a torque that a motion is differentiated by.
///
/// [`TorqueModel::parameters`] has the names of a model's numbers, vectors by their components: `stiffness` of a spring, `xx` … `yz` of
/// drag, `x`, `y`, `z` of a constant torque or of g. Every torque has a `factor` too, which is 1: the derivative by it is what the whole torque
/// makes. Of a gravity gradient it is µ over itself, on an orbit that stays as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TorqueParameter {
    /// Which of the torques, from 0.
    pub torque: usize,
    /// The number's name.
    pub name: &'static str,
}

/// What a parameter is of its torque.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::motion) enum ParameterKind {
    /// What all of it is multiplied by.
    Factor,
    /// One of the law's, by its place.
    OfLaw(usize),
}

impl TorqueParameter {
    /// What it is, and its torque.
    ///
    /// # Errors
    /// [`MotionError::NoParameter`] if there is no such torque, or it has no number with this name.
    pub(in crate::motion) fn of<'t>(
        &self,
        torques: &'t [TorqueModel],
    ) -> Result<(&'t TorqueModel, ParameterKind), MotionError> {
        let Self { torque, name } = *self;
        let found = torques.get(torque).and_then(|model| {
            let place = model.parameters().iter().position(|known| *known == name);
            let factor = (name == FACTOR && model.sink() == 0.0).then_some(ParameterKind::Factor);
            Some((model, place.map(ParameterKind::OfLaw).or(factor)?))
        });
        found.ok_or(MotionError::NoParameter { torque, name })
    }
}

/// The name of what a whole torque is multiplied by.
const FACTOR: &str = "factor";
