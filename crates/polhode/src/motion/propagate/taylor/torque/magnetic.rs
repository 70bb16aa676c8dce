//! The series of a magnet in a field.

use super::super::row::Row;
use super::{Known, StepStart};
use crate::motion::rotor::Rotor;
use crate::motion::torque::Magnetic;

/// The series of a magnet in a field.
#[derive(Clone, Debug)]
pub(in super::super) struct MagneticSeries {}

impl MagneticSeries {
    pub(super) fn of(_model: &Magnetic, _rotor: &Rotor) -> Self {
        Self {}
    }

    pub(super) fn start(&mut self, _at: &StepStart) {}

    #[inline(always)]
    pub(super) fn coefficient(&mut self, _n: usize, _known: &Known<'_>) -> Row {
        Row::ZERO
    }

    #[inline(always)]
    pub(super) fn extend(&mut self, _n: usize, _known: &Known<'_>) {}
}
