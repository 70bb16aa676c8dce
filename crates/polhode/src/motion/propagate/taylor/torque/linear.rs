//! Torques that are linear in a vector that is constant in space: constant ones, and gravity at a pivot.

use super::super::row::Row;
use super::super::seen::Seen;
use super::super::sums::Sums;
use super::{Known, StepStart, row};
use crate::math::frame::{Body, Principal, Space};
use crate::math::number::{MulAdd, Number};
use crate::math::vector::Direction;
use crate::motion::propagate::chart::{ROUNDING, THIN};
use crate::motion::rotor::Rotor;
use crate::motion::torque::{ConstantTorque, TorqueModel};

/// N = A v, v̇ = v × Ω: v is constant in space and seen from the body.
#[derive(Clone, Debug)]
pub(in super::super) struct LinearSeries<N> {
    in_space: Row<N>,
    /// Columns of A.
    columns: [Row<N>; 3],
    /// Where it is not expanded beside the turn.
    v: Seen<N>,
}

impl<N: Number> LinearSeries<N> {
    pub(super) fn all(zero: N) -> Self {
        Self { in_space: Row::splat(zero), columns: [Row::splat(zero); 3], v: Seen::all(zero) }
    }

    /// A constant torque's own vector, or N = l × M g.
    pub(super) fn set_model(&mut self, lane: usize, model: &TorqueModel, rotor: &Rotor) {
        match model {
            TorqueModel::Constant(ConstantTorque::Space(torque)) => {
                self.set(lane, torque.as_quantity(), |v| v, rotor);
            }
            TorqueModel::Gravity(gravity) => {
                let lever: Direction<Body> = (rotor.lever() * rotor.mass()).as_quantity();
                let lever = rotor.principal().rotation().inverse() * lever;
                self.set(lane, gravity.acceleration.as_quantity(), |v| lever.cross(v), rotor);
            }
            _ => {}
        }
    }

    fn set(
        &mut self,
        lane: usize,
        in_space: Direction<Space>,
        a: impl Fn(Direction<Principal>) -> Direction<Principal>,
        rotor: &Rotor,
    ) {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Direction::from_array);
        let columns = cleaned(axes.map(|axis| a(axis).to_array()), rotor);
        self.in_space.put(lane, row(in_space));
        for (place, column) in self.columns.iter_mut().zip(columns) {
            place.put(lane, column);
        }
    }

    #[inline(always)]
    pub(super) fn start(&mut self, at: &StepStart<N>) {
        self.v.start(self.carried(at));
    }

    /// v at the start of a step.
    #[inline(always)]
    pub(super) fn carried(&self, at: &StepStart<N>) -> Row<N> {
        at.seen(self.in_space)
    }

    #[inline(always)]
    pub(super) fn coefficient(&self, n: usize) -> Row<N> {
        times(&self.columns, self.v.coefficient(n))
    }

    /// Columns of A.
    pub(super) fn columns(&self) -> &[Row<N>; 3] {
        &self.columns
    }

    #[inline(always)]
    pub(super) fn extend<M: Sums<N = N>>(&mut self, n: usize, known: &Known<'_, M>) {
        let none = Row::splat(self.in_space.0[0].like(0.0));
        self.v.extend(known.s, n, known.turning, none);
    }
}

/// A v, of A's columns.
#[inline(always)]
pub(super) fn times<N: Number>(columns: &[Row<N>; 3], v: Row<N>) -> Row<N> {
    let [x, y, z, _] = v.0;
    let [a, b, c] = *columns;
    a.mul_add(Row::splat(x), b.mul_add(Row::splat(y), c * Row::splat(z)))
}

/// Columns without what is only rounding along the axis of a needle: divided by so small a moment, it would spin it.
pub(super) fn cleaned(mut columns: [[f64; 3]; 3], rotor: &Rotor) -> [Row; 3] {
    let moments = rotor.principal().moments();
    let size = |k: usize| columns.iter().map(|column| column[k].abs()).fold(0.0, f64::max);
    let sizes = [size(0), size(1), size(2)];
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    for k in 0..2 {
        if moments[k] < THIN * moments[2] && sizes[k] < ROUNDING * largest {
            columns.iter_mut().for_each(|column| column[k] = 0.0);
        }
    }
    columns.map(|[x, y, z]| Row([x, y, z, 0.0]))
}
