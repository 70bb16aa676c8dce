//! Torques on a body, decomposed once for all of its motions.

use std::sync::Arc;

use super::torque::{Decomposition, TorqueKind};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::torque::TorqueModel;
use crate::motion::model::wheel::{Motor, Wheel};

/// Properties that bodies in one batch must share. They differ only in their numbers.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in crate::motion) struct BatchKind {
    torques: TorqueKind,
    /// True with wheels or internal friction.
    has_inside: bool,
}

/// Torques on equal bodies, decomposed once for all of them.
#[derive(Debug)]
pub(in crate::motion) struct Acting {
    pub(super) decomposition: Decomposition,
    pub(super) kind: BatchKind,
}

/// Returns true if a motion can be computed in a batch: not with schedules, or torques without a
/// series.
fn has_series(rotor: &Rotor, torques: &[TorqueModel]) -> bool {
    let has_series = |torque: &TorqueModel| torque.model().roughness().is_none() && !torque.is_timed();
    let is_steady = |wheel: &Wheel| !matches!(wheel.motor(), Motor::Torque { schedule: Some(_), .. });
    torques.iter().all(has_series) && rotor.wheels().iter().all(is_steady)
}

impl Acting {
    /// Returns `None` for motions that must be computed one by one: see [`has_series`].
    pub(in crate::motion) fn of(rotor: &Rotor, torques: &[TorqueModel]) -> Option<Arc<Self>> {
        if !has_series(rotor, torques) {
            return None;
        }
        let has_inside =
            !rotor.wheels().is_empty() || torques.iter().any(|torque| torque.model().sink() != 0.0);
        let decomposition = Decomposition::of(rotor, torques.iter(), !has_inside);
        let kind = BatchKind { torques: decomposition.kind(), has_inside };
        Some(Arc::new(Self { decomposition, kind }))
    }
}
