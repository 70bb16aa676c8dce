//! A torque that acts at scheduled times only.

use super::TorqueModel;
use super::model::{AnyLaw, Model};
use super::polynomial::{PolynomialVector, Unknowns};
use super::recorder::{Recorder, VectorNode};
use super::tangent::Tangent;
use super::variation::Variation;
use super::varied::VariedVector;
use crate::math::frame::Body;
use crate::math::rotation::Attitude;
use crate::math::vector::Torque;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::schedule::Schedule;
use crate::motion::model::state::State;

/// Torque with a schedule. The integrators stop at each change, so that no step crosses one.
#[derive(Clone, Debug, PartialEq)]
pub struct Scheduled {
    /// Torque during the scheduled times.
    pub torque: TorqueModel,
    /// Times at which it acts.
    pub schedule: Schedule,
}

/// The polynomial and the graph are those of the torque while it acts.
impl AnyLaw for Scheduled {
    fn value(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        if self.schedule.is_on(state.time) { self.torque.torque(rotor, state) } else { Torque::ZERO }
    }

    fn polynomial(&self, unknowns: &Unknowns<'_>) -> PolynomialVector {
        self.torque.model().polynomial(unknowns)
    }

    fn record<'r>(&self, recorder: &Recorder<'r>) -> VectorNode<'r> {
        self.torque.model().record(recorder)
    }

    fn derivative(&self, along: &Tangent<'_>) -> Torque<Body> {
        if self.schedule.is_on(along.time()) { self.torque.model().derivative(along) } else { Torque::ZERO }
    }

    fn variation<'r>(&self, at: &Variation<'_, 'r>) -> VariedVector<'r> {
        self.torque.model().variation(at)
    }

    fn parameters(&self) -> &'static [&'static str] {
        self.torque.model().parameters()
    }
}

/// A switched torque has no potential.
impl Model for Scheduled {
    fn name(&self) -> &'static str {
        self.torque.name()
    }

    fn scale(&self, rotor: &Rotor, state: &State) -> f64 {
        self.torque.model().scale(rotor, state)
    }

    fn roughness(&self) -> Option<&'static str> {
        self.torque.model().roughness()
    }

    fn is_partial(&self) -> bool {
        self.torque.model().is_partial()
    }

    fn unsplittable(&self) -> Option<&'static str> {
        self.torque.model().unsplittable()
    }

    fn rest(&self) -> Option<Attitude> {
        self.torque.model().rest()
    }
}
