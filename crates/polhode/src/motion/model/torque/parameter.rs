//! Parameters of torques with respect to which motions are differentiated.

use super::TorqueModel;
use crate::motion::error::MotionError;

/// Parameter of a torque with respect to which a motion is differentiated.
///
/// [`TorqueModel::parameters`] returns the names of a model's parameters, with vectors by
/// components: `stiffness` of a spring, `xx` … `yz` of a drag matrix, `x`, `y`, `z` of a constant
/// torque or of g. Every torque also has a `factor`, which is 1. The derivative with respect to it
/// is the effect of the whole torque. For a gravity gradient it is a relative change of µ on an
/// unchanged orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TorqueParameter {
    /// Index of the torque, from 0.
    pub torque: usize,
    /// Name of the parameter.
    pub name: &'static str,
}

/// Kind of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::motion) enum ParameterKind {
    /// Multiplier of the whole torque.
    Factor,
    /// Parameter of the law, by index.
    OfLaw(usize),
}

impl TorqueParameter {
    /// Finds the torque and the kind of the parameter.
    ///
    /// # Errors
    /// [`MotionError::NoParameter`] if the torque does not exist, or has no parameter with this
    /// name.
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

/// Name of the multiplier of a whole torque.
const FACTOR: &str = "factor";
