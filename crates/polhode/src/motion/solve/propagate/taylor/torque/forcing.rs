//! Torques that depend on time alone. All their coefficients are known at the start of a step.

use super::super::recurrence::Motion;
use super::super::row::{Row, Vectors};
use super::super::sums::SeriesSums;
use super::tape::Tape;
use super::{Known, StepStart};
use crate::math::number::Number;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::torque::graph::Graph;

/// Series of such torques, principal axes.
#[derive(Clone, Debug)]
pub(in super::super) struct Forcing<N> {
    tape: Tape<N>,
    /// Series of the state, which the operations do not use.
    state: Box<Vectors<N>>,
}

impl<N: Number> Forcing<N> {
    /// Creates the series for all bodies whose graphs have these operations.
    pub(in super::super) fn of(zero: N, graph: &Graph) -> Self {
        let state = Box::new(Vectors::all(zero));
        Self { tape: Tape::of(zero, graph), state }
    }

    /// Sets the values of a lane's body. Its graph must have the same operations.
    pub(in super::super) fn set(&mut self, lane: usize, graph: &Graph, rotor: &Rotor) {
        self.tape.set(lane, graph, rotor);
    }

    /// Starts a step.
    #[inline(always)]
    pub(in super::super) fn start(&mut self, at: &StepStart<N>) {
        self.tape.start(at);
    }

    /// Expands the torques about the start of the step.
    #[inline(always)]
    pub(in super::super) fn expand<M: SeriesSums<N = N>>(&mut self, s: M, motion: &Motion<N>, order: usize) {
        let Self { tape, state } = self;
        let known = Known { s, omega: &**state, turning: &**state, motion };
        tape.expand(order, &known);
    }

    /// Returns coefficient n of N.
    #[inline(always)]
    pub(in super::super) fn at(&self, n: usize) -> Row<N> {
        self.tape.torque_at(n)
    }
}
