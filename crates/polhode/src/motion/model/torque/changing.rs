//! A body with changing mass, expressed as a torque. The torque on a sphere of 1 kg·m² equals ω̇.

use std::sync::Arc;

use super::graph::Graph;
use super::model::AnyLaw;
use super::polynomial::{PolynomialVector, Unknowns};
use super::recorder::{Recorder, VectorNode};
use super::tangent::Tangent;
use super::variation::Variation;
use super::varied::VariedVector;
use super::{OwnTorque, TorqueModel};
use crate::math::frame::{Body, Space};
use crate::math::rotation::Attitude;
use crate::math::vector::{AngularMomentum, Direction, Torque};
use crate::motion::model::law::Values;
use crate::motion::model::mass_history::changing_body::ChangingBody;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// Body with changing mass, and the torques that act on it.
#[derive(Clone, Debug)]
pub(in crate::motion) struct DrivenBody {
    body: ChangingBody,
    /// External torques, without schedules.
    torques: Vec<TorqueModel>,
}

impl OwnTorque {
    /// Creates the law of a body with changing mass.
    pub(in crate::motion) fn of_changing(body: Arc<DrivenBody>) -> Self {
        Self::smooth("changing mass", body)
    }
}

impl ChangingBody {
    /// Returns the reason that a law has no power series in time if it acts on this body. A
    /// user-supplied law may need the rotor, which is known in states only.
    pub(in crate::motion) fn roughness(&self, torque: &TorqueModel, ball: &Rotor) -> Option<&'static str> {
        let own = match torque {
            TorqueModel::Scheduled(scheduled) => return self.roughness(&scheduled.torque, ball),
            TorqueModel::Own(own) => own,
            _ => return None,
        };
        let record =
            |recorder: &Recorder<'_>| recorder.of_changing(self, |recorder| own.record(recorder)).place;
        let (graph, _) = Graph::recorded(ball, record);
        graph.asks_for_rotor.then_some("a law that asks for the rotor, and the body changes")
    }
}

impl DrivenBody {
    pub(in crate::motion) fn new(body: ChangingBody, torques: Vec<TorqueModel>) -> Self {
        Self { body, torques }
    }

    /// Returns the rotor at `time`.
    pub(in crate::motion) fn rotor(&self, time: f64) -> Option<Rotor> {
        self.body.rotor(time)
    }

    /// Returns the total external torque, body axes; NaN if the body is not known. If `near` is
    /// given, twists are continuous relative to that attitude, which is near the attitude of the
    /// state.
    fn torque(&self, state: &State, near: Option<Attitude>) -> Torque<Body> {
        if self.torques.is_empty() {
            return Torque::ZERO;
        }
        let Some(rotor) = self.body.rotor(state.time) else { return Torque::from_array([f64::NAN; 3]) };
        let torque = |model: &TorqueModel| match near {
            None => model.torque(&rotor, state),
            Some(near) => model.model().value_near(&rotor, state, near),
        };
        self.torques.iter().fold(Torque::ZERO, |sum, model| sum + torque(model))
    }

    /// Returns [`ChangingBody::balances`] for the sphere that replaces the body.
    pub(in crate::motion) fn evidence(&self, ball: &Rotor, state: &State) -> (f64, AngularMomentum<Space>) {
        let torque = self.torque(state, None);
        self.body.balances(&Values { rotor: ball, state, near: None }, state, torque)
    }

    /// Returns the torque on the sphere that replaces the body. Twists are continuous relative to
    /// the attitude `near`.
    pub(in crate::motion) fn value_near(&self, ball: &Rotor, state: &State, near: Attitude) -> Torque<Body> {
        let torque: Direction<Body> = self.torque(state, Some(near)).as_quantity();
        self.body.acceleration(&Values { rotor: ball, state, near: Some(near) }, torque).as_quantity()
    }
}

/// A driven body has a graph and no derivatives.
impl AnyLaw for DrivenBody {
    fn value(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        let torque: Direction<Body> = self.torque(state, None).as_quantity();
        self.body.acceleration(&Values { rotor, state, near: None }, torque).as_quantity()
    }

    fn polynomial(&self, _: &Unknowns<'_>) -> PolynomialVector {
        PolynomialVector::NONE
    }

    fn record<'r>(&self, recorder: &Recorder<'r>) -> VectorNode<'r> {
        recorder.of_changing(&self.body, |recorder| {
            let torques = self.torques.iter().map(|torque| torque.model().record(recorder));
            let torque =
                torques.reduce(|sum, n| sum + n).unwrap_or_else(|| recorder.constant(Direction::ZERO));
            self.body.acceleration(recorder, torque)
        })
    }

    fn derivative(&self, _: &Tangent<'_>) -> Torque<Body> {
        Torque::from_array([f64::NAN; 3])
    }

    fn variation<'r>(&self, at: &Variation<'_, 'r>) -> VariedVector<'r> {
        at.rough()
    }

    fn parameters(&self) -> &'static [&'static str] {
        &[]
    }
}
