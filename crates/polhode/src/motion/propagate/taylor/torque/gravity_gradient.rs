//! The series of the gravity gradient.

use super::super::row::Row;
use super::{Known, StepStart};
use crate::math::lanes::Fours;
use crate::motion::rotor::Rotor;
use crate::motion::torque::GravityGradient;

/// The series of the gravity gradient.
#[derive(Clone, Debug)]
pub(in super::super) struct GravityGradientSeries {}

impl GravityGradientSeries {
    pub(super) fn of(_model: &GravityGradient, _rotor: &Rotor) -> Self {
        Self {}
    }

    pub(super) fn start(&mut self, _at: &StepStart) {}

    #[inline(always)]
    pub(super) fn coefficient<S: Fours>(&mut self, _n: usize, _known: &Known<'_, S>) -> Row {
        Row::ZERO
    }

    #[inline(always)]
    pub(super) fn extend<S: Fours>(&mut self, _n: usize, _known: &Known<'_, S>) {}
}
