//! Torques of the user of this crate.

use core::fmt;
use std::sync::Arc;

use super::graph::Graph;
use super::law::Law;
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
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// A torque of the user: a [`Law`], which is as fast as those of this crate, or a function, which has no power series.
#[derive(Clone)]
pub struct OwnTorque {
    name: &'static str,
    kind: OwnLaw,
}

type Function = dyn Fn(&Rotor, &State) -> Torque<Body> + Send + Sync;

/// What it is given by.
#[derive(Clone)]
enum OwnLaw {
    Law { law: Arc<dyn AnyLaw + Send + Sync>, is_smooth: bool },
    Function(Arc<Function>),
}

impl OwnTorque {
    pub(super) fn law(name: &'static str, law: impl Law + fmt::Debug + Send + Sync + 'static) -> Self {
        let law = Arc::new(law);
        let is_smooth = !is_rough(law.as_ref());
        Self { name, kind: OwnLaw::Law { law, is_smooth } }
    }

    /// A law that is known to have a power series.
    pub(super) fn smooth(name: &'static str, law: Arc<dyn AnyLaw + Send + Sync>) -> Self {
        Self { name, kind: OwnLaw::Law { law, is_smooth: true } }
    }

    pub(super) fn function(
        name: &'static str,
        torque: impl Fn(&Rotor, &State) -> Torque<Body> + Send + Sync + 'static,
    ) -> Self {
        Self { name, kind: OwnLaw::Function(Arc::new(torque)) }
    }

    /// What the user calls it.
    pub const fn name(&self) -> &'static str {
        self.name
    }
}

/// A user's function is known in states only: nothing is made of it.
impl AnyLaw for OwnTorque {
    fn value(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.value(rotor, state),
            OwnLaw::Function(torque) => torque(rotor, state),
        }
    }

    fn polynomial(&self, unknowns: &Unknowns<'_>) -> PolynomialVector {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.polynomial(unknowns),
            OwnLaw::Function(_) => PolynomialVector::NONE,
        }
    }

    fn record<'r>(&self, recorder: &Recorder<'r>) -> VectorNode<'r> {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.record(recorder),
            OwnLaw::Function(_) => recorder.rough(),
        }
    }

    fn derivative(&self, along: &Tangent<'_>) -> Torque<Body> {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.derivative(along),
            OwnLaw::Function(_) => Torque::new(f64::NAN, f64::NAN, f64::NAN),
        }
    }

    fn variation<'r>(&self, at: &Variation<'_, 'r>) -> VariedVector<'r> {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.variation(at),
            OwnLaw::Function(_) => at.rough(),
        }
    }

    fn parameters(&self) -> &'static [&'static str] {
        match &self.kind {
            OwnLaw::Law { law, .. } => law.parameters(),
            OwnLaw::Function(_) => &[],
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
            OwnLaw::Function(_) => Some("a function that is not written as a law"),
        }
    }

    fn is_partial(&self) -> bool {
        true
    }

    fn unsplittable(&self) -> Option<&'static str> {
        Some("it may depend on the angular velocity")
    }
}

/// Does a law need what has no power series? That is the same for all bodies.
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
            OwnLaw::Function(_) => write!(f, "{}: a function", self.name),
        }
    }
}

/// Two are equal if they are the same one.
impl PartialEq for OwnTorque {
    fn eq(&self, other: &Self) -> bool {
        match (&self.kind, &other.kind) {
            (OwnLaw::Law { law: a, .. }, OwnLaw::Law { law: b, .. }) => Arc::ptr_eq(a, b),
            (OwnLaw::Function(a), OwnLaw::Function(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}
