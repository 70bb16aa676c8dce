//! User-supplied torques.

use core::fmt;
use core::sync::atomic::{AtomicU64, Ordering};
use std::sync::Arc;

use super::graph::Graph;
use super::model::{AnyLaw, Model};
use super::polynomial::{PolynomialVector, Unknowns};
use super::recorder::{Recorder, VectorNode};
use super::tangent::Tangent;
use super::variation::Variation;
use super::varied::VariedVector;
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::math::vector::{Position, Torque};
use crate::motion::model::law::Law;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// User-supplied torque. A [`Law`] is as fast as the built-in ones; a function has no power series.
#[derive(Clone)]
pub struct OwnTorque {
    name: &'static str,
    kind: OwnLaw,
}

type Function = dyn Fn(&Rotor, &State) -> Torque<Body> + Send + Sync;

/// Function of several bodies in their states.
pub(in crate::motion) type VectorizedFunction =
    dyn for<'a> Fn(&[MemberState<'a>]) -> Vec<Torque<Body>> + Send + Sync;

/// Body in a state for which a torque is requested.
#[derive(Clone, Copy, Debug)]
pub struct MemberState<'a> {
    /// Index of the member of an [`Ensemble`](crate::motion::Ensemble), from 0; 0 for a single
    /// body.
    pub member: usize,
    /// Body, with its point of rotation.
    pub rotor: &'a Rotor,
    /// State of the body.
    pub state: State,
}

/// Torque that was computed elsewhere for the state of the next evaluation.
#[derive(Debug, Default)]
pub(in crate::motion) struct GivenTorque([AtomicU64; 3]);

impl GivenTorque {
    pub(in crate::motion) fn set(&self, torque: Torque<Body>) {
        for (place, component) in self.0.iter().zip(torque.to_array()) {
            place.store(component.to_bits(), Ordering::Relaxed);
        }
    }

    fn get(&self) -> Torque<Body> {
        Torque::from_array([0, 1, 2].map(|k| f64::from_bits(self.0[k].load(Ordering::Relaxed))))
    }
}

/// Definition of the torque.
#[derive(Clone)]
enum OwnLaw {
    Law {
        law: Arc<dyn AnyLaw + Send + Sync>,
        is_smooth: bool,
    },
    Function(Arc<Function>),
    /// Function of many bodies. The option holds the torque if it is computed elsewhere for all
    /// bodies together.
    Vectorized(Arc<VectorizedFunction>, Option<Arc<GivenTorque>>),
}

impl OwnTorque {
    pub(super) fn law(name: &'static str, law: impl Law + fmt::Debug + Send + Sync + 'static) -> Self {
        let law = Arc::new(law);
        let is_smooth = !is_rough(law.as_ref());
        Self { name, kind: OwnLaw::Law { law, is_smooth } }
    }

    /// Creates a torque from a law that is known to have a power series.
    pub(super) fn smooth(name: &'static str, law: Arc<dyn AnyLaw + Send + Sync>) -> Self {
        Self { name, kind: OwnLaw::Law { law, is_smooth: true } }
    }

    pub(super) fn function(
        name: &'static str,
        torque: impl Fn(&Rotor, &State) -> Torque<Body> + Send + Sync + 'static,
    ) -> Self {
        Self { name, kind: OwnLaw::Function(Arc::new(torque)) }
    }

