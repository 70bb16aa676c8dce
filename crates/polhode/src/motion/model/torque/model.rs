//! What the solvers ask of a torque.

use core::fmt;

use super::polynomial::{PolynomialVector, Unknowns};
use super::recorder::{Recorder, VectorNode};
use super::tangent::Tangent;
use super::variation::Variation;
use super::varied::VariedVector;
use crate::math::frame::Body;
use crate::math::rotation::Attitude;
use crate::math::vector::Torque;
use crate::motion::model::law::Law;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// A law, run over what the solvers need.
pub(in crate::motion) trait AnyLaw: fmt::Debug {
    /// N in a state, N·m.
    fn value(&self, rotor: &Rotor, state: &State) -> Torque<Body>;

    /// As a polynomial.
    fn polynomial(&self, unknowns: &Unknowns<'_>) -> PolynomialVector;

    /// As a part of a graph.
    fn record<'r>(&self, recorder: &Recorder<'r>) -> VectorNode<'r>;

    /// N′ along a tangent; NaN if it has none.
    fn derivative(&self, along: &Tangent<'_>) -> Torque<Body>;

    /// As a part of a graph, with its derivative.
    fn variation<'r>(&self, at: &Variation<'_, 'r>) -> VariedVector<'r>;

    /// The names of its parameters.
    fn parameters(&self) -> &'static [&'static str];
}

impl<L: Law + fmt::Debug> AnyLaw for L {
    fn value(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        self.at(rotor, state)
    }

    fn polynomial(&self, unknowns: &Unknowns<'_>) -> PolynomialVector {
        self.torque(unknowns)
    }

    fn record<'r>(&self, recorder: &Recorder<'r>) -> VectorNode<'r> {
        self.torque(recorder)
    }

    fn derivative(&self, along: &Tangent<'_>) -> Torque<Body> {
        Torque::from_array(self.torque(along).0.map(|component| component.first))
    }

    fn variation<'r>(&self, at: &Variation<'_, 'r>) -> VariedVector<'r> {
        self.torque(at)
    }

    fn parameters(&self) -> &'static [&'static str] {
        Law::parameters(self)
    }
}

/// A torque: its law, and what does not follow from it.
pub(in crate::motion) trait Model: AnyLaw {
    /// The name in scenario files and summaries.
    fn name(&self) -> &'static str;

    /// The potential energy whose loss is this torque's work, J. In general a torque that follows the body, or that changes with
    /// time, has none.
    fn potential(&self, _rotor: &Rotor, _state: &State) -> Option<f64> {
        None
    }

    /// The size that its rounding is relative to, N·m: sup |N| where that is known, else |N|.
    fn scale(&self, rotor: &Rotor, state: &State) -> f64 {
        self.value(rotor, state).norm()
    }

    /// Why it has no power series, if it has none.
    fn roughness(&self) -> Option<&'static str> {
        None
    }

    /// Why it is no function of attitude and time alone, if it is none: splitting needs that.
    fn unsplittable(&self) -> Option<&'static str> {
        None
    }

    /// May it be NaN in some states?
    fn is_partial(&self) -> bool {
        false
    }

    /// α of an energy sink, 1/(N·m·s).
    fn sink(&self) -> f64 {
        0.0
    }

    /// The attitude without twist of a torsion, whose torque is determined up to half a turn from there.
    fn rest(&self) -> Option<Attitude> {
        None
    }

    /// N in a state, N·m. The twist of a torsion is continued from an attitude `near` that of the state, beyond half
    /// a turn too.
    fn value_near(&self, rotor: &Rotor, state: &State, _near: Attitude) -> Torque<Body> {
        self.value(rotor, state)
    }
}
