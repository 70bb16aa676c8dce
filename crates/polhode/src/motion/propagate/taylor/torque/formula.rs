//! The series of a torque that formulas give.

use super::super::row::Row;
use super::{Known, StepStart};
use crate::math::lanes::Fours;
use crate::motion::rotor::Rotor;
use crate::motion::torque::FormulaTorque;

/// The series of a torque that formulas give.
#[derive(Clone, Debug)]
pub(in super::super) struct FormulaSeries {}

impl FormulaSeries {
    pub(super) fn of(_model: &FormulaTorque, _rotor: &Rotor) -> Self {
        Self {}
    }

    pub(super) fn start(&mut self, _at: &StepStart) {}

    #[inline(always)]
    pub(super) fn coefficient<S: Fours>(&mut self, _n: usize, _known: &Known<'_, S>) -> Row {
        Row::ZERO
    }
}