    pub(super) fn vectorized(
        name: &'static str,
        torques: impl Fn(&[MemberState<'_>]) -> Vec<Torque<Body>> + Send + Sync + 'static,
    ) -> Self {
        Self { name, kind: OwnLaw::Vectorized(Arc::new(torques), None) }
    }

    /// Returns the function of many bodies, if the torque is one.
    pub(in crate::motion) fn vectorized_function(&self) -> Option<&Arc<VectorizedFunction>> {
        match &self.kind {
            OwnLaw::Vectorized(torques, _) => Some(torques),
            OwnLaw::Law { .. } | OwnLaw::Function(_) => None,
        }
    }

    /// Takes the torque from a value that is computed elsewhere.
    pub(in crate::motion) fn given(&self, torque: &Arc<GivenTorque>) -> Self {
        let kind = match &self.kind {
            OwnLaw::Vectorized(torques, _) => {
                OwnLaw::Vectorized(Arc::clone(torques), Some(Arc::clone(torque)))
            }
            other => other.clone(),
        };
        Self { name: self.name, kind }
    }

    /// Restricts a function of many bodies to one member of an ensemble.
    pub(in crate::motion) fn alone(&self, member: usize) -> Self {
        let kind = match &self.kind {
            OwnLaw::Vectorized(torques, _) => {
                let torques = Arc::clone(torques);
                OwnLaw::Function(Arc::new(move |rotor, state| {
                    let alone = torques(&[MemberState { member, rotor, state: *state }]);
                    alone.first().copied().unwrap_or(NOT_KNOWN)
                }))
            }
            other => other.clone(),
        };
        Self { name: self.name, kind }
    }

    /// Returns the name.
    pub const fn name(&self) -> &'static str {
        self.name
    }
}

/// Torque for a body that the function did not return.
pub(in crate::motion) const NOT_KNOWN: Torque<Body> = Torque::new(f64::NAN, f64::NAN, f64::NAN);

/// A function is known in numeric states only: it has no polynomial, graph or derivative.
impl AnyLaw for OwnTorque {
    fn value(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.value(rotor, state),
            OwnLaw::Function(torque) => torque(rotor, state),
            OwnLaw::Vectorized(_, Some(given)) => given.get(),
            OwnLaw::Vectorized(torques, None) => {
                let alone = torques(&[MemberState { member: 0, rotor, state: *state }]);
                alone.first().copied().unwrap_or(NOT_KNOWN)
            }
        }
    }

    fn polynomial(&self, unknowns: &Unknowns<'_>) -> PolynomialVector {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.polynomial(unknowns),
            OwnLaw::Function(_) | OwnLaw::Vectorized(..) => PolynomialVector::NONE,
        }
    }

    fn record<'r>(&self, recorder: &Recorder<'r>) -> VectorNode<'r> {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.record(recorder),
            OwnLaw::Function(_) | OwnLaw::Vectorized(..) => recorder.rough(),
        }
    }

    fn derivative(&self, along: &Tangent<'_>) -> Torque<Body> {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.derivative(along),
            OwnLaw::Function(_) | OwnLaw::Vectorized(..) => NOT_KNOWN,
        }
    }

    fn variation<'r>(&self, at: &Variation<'_, 'r>) -> VariedVector<'r> {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.variation(at),
            OwnLaw::Function(_) | OwnLaw::Vectorized(..) => at.rough(),
        }
    }

    fn parameters(&self) -> &'static [&'static str] {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.parameters(),
            OwnLaw::Function(_) | OwnLaw::Vectorized(..) => &[],
        }
    }
}

impl Model for OwnTorque {
    fn name(&self) -> &'static str {
        self.name
    }

    fn roughness(&self) -> Option<&'static str> {
        match self.kind {
            OwnLaw::Law { is_smooth: true, .. } => None,
            OwnLaw::Law { is_smooth: false, .. } => Some("a function with a corner or a jump"),
            OwnLaw::Function(_) | OwnLaw::Vectorized(..) => Some("a function that is not written as a law"),
        }
    }

    fn is_partial(&self) -> bool {
        true
    }

    fn unsplittable(&self) -> Option<&'static str> {
        Some("it may depend on the angular velocity")
    }
}

/// Checks if a law uses values without a power series. The result is the same for all bodies.
fn is_rough(law: &dyn AnyLaw) -> bool {
    let sphere = InertiaTensor::diagonal([1.0; 3]);
    let body = sphere.and_then(|inertia| MassProperties::new(1.0, Position::ZERO, inertia));
    body.is_ok_and(|body| {
        Graph::recorded(&Rotor::free(&body), |recorder| law.record(recorder).place).0.is_rough()
    })
}

impl fmt::Debug for OwnTorque {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.kind {
            OwnLaw::Law { law, .. } => write!(f, "{}: {law:?}", self.name),
            OwnLaw::Function(_) | OwnLaw::Vectorized(..) => write!(f, "{}: a function", self.name),
        }
    }
}

/// Two torques are equal if they are the same object.
impl PartialEq for OwnTorque {
    fn eq(&self, other: &Self) -> bool {
        match (&self.kind, &other.kind) {
            (OwnLaw::Law { law: a, .. }, OwnLaw::Law { law: b, .. }) => Arc::ptr_eq(a, b),
            (OwnLaw::Function(a), OwnLaw::Function(b)) => Arc::ptr_eq(a, b),
            (OwnLaw::Vectorized(a, _), OwnLaw::Vectorized(b, _)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}
