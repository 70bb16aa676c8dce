//! Interface of a torque to the solvers.

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

/// Law that can be evaluated over each input type that the solvers need.
pub(in crate::motion) trait AnyLaw: fmt::Debug {
    /// Returns N in a state, body axes, N·m.
    fn value(&self, rotor: &Rotor, state: &State) -> Torque<Body>;

    /// Returns N as a polynomial.
    fn polynomial(&self, unknowns: &Unknowns<'_>) -> PolynomialVector;

    /// Records N in a graph.
    fn record<'r>(&self, recorder: &Recorder<'r>) -> VectorNode<'r>;

    /// Returns the derivative N′ along a tangent; NaN if it does not exist.
    fn derivative(&self, along: &Tangent<'_>) -> Torque<Body>;

    /// Records N and its derivative in a graph.
    fn variation<'r>(&self, at: &Variation<'_, 'r>) -> VariedVector<'r>;

    /// Returns the names of the parameters.
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

/// Torque: its law, and properties that do not follow from the law.
pub(in crate::motion) trait Model: AnyLaw {
    /// Returns the name used in scenario files and summaries.
    fn name(&self) -> &'static str;

    /// Returns the potential energy, J. A torque that follows the body or changes with time has in
    /// general no potential.
    fn potential(&self, _rotor: &Rotor, _state: &State) -> Option<f64> {
        None
    }

    /// Returns the magnitude to which the rounding is relative, N·m: sup |N| if it is known,
    /// otherwise |N|.
    fn scale(&self, rotor: &Rotor, state: &State) -> f64 {
        self.value(rotor, state).norm()
    }

    /// Returns the reason that the torque has no power series, if it has none.
    fn roughness(&self) -> Option<&'static str> {
        None
    }

    /// Returns the reason that the torque is not a function of attitude and time alone, if it is
    /// not. Splitting methods need such a function.
    fn unsplittable(&self) -> Option<&'static str> {
        None
    }

    /// True if the torque may be NaN in some states.
    fn is_partial(&self) -> bool {
        false
    }

    /// Returns the coefficient α of an energy sink, 1/(N·m·s).
    fn sink(&self) -> f64 {
        0.0
    }

    /// Returns the attitude without twist of a torsion. The torque is determined up to half a turn
    /// from it.
    fn rest(&self) -> Option<Attitude> {
        None
    }

    /// Returns N in a state, N·m. The twist of a torsion is continuous relative to an attitude
    /// `near` that of the state, even beyond half a turn.
    fn value_near(&self, rotor: &Rotor, state: &State, _near: Attitude) -> Torque<Body> {
        self.value(rotor, state)
    }
}
