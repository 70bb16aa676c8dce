//! The series of a torsion spring or wire.

use super::super::row::Row;
use super::{Known, StepStart};
use crate::math::lanes::Fours;
use crate::motion::rotor::Rotor;
use crate::motion::torque::Torsion;

/// The series of a torsion spring or wire.
#[derive(Clone, Debug)]
pub(in super::super) struct TorsionSeries {}

impl TorsionSeries {
    pub(super) fn of(_model: &Torsion, _rotor: &Rotor) -> Self {
        Self {}
    }

    pub(super) fn start(&mut self, _at: &StepStart) {}

    #[inline(always)]
    pub(super) fn coefficient<S: Fours>(&mut self, _n: usize, _known: &Known<'_, S>) -> Row {
        Row::ZERO
    }
}
